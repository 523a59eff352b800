// The synchronizer of an Oncilla on CAN: the only node that knows its buses. It reads in `sense` and sends in
// `act`. How it starts, watches and stops the drives is in robot/drive_synchronizer.hpp, with its parameters.
//
//   sense   out one port an axis: robots::oncilla::measured_joint (rad, rad/s, N m), NaN until the drive has
//               reported, and where the report is too old; the nodes after it publish only numbers
//               (oncilla_nodes.hpp)
//           out "trunk"  the sensor board, as robots::oncilla::measured_trunk, NaN likewise
//           out "joints" joint_states for the guards: what is measured, what is wrong, how far the drives are
//   act     in "set_points" of the guards; optional "abduction" targets for the board
//
// The abduction servos move only where the drives may (abduction_gate.hpp). Cost: that of
// drive_synchronizer.hpp. docs/hardware.md.
#pragma once

#include <tuple>
#include <utility>

#include <cca/component/port.hpp>
#include <cca/hardware/oncilla/abduction_gate.hpp>
#include <cca/hardware/oncilla/board_record.hpp>
#include <cca/hardware/oncilla/sensor_board.hpp>
#include <cca/hardware/robot/drive_synchronizer.hpp>
#include <cca/robots/oncilla/former_names.hpp>

namespace cca::hardware {

template <CanBus Bus, class Board, class Joints>
class can_synchronizer;

template <CanBus Bus, class Board, class... J>
class can_synchronizer<Bus, Board, joint_list<J...>>
    : public drive_synchronizer<Bus, Board, joint_list<J...>> {
  using drives = drive_synchronizer<Bus, Board, joint_list<J...>>;

public:
  using joints = joint_list<J...>;

  auto sense(beat now)
      -> std::tuple<out<J::axis::label, robots::oncilla::measured_joint<typename J::axis>>...,
                    out<"trunk", robots::oncilla::measured_trunk>,
                    out<"joints", joint_states<joints>>> {
    this->read(now);
    return drives::each([&]<std::size_t... I>(std::index_sequence<I...>) {
      return decltype(sense(now))(this->measured(I)..., trunk_record_of(this->reading), this->states());
    });
  }

  void act(in<"set_points", set_points<joints>> wanted,
           optional_in<"abduction", robots::oncilla::abduction_angles> abduction) {
    this->send(wanted.vector(), [&](bool runs) {
      if (!runs) abductions.close();
      else if (abduction && abduction.origin() != never)
        this->outbox[Board::bus].add(
            Board::abduct(abductions.pass(abduction.vector(), this->reading.abduction)));
    });
  }

private:
  abduction_gate abductions{};
};

}  // namespace cca::hardware
