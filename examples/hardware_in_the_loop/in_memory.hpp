#pragma once
// Robot and far end in one process, on five buses in memory: the controller at one end, virtual drives around
// the simulated Oncilla at the other, and a third node on each bus for spies and intruders.
#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <utility>

#include <cca/cca.hpp>
#include <cca/hardware/robot/shut_down.hpp>
#include <cca/hardware/virtual_hardware.hpp>

#include "../trot/architecture.hpp"
#include "mechanics.hpp"
#include "robot.hpp"

namespace hil {

using memory_end = hw::virtual_bus_end;

// The trot, with one type changed. [trot]
struct trot_on_drives : trot::architecture<oncilla<memory_end>> {};
// [trot end]

// How an operator sets the robot on its feet, rad. Its knees are straighter than those of the trot: until
// its drives are on, nothing holds it, and the springs extend knees that are flexed so far faster than their
// axes allow, which refuses the start.
struct stance {
  double hip, knee;
};
inline constexpr stance front_stance{trot::degrees(45.5), trot::degrees(93.2)},
    hind_stance{trot::degrees(36.1), trot::degrees(87.0)};

// `beyond`: rad, added to each joint.
inline cca::sim::world put_down(const std::array<double, 8>& beyond = {}) {
  cca::sim::initial_posture posture;
  for (std::size_t leg = 0; leg < axes::leg_count; ++leg) {
    const stance& at = axes::is_front(leg) ? front_stance : hind_stance;
    posture.legs[leg] = {at.hip + beyond[axes::hip_of(leg)], at.knee + beyond[axes::knee_of(leg)], 0};
  }
  return cca::sim::world(cca::sim::terrain::flat(), posture);
}

// The buses and what is behind them: virtual drives, the simulated Oncilla, and what programs ask of them.
template <class Robot, template <class> class Virtual = virtual_damiao>
class memory_buses_of : public hw::virtual_hardware<Robot, mechanics, Virtual> {
  using behind = hw::virtual_hardware<Robot, mechanics, Virtual>;

public:
  // `one_shot`: a frame is sent once, without retries, as docs/hardware.md asks for. `answering`: the time in
  // a beat at which the far end answers, ns.
  explicit memory_buses_of(std::span<const hw::bus_fault> script = {},
                           bool one_shot = true,
                           std::int64_t answering = behind::beat / 2)
      : behind({.one_shot = one_shot, .seed = 1, .script = script}) {
    this->answers_at = answering;
    this->plant.put_down(hil::put_down());
  }

  // A controller that has the robot at "robot".
  template <class Controller>
  void connect(Controller& controller) {
    behind::connect(controller.template get<"robot.synchronizer">());
  }

  // The drives' reaction to what the controller has sent.
  void pass_millisecond() { behind::step(); }

  // Stops the robot in order. The drives go on answering meanwhile.
  template <class Controller>
  hw::shut_down_report shut_down(Controller& controller) {
    return hw::shut_down(controller, this->pace());
  }

  // Whether no drive holds anything: what the drives do, not what the controller knows of them.
  bool are_free() const {
    return std::ranges::none_of(this->laws,
                                [](const auto& law) { return law.stiffness > 0 || law.damping > 0; });
  }

  // For programs that put the robot down and push it.
  const cca::sim::world& world() const { return this->plant.world; }
  void put_down(cca::sim::world&& w, const cca::sim::disturbance& d) {
    this->plant.put_down(std::move(w));
    disturb(d);
  }
  void push(const Eigen::Vector3d& force) { this->plant.world.push(force); }
  void disturb(const cca::sim::disturbance& d) { this->plant.disturbance = d; }
};

using memory_buses = memory_buses_of<oncilla<memory_end>>;

// The same with a controller, for programs that run it themselves. `Architecture` has the robot at "robot".
// Of a deployment, `Controller` is cca::deployed<Architecture>: the buses are used by the thread that calls
// `step` or `run`, so "robot" belongs into the first environment.
template <class Architecture = trot_on_drives,
          class Controller = cca::controller<Architecture>,
          class Buses = memory_buses>
class in_memory : public Buses {
public:
  explicit in_memory(std::span<const hw::bus_fault> script = {},
                     bool one_shot = true,
                     std::int64_t answering = Buses::beat / 2)
      : Buses(script, one_shot, answering) {
    this->connect(controller);
  }

  // One millisecond: the controller's beat, unless it stands still, then the drives' reaction.
  bool step(bool controller_runs = true) {
    const bool stepped = controller_runs && controller.step();
    this->pass_millisecond();
    return stepped;
  }

  // As many of them; ends on a fault, and where `between` returns false.
  template <class Between>
  void run(std::int64_t beats, Between between) {
    controller.run(cca::for_some_beats{beats}, this->pace(), between);
    this->pass_millisecond();
  }

  hw::shut_down_report shut_down() { return Buses::shut_down(controller); }

  // A new controller, as if the program were started again.
  void restart_program() {
    controller = {};
    this->connect(controller);
  }

  Controller controller{};
};

}  // namespace hil
