// From the words of a command line to a command. `open(name, fd)` opens a bus.
#pragma once

#include <fstream>
#include <iostream>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "commands/calibrate.hpp"
#include "drives/drive_name.hpp"
#include "commands/enable.hpp"
#include "commands/help.hpp"
#include "in_memory.hpp"
#include "commands/interfaces.hpp"
#include "commands/jog.hpp"
#include "commands/list.hpp"
#include "commands/pretend.hpp"
#include "commands/record.hpp"
#include "commands/replay.hpp"
#include "commands/watch.hpp"
#include "words.hpp"

namespace cca_can {

namespace detail {

struct bus_name {
  std::string name;
  bool fd = false;
};
inline bus_name bus_named(const std::string& text) {
  auto parts = split(text, ',');
  if (parts.size() > 2 || (parts.size() == 2 && parts[1] != "fd"))
    throw usage_error("a bus is named as can0, or can0,fd");
  return {parts[0], parts.size() == 2};
}
inline bus_name bus_in(words& w) { return bus_named(w.needed_next("the name of the bus, as can0,")); }

inline std::vector<std::string> drive_texts(words& w) {
  std::vector<std::string> all{w.needed_next("the drive, as mit:ak80-9:3,")};
  while (auto one = w.next()) all.push_back(*one);
  return all;
}

inline double seconds_in(words& w) {
  return w.number("--seconds", "seconds, 0 without end", 0, 1e6).value_or(0);
}

inline pretend_order pretend_in(words& w) {
  pretend_order o{.seconds = seconds_in(w)};
  o.silent_at = w.number("--silent-at", "seconds", 0, 1e6);
  o.silent_for = w.number("--silent-for", "seconds, 0 for good", 0, 1e6).value_or(0);
  o.fault_at = w.number("--fault-at", "seconds", 0, 1e6);
  if (o.fault_at)
    o.code = static_cast<std::uint32_t>(
        w.needed_number("--code", "the firmware's number of a fault", 1, 4294967295.0));
  o.load = w.number("--load", "N m", -1e3, 1e3).value_or(0);
  return o;
}

inline list_order list_in(words& w) {
  list_order o;
  o.listen = w.number("--listen", "seconds", 0, 3600).value_or(o.listen);
  if (const auto ask = w.option("--ask")) {
    o.ask = split(*ask, ',');
    for (const std::string& family : o.ask)
      if (family != "mit" && family != "moteus" && family != "robstride" && family != "cia402")
        throw usage_error("--ask " + *ask +
                          ": expected some of mit, moteus, robstride, cia402; an ODrive reports by itself");
  }
  if (const auto ids = w.option("--ids")) {
    const auto ends = split(*ids, '-');
    const auto first = number_in(ends.front()), last = number_in(ends.back());
    if (ends.size() > 2 || !first || !last || !(*first >= 1 && *first <= *last && *last <= 127))
      throw usage_error("--ids " + *ids + ": expected numbers from 1 to 127, as 1-16");
    o.first = static_cast<std::uint32_t>(*first), o.last = static_cast<std::uint32_t>(*last);
  }
  return o;
}

inline jog_order jog_in(words& w) {
  jog_order o;
  constexpr double far = 1e4;
  const auto range = w.option("--range");
  if (!range)
    throw usage_error("--range is missing: the angles that the drive may be at, in rad, as -0.2,0.2");
  const auto ends = split(*range, ',');
  const auto low = number_in(ends.front()), high = number_in(ends.back());
  if (ends.size() != 2 || !low || !high || !(*low < *high))
    throw usage_error("--range " + *range + ": expected two angles in rad, the lower one first, as -0.2,0.2");
  o.limits.low = *low, o.limits.high = *high;
  o.limits.speed = w.needed_number("--speed", "rad/s, as 0.5", 1e-3, 20);
  o.limits.torque = w.needed_number("--torque", "N m, as 0.5", 1e-2, 100);
  o.limits.stiffness = w.number("--stiffness", "N m/rad", 1e-2, 500).value_or(o.limits.torque / 0.1);
  o.limits.damping =
      w.number("--damping", "N m s/rad", 0, 100).value_or(0.2 * o.limits.torque / o.limits.speed);
  o.hold = w.number("--hold", "seconds", 0, 3600).value_or(o.hold);
  const auto to = w.number("--to", "rad", -far, far), by = w.number("--by", "rad", -far, far);
  if (to.has_value() == by.has_value())
    throw usage_error("jog needs either --to, an angle of the drive in rad, or --by");
  o.relative = by.has_value();
  o.goal = to ? *to : *by;
  if (to && !(*to >= *low && *to <= *high))
    throw usage_error("--to " + std::to_string(*to) + " lies outside of --range " + *range);
  return o;
}

inline calibrate_order calibrate_in(words& w) {
  calibrate_order o;
  const auto joint = w.option("--joint"), file = w.option("--file"), node = w.option("--node");
  if (!joint) throw usage_error("--joint is missing: one of " + joint_list_text());
  if (!file) throw usage_error("--file is missing: the file of offsets, as offsets.toml");
  o.joint = joint_named(*joint);
  o.file = *file;
  if (node) o.node = *node;
  o.at = w.needed_number("--at", "the angle in rad at which the joint stands", -10, 10);
  o.mounted.gear = w.number("--gear", "turns of the drive for one of the joint", 1e-3, 1e3).value_or(1);
  o.mounted.sign = w.number("--sign", "1 or -1", -1, 1).value_or(1);
  if (std::abs(o.mounted.sign) != 1) throw usage_error("--sign: expected 1 or -1");
  o.mounted.offset = w.number("--offset", "rad", -10, 10).value_or(0);
  return o;
}

}  // namespace detail

template <class Open>
ending run_command(words& w, Open open, pace& time, console& say) {
  const std::string& command = w.command();
  const auto drive_in = [&w] { return drive_named(w.needed_next("the drive, as mit:ak80-9:3,")); };
  const auto bus_of = [&open](const detail::bus_name& b, const any_drive* d = nullptr) {
    return open(b.name, b.fd || (d && d->needs_fd));
  };

  if (command == "help") {
    w.nothing_left();
    say.out << help_text;
    return done;
  }
  if (command == "list") {
    const list_order o = detail::list_in(w);
    const auto name = w.next();
    w.nothing_left();
    const auto interfaces =
        name && detail::bus_named(*name).name == bus_in_memory ? std::vector<bus_info>() : can_interfaces();
    if (!name) {
      for (const bus_info& b : interfaces) say.out << text_of(b) << '\n';
      if (interfaces.empty())
        say.out << "this machine has no CAN interface: is the adapter there, its driver loaded?\n";
      return interfaces.empty() ? failed : done;
    }
    const detail::bus_name b = detail::bus_named(*name);
    bool fd = b.fd;
    for (const bus_info& each : interfaces)
      if (each.name == b.name) say.out << text_of(each) << '\n', fd = each.fd;
    auto bus = open(b.name, fd);
    return list(bus, o, time, say);
  }
  if (command == "watch") {
    const bool ask = w.flag("--ask");
    const double seconds = detail::seconds_in(w);
    const detail::bus_name b = detail::bus_in(w);
    std::vector<std::unique_ptr<any_drive>> drives;
    bool fd = b.fd;
    for (const std::string& each : detail::drive_texts(w))
      drives.push_back(drive_named(each)), fd = fd || drives.back()->needs_fd;
    w.nothing_left();
    auto bus = open(b.name, fd);
    return watch(bus, drives, ask, seconds, time, say);
  }
  if (command == "enable") {
    const double seconds = detail::seconds_in(w);
    const detail::bus_name b = detail::bus_in(w);
    const auto drive = drive_in();
    w.nothing_left();
    auto bus = bus_of(b, drive.get());
    return enable(bus, b.name, *drive, seconds, time, say);
  }
  if (command == "jog") {
    const jog_order o = detail::jog_in(w);
    const detail::bus_name b = detail::bus_in(w);
    const auto drive = drive_named(w.needed_next("the drive, as mit:ak80-9:3,"), true, true);
    w.nothing_left();
    auto bus = bus_of(b, drive.get());
    return jog(bus, b.name, *drive, o, time, say);
  }
  if (command == "calibrate") {
    const calibrate_order o = detail::calibrate_in(w);
    const detail::bus_name b = detail::bus_in(w);
    const auto drive = drive_in();
    w.nothing_left();
    auto bus = bus_of(b, drive.get());
    return calibrate(bus, b.name, *drive, o, time, say);
  }
  if (command == "record") {
    record_order o;
    o.seconds = detail::seconds_in(w);
    o.frames = static_cast<std::uint64_t>(w.number("--frames", "a number of frames", 1, 1e12).value_or(0));
    const auto file = w.option("--file");
    const detail::bus_name b = detail::bus_in(w);
    w.nothing_left();
    auto bus = bus_of(b);
    if (!file || *file == "-") return record(bus, b.name, o, say.out, time, say);
    if (std::filesystem::exists(*file) &&
        !say.confirmed(*file + " is there already, and would be overwritten"))
      return not_confirmed;
    std::ofstream out(*file);
    if (!out) cca::detail::refuse_file(*file, "cannot be written", errno);
    return record(bus, b.name, o, out, time, say);
  }
  if (command == "replay") {
    replay_order o;
    if (const auto from = w.option("--from")) o.only = *from;
    o.speed = w.number("--speed", "times as fast as it was", 1e-3, 1e3).value_or(1);
    if (w.flag("--fast")) o.speed = 0;
    const detail::bus_name b = detail::bus_in(w);
    const std::string file = w.needed_next("the log");
    w.nothing_left();
    std::ifstream in(file);
    if (!in) cca::detail::refuse_file(file, "cannot be read", errno);
    const log_file log = read_log(in, file);
    bool fd = b.fd;
    for (const log_line& l : log.lines) fd = fd || l.frame.fd;
    auto bus = open(b.name, fd);
    return replay(bus, b.name, log, o, time, say);
  }
  if (command == "pretend") {
    const pretend_order o = detail::pretend_in(w);
    const detail::bus_name b = detail::bus_in(w);
    std::vector<std::unique_ptr<any_virtual>> drives;
    bool fd = b.fd;
    for (const std::string& each : detail::drive_texts(w))
      drives.push_back(virtual_named(each)), fd = fd || each.starts_with("moteus");
    w.nothing_left();
    if (!b.name.starts_with("vcan") && !say.confirmed("On " + b.name +
                                                      " this answers instead of drives: a "
                                                      "controller there takes its answers for the robot's."))
      return not_confirmed;
    auto bus = open(b.name, fd);
    return pretend(bus, drives, o, time);
  }
  throw usage_error("there is no command `" + command + "`; see `cca-can help`");
}

// A bus in memory plays the drives of --pretend, or else those that the command names.
template <class Open>
ending run(const std::vector<std::string>& line, Open open, pace& time, console& say) {
  words w(line);
  if (w.wants_help() && w.answer().empty()) return say.out << help_text, done;
  if (!w.answer().empty()) return say.out << w.answer(), done;
  say.yes = w.flag("--yes") || say.yes;
  const auto bus = w.peek();
  auto played = w.all_of("--pretend");
  if (!bus || detail::bus_named(*bus).name != bus_in_memory) {
    if (!played.empty())
      throw usage_error("--pretend plays drives in memory only: write `memory` as the bus");
    return run_command(w, open, time, say);
  }
  if (w.command() == "pretend")
    throw usage_error("`memory` lasts as long as one command: give that command --pretend DRIVE instead");
  if (played.empty() && w.command() != "replay") played = w.words_after_first();
  memory_pace in_memory(time, played);
  return run_command(w, [&in_memory](const std::string&, bool) { return in_memory.open(); }, in_memory, say);
}

// The same; errors become a message and an exit code.
template <class Open>
ending run_and_tell(const std::vector<std::string>& line, Open open, pace& time, console& say) {
  try {
    return run(line, open, time, say);
  } catch (const usage_error& e) {
    say.error << "cca-can: " << e.what() << '\n';
    return misunderstood;
  } catch (const cca::refused& e) {
    say.error << "cca-can: " << e.what() << '\n';
    return refused;
  }
}

}  // namespace cca_can
