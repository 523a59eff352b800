// The synchronizer of a described robot on CAN: the only node that knows its buses. How it starts, watches
// and stops the drives is in drive_synchronizer.hpp, with its parameters.
//
//   sense   out one port an axis: robots::measured_joint<R, Axis> (rad, rad/s, N m), NaN until the drive has
//               reported, and where the report is too old
//           out one port a force sensor, under its name: robots::sensed_load, nothing until the board has
//           sent
//               it. The sensors of R are those of the board, in the same order
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
    : public drive_synchronizer<Bus, Board, joint_list<J...>> {
  using drives = drive_synchronizer<Bus, Board, joint_list<J...>>;

public:
  using joints = joint_list<J...>;

  auto sense() -> std::tuple<out<J::axis::label, robots::measured_joint<R, typename J::axis>>...,
                             maybe<Sensors::name, robots::sensed_load<R, Sensors>>...,
                             out<"joints", joint_states<joints>>> {
    this->read();
    [[maybe_unused]] std::size_t sensor = 0;
    return drives::each([&]<std::size_t... I>(std::index_sequence<I...>) {
      return decltype(sense()){this->measured(I)..., load<Sensors>(sensor++)..., this->states()};
    });
  }

  void act(in<"set_points", set_points<joints>> wanted) {
    this->send(wanted.vector(), [](bool) {});
  }

private:
  template <class Sensor>
  maybe<Sensor::name, robots::sensed_load<R, Sensor>> load(std::size_t i) const {
    const auto& now = this->reading.loads[i];
    if (!(now[0] - now[0] == 0)) return {};
    return typename robots::sensed_load<R, Sensor>::vector_type(Eigen::Matrix<double, 6, 1>::Map(now.data()));
  }
};

}  // namespace cca::hardware
