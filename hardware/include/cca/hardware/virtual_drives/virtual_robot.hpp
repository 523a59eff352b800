// A robot's drives and sensor board at the far end of its buses. You supply the mechanics of the joints.
//
//   virtual_robot<Bus, Virtual, Board, Joints> far;   // Virtual<Drive>: the virtual drive for each drive
//   far.connect(bus0, ...);
//   far.listen(now);                                  // takes all frames that have come
//   const auto laws = far.laws(now);                  // the control law of each joint, as its drive follows
//   far.tell(motions, board_reading);                 // answers with the state of the mechanics; the reading
//                                                     // of its Board
//
// A frame for which a queue has no room is dropped, as by a real drive. Example:
// examples/hardware_in_the_loop; docs/hardware.md.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <tuple>
#include <utility>

#include <cca/base/messages/holds_or_tells.hpp>
#include <cca/hardware/drives/joint.hpp>
#include <cca/hardware/virtual_drives/virtual_drive.hpp>

namespace cca::hardware {

template <CanBus Bus, template <class> class Virtual, class Board, class Joints>
class virtual_robot;

template <CanBus Bus, template <class> class Virtual, class Board, class... J>
class virtual_robot<Bus, Virtual, Board, joint_list<J...>> {
public:
  static constexpr std::size_t count = sizeof...(J), buses = 1 + std::max({Board::bus, J::bus...});
  using drives_type = std::tuple<Virtual<typename J::drive>...>;
  drives_type drives{};
  std::array<double, 4> abduction{};  // the last targets that the board of an Oncilla received
  bool board_silent = false;

  template <class... Buses>
  void connect(Buses&... all) {
    constexpr bool all_given = sizeof...(Buses) == buses;
    static_assert(
        cca::detail::holds_or_tells<all_given,
                                    detail::other_count_of_buses<sizeof...(Buses), Board, J...>>::value);
    if constexpr (all_given) wires = {&all...};
  }

  // Calls tap(bus, frame) for every frame.
  template <class Tap>
  std::size_t listen(std::int64_t now, Tap tap) {
    std::size_t heard = 0;
    for (std::size_t b = 0; b < buses; ++b)
      for (std::size_t n = inbox.size(); n == inbox.size();) {
        n = wires[b]->receive(inbox);
        for (std::size_t k = 0; k < n; ++k, ++heard) {
          tap(b, inbox[k].frame);
          if constexpr (requires { Board::abducted(inbox[k].frame, abduction); })
            if (b == Board::bus && Board::abducted(inbox[k].frame, abduction)) continue;
          each([&]<std::size_t... I>(std::index_sequence<I...>) {
            ((J::bus == b ? void(std::get<I>(drives).hear(inbox[k].frame, now)) : void()),
             ...);  // some frames are broadcasts
          });
        }
      }
    return heard;
  }
  std::size_t listen(std::int64_t now) {
    return listen(now, [](std::size_t, const can_frame&) {});
  }

  // For each joint, in angle, speed and torque of its axis.
  std::array<drive_command, count> laws(std::int64_t now) {
    return each([&]<std::size_t... I>(std::index_sequence<I...>) {
      return std::array<drive_command, count>{J::from_drive(std::get<I>(drives).law(now))...};
    });
  }

  void tell(const std::array<drive_motion, count>& joints, const typename Board::reading& board) {
    each([&]<std::size_t... I>(std::index_sequence<I...>) {
      (send<J>(std::get<I>(drives).answer({J::drive_angle_of(joints[I].position),
                                           J::drive_speed_of(joints[I].velocity),
                                           J::drive_torque_of(joints[I].torque)})),
       ...);
    });
    if (!board_silent && !Board::traffic.empty()) wires[Board::bus]->send(Board::frames(board, counter++));
  }

private:
  template <class F>
  static decltype(auto) each(F f) {
    return f(std::make_index_sequence<count>());
  }
  template <class One>
  void send(const drive_frames& frames) {
    if (!frames.empty()) wires[One::bus]->send(frames);
  }

  std::array<Bus*, buses> wires{};
  std::array<received_frame, 64> inbox{};
  std::uint8_t counter = 0;
};

}  // namespace cca::hardware
