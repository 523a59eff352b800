// The messages of a deployment, and whether one that has come can be true.
//
//   a sample   its number, beat of publication, origin, values        a topic for each output that leaves
//   a status   how far an environment is, its faults, its counts      a topic for each environment
//
// What can't be checked here: that a value is right. A component may publish NaN, and a wire in a process
// passes it on; so it passes here as well, and is counted.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>
#include <string_view>
#include <type_traits>
#include <vector>

#include <cca/dds/domain/channel.hpp>
#include <cca/runtime/environments/exchange/exchange.hpp>

namespace cca::dds::detail {

using cca::detail::no_position;

// What beats are possible: their times are 64-bit numbers of nanoseconds.
struct bounds {
  std::int64_t period = 1, calls_and_one = 1;
  int nodes = 0;
  std::int64_t ahead = 0;  // beats that an environment may be ahead
  int modes = 1;
  std::size_t parts = 0;

  std::int64_t last_beat() const { return (std::int64_t{1} << 62) / std::max(period, calls_and_one); }
  // How far ahead of all that is known here a message may be: a process that has not been heard for two
  // seconds is gone, and no loop runs a hundred times as fast as the clock.
  std::int64_t window() const { return 1024 + 100'000'000'000 / period; }
};

struct sample_message {
  static constexpr std::size_t head = 3;
  // Beside the beat: the sample was not published in it, but counts as if it were. A queue does not take it.
  static constexpr std::uint64_t is_repeated = std::uint64_t{1} << 63;
  static std::int64_t beat(std::span<const std::uint64_t> message) {
    return static_cast<std::int64_t>(message[1] & ~is_repeated);
  }

  static bool is_finite(std::span<const std::uint64_t> message) {
    return std::ranges::all_of(message.subspan(head),
                               [](std::uint64_t word) { return std::isfinite(std::bit_cast<double>(word)); });
  }
};

// As numbers, in the order in which they are sent.
struct status {
  enum field : std::size_t {
    flags,
    position,
    begun,
    begun_age,
    interval,
    fault_position,
    fault_node,
    stop_at,
    arrived,
    ready,
    finished,
    stopped,
    beat,
    length,
    mode,
    switches,
    overruns,
    lost_periods,
    field_count
  };
  static constexpr std::int64_t is_exact = 1, all_meet = 2, is_leaving = 4, is_paused = 8;
  using reason_words = std::array<std::uint64_t, cca::detail::fault_record::most_letters / 8>;

  std::array<std::int64_t, field_count> fields{};
  reason_words reason{};
  std::vector<std::int64_t> late;         // of each environment
  std::vector<std::uint64_t> accepted;    // of each environment: the participant that this one listens to
  std::vector<std::int64_t> accepted_in;  // of each environment: the newest run that began before that
  std::vector<std::int64_t> published;    // of each output: the number of the next sample
  std::vector<std::int64_t> wishes;       // of each part: what was asked between two runs

  status(std::size_t environments, std::size_t outputs, std::size_t parts = 0)
      : late(environments),
        accepted(environments),
        accepted_in(environments),
        published(outputs),
        wishes(parts) {}

  std::int64_t& operator[](field f) { return fields[f]; }
  std::int64_t operator[](field f) const { return fields[f]; }

  static std::size_t size(std::size_t environments, std::size_t outputs, std::size_t parts = 0) {
    return field_count + reason_words().size() + 3 * environments + outputs + parts;
  }
  void write_to(words& message) const {
    message.clear();
    each(*this, [&](auto& number) { message.push_back(static_cast<std::uint64_t>(number)); });
  }
  void read_from(std::span<const std::uint64_t> message) {
    auto next = message.begin();
    each(*this,
         [&](auto& number) { number = static_cast<std::remove_reference_t<decltype(number)>>(*next++); });
  }

  std::string_view reason_text() const {
    const auto* const letters = reinterpret_cast<const char*>(reason.data());
    return {letters, std::find(letters, letters + sizeof reason, '\0')};
  }

  // Empty, or what is wrong with it. `newest`: the newest beat known here.
  std::string_view complaint(const bounds& of, std::int64_t newest) const {
    const auto is_in = [](std::int64_t number, std::int64_t lower, std::int64_t upper) {
      return number >= lower && number <= upper;
    };
    const auto& s = *this;
    const std::int64_t last = newest < 0 ? of.last_beat() : std::min(of.last_beat(), newest + of.window());
    const std::int64_t end = last * of.calls_and_one, most_runs = std::int64_t{1} << 40;
    if (!is_in(s[flags], 0, 15)) return "flags that do not exist";
    if (!is_in(s[mode], 0, of.modes - 1)) return "a mode that does not exist";
    if (!is_in(s[position], -1, end) || !is_in(s[begun], -1, last) || !is_in(s[beat], 0, last))
      return "a beat that can't be";
    if (!is_in(s[begun_age], 0, no_position / 2) || !is_in(s[interval], 0, no_position / (of.window() + 1)))
      return "a time that can't be";
    if (s[fault_position] != no_position && !is_in(s[fault_position], -1, end))
      return "a fault that can't be";
    if (!is_in(s[fault_node], -1, of.nodes - 1)) return "a component that does not exist";
    if (s[stop_at] != no_position && !is_in(s[stop_at], 0, last)) return "an end that can't be";
    if (!is_in(s[arrived], 0, most_runs) || !is_in(s[ready], 0, most_runs) ||
        !is_in(s[finished], 0, most_runs))
      return "a run that can't be";
    if (s[length] < 0 || s[stopped] < 0 || s[switches] < 0 || s[overruns] < 0 || s[lost_periods] < 0 ||
        std::ranges::any_of(
            late, [](std::int64_t n) { return n < 0; }) ||
        std::ranges::any_of(published, [](std::int64_t n) { return n < 0; }))
      return "a count below zero";
    if (std::ranges::any_of(
            wishes, [&](std::int64_t n) { return !is_in(n, 0, cca::detail::wish_to_start_and_stop); }))
      return "a wish that does not exist";
    const std::string_view text = reason_text();
    if (text.size() >= sizeof reason ||
        std::ranges::any_of(text, [](char c) { return static_cast<unsigned char>(c) < ' '; }))
      return "a reason that is no text";
    return {};
  }

private:
  template <class Self, class F>
  static void each(Self& s, F f) {
    for (auto& number : s.fields) f(number);
    for (auto& number : s.reason) f(number);
    for (auto& number : s.late) f(number);
    for (auto& number : s.accepted) f(number);
    for (auto& number : s.accepted_in) f(number);
    for (auto& number : s.published) f(number);
    for (auto& number : s.wishes) f(number);
  }
};

// The samples of an output as they come in from the process that runs it.
class arriving_numbers {
public:
  // Empty, or what is wrong with the sample.
  std::string_view complaint(std::span<const std::uint64_t> message, const bounds& of, std::int64_t newest) {
    if (message.empty()) return "a sample of another length";
    const auto number = static_cast<std::int64_t>(message[0]), k = sample_message::beat(message);
    if (number < next || number > (std::int64_t{1} << 62)) return "a number that does not follow";
    const std::int64_t last = newest < 0 ? of.last_beat() : std::min(of.last_beat(), newest + of.window());
    if (k < std::max<std::int64_t>(beat - of.ahead, 0) || k > last)
      return "a beat that can't be";  // after a fault an environment may go back by what it was ahead
    next = number + 1;
    beat = k;
    return {};
  }
  bool has_come(std::int64_t count) const { return next >= count; }
  void forget() { *this = {}; }

private:
  std::int64_t next = 0, beat = -1;
};

}  // namespace cca::dds::detail
