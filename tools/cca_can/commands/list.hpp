// cca-can list: which drives are on a bus. It listens first; with --ask it then asks the numbers of a family.
//
// The questions (`ask` in drives/addresses.hpp) can't move a motor; some take its torque away. A number is
// not asked if somebody sends to such a drive, or if another frame was heard under its id: a frame can mean
// different things to different families.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "../console.hpp"
#include "../drives/drive_name.hpp"
#include "../log_line.hpp"
#include "../drives/talk.hpp"

namespace cca_can {

struct list_order {
  std::vector<std::string> ask{};  // families
  std::uint32_t first = 1, last = 16;
  double listen = 0.5;  // s
};

struct found_drive {
  std::string name, tells;
};

namespace detail {

struct heard {
  hw::can_frame last{};
  int count = 0;
};
// By id, 29-bit ids last.
using heard_frames = std::map<std::uint64_t, heard>;
constexpr std::uint64_t key_of(hw::can_id i) { return std::uint64_t{i.extended} << 32 | i.number; }

template <hw::CanBus Bus, class F>
void listen(Bus& bus, pace& time, std::int64_t duration, F&& each) {
  for (const std::int64_t end = time.now() + duration; time.now() < end && !time.end_wanted();) {
    time.wait_until(std::min(end, time.now() + 2 * ms));
    std::array<hw::received_frame, 32> frames;
    for (std::size_t n = frames.size(); n == frames.size();) {
      n = bus.receive(frames);
      for (std::size_t i = 0; i < n; ++i) each(frames[i].frame);
    }
  }
}

// Drives that report by themselves.
inline void found_by_heartbeat(const hw::can_frame& f, std::vector<found_drive>& all) {
  constexpr std::uint8_t most_odrive_state = 14;
  if ((f.id.number & 31) == 1 && f.length == 8 && !f.fd && !f.remote && f.data[4] <= most_odrive_state) {
    const std::uint32_t node = f.id.number >> 5;
    hw::drive_report r;
    const std::string name = "odrive:" + std::to_string(node);
    if ((node > 63) == f.id.extended && drive_named(name)->decode(f, r)) all.push_back({name, text_of(r)});
  }
  if (!f.id.extended && f.id.number > 0x700 && f.id.number <= 0x77F && f.length == 1 && !f.fd && !f.remote) {
    const char* state = f.data[0] == 0      ? "boots"
                        : f.data[0] == 4    ? "stopped"
                        : f.data[0] == 5    ? "operational"
                        : f.data[0] == 0x7F ? "pre-operational"
                                            : nullptr;
    if (state)
      all.push_back({"cia402:" + std::to_string(f.id.number & 0x7F), std::string("heartbeat: ") + state});
  }
}

// An MIT drive says its number in the first byte; length and first byte show the firmware.
inline bool is_mit_answer(const hw::can_frame& f, std::uint32_t number) {
  return !f.id.extended && !f.fd && !f.remote && f.id.number != number && (f.length == 6 || f.length == 8) &&
         (f.data[0] == number || (number < 16 && f.length == 8 && (f.data[0] & 0xF) == number));
}

}  // namespace detail

// The drives that were found; `say` gets the reason why something was not asked.
template <hw::CanBus Bus>
std::vector<found_drive> drives_on(Bus& bus, const list_order& o, pace& time, console& say) {
  std::vector<found_drive> all;
  detail::heard_frames heard;
  detail::listen(bus, time, static_cast<std::int64_t>(o.listen * 1e9), [&](const hw::can_frame& f) {
    detail::heard& h = heard[detail::key_of(f.id)];
    h.last = f;
    ++h.count;
  });
  for (const auto& [id, h] : heard) detail::found_by_heartbeat(h.last, all);

  for (const std::string& family : o.ask) {
    const bool mit = family == "mit";
    for (std::uint32_t number = o.first; number <= o.last && !time.end_wanted(); ++number) {
      const auto drive = drive_named(family + ":" + std::to_string(number), false);
      const hw::drive_frames question = drive->ask();
      if (const auto at = heard.find(detail::key_of(question[0].id)); at != heard.end()) {
        say.out << "  " << drive->text << "  not asked: someone sends under its id, "
                << text_of(at->second.last) << '\n';
        continue;
      }
      if (bus.send(question).outcome == hw::send_outcome::invalid) {
        say.error << "cca-can: " << family << " drives speak CAN FD, and this interface does not\n";
        return all;
      }
      std::string answer;
      detail::listen(bus, time, 10 * ms, [&](const hw::can_frame& f) {
        if (!answer.empty() || heard.contains(detail::key_of(f.id))) return;
        hw::drive_report r;
        if (mit ? detail::is_mit_answer(f, number) : drive->is_from(f)) {
          answer = "answers " + text_of(f);
          if (!mit && drive->decode(f, r)) answer += "  " + text_of(r);
        }
      });
      if (!answer.empty()) all.push_back({drive->text, answer});
      if (is_away(bus.state())) return all;
    }
  }
  return all;
}

template <hw::CanBus Bus>
ending list(Bus& bus, const list_order& o, pace& time, console& say) {
  const auto all = drives_on(bus, o, time, say);
  for (const found_drive& d : all) say.out << "  " << d.name << "  " << d.tells << '\n';
  if (is_away(bus.state())) {
    say.error << "cca-can: the bus is " << name_of(bus.state()) << '\n';
    return failed;
  }
  if (bus.in_flight() > 0)
    say.out << "  nobody acknowledges: is anything on this bus powered, at this bit rate?\n";
  if (all.empty())
    say.out << "  no drive "
            << (o.ask.empty() ? "reports by itself; --ask mit,moteus,robstride,cia402 asks\n" : "answers\n");
  return all.empty() ? failed : done;
}

}  // namespace cca_can
