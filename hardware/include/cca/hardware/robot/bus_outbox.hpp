// The buses of a robot, and what goes out on each of them in a beat.
//
//   connect({&bus0, ...})     the buses, which must outlive it
//   clear(), add(bus, frames) the batch of this beat
//   moves[bus]                the batch follows the controller; else its frames damp, disable or ask
//   send()                    one batch a bus, with the frames that end a cycle (SYNC)
//   let_pass()                before frames that must go out after whatever still waits: those of a stop
//   is_free(bus)              it is there and holds no frames
//   has_sent[bus]             the last send() put frames on it
//
// Behind frames that still wait, a set point would be stale: it is dropped and counted. Only frames that damp
// may go after frames that move, once: so they come last. Used by drive_synchronizer.hpp.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>

#include <cca/base/refused.hpp>
#include <cca/hardware/bus/can_bus.hpp>
#include <cca/hardware/robot/joint_frames.hpp>
#include <cca/hardware/safety/link_supervisor.hpp>

namespace cca::hardware {

template <CanBus Bus, std::size_t Buses, class... J>
class bus_outbox {
public:
  static constexpr std::size_t most_frames = 8 * sizeof...(J) + 1 + 4;
  using batch = frame_list<most_frames>;

  std::array<link_supervisor<3>, Buses> links{};
  std::array<bool, Buses> moves{}, has_sent{};

  // Refuses one bus for two numbers: the first would take the frames of both.
  void connect(const std::array<Bus*, Buses>& all) {
    for (std::size_t b = 0; b < Buses; ++b)
      for (std::size_t a = 0; a < b; ++a)
        if (all[a] == all[b])
          throw refused("robot.drives: bus " + std::to_string(a) + " and bus " + std::to_string(b) +
                        " that are connected are the same bus: connect one for each number, or give the "
                        "joints on it one number");
    ends = all;
  }
  Bus* end(std::size_t b) const { return ends[b]; }

  void clear() {
    std::ranges::for_each(batches, &batch::clear);
    moves = {};
  }
  batch& operator[](std::size_t b) { return batches[b]; }
  template <class Frames>
  void add(std::size_t b, const Frames& frames) {
    for (std::size_t k = 0; k < frames.size(); ++k) batches[b].add(frames[k]);
  }

  void send() {
    for (std::size_t b = 0; b < Buses; ++b) {
      has_sent[b] = false;
      if (!ends[b] || batches[b].empty() || !links[b].may_speak()) continue;
      add(b, cycle_end_frames[b]);
      const bool too_late = ends[b]->in_flight() != 0 && (moves[b] || !moved[b]);
      const send_result sent = too_late ? send_result{0, send_outcome::full} : ends[b]->send(batches[b]);
      has_sent[b] = sent.sent != 0;
      if (has_sent[b]) moved[b] = moves[b];
      if (links[b].may_move()) links[b].sent(sent);
    }
  }
  void let_pass() { moved.fill(true); }

  bool is_free(std::size_t b) const {
    return ends[b] && !is_away(ends[b]->state()) && ends[b]->in_flight() == 0;
  }
  bool are_all_free() const {
    for (std::size_t b = 0; b < Buses; ++b)
      if (!is_free(b)) return false;
    return true;
  }

private:
  static constexpr auto cycle_end_frames = cycle_ends<Buses, J...>();

  std::array<Bus*, Buses> ends{};
  std::array<batch, Buses> batches{};
  std::array<bool, Buses> moved{};  // whether the last batch that was sent followed the controller
};

}  // namespace cca::hardware
