// The synchronizer of a described robot on CAN: the only node that knows its buses. How it starts, watches
// and stops the drives is in drive_synchronizer.hpp, with its parameters.
//
//   sense   out one port an axis: robots::measured_joint<R, Axis> (rad, rad/s, N m), NaN until the drive has
//               reported, and where the report is too old. Of an axis that a servo of the board moves, the
//               angle that the board has sent last; the rest is NaN
//           out one port a sensor, under its name: robots::sensed, nothing until the board has sent it. The
//               sensors of R are those of the board (boards/board_facts.hpp), in the same order
//           out "joints" joint_states for the guards
//   act     in "set_points" of the guards; of an axis that a servo moves, what its joint wants, under its name
//
// The servos follow positions. They move only where the drives may (servo_gate.hpp); before a first command
// comes the board keeps them where they are. Cost: that of drive_synchronizer.hpp.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>
#include <type_traits>
#include <utility>

#include <cca/component/port.hpp>
#include <cca/hardware/robot/boards/board_facts.hpp>
#include <cca/hardware/robot/drive_synchronizer.hpp>
#include <cca/hardware/robot/servo_gate.hpp>
#include <cca/robots/commanded_joint.hpp>
#include <cca/robots/ports.hpp>

namespace cca::hardware {

namespace detail {

template <class R, CanBus Bus, class Board, class Joints, class Sensors, class Servos>
class robot_synchronizer_of;

template <class R, CanBus Bus, class Board, class... J, class... Sensors, class... Servos>
class robot_synchronizer_of<R, Bus, Board, joint_list<J...>, robots::sensors<Sensors...>, axes<Servos...>>
    : public drive_synchronizer<Bus, Board, joint_list<J...>, typename R::rate> {
  using drives = drive_synchronizer<Bus, Board, joint_list<J...>, typename R::rate>;

public:
  using joints = joint_list<J...>;
  using servo_axes = axes<Servos...>;

  auto sense(beat now) -> std::tuple<out<J::axis::label, robots::measured_joint<R, typename J::axis>>...,
                                     out<Servos::label, robots::measured_joint<R, Servos>>...,
                                     maybe<Sensors::name, robots::sensed<R, Sensors>>...,
                                     out<"joints", joint_states<joints>>> {
    this->read(now);
    return drives::each([&]<std::size_t... I>(std::index_sequence<I...>) {
      return decltype(sense(now)){this->measured(I)..., servo<Servos>()..., reading_of<Sensors>()...,
                                  this->states()};
    });
  }

  void act(in<"set_points", set_points<joints>> wanted,
           in<Servos::label, robots::wanted_joint<R, Servos>>... targets) {
    this->send(wanted.vector(), [&]([[maybe_unused]] bool runs) {
      if constexpr (sizeof...(Servos) != 0)
        move_servos({robots::commands_of(targets.vector())[robots::command_kind::position]...}, runs);
    });
  }

private:
  using angles = std::array<double, sizeof...(Servos)>;

  template <class Axis>
  Eigen::Vector3d servo() const {
    constexpr double none = drive_report::untold;
    return {this->reading.abduction[static_cast<std::size_t>(servo_axes::template index_of<Axis>)], none,
            none};
  }
  void move_servos(const angles& targets, bool runs) {
    const bool any_came = !std::ranges::all_of(targets, [](double target) { return std::isnan(target); });
    if (!runs) servos.close();
    else if (any_came)
      this->outbox[Board::bus].add(Board::abduct(servos.pass(targets, this->reading.abduction)));
  }

  template <class Sensor>
  maybe<Sensor::name, robots::sensed<R, Sensor>> reading_of() const {
    using vector = typename robots::sensed<R, Sensor>::vector_type;
    const auto& numbers = numbers_of<Sensor, robots::sensors<Sensors...>>(this->reading);
    if (!(numbers[0] - numbers[0] == 0)) return {};
    return vector(vector::Map(numbers.data()));
  }

  [[no_unique_address]] servo_gate<servo_axes, typename R::rate> servos{};
};

}  // namespace detail

template <class R, CanBus Bus, class Board, class Joints>
class robot_synchronizer
    : public detail::
          robot_synchronizer_of<R, Bus, Board, Joints, robots::sensors_of<R>, detail::servo_axes_of<Board>> {
};

}  // namespace cca::hardware
