// cca-can replay: sends a log again, at its pace.
//
// A frame that finds no room is tried again for a second, so all go out in order; then the command fails.
#pragma once

#include <array>
#include <istream>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include <cca/hardware/can_bus.hpp>

#include "../console.hpp"
#include "../log_line.hpp"
#include "../pace.hpp"

namespace cca_can {

struct log_file {
  std::vector<log_line> lines{};
  std::uint64_t errors = 0;   // error frames, which are not sent
  std::uint64_t xl = 0;       // frames of CAN XL, neither
  std::uint64_t missing = 0;  // frames that candump has lost
};

// The longest line that candump writes is a frame of CAN XL with 2048 bytes, and dots between them.
inline constexpr std::size_t longest_line = 8192;

// Throws cca::refused, with the number of the line.
inline log_file read_log(std::istream& in, const std::string& name) {
  log_file log;
  const auto memory = std::make_unique<char[]>(longest_line);
  for (std::uint64_t number = 1; in.getline(memory.get(), longest_line) || in.gcount() > 0; ++number) {
    // Without its end: the number of bytes that were read counts the end of the line, too.
    const std::string text(memory.get(),
                           static_cast<std::size_t>(in.gcount()) - (in.eof() || in.fail() ? 0 : 1));
    if (in.fail())
      throw cca::refused(name + ":" + std::to_string(number) + ": a line of more than " +
                         std::to_string(longest_line - 1) + " bytes: this is no log, in `" +
                         text.substr(0, 80) + "`");
    if (text.find_first_not_of(" \t\r") == text.npos) continue;
    if (is_drop_count(text)) {
      log.missing += dropped_in(text);
      continue;
    }
    log_line line;
    if (const std::string wrong = read_line(text, line); !wrong.empty())
      throw cca::refused(name + ":" + std::to_string(number) + ": " + wrong + ", in `" + text.substr(0, 80) +
                         "`");
    if (line.error) ++log.errors;
    else if (line.xl) ++log.xl;
    else log.lines.push_back(line);
  }
  return log;
}

struct replay_order {
  std::string only{};  // only frames of this interface in the log; empty: it has just one
  double speed = 1;    // times as fast; 0: without pauses
};

template <hw::CanBus Bus>
ending replay(
    Bus& bus, const std::string& name, const log_file& log, const replay_order& o, pace& time, console& say) {
  std::vector<const log_line*> chosen;
  std::set<std::string> names;
  for (const log_line& l : log.lines) {
    names.insert(l.bus);
    if (o.only.empty() || l.bus == o.only) chosen.push_back(&l);
  }
  std::string all;
  for (const std::string& each : names) all += (all.empty() ? "" : ", ") + each;
  if (o.only.empty() && names.size() > 1)
    throw usage_error("the log has several interfaces, " + all + ": choose one by --from");
  if (chosen.empty())
    throw cca::refused("the log has no frame" +
                       (o.only.empty() ? std::string() : " of " + o.only + ", but of " + all));
  if (!say.confirmed("replay " + std::to_string(chosen.size()) + " frames on " + name +
                     ": whatever they moved when they were recorded, they may move again"))
    return not_confirmed;

  const std::int64_t from = time.now(), first = chosen.front()->time;
  std::uint64_t sent = 0;
  std::string wrong;
  for (const log_line* l : chosen) {
    if (o.speed > 0)
      wait_until_end_wanted(time,
                            from + static_cast<std::int64_t>(static_cast<double>(l->time - first) / o.speed));
    hw::send_result r;
    for (const std::int64_t patience = time.now() + 1000 * ms; !time.end_wanted();) {
      r = bus.send({&l->frame, 1});
      if (r.outcome != hw::send_outcome::full || time.now() >= patience) break;
      time.wait_until(time.now() + ms / 5);
      std::array<hw::received_frame, 32> others;
      while (bus.receive(others) == others.size()) {}  // confirmations come this way
    }
    if (time.end_wanted()) break;
    if (r.outcome != hw::send_outcome::sent) {
      wrong = r.outcome == hw::send_outcome::full      ? "the queue stays full: does anybody acknowledge?"
              : r.outcome == hw::send_outcome::invalid ? "this interface takes no " + text_of(l->frame) +
                                                             " (FD frames need `fd on`, vcan `mtu 72`)"
                                                       : "the bus is " + std::string(name_of(bus.state()));
      break;
    }
    ++sent;
  }
  say.error << sent << " of " << chosen.size() << " frames sent\n";
  if (log.errors > 0) say.error << log.errors << " error frames not sent\n";
  if (log.xl > 0) say.error << log.xl << " frames of CAN XL not sent\n";
  if (log.missing > 0) say.error << log.missing << " frames are missing in the log: candump lost them\n";
  if (!wrong.empty()) say.error << "cca-can: " << name << ": " << wrong << '\n';
  return !wrong.empty() ? failed : time.end_wanted() ? interrupted : done;
}

}  // namespace cca_can
