// The simulated Oncilla on its terrain: commands in, one beat of physics, readings out.
//
// A world is a value. A copy is a snapshot: original and copy, given the same commands, stay bit-identical,
// in one thread or in two. `save` and `restore` do the same with a plain value, for worlds of the same model,
// terrain and posture. Only `advance`, `follow`, `push`, `restore` and assignment change a world.
//
// Cost: a beat (two physics steps) takes about 0.1 ms on a core of 2023. It allocates nothing after the first
// beats.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include <ode/ode.h>

#include <cca/sim/attitude.hpp>
#include <cca/sim/engine.hpp>
#include <cca/sim/footing.hpp>
#include <cca/sim/ground.hpp>
#include <cca/sim/interface.hpp>
#include <cca/sim/kinematics.hpp>
#include <cca/sim/leg.hpp>
#include <cca/sim/oncilla_model.hpp>
#include <cca/sim/state.hpp>
#include <cca/sim/terrain.hpp>

namespace cca::sim {

class world {
public:
  explicit world(const oncilla_model& model = {},
                 const terrain& ground_shape = terrain::flat(),
                 const initial_posture& posture = {})
      : model_(model),
        terrain_(ground_shape),
        posture_(posture),
        engine_(model_.engine()),
        ground_(model_, terrain_) {
    build();
  }

  world(const world& other) : world(other.model_, other.terrain_, other.posture_) { restore(other.save()); }
  world(world&&) = default;
  world& operator=(const world& other) { return *this = world(other); }
  world& operator=(world&& other) noexcept {
    if (this != &other) {
      std::destroy_at(this);
      std::construct_at(this, std::move(other));
    }
    return *this;
  }
  ~world() = default;

  // One beat. The speed of the first targets is 0.
  void advance(const robot_command& command) {
    prepare_engine();
    accept(command);
    finish_beat();
  }

  // One beat with drives that have their own loops.
  void follow(const robot_laws& laws) {
    prepare_engine();
    for (std::size_t i = 0; i < leg_count; ++i) {
      leg_motors& motors = state_.motors[i];
      motors.by_law = 1;
      for (const auto& [kept, wanted] :
           {std::pair(&motors.hip_law, &laws[i].hip), std::pair(&motors.knee_law, &laws[i].knee)})
        if (std::isfinite(wanted->position + wanted->velocity + wanted->torque + wanted->stiffness +
                          wanted->damping))
          *kept = *wanted;
      motors.target.hip = motors.hip_law.position;
      motors.target.knee = motors.knee_law.position;
      if (std::isfinite(laws[i].abduction))
        motors.target.abduction = model_.abduction_range.clamp(laws[i].abduction);
    }
    finish_beat();
  }

  // A force on the trunk's centre, in the world's axes, until it is set again.
  void push(const vector3& force) {
    for (std::size_t k = 0; k < 3; ++k)
      if (std::isfinite(force[k])) state_.push[k] = force[k];
  }

  const robot_reading& reading() const { return state_.reading; }

  // The targets that the motors follow: the commands after clamping.
  robot_command targets() const {
    robot_command taken;
    for (std::size_t i = 0; i < leg_count; ++i) taken[i] = state_.motors[i].target;
    return taken;
  }

  // The true state, which no sensor of the robot measures.
  vector3 trunk_position() const { return vector(dBodyGetPosition(trunk_)); }
  vector3 trunk_velocity() const { return velocity(trunk_); }
  vector3 foot_position(std::size_t leg) const { return vector(dBodyGetPosition(legs_.at(leg).toe())); }
  double hip_height() const {
    const vector3 p = trunk_position();
    return p[2] - model_.trunk_above_hips - terrain_.height(p[0]);
  }
  vector3 centre_of_mass() const {
    vector3 sum{};
    for (dBodyID b : bodies_)
      for (std::size_t k = 0; k < 3; ++k) sum[k] += mass_of(b) * dBodyGetPosition(b)[k];
    for (double& x : sum) x /= mass();
    return sum;
  }
  double mass() const {
    double sum = 0;
    for (dBodyID b : bodies_) sum += mass_of(b);
    return sum;
  }

  // The trunk has touched the ground, or rolled or pitched by 30 degrees.
  bool fallen() const {
    const roll_pitch_yaw a = attitude(state_.reading.trunk.orientation);
    constexpr double limit = degrees(30);
    return state_.trunk_contacts > 0 || !(std::abs(a.roll) < limit) || !(std::abs(a.pitch) < limit);
  }

  double time() const { return static_cast<double>(state_.beats) * model_.beat(); }
  const foot_account& foot(std::size_t leg) const { return state_.feet.at(leg); }
  double positive_work() const { return state_.positive_work; }
  double absolute_work() const { return state_.absolute_work; }
  double pantograph_error() const { return state_.pantograph_error; }
  std::int64_t knee_contacts() const { return state_.knee_contacts; }

  const oncilla_model& model() const { return model_; }
  const terrain& ground_shape() const { return terrain_; }
  const initial_posture& posture() const { return posture_; }

  world_state save() const {
    world_state s = state_;
    for (std::size_t i = 0; i < body_count; ++i) s.bodies[i] = save_body(bodies_[i]);
    return s;
  }

  void restore(const world_state& s) {
    state_ = s;
    for (std::size_t i = 0; i < body_count; ++i) restore_body(bodies_[i], s.bodies[i]);
  }

  std::uint64_t hash() const { return sim::hash(save()); }

private:
  void build() {
    double lowest = 0;
    for (const leg_posture& p : posture_.legs)
      lowest = std::min(lowest,
                        std::cos(p.abduction) * foot_in_plane(sim::foot_position(model_, {p.hip, p.knee})).z);
    const double hip_height = -lowest + model_.foot_radius + clearance;

    trunk_ = dBodyCreate(engine_.id());
    dMass box;
    dMassSetBoxTotal(&box, model_.trunk_mass, model_.trunk_length, model_.trunk_width, model_.trunk_height);
    dBodySetMass(trunk_, &box);
    dBodySetPosition(trunk_, model_.trunk_forward_of_hips, 0, hip_height + model_.trunk_above_hips);
    dBodySetLinearVel(trunk_, posture_.trunk_velocity[0], posture_.trunk_velocity[1],
                      posture_.trunk_velocity[2]);
    trunk_shape_ = box_on(trunk_, model_.trunk_length, model_.trunk_width, model_.trunk_height);

    bodies_[0] = trunk_;
    legs_.reserve(leg_count);
    for (std::size_t i = 0; i < leg_count; ++i) {
      const leg_posture& p = posture_.legs[i];
      const vector3 hip{is_front(i) ? model_.hip_x : -model_.hip_x, side_of(i) * model_.hip_y, hip_height};
      const leg& l = legs_.emplace_back(engine_.id(), model_, trunk_, hip, side_of(i), p);
      for (std::size_t k = 0; k < 4; ++k) bodies_[1 + 4 * i + k] = l.bodies()[k];
      feet_[i] = sphere_on(l.toe(), model_.foot_radius);
      knees_[2 * i] = sphere_on(l.middle(), model_.knee_radius, {0, 0, model_.middle_length / 2});
      knees_[2 * i + 1] = sphere_on(l.middle(), model_.ankle_radius, {0, 0, -model_.middle_length / 2});

      leg_motors& motors = state_.motors[i];
      motors.target = {p.hip, p.knee, p.abduction, model_.hip_stiffness};
      motors.former_hip_target = p.hip;
      motors.cable.position = p.knee;
      l.read(state_.reading.legs[i]);
    }
    sense_trunk(velocity(trunk_));
  }

  void accept(const robot_command& command) {
    const auto take = [](double& kept, double wanted, interval range) {
      if (std::isfinite(wanted)) kept = range.clamp(wanted);
    };
    const bool first = state_.commands++ == 0;
    for (std::size_t i = 0; i < leg_count; ++i) {
      leg_motors& motors = state_.motors[i];
      leg_command& target = motors.target;
      motors.former_hip_target = target.hip;
      take(target.hip, command[i].hip, model_.hip_range);
      take(target.knee, command[i].knee, model_.knee_range);
      take(target.abduction, command[i].abduction, model_.abduction_range);
      take(target.hip_stiffness,
           command[i].hip_stiffness < 0 ? target.hip_stiffness : command[i].hip_stiffness,
           {0, model_.stiffest_hip});
      const interval believable{-model_.hip_feed_forward_speed, model_.hip_feed_forward_speed};
      motors.by_law = 0;
      motors.hip_target_speed =
          first ? 0.0 : believable.clamp((target.hip - motors.former_hip_target) / model_.beat());
      motors.cable.aim(target.knee, model_.beat());
    }
  }

  void finish_beat() {
    const vector3 velocity_before = velocity(trunk_);
    for (leg_reading& r : state_.reading.legs) r.foot_force = {};
    for (int i = 0; i < model_.steps_per_beat; ++i) step();
    sense_trunk(velocity_before);
    ++state_.beats;
  }

  void step() {
    for (std::size_t i = 0; i < leg_count; ++i)
      legs_[i].drive(model_, state_.motors[i], state_.reading.legs[i], model_.step);
    dBodyAddForce(trunk_, state_.push[0], state_.push[1], state_.push[2]);

    footing touching;
    for (std::size_t i = 0; i < leg_count; ++i)
      ground_.touch(engine_, feet_[i].get(), state_.feet[i].pressing,
                    [&](dJointID contact, const dContactGeom& place) {
                      touching.add(i, contact, legs_[i].toe(), place);
                    });
    for (const auto& knee : knees_)
      ground_.touch(engine_, knee.get(), [&](dJointID, const dContactGeom&) { ++state_.knee_contacts; });
    bool trunk_down = false;
    ground_.touch(engine_, trunk_shape_.get(), [&](dJointID, const dContactGeom&) { trunk_down = true; });
    state_.trunk_contacts += trunk_down;

    engine_.step(model_.step);

    touching.account(state_, model_);
    dJointGroupEmpty(engine_.contacts());
    for (std::size_t i = 0; i < leg_count; ++i) {
      leg_reading& r = state_.reading.legs[i];
      legs_[i].read(r);
      account(r.hip.torque * r.hip.velocity);
      account(r.abduction.torque * r.abduction.velocity);
      account(r.knee.torque * state_.motors[i].cable.speed);
      state_.pantograph_error = std::max(state_.pantograph_error, std::abs(legs_[i].pantograph_error()));
    }
  }

  void account(double power) {
    state_.positive_work += std::max(0.0, power) * model_.step;
    state_.absolute_work += std::abs(power) * model_.step;
  }

  void sense_trunk(const vector3& velocity_before) {
    trunk_reading& r = state_.reading.trunk;
    const dReal* q = dBodyGetQuaternion(trunk_);
    r.orientation = {q[0], q[1], q[2], q[3]};
    const dReal* w = dBodyGetAngularVel(trunk_);
    const vector3 now = velocity(trunk_);
    vector3 force;
    for (std::size_t k = 0; k < 3; ++k) force[k] = (now[k] - velocity_before[k]) / model_.beat();
    force[2] += model_.gravity;
    r.angular_velocity = in_trunk({w[0], w[1], w[2]});
    r.specific_force = in_trunk(force);
  }

  vector3 in_trunk(const vector3& v) const {
    const dReal* r = dBodyGetRotation(trunk_);
    return {r[0] * v[0] + r[4] * v[1] + r[8] * v[2], r[1] * v[0] + r[5] * v[1] + r[9] * v[2],
            r[2] * v[0] + r[6] * v[1] + r[10] * v[2]};
  }

  static vector3 vector(const dReal* p) { return {p[0], p[1], p[2]}; }
  static double mass_of(dBodyID body) {
    dMass m;
    dBodyGetMass(body, &m);
    return m.mass;
  }
  static vector3 velocity(dBodyID body) { return vector(dBodyGetLinearVel(body)); }

  static constexpr double clearance = 0.001;

  oncilla_model model_;
  terrain terrain_;
  initial_posture posture_;
  engine engine_;
  ground ground_;
  dBodyID trunk_ = nullptr;
  std::vector<leg> legs_;
  std::array<dBodyID, body_count> bodies_{};
  engine_handle<dxGeom> trunk_shape_;
  std::array<engine_handle<dxGeom>, leg_count> feet_;
  std::array<engine_handle<dxGeom>, 2 * leg_count> knees_;
  world_state state_{};
};

}  // namespace cca::sim
