#pragma once
// Robot and far end in one process, on five buses in memory: the controller at one end, virtual drives around
// the simulated Oncilla at the other, and a third node on each bus for spies and intruders.
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>

#include <cca/cca.hpp>
#include <cca/hardware/memory_bus.hpp>
#include <cca/hardware/robot/shut_down.hpp>

#include "../trot/architecture.hpp"
#include "mechanics.hpp"
#include "robot.hpp"

namespace hil {

using wire = cca::hardware::memory_bus<3, 8>;
using memory_end = wire::end_type;

// The trot, with one type changed. [trot]
struct trot_on_drives : trot::architecture<oncilla<memory_end>> {};
// [trot end]

// The posture around which the gait swings. `beyond`: rad, added to each joint.
inline cca::sim::world put_down(const std::array<double, 8>& beyond = {}) {
  const trot::gait g;
  cca::sim::initial_posture posture;
  for (std::size_t leg = 0; leg < axes::leg_count; ++leg) {
    const trot::leg_shape& shape = axes::is_front(leg) ? g.p.front : g.p.hind;
    posture.legs[leg] = {shape.hip + beyond[axes::hip_of(leg)], shape.knee + beyond[axes::knee_of(leg)], 0};
  }
  return cca::sim::world(cca::sim::terrain::flat(), posture);
}

// The buses and what is behind them: `Far`, the far side of a robot. Neither copied nor moved: its parts
// point to one another.
template <class Far>
class memory_buses_of {
public:
  static constexpr std::int64_t beat = 1'000'000;

  // `one_shot`: a frame is sent once, without retries, as docs/hardware.md asks for. `answering`: the time in
  // a beat at which the far end answers, ns.
  explicit memory_buses_of(std::span<const cca::hardware::bus_fault> script = {},
                           bool one_shot = true,
                           std::int64_t answering = beat / 2)
      : answers_at(answering),
        wires{made(script, one_shot, 1), made(script, one_shot, 2), made(script, one_shot, 3),
              made(script, one_shot, 4), made(script, one_shot, 5)} {
    far.connect(ends[0], ends[1], ends[2], ends[3], ends[4]);
  }
  memory_buses_of(const memory_buses_of&) = delete;
  memory_buses_of& operator=(const memory_buses_of&) = delete;

  // A controller that has the robot at "robot".
  template <class Controller>
  void connect(Controller& controller) {
    controller.template get<"robot.synchronizer">().connect(near[0], near[1], near[2], near[3], near[4]);
  }

  // The drives' reaction to what the controller has sent, in one millisecond.
  void pass_millisecond() {
    const std::int64_t heard = now + answers_at;
    go_to(heard);
    far.listen(heard);
    laws = far.laws(heard);
    robot.advance(laws, far.abduction);
    auto motions = robot.joints();
    for (std::size_t i = 0; i < motions.size(); ++i) motions[i].velocity *= speed_scale[i];
    far.tell(motions, robot.board());
    now += beat;
    go_to(now - 1);
  }

  // Stops the robot in order. The drives go on answering meanwhile.
  template <class Controller>
  cca::hardware::shut_down_report shut_down(Controller& controller) {
    return cca::hardware::shut_down(controller, drives_reaction{*this});
  }

  // Whether no drive holds anything: what the drives do, not what the controller knows of them.
  bool are_free() const {
    return std::ranges::none_of(laws, [](const auto& law) { return law.stiffness > 0 || law.damping > 0; });
  }

  // For programs that put the robot down and push it.
  const cca::sim::world& world() const { return robot.world; }
  void put_down(cca::sim::world&& w, const cca::sim::disturbance& d) {
    robot.put_down(std::move(w));
    robot.disturbance = d;
  }
  void disturb(const cca::sim::disturbance& d) { robot.disturbance = d; }

  std::int64_t answers_at;
  std::array<wire, buses> wires;
  Far far{};
  mechanics robot{hil::put_down()};
  std::array<cca::hardware::drive_command, 8> laws{};         // of the drives in the last beat
  std::array<double, 8> speed_scale{1, 1, 1, 1, 1, 1, 1, 1};  // of the velocities that the drives report
  std::int64_t now = 0;

private:
  // The pace of shut_down: what the drives do between two beats.
  struct drives_reaction {
    memory_buses_of& run;
    void begin() const {}
    void wait(std::int64_t) const { run.pass_millisecond(); }
  };

  static wire made(std::span<const cca::hardware::bus_fault> script, bool one_shot, std::uint64_t seed) {
    return wire({.rates = {1'000'000}, .one_shot = one_shot, .seed = seed, .script = script});
  }
  void go_to(std::int64_t time) {
    for (auto& w : wires) w.advance(time);
  }
  std::array<memory_end, buses> near{wires[0].end(0), wires[1].end(0), wires[2].end(0), wires[3].end(0),
                                     wires[4].end(0)};
  std::array<memory_end, buses> ends{wires[0].end(1), wires[1].end(1), wires[2].end(1), wires[3].end(1),
                                     wires[4].end(1)};
};

using memory_buses = memory_buses_of<far_side<memory_end>>;

// The same with a controller, for programs that run it themselves. `Architecture` has the robot at "robot".
// Of a deployment, `Controller` is cca::deployed<Architecture>: the buses are used by the thread that calls
// `step` or `run`, so "robot" belongs into the first environment.
template <class Architecture = trot_on_drives,
          class Controller = cca::controller<Architecture>,
          class Far = far_side<memory_end>>
class in_memory : public memory_buses_of<Far> {
  using behind = memory_buses_of<Far>;

public:
  explicit in_memory(std::span<const cca::hardware::bus_fault> script = {},
                     bool one_shot = true,
                     std::int64_t answering = behind::beat / 2)
      : behind(script, one_shot, answering) {
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
    controller.run(cca::for_some_beats{beats}, time_of_drives{*this}, between);
    this->pass_millisecond();
  }

  cca::hardware::shut_down_report shut_down() { return behind::shut_down(controller); }

  // A new controller, as if the program were started again.
  void restart_program() {
    controller = {};
    this->connect(controller);
  }

  Controller controller{};

private:
  // A pace: between two beats of a run a millisecond passes.
  struct time_of_drives {
    in_memory& all;
    void begin() const {}
    void wait(std::int64_t since) const {
      if (since > 0) all.pass_millisecond();
    }
  };
};

}  // namespace hil
