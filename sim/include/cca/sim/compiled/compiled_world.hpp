// A described robot as physics that is compiled from its description: laws for its drives in, one beat of
// physics, readings out. No engine: each step is arithmetic on numbers of a fixed count.
//
//   cca::sim::scene room;
//   room.floor = -0.2;
//   cca::sim::compiled_world<cca::robots::arm::description> w(room);
//   w.advance(laws);                      one law for each coordinate (joint_law.hpp)
//   w.joints()[3].angle                   rad; torques are means over the beat
//   w.end("arm")                          where the end of a part is and how it moves
//
// The names are those of robot_world, which is the same robot in the Open Dynamics Engine. What is here and
// what is not: docs/physics.md. A description that asks for more is refused (compiled_mistakes.hpp).
//
// A world is a trivially copyable value: a copy goes on bit for bit, `save` and `restore` do the same with
// its state. A world that can't be right any more stands still: `trouble()`, `trouble_text()`.
//
//   Real   the scalar of the motion: double, or a type with what scalar.hpp asks for
//
// Errors: robot.compiled; std::invalid_argument for a place or a setting that is none; std::out_of_range for
// a name or a number that the robot does not have. A beat neither allocates nor throws.
// Cost: docs/physics.md.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>

#include <cca/sim/compiled/compiled_mistakes.hpp>
#include <cca/sim/compiled/compiled_state.hpp>
#include <cca/sim/compiled/compiled_trouble.hpp>
#include <cca/sim/compiled/given_vector.hpp>
#include <cca/sim/compiled/on_links.hpp>
#include <cca/sim/compiled/readings/units.hpp>
#include <cca/sim/compiled/step/step_in_world.hpp>
#include <cca/sim/compiled/tree_step.hpp>
#include <cca/sim/compiled/whole_robot.hpp>
#include <cca/sim/robot/model/checked_settings.hpp>
#include <cca/sim/robot/model/joint_law.hpp>
#include <cca/sim/robot/model/plausible.hpp>
#include <cca/sim/robot/model/push.hpp>
#include <cca/sim/robot/model/robot_model.hpp>
#include <cca/sim/robot/model/robot_world_settings.hpp>

namespace cca::sim {

namespace detail {
template <class R, int N>
class beat_in_lanes;  // together/beat_in_lanes.hpp
}

template <class R, class Real = double>
class compiled_world {
  static_assert(detail::check_compiled<R>());
  using tree = detail::compiled_tree<R>;
  using links = detail::on_links<R, Real>;
  using whole = detail::whole_robot<R, Real>;
  using vector3 = detail::triple<Real>;
  using given = detail::given_vector<Real>;
  static constexpr auto n = static_cast<std::size_t>(tree::coordinates);
  static constexpr bool has_shapes = detail::probes_of<R>::shape_count > 0;

public:
  using description = R;
  using state_type = compiled_state<R, Real>;
  static constexpr double beat = 1 / cca::detail::hz_of<typename R::rate>;

  explicit compiled_world(const scene& around = {}, const robot_world_settings& settings = {})
      : settings_((check(settings), settings)),
        around_(detail::surroundings_of<Real>(around, settings.engine, has_shapes)),
        built_(settings.body) {
    model();  // its numbers are checked
    state_.around.begin(around);
    std::array<Real, n> q{};
    if constexpr (requires { R::start.size(); }) std::copy(R::start.begin(), R::start.end(), q.begin());
    put(q, {}, settings.mount, {}, {});
  }

  explicit compiled_world(const robot_world_settings& s) : compiled_world({}, s) {}
  static compiled_world at_start() { return compiled_world(); }

  // Puts the robot there: coordinates and speeds, and the motion of a base that floats. All are finite.
  void place(const std::array<Real, n>& q, const std::array<Real, n>& dq) {
    put(q, dq, settings_.mount, {}, {});
  }
  void place(const std::array<Real, n>& q,
             const std::array<Real, n>& dq,
             const placement& base,
             const std::array<Real, 3>& angular_velocity,
             const std::array<Real, 3>& velocity) {
    static_assert(tree::floats,
                  "cca::sim::compiled_world: the base of this robot is held, so it has no place");
    put(q, dq, base, {angular_velocity[0], angular_velocity[1], angular_velocity[2]},
        {velocity[0], velocity[1], velocity[2]});
  }

  // One beat. A law that isn't finite is ignored: the drive keeps the last one. After a beat that can't be
  // right all is as it was before it, but for `trouble()`.
  void advance(std::span<const joint_law> laws) {
    if (state_.trouble) return;
    const state_type before = state_;
    detail::take_laws(laws, state_.drives.laws);
    detail::step_in_world<R, Real> steps{settings_, around_, built_, state_};
    steps.begin_beat();
    for (int i = 0; i < settings_.steps_per_beat && !state_.trouble; ++i) steps.make(i);
    if (const world_trouble found = state_.trouble) {
      state_ = before, state_.trouble = found;
      return;
    }
    steps.end_beat();
    end_beat();
  }

  // Of the drives from now on, one for each coordinate; what no drive can be in is ignored.
  void set_condition(std::span<const drive_condition> now) {
    take_possible(now, state_.conditions);
    built_.take(state_.conditions);
  }

  // At the end of a part, along the world's axes, until they are set again; what is not finite is ignored.
  void pull(std::size_t part, const given& force, const given& torque = {}) {
    auto& kept = state_.pulls[numbered(part, state_.pulls.size(), "part")];
    detail::take_finite(kept.force, force);
    detail::take_finite(kept.torque, torque);
  }
  void pull(std::string_view part, const given& force, const given& torque = {}) {
    pull(index_of(model().names.ends, part, "part"), force, torque);
  }
  // A force on the centre of mass of a base that floats, along the world's axes, until it is set again.
  void push(const given& force) { detail::take_finite(state_.push, force); }
  // As the plan says, where it says something else than at the last call.
  void follow(const push_plan& plan) {
    const std::array<double, 3> now = plan.force_at(time());
    if (now != state_.planned) push({Real(now[0]), Real(now[1]), Real(now[2])});
    state_.planned = now;
  }

  // A box of the scene goes there in the next beat, or is there at once (around/boxes.hpp).
  void move(std::size_t box, const placement& where) {
    numbered(box, around_.boxes.count, "box");
    if (!is_place(where)) need_place(where, "box " + std::to_string(box) + " of the scene");
    state_.around.boxes[box].move(where, around_.boxes.half[box], beat);
  }

  const std::array<compiled_reading<Real>, n>& joints() const { return state_.joints; }
  const compiled_reading<Real>& joint(std::string_view name) const {
    return state_.joints[index_of(model().names.joints, name, "joint")];
  }
  const auto& laws() const { return state_.drives.laws; }

  // The torque about the sensor's origin, then the force of the ground, along the sensor's axes: means.
  const std::array<Real, 6>& load(std::size_t sensor) const {
    return state_.loads[numbered(sensor, state_.loads.size(), "force sensor")];
  }
  const std::array<Real, 6>& load(std::string_view sensor) const {
    return load(index_of(model().names.sensors, sensor, "force sensor"));
  }
  // Of the ground on all shapes at the end of a part, along the world's axes: N, a mean over the beat.
  const std::array<Real, 3>& force_on_end(std::size_t part) const {
    return state_.end_forces[numbered(part, state_.end_forces.size(), "part")];
  }
  const std::array<Real, 3>& force_on_end(std::string_view part) const {
    return force_on_end(index_of(model().names.ends, part, "part"));
  }

  const robots::inertial_reading& inertial(std::size_t unit) const {
    return state_.inertial[numbered(unit, state_.inertial.size(), "inertial unit")];
  }
  const robots::inertial_reading& inertial(std::string_view sensor) const {
    return inertial(static_cast<std::size_t>(
        model().unit_of[index_of(model().names.inertial, sensor, "inertial sensor")]));
  }

  // The true state, which no sensor of the robot measures; in the world.
  moving_frame frame(int link) const
    requires std::is_same_v<Real, double>
  {
    if (link >= 0) numbered(static_cast<std::size_t>(link), tree::links, "link");
    return whole::frame_of(state_.motion, {link, {}});
  }
  moving_frame end(std::size_t part) const
    requires std::is_same_v<Real, double>
  {
    const auto& e = tree::described.ends[numbered(part, tree::described.ends.size(), "part")];
    return whole::frame_of(state_.motion, {e.link, e.where});
  }
  moving_frame end(std::string_view part) const
    requires std::is_same_v<Real, double>
  {
    return end(index_of(model().names.ends, part, "part"));
  }

  Eigen::Vector3d ball_position(std::size_t i) const
    requires std::is_same_v<Real, double>
  {
    return whole::vector_of(ball(i).at);
  }
  Eigen::Vector3d ball_velocity(std::size_t i) const
    requires std::is_same_v<Real, double>
  {
    return whole::vector_of(ball(i).velocity);
  }

  double mass() const {
    if constexpr (detail::is_in_lanes<Real>) return tree::mass + built_.added.mass()[0];  // in all lanes
    else return tree::mass + built_.added.mass();
  }
  std::array<Real, 3> centre_of_mass() const {
    const vector3 c = whole::centre_of_mass(state_.motion, built_.added);
    return {c[0], c[1], c[2]};
  }
  // Of the robot alone, J: kinetic, and potential from the world's origin.
  Real energy() const { return whole::energy(state_.motion, settings_.engine.gravity, built_.added); }
  // J; in springs and cables between points, and in joints.
  Real spring_energy() const { return whole::spring_energy(state_.motion); }
  // The force of a spring or cable (in order of declaration), N; negative: it pushes.
  Real tension(std::size_t spring) const {
    return whole::tension(state_.motion, numbered(spring, tree::lines.size(), "spring"));
  }

  // Accounts since the start: of a shape, of those at the end of a part, of those on the base; of the motors.
  const contact_account& contact(std::size_t shape) const
    requires(!detail::is_in_lanes<Real>)
  {
    return state_.contacts[numbered(shape, state_.contacts.size(), "shape of the robot")];
  }
  contact_account contact_at_end(std::size_t part) const
    requires(!detail::is_in_lanes<Real>)
  {
    return contact_of(model(), state_.contacts,
                      [&](const placed_shape& s) { return s.end == static_cast<int>(part); });
  }
  contact_account contact_at_end(std::string_view part) const
    requires(!detail::is_in_lanes<Real>)
  {
    return contact_at_end(index_of(model().names.ends, part, "part"));
  }
  contact_account contact_of_base() const
    requires(!detail::is_in_lanes<Real>)
  {
    return contact_of(model(), state_.contacts, [](const placed_shape& s) { return s.link < 0; });
  }
  static constexpr double parallel_error() { return 0; }
  Real positive_work() const { return state_.positive_work; }  // braking is none
  Real absolute_work() const { return state_.absolute_work; }  // braking is work
  double time() const { return static_cast<double>(state_.beats) * beat; }

  // At x, m; without floor and terrain it is minus infinity.
  double ground_height(double x) const {
    if constexpr (detail::is_in_lanes<Real>) return detail::height_of(around_.under.lane(0), x);
    else return detail::height_of(around_.under, x);
  }

  const world_trouble& trouble() const { return state_.trouble; }
  std::string trouble_text() const { return text_of(state_.trouble, model()); }
  const robot_world_settings& settings() const { return settings_; }
  // The description as a value of the program, for names.
  static const robot_model& model() {
    static const robot_model m = checked(model_of<R>());
    return m;
  }

  const state_type& save() const { return state_; }
  void restore(const state_type& s) { state_ = s, built_.take(s.conditions); }

private:
  template <class, int>
  friend class detail::beat_in_lanes;

  // What is not of the steps.
  void end_beat() {
    detail::read_units<R>(state_, true, beat, settings_.engine.gravity);
    if constexpr (!detail::is_in_lanes<Real>)
      if (around_.boxes.count > 0) state_.around.end_beat(around_, beat);
    ++state_.beats;
  }
  void put(const std::array<Real, n>& q,
           const std::array<Real, n>& dq,
           const placement& base,
           const vector3& angular_velocity,
           const vector3& velocity) {
    need_place(base, "the base of the robot");
    bool is_finite = true;
    for (std::size_t c = 0; c < n; ++c)
      is_finite = is_finite && detail::is_finite(q[c]) && detail::is_finite(dq[c]);
    for (std::size_t k = 0; k < 3; ++k)
      is_finite = is_finite && detail::is_finite(angular_velocity[k]) && detail::is_finite(velocity[k]);
    if (!is_finite) throw std::invalid_argument("cca::sim::compiled_world: a place is not finite");
    state_.impulses = {};
    auto& m = state_.motion;
    m = {}, m.q = q, m.dq = dq, m.angular_velocity = angular_velocity, m.velocity = velocity;
    m.attitude = m.attitude.of(base.rotation);
    for (std::size_t k = 0; k < 3; ++k) m.at[k] = Real(base.translation[k]);
    for (std::size_t c = 0; c < n; ++c) {
      state_.joints[c] = {q[c], dq[c], {}};
      state_.drives.pulleys[c] = {q[c], {}, {}, {}};
    }
    detail::read_units<R>(state_, false, beat, settings_.engine.gravity);
    state_.trouble = detail::look_at_motion<R, Real>::at_bodies(m, settings_.plausible, step_seconds());
  }
  const detail::ball_motion<Real>& ball(std::size_t i) const {
    return state_.around.balls[numbered(i, around_.balls.count, "ball")];
  }
  double step_seconds() const { return beat / settings_.steps_per_beat; }

  robot_world_settings settings_;
  detail::surroundings_for<Real> around_;
  state_type state_{};
  detail::built_robot<R, Real> built_;
};

}  // namespace cca::sim
