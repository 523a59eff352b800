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
#include <cmath>
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
#include <cca/sim/compiled/contacts.hpp>
#include <cca/sim/compiled/on_links.hpp>
#include <cca/sim/compiled/readings/felt_contact.hpp>
#include <cca/sim/compiled/readings/motor_work.hpp>
#include <cca/sim/compiled/tree_step.hpp>
#include <cca/sim/compiled/whole_robot.hpp>
#include <cca/sim/robot/model/checked_settings.hpp>
#include <cca/sim/robot/model/ideal_inertial_unit.hpp>
#include <cca/sim/robot/model/joint_law.hpp>
#include <cca/sim/robot/model/plausible.hpp>
#include <cca/sim/robot/model/push.hpp>
#include <cca/sim/robot/model/robot_model.hpp>
#include <cca/sim/robot/model/robot_world_settings.hpp>

namespace cca::sim {

template <class R, class Real = double>
class compiled_world {
  static_assert(detail::check_compiled<R>());
  using tree = detail::compiled_tree<R>;
  using step_type = detail::tree_step<R, Real>;
  using links = detail::on_links<R, Real>;
  using whole = detail::whole_robot<R, Real>;
  using vector3 = detail::triple<Real>;
  static constexpr auto n = static_cast<std::size_t>(tree::coordinates);

public:
  using state_type = compiled_state<R, Real>;
  static constexpr double beat = 1 / cca::detail::hz_of<typename R::rate>;

  explicit compiled_world(const scene& around = {}, const robot_world_settings& settings = {})
      : settings_(settings), ground_(detail::ground_of(around, settings.engine)) {
    model();  // its numbers are checked
    check(settings);
    if (settings.steps_per_beat < 1)
      throw std::invalid_argument("cca::sim::compiled_world: a beat has at least one physics step");
    std::array<Real, n> q{};
    if constexpr (requires { R::start.size(); }) std::copy(R::start.begin(), R::start.end(), q.begin());
    put(q, {}, settings.mount, {}, {});
  }

  explicit compiled_world(const robot_world_settings& settings) : compiled_world({}, settings) {}
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
    auto& d = state_.drives;
    detail::take_laws(laws, d.laws);
    for (std::size_t c = 0; c < n; ++c) {
      d.pulleys[c].wanted = Real(1 / beat) * (Real(d.laws[c].position) - d.pulleys[c].wound);
      state_.joints[c].torque = Real(0.0);
    }
    state_.loads = {}, state_.end_forces = {};
    for (int i = 0; i < settings_.steps_per_beat && !state_.trouble; ++i) step();
    if (const world_trouble found = state_.trouble) {
      state_ = before, state_.trouble = found;
      return;
    }
    for (std::size_t c = 0; c < n; ++c)
      state_.joints[c].angle = state_.motion.q[c], state_.joints[c].velocity = state_.motion.dq[c];
    read_units(true);
    ++state_.beats;
  }

  // A force and a torque at the end of a part, along the world's axes, until they are set again. What is not
  // finite is ignored.
  void pull(std::size_t part, const std::array<Real, 3>& force, const std::array<Real, 3>& torque = {}) {
    auto& kept = state_.pulls[numbered(part, state_.pulls.size(), "part")];
    take(kept.force, force);
    take(kept.torque, torque);
  }
  void pull(std::string_view part, const std::array<Real, 3>& force, const std::array<Real, 3>& torque = {}) {
    pull(index_of(model().names.ends, part, "part"), force, torque);
  }
  // A force on the centre of mass of a base that floats, along the world's axes, until it is set again.
  void push(const std::array<Real, 3>& force) { take(state_.push, force); }
  // Pushes as the plan says, but only where it says something else than at the last call.
  void follow(const push_plan& plan) {
    const std::array<double, 3> now = plan.force_at(time());
    if (now != state_.planned) push({Real(now[0]), Real(now[1]), Real(now[2])});
    state_.planned = now;
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

  double mass() const { return tree::mass; }
  std::array<Real, 3> centre_of_mass() const {
    const vector3 c = whole::centre_of_mass(state_.motion);
    return {c[0], c[1], c[2]};
  }
  // Of the robot alone, J: kinetic, and potential from the height of the world's origin.
  Real energy() const { return whole::energy(state_.motion, settings_.engine.gravity); }
  // In springs and cables between points and in the springs of joints, J.
  Real spring_energy() const { return whole::spring_energy(state_.motion); }
  // The force of a spring or cable (in order of declaration), N; negative: it pushes.
  Real tension(std::size_t spring) const {
    return whole::tension(state_.motion, numbered(spring, tree::lines.size(), "spring"));
  }

  // Accounts since the start: of a shape, of those at the end of a part, of those on the base; J of the
  // motors. Links that are held parallel stay so.
  const contact_account& contact(std::size_t shape) const
    requires(!detail::is_in_lanes<Real>)
  {
    return state_.contacts[numbered(shape, state_.contacts.size(), "shape of the robot")];
  }
  contact_account contact_at_end(std::size_t part) const {
    return contact_of(model(), state_.contacts,
                      [&](const placed_shape& s) { return s.end == static_cast<int>(part); });
  }
  contact_account contact_at_end(std::string_view part) const {
    return contact_at_end(index_of(model().names.ends, part, "part"));
  }
  contact_account contact_of_base() const {
    return contact_of(model(), state_.contacts, [](const placed_shape& s) { return s.link < 0; });
  }
  static constexpr double parallel_error() { return 0; }
  Real positive_work() const { return state_.positive_work; }  // braking is none
  Real absolute_work() const { return state_.absolute_work; }  // braking is work
  double time() const { return static_cast<double>(state_.beats) * beat; }

  // Of the floor or the terrain at x; m. Without both it is minus infinity.
  double ground_height(double x) const { return detail::height_of(ground_, x); }

  const world_trouble& trouble() const { return state_.trouble; }
  std::string trouble_text() const { return text_of(state_.trouble, model()); }
  const robot_world_settings& settings() const { return settings_; }
  // The description as a value of the program, for names.
  static const robot_model& model() {
    static const robot_model m = checked(model_of<R>());
    return m;
  }

  const state_type& save() const { return state_; }
  void restore(const state_type& s) { state_ = s; }

private:
  void put(const std::array<Real, n>& q,
           const std::array<Real, n>& dq,
           const placement& base,
           const vector3& angular_velocity,
           const vector3& velocity) {
    need_place(base, "the base of the robot");
    bool is_finite = true;
    for (std::size_t c = 0; c < n; ++c) is_finite = is_finite && finite(q[c]) && finite(dq[c]);
    for (std::size_t k = 0; k < 3; ++k)
      is_finite = is_finite && finite(angular_velocity[k]) && finite(velocity[k]);
    if (!is_finite) throw std::invalid_argument("cca::sim::compiled_world: a place is not finite");
    state_.impulses = {};
    auto& m = state_.motion;
    m = {}, m.q = q, m.dq = dq, m.angular_velocity = angular_velocity, m.velocity = velocity;
    double square = 0;
    for (const double x : base.rotation) square += x * x;
    for (std::size_t k = 0; k < 4; ++k) m.attitude.q[k] = Real(base.rotation[k] / std::sqrt(square));
    for (std::size_t k = 0; k < 3; ++k) m.at[k] = Real(base.translation[k]);
    for (std::size_t c = 0; c < n; ++c) {
      state_.joints[c] = {q[c], dq[c], {}};
      state_.drives.pulleys[c] = {q[c], {}, {}, {}};
    }
    read_units(false);
    state_.trouble = detail::look_at_motion<R, Real>::at_bodies(m, settings_.plausible, step_seconds());
  }
  double step_seconds() const { return beat / settings_.steps_per_beat; }

  // Of a scalar that is no double there are no readings.
  void read_units(bool after_beat) {
    if constexpr (std::is_same_v<Real, double>)
      for (std::size_t i = 0; i < state_.inertial.size(); ++i) {
        const moving_frame now = whole::frame_of(state_.motion, detail::inertial_places<R>[i]);
        const Eigen::Vector3d before = cca::detail::as_vector(state_.unit_speeds[i]);
        state_.inertial[i] =
            inertial_reading_of(now, after_beat ? before : now.velocity, beat, settings_.engine.gravity);
        state_.unit_speeds[i] = {now.velocity[0], now.velocity[1], now.velocity[2]};
      }
  }

  void step() {
    const double h = step_seconds();
    auto& m = state_.motion;
    step_type now(h);
    now.begin(m, settings_.engine.gravity);
    pull_and_push(now);
    now.solve(m, state_.drives);
    if constexpr (detail::probes_of<R>::count > 0) {
      if (ground_.exists) touch(now, h);
      else now.end(m, state_.drives, now.change);
    } else {
      now.end(m, state_.drives, now.change);
    }
    detail::account_motors<R>(state_, h, Real(h / beat));
    state_.trouble = detail::trouble_of<R>(m, settings_.plausible, h);
  }

  void touch(step_type& now, double h) {
    detail::contacts_in_step<R, Real> contacts;
    const auto without = now.change;
    contacts.solve(now, state_.motion, ground_, state_.impulses, h);
    now.end(state_.motion, state_.drives, detail::lasting(without, now.change));
    for (contact_account& a : state_.contacts) a.begin_step();
    contacts.each(h, [&](const auto& c) {
      detail::feel<R>(now, c, Real(h / beat), state_);
      detail::add_to(state_.contacts[detail::probes_of<R>::shape_of(c.probe)], c, h);
    });
  }
  void pull_and_push(step_type& now) const {
    const auto given = [&](const std::array<Real, 3>& v) {
      return detail::along(now.base, vector3{v[0], v[1], v[2]});
    };
    for (std::size_t part = 0; part < state_.pulls.size(); ++part) {
      const auto& e = tree::described.ends[part];
      const auto& [force, torque] = state_.pulls[part];
      if (detail::is_none(force) && detail::is_none(torque)) continue;
      const vector3 at = links::point(now.now.places, e.link, tree::point({e.link, e.where}));
      links::add_wrench(now.now.places, e.link, at, given(force), given(torque), now.now.forces);
    }
    constexpr auto c = cca::detail::base_inertia_of<typename R::body>().centre;
    if (tree::floats && !detail::is_none(state_.push))
      links::add_wrench(now.now.places, -1, {Real(c[0]), Real(c[1]), Real(c[2])}, given(state_.push), {},
                        now.now.forces);
  }

  static bool finite(const Real& x) {
    using detail::everywhere;
    return everywhere(x - x == Real(0.0));
  }
  static void take(std::array<Real, 3>& kept, const std::array<Real, 3>& wanted) {
    for (std::size_t k = 0; k < 3; ++k)
      if (finite(wanted[k])) kept[k] = wanted[k];
  }

  robot_world_settings settings_;
  detail::ground ground_;
  state_type state_{};
};

}  // namespace cca::sim
