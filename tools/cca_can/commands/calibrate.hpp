// cca-can calibrate: the joint is held at a known angle; its offset follows from the drive's position, and
// goes into a file.
//
// A controller with cca::hardware::oncilla loads this file: it is the parameter `offset` of its synchronizer,
// which is added to the offset of the joint's type. Offsets of other joints stay as they are. A file with
// anything else in it is refused, so that nothing is lost.
#pragma once

#include <array>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include <cca/base/file.hpp>
#include <cca/hardware/joint.hpp>
#include <cca/robots/oncilla/spaces.hpp>

#include "../console.hpp"
#include "../drives/talk.hpp"
#include "../words.hpp"

namespace cca_can {

namespace detail {

template <class... Axes>
constexpr std::array<std::string_view, sizeof...(Axes)> names_of(cca::axes<Axes...>) {
  return {Axes::name...};
}
inline constexpr auto joint_names = names_of(cca::robots::oncilla::leg_axes());

}  // namespace detail

using offsets = std::array<double, detail::joint_names.size()>;

inline std::string joint_list_text() {
  std::string all;
  for (const auto name : detail::joint_names) all += (all.empty() ? "" : ", ") + std::string(name);
  return all;
}

inline std::size_t joint_named(const std::string& name) {
  for (std::size_t i = 0; i < detail::joint_names.size(); ++i)
    if (detail::joint_names[i] == name) return i;
  throw usage_error("--joint " + name + ": expected one of " + joint_list_text());
}

inline std::string offset_file(const offsets& all, const std::string& node) {
  std::string text =
      "# Offsets of the joints in rad, as `cca-can calibrate` found them; a controller loads them.\n[" +
      node + "]\noffset = [\n";
  for (std::size_t i = 0; i < all.size(); ++i) {
    char line[96];
    std::snprintf(line, sizeof line, "  %.6f,  # %s\n", all[i], std::string(detail::joint_names[i]).c_str());
    text += line;
  }
  return text + "]\n";
}

// Reads only what offset_file writes: so nothing that somebody put into a file is lost.
inline std::optional<offsets> read_offset_file(const std::string& text, const std::string& node) {
  offsets all{};
  std::string bare;
  for (const std::string& line : split(text, '\n')) {
    for (const char c : line.substr(0, line.find('#')))
      if (c != ' ' && c != '\t' && c != '\r') bare += c;
  }
  const std::string head = "[" + node + "]offset=[";
  if (!bare.starts_with(head) || !bare.ends_with(']')) return {};
  auto numbers = split(bare.substr(head.size(), bare.size() - head.size() - 1), ',');
  if (numbers.size() == all.size() + 1 && numbers.back().empty()) numbers.pop_back();
  if (numbers.size() != all.size()) return {};
  for (std::size_t i = 0; i < all.size(); ++i) {
    const auto n = number_in(numbers[i]);
    if (!n) return {};
    all[i] = *n;
  }
  return all;
}

struct calibrate_order {
  std::size_t joint = 0;
  double at = 0;           // rad, the joint's angle
  hw::mounting mounted{};  // as in the joint's type
  std::string file, node = "robot.synchronizer";
};

template <hw::CanBus Bus>
ending calibrate(
    Bus& bus, const std::string& name, any_drive& drive, const calibrate_order& o, pace& time, console& say) {
  const std::string joint(detail::joint_names[o.joint]);
  offsets all{};
  if (std::filesystem::exists(o.file)) {
    const auto old = read_offset_file(cca::detail::read_file(o.file), o.node);
    if (!old) {
      throw cca::refused(o.file + ": has more in it than the offsets of [" + o.node +
                         "]: write into another file, and copy the offsets from there");
    }
    all = *old;
  }
  char what[400];
  std::snprintf(what, sizeof what,
                "calibrate %s by %s on %s: it is now at %.4f rad, without torque; write its offset into %s",
                joint.c_str(), drive.text.c_str(), name.c_str(), o.at, o.file.c_str());
  if (!say.confirmed(what)) return not_confirmed;

  talk t(bus, drive, time, 10 * ms);
  trouble wrong = t.ask_position();
  double sum = 0, low = 0, high = 0;
  constexpr int samples = 50;
  std::uint64_t before = 0;
  int answers = 0;
  for (int i = 0; i < samples && wrong.empty(); ++i) {
    const double q = t.report().position;
    answers += t.report().frames != before;
    before = t.report().frames;
    sum += q;
    low = i == 0 ? q : std::min(low, q);
    high = i == 0 ? q : std::max(high, q);
    wrong = t.cycle(drive.ask_state());
  }
  const double spread = high - low, mean = sum / samples;
  const double of_type = o.mounted.sign * mean / o.mounted.gear + o.mounted.offset, offset = o.at - of_type;
  char numbers[160];
  std::snprintf(numbers, sizeof numbers, "drive at %.4f rad, joint by its type at %.4f rad, offset %.6f rad",
                mean, of_type, offset);
  if (wrong.empty() && answers < samples / 2)
    wrong = "it answered only " + std::to_string(answers) + " of 50 times";
  if (wrong.empty() && !(spread < 0.005))
    wrong = "it moves, by " + std::to_string(spread) + " rad: hold it still";
  if (wrong.empty() && t.turned() != 0)
    wrong =
        "its position begins again just here, so a controller can't know on which side it starts: mount "
        "the drive otherwise";
  if (wrong.empty() && !(std::abs(offset) <= 1))
    wrong = std::string(numbers) + ": more than 1 rad; is the sign, the gear or the angle wrong?";
  if (!wrong.empty()) {
    say.error << "cca-can: " << drive.text << " on " << name << ": " << wrong << "; nothing was written\n";
    return time.end_wanted() ? interrupted : failed;
  }
  all[o.joint] = offset;
  cca::detail::write_file(o.file, offset_file(all, o.node));
  say.out << joint << ": " << numbers << "; written into " << o.file << '\n';
  return done;
}

}  // namespace cca_can
