// A described robot in the Open Dynamics Engine, with what stands around it: laws for its drives in, one beat
// of physics, readings out.
//
//   cca::sim::robot_world w(cca::sim::model_of<cca::robots::arm::description>(), room);
//   w.advance(laws);                      one law for each coordinate (joint_law.hpp)
//   w.joints()[3].angle                   rad; torques are means over the beat
//   w.joint("a4"), w.end("arm")           by name, or by number
//   w.load("flange_load")                 of a force sensor, in its frame
//   w.inertial("gyro").orientation        of the inertial unit of a sensor
//   w.contact_at_end("arm").slip          what its contacts have done (contact_account.hpp)
//
// A world is a value. A copy is a snapshot: original and copy, given the same commands, stay bit-identical.
// `save` and `restore` do the same with a plain value, for worlds of the same model and scene. `pull`,
// `push` and `move`: a force at the end of a part, one on the base, a box that moves without notice.
//
// A motor brakes with its full torque and drives with what its line leaves. Springs, friction and motors are
// stable at every stiffness, damping and step (drives_in_engine.hpp); coupled joints follow at its end
// (coupled_joints.hpp). A world that can't be right any more (plausible.hpp) stands still: `trouble()`,
// `trouble_text()`. Errors: std::invalid_argument when it is made (tree_in_engine.hpp, robot_model.hpp);
// std::out_of_range, with all names, for a name that the robot doesn't have. Cost: docs/robots.md. It
// allocates nothing after the first beats.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <ode/ode.h>

#include <cca/sim/engine.hpp>
#include <cca/sim/robot/forces/drives_in_engine.hpp>
#include <cca/sim/robot/forces/gyroscopic.hpp>
#include <cca/sim/robot/inertial_units.hpp>
#include <cca/sim/robot/judgement.hpp>
#include <cca/sim/robot/forces/outer_forces.hpp>
#include <cca/sim/robot/robot_model.hpp>
#include <cca/sim/robot/robot_state.hpp>
#include <cca/sim/robot/scene.hpp>
#include <cca/sim/robot/shapes_in_engine.hpp>
#include <cca/sim/robot/springs_in_engine.hpp>
#include <cca/sim/robot/forces/stops_in_engine.hpp>
#include <cca/sim/robot/touching.hpp>

namespace cca::sim {

struct robot_world_settings {
  engine_settings engine{};
  int steps_per_beat = 2;
  placement mount{};  // of the base, in the world; of a base that floats, at the start
  plausible_bounds plausible{};
};

class robot_world {
public:
  explicit robot_world(robot_model model, scene around = {}, const robot_world_settings& settings = {})
      : robot_world(std::make_shared<const robot_model>(checked(std::move(model))),
                    std::make_shared<const scene>(std::move(around)),
                    settings,
                    nullptr) {}

  robot_world(const robot_world& other)
      : robot_world(other.model_, other.scene_, other.settings_, &other.drives_) {
    restore(other.save());
  }
  robot_world(robot_world&&) = default;
  robot_world& operator=(const robot_world& other) { return *this = robot_world(other); }
  robot_world& operator=(robot_world&& other) noexcept {
    if (this != &other) {
      std::destroy_at(this);
      std::construct_at(this, std::move(other));
    }
    return *this;
  }
  ~robot_world() = default;

  // Puts the robot there: coordinates and speeds, and the motion of a base that floats. All are finite.
  void place(std::span<const double> q, std::span<const double> dq) {
    place(q, dq, {mount(), Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero()});
  }
  void place(std::span<const double> q, std::span<const double> dq, const moving_frame& base) {
    if (q.size() != state_.joints.size() || dq.size() != q.size())
      throw std::invalid_argument("cca::sim::robot_world: one angle and one speed for each coordinate");
    double sum = sum_of(base);
    for (std::size_t c = 0; c < q.size(); ++c) sum += q[c] + dq[c];
    if (!std::isfinite(sum)) throw std::invalid_argument("cca::sim::robot_world: a place is not finite");
    tree_.place(q, dq, base);
    for (std::size_t c = 0; c < q.size(); ++c) {
      state_.joints[c] = {q[c], dq[c], 0};
      state_.winches[c] = {.position = q[c]};
    }
    units_.begin(tree_);
    units_.read(tree_, state_.inertial);
    state_.trouble = {};
    look(settings_.plausible);
  }

  // One beat. A law that isn't finite is ignored: the drive keeps the last one.
  void advance(std::span<const joint_law> laws) {
    prepare_engine();
    if (state_.trouble) return;
    for (std::size_t c = 0; c < std::min(laws.size(), state_.laws.size()); ++c)
      if (laws[c].is_finite()) state_.laws[c] = laws[c];
    for (std::size_t c = 0; c < state_.winches.size(); ++c)
      state_.winches[c].aim(state_.laws[c].position, model_->beat);
    drives_.begin(tree_, state_, [this](std::size_t i) {
      return springs_in_engine::length_and_tension(model_->line_springs[i], tree_);
    });
    units_.begin(tree_);
    for (joint_reading& r : state_.joints) r.torque = 0;
    for (auto& load : state_.loads) load.fill(0);
    for (auto& force : state_.end_forces) force.fill(0);
    for (int i = 0; i < settings_.steps_per_beat && !state_.trouble; ++i) step();
    if (!state_.trouble) units_.read(tree_, state_.inertial);
    ++state_.beats;
  }

  // A force and a torque at the end of a part (in order of declaration), along the world's axes, until they
  // are set again.
  void pull(std::size_t part, const Eigen::Vector3d& force, const Eigen::Vector3d& torque = {0, 0, 0}) {
    take_finite(state_.pulls.at(part).force, force);
    take_finite(state_.pulls.at(part).torque, torque);
  }

  void pull(std::string_view part, const Eigen::Vector3d& force, const Eigen::Vector3d& torque = {0, 0, 0}) {
    pull(index_of(model_->names.ends, part, "part"), force, torque);
  }

  // A force on the centre of mass of a base that floats, along the world's axes, until it is set again.
  void push(const Eigen::Vector3d& force) { take_finite(state_.push, force); }

  // Puts a box of the scene elsewhere.
  void move(std::size_t box, const placement& where) { shapes_.put_box(box, where); }

  // Why it stands still.
  const world_trouble& trouble() const { return state_.trouble; }
  std::string trouble_text() const { return text_of(state_.trouble, *model_); }

  const std::vector<joint_reading>& joints() const { return state_.joints; }
  const joint_reading& joint(std::string_view name) const {
    return state_.joints[index_of(model_->names.joints, name, "joint")];
  }
  // The torque about the sensor's origin, then the force of the world, along the sensor's axes.
  const std::array<double, 6>& load(std::size_t sensor) const { return state_.loads.at(sensor); }

  const std::array<double, 6>& load(std::string_view sensor) const {
    return load(index_of(model_->names.sensors, sensor, "force sensor"));
  }

  // Of the world on all shapes at the end of a part, along the world's axes: N, a mean over the beat.
  const std::array<double, 3>& force_on_end(std::size_t part) const { return state_.end_forces.at(part); }

  const inertial_reading& inertial(std::size_t unit) const { return state_.inertial.at(unit); }
  const inertial_reading& inertial(std::string_view sensor) const {
    return inertial(static_cast<std::size_t>(
        model_->unit_of[index_of(model_->names.inertial, sensor, "inertial sensor")]));
  }

  // The true state, which no sensor of the robot measures; in the world.
  moving_frame frame(int link) const { return tree_.frame(link); }
  moving_frame end(std::size_t part) const { return tree_.at(model_->ends.at(part)); }
  moving_frame end(std::string_view part) const { return end(index_of(model_->names.ends, part, "part")); }
  Eigen::Vector3d ball_position(std::size_t i) const {
    return Eigen::Vector3d::Map(dBodyGetPosition(shapes_.balls().at(i)));
  }
  Eigen::Vector3d ball_velocity(std::size_t i) const {
    return Eigen::Vector3d::Map(dBodyGetLinearVel(shapes_.balls().at(i)));
  }
  double mass() const { return sum_of_links(0.0, &mass_of); }
  Eigen::Vector3d centre_of_mass() const {
    return sum_of_links(Eigen::Vector3d(0, 0, 0), &moment_of) / mass();
  }

  // Accounts since the start: of a shape, of those at the end of a part, of those on the base; J of the
  // motors.
  const contact_account& contact(std::size_t shape) const { return state_.contacts.at(shape); }
  contact_account contact_at_end(std::size_t part) const {
    return contact_of(*model_, state_.contacts,
                      [&](const placed_shape& s) { return s.end == static_cast<int>(part); });
  }
  contact_account contact_at_end(std::string_view part) const {
    return contact_at_end(index_of(model_->names.ends, part, "part"));
  }
  contact_account contact_of_base() const {
    return contact_of(*model_, state_.contacts, [](const placed_shape& s) { return s.link < 0; });
  }
  double positive_work() const { return state_.positive_work; }  // braking is none
  double absolute_work() const { return state_.absolute_work; }  // braking is work
  double parallel_error() const { return state_.parallel_error; }

  // Of the robot alone, J: kinetic, and potential from the height of the world's origin.
  double energy() const {
    return sum_of_links(
        0.0, [&](dBodyID b) { return kinetic_energy(b) + potential_energy(b, settings_.engine.gravity); });
  }
  // In springs and cables between points and in the springs of joints, J.
  double spring_energy() const {
    return springs_in_engine::stored(*model_, tree_) + drives_in_engine::stored(*model_, state_);
  }
  // The force of a spring or cable (in order of declaration), N; negative: it pushes.
  double tension(std::size_t spring) const {
    return springs_in_engine::tension(model_->line_springs.at(spring), tree_);
  }
  double time() const { return static_cast<double>(state_.beats) * model_->beat; }

  const robot_model& model() const { return *model_; }
  const scene& around() const { return *scene_; }

  robot_state save() const {
    robot_state s = state_;
    each_body([&](dBodyID b) { s.bodies.push_back(save_body(b)); });
    s.boxes = shapes_.box_places();
    return s;
  }
  void restore(const robot_state& s) {
    state_ = s;
    state_.bodies.clear();
    state_.boxes.clear();
    std::size_t i = 0;
    each_body([&](dBodyID b) { restore_body(b, s.bodies.at(i++)); });
    shapes_.restore_boxes(s.boxes);
  }
  std::uint64_t hash() const { return save().hash(); }

private:
  robot_world(std::shared_ptr<const robot_model> model,
              std::shared_ptr<const scene> around,
              const robot_world_settings& settings,
              const drives_in_engine* like)
      : model_(std::move(model)),
        scene_(std::move(around)),
        settings_(settings),
        step_(step_of(*model_, settings)),
        engine_(settings.engine),
        tree_(engine_.id(), model_, mount()),
        coupled_(model_, tree_),
        units_(model_, settings.engine.gravity),
        shapes_(engine_.id(), *model_, *scene_, tree_),
        touching_(scene_->contact, step_),
        drives_(engine_.id(), model_, tree_, step_, like),
        stops_(*model_, tree_, settings.engine.erp) {
    touching_.set_pairs(shapes_.pairs());
    state_.pressing.assign(touching_.pair_count(), 0);
    state_.laws.assign(model_->drives.size(), {});
    state_.joints.assign(model_->drives.size(), {});
    state_.loads.assign(model_->sensors.size(), {});
    state_.winches.assign(model_->drives.size(), {});
    state_.inertial.assign(units_.count(), {});
    state_.pulls.assign(model_->ends.size(), {});
    state_.contacts.assign(model_->shapes.size(), {});
    state_.end_forces.assign(model_->ends.size(), {});
    const std::vector<double> rest(model_->drives.size(), 0.0);
    place(model_->start, rest);
  }

  static double step_of(const robot_model& m, const robot_world_settings& s) {
    const double step = m.beat / s.steps_per_beat;
    if (!(step > 0 && std::isfinite(step)))
      throw std::invalid_argument("cca::sim::robot_world: a beat has at least one physics step, above 0 s");
    return step;
  }
  rigid mount() const { return rigid{} * settings_.mount; }

  // The base, if it floats; the links.
  template <class F>
  void each_link(F f) const {
    if (tree_.base()) f(tree_.base());
    for (const dBodyID b : tree_.links())
      if (b) f(b);  // none where joints cross
  }
  template <class Sum, class F>
  Sum sum_of_links(Sum sum, F f) const {
    each_link([&](dBodyID b) { sum += f(b); });
    return sum;
  }
  template <class F>
  void each_body(F f) const {
    each_link(f);
    for (const dBodyID b : shapes_.balls()) f(b);
  }

  void step() {
    const double share = 1.0 / settings_.steps_per_beat;
    state_.parallel_error = std::max(state_.parallel_error, tree_.hold_parallel());
    if (coupled_.exist()) coupled_.begin(tree_);
    drives_.act(tree_, coupled_, state_, share);
    if (!coupled_.exist())
      stops_.act(*model_, tree_, state_.joints, step_, [&](std::size_t c) { return drives_.is_stiff(c); });
    springs_in_engine::act(engine_, *model_, tree_, drives_, coupled_, step_);
    each_link([&](dBodyID b) { turn_freely(b, step_); });
    pull_at_ends(*model_, tree_, state_.pulls);
    push_base(tree_, state_.push);
    touching_.find(engine_, state_.pressing);
    if (!engine_.step(step_)) state_.trouble = {implausible::engine};
    // With coupled joints the engine's step is half of one: only its numbers must be right.
    if (!state_.trouble) look(coupled_.exist() ? plausible_bounds::none() : settings_.plausible);
    if (state_.trouble) return;
    for (contact_account& c : state_.contacts) c.begin_step();
    touching_.account(state_.pressing, [&](const touch& t) {
      feel(*model_, tree_, t, share, state_);
      state_.contacts[t.shape].add(t, step_);
    });
    dJointGroupEmpty(engine_.contacts());
    if (coupled_.exist()) {
      if (!coupled_.end(tree_, state_.joints, step_)) state_.trouble = {implausible::engine};
      else look(settings_.plausible);
      if (state_.trouble) return;
    }
    drives_.account(tree_, coupled_, state_, share);
    state_.trouble = look_at_stops(*model_, tree_, state_.joints, settings_.plausible);
  }

  void look(const plausible_bounds& bounds) {
    state_.trouble = look_at_bodies(tree_, shapes_.balls(), bounds, step_);
  }

  std::shared_ptr<const robot_model> model_;
  std::shared_ptr<const scene> scene_;
  robot_world_settings settings_;
  double step_;
  engine engine_;
  tree_in_engine tree_;
  coupled_joints coupled_;
  inertial_units units_;
  shapes_in_engine shapes_;
  touching touching_;
  drives_in_engine drives_;
  stops_in_engine stops_;
  robot_state state_;
};

}  // namespace cca::sim
