// The synchronizer of a described robot on CAN: the only node that knows its buses. How it starts, watches
// and stops the drives is in drive_synchronizer.hpp, with its parameters.
//
//   sense   out one port an axis: robots::measured_joint<R, Axis> (rad, rad/s, N m), NaN until the drive has
//               reported, and where the report is too old
//           out one port a sensor, under its name: robots::sensed, nothing until the board has sent it. The
//               force sensors of R are those of the board, in the same order; so are the places of the
//               inertial ones, and its inertial units
//           out "joints" joint_states for the guards
//   act     in "set_points" of the guards
//
// Cost: that of drive_synchronizer.hpp.
#pragma once

#include <tuple>
#include <type_traits>
#include <utility>

#include <cca/component/port.hpp>
#include <cca/hardware/robot/drive_synchronizer.hpp>
#include <cca/robots/ports.hpp>

namespace cca::hardware {

template <class R, CanBus Bus, class Board, class Joints, class Sensors = robots::sensors_of<R>>
class robot_synchronizer;

template <class R, CanBus Bus, class Board, class... J, class... Sensors>
class robot_synchronizer<R, Bus, Board, joint_list<J...>, robots::sensors<Sensors...>>
    : public drive_synchronizer<Bus, Board, joint_list<J...>, typename R::rate> {
  using drives = drive_synchronizer<Bus, Board, joint_list<J...>, typename R::rate>;

public:
  using joints = joint_list<J...>;

  auto sense(beat now) -> std::tuple<out<J::axis::label, robots::measured_joint<R, typename J::axis>>...,
                                     maybe<Sensors::name, robots::sensed<R, Sensors>>...,
                                     out<"joints", joint_states<joints>>> {
    this->read(now);
    return drives::each([&]<std::size_t... I>(std::index_sequence<I...>) {
      return decltype(sense(now)){this->measured(I)..., reading_of<Sensors>()..., this->states()};
    });
  }

  void act(in<"set_points", set_points<joints>> wanted) {
    this->send(wanted.vector(), [](bool) {});
  }

private:
  template <class Sensor>
  maybe<Sensor::name, robots::sensed<R, Sensor>> reading_of() const {
    using vector = typename robots::sensed<R, Sensor>::vector_type;
    const auto& numbers = numbers_of<Sensor>();
    if (!(numbers[0] - numbers[0] == 0)) return {};
    return vector(vector::Map(numbers.data()));
  }
  template <class Sensor>
  const auto& numbers_of() const {
    using all = robots::sensors<Sensors...>;
    if constexpr (Sensor::kind == robots::sensor_kind::load) {
      return this->reading.loads[robots::detail::place_among_loads<Sensor>(all())];
    } else {
      return robots::detail::share_of<Sensor>(this->reading.inertial[robots::detail::unit_of<Sensor>(all())]);
    }
  }
};

}  // namespace cca::hardware
