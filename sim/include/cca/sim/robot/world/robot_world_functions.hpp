// The functions of a robot's world that need the engine. robot_world.hpp includes this, unless they are
// compiled once for the program (cca/base/separate/compiled.hpp).
#pragma once

#include <algorithm>
#include <limits>
#include <memory>
#include <span>
#include <string>
#include <utility>

#include <cca/sim/robot/world/robot_world.hpp>
#include <cca/sim/robot/world/world_in_engine.hpp>

namespace cca::sim {

CCA_SIM_INLINE robot_world::robot_world(robot_model model, scene around, const robot_world_settings& settings)
    : in_(world_in_engine::made(std::move(model), std::move(around), settings)) {}
CCA_SIM_INLINE robot_world::robot_world(const robot_world& other)
    : in_(std::make_unique<world_in_engine>(*other.in_)) {}
CCA_SIM_INLINE robot_world::robot_world(robot_world&&) noexcept = default;
CCA_SIM_INLINE robot_world& robot_world::operator=(const robot_world& other) {
  return *this = robot_world(other);
}
CCA_SIM_INLINE robot_world& robot_world::operator=(robot_world&&) noexcept = default;
CCA_SIM_INLINE robot_world::~robot_world() = default;

CCA_SIM_INLINE void robot_world::place(std::span<const double> q, std::span<const double> dq) {
  in_->place(q, dq);
}
CCA_SIM_INLINE void robot_world::place(std::span<const double> q,
                                       std::span<const double> dq,
                                       const moving_frame& base) {
  in_->place(q, dq, base);
}
CCA_SIM_INLINE void robot_world::advance(std::span<const joint_law> laws) { in_->advance(laws); }
CCA_SIM_INLINE void robot_world::set_condition(std::span<const drive_condition> now) {
  in_->set_condition(now);
}
CCA_SIM_INLINE void robot_world::pull(std::size_t part,
                                      const Eigen::Vector3d& force,
                                      const Eigen::Vector3d& torque) {
  in_->pull(part, force, torque);
}
CCA_SIM_INLINE void robot_world::push(const Eigen::Vector3d& force) { in_->push(force); }
CCA_SIM_INLINE void robot_world::follow(const push_plan& plan) { in_->follow(plan); }
CCA_SIM_INLINE void robot_world::move(std::size_t box, const placement& where) { in_->move(box, where); }

CCA_SIM_INLINE double robot_world::ground_height(double x) const {
  constexpr double none = -std::numeric_limits<double>::infinity();
  const scene& s = around();
  return std::max(s.floor.value_or(none), s.ground ? s.ground->height(x) : none);
}

CCA_SIM_INLINE std::string robot_world::trouble_text() const { return text_of(state().trouble, model()); }

CCA_SIM_INLINE moving_frame robot_world::frame(int link) const { return in_->frame(link); }
CCA_SIM_INLINE moving_frame robot_world::end(std::size_t part) const { return in_->end(part); }
CCA_SIM_INLINE Eigen::Vector3d robot_world::ball_position(std::size_t i) const {
  return in_->ball_position(i);
}
CCA_SIM_INLINE Eigen::Vector3d robot_world::ball_velocity(std::size_t i) const {
  return in_->ball_velocity(i);
}
CCA_SIM_INLINE double robot_world::mass() const { return in_->mass(); }
CCA_SIM_INLINE Eigen::Vector3d robot_world::centre_of_mass() const { return in_->centre_of_mass(); }
CCA_SIM_INLINE double robot_world::energy() const { return in_->energy(); }
CCA_SIM_INLINE double robot_world::spring_energy() const { return in_->spring_energy(); }
CCA_SIM_INLINE double robot_world::tension(std::size_t spring) const { return in_->tension(spring); }

CCA_SIM_INLINE const robot_model& robot_world::model() const { return in_->model(); }
CCA_SIM_INLINE const scene& robot_world::around() const { return in_->around(); }
CCA_SIM_INLINE const robot_world_settings& robot_world::settings() const { return in_->settings(); }
CCA_SIM_INLINE const robot_state& robot_world::state() const { return in_->state(); }
CCA_SIM_INLINE robot_state robot_world::save() const { return in_->save(); }
CCA_SIM_INLINE void robot_world::restore(const robot_state& s) { in_->restore(s); }

}  // namespace cca::sim
