// A test of an input through a door (cca::test_input): one at a time. It is a change of parameters, which the
// door makes of the arguments of /cca/test; the door keeps the samples of its outputs, and computes the
// answer of them when somebody asks.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <cca/door/controls.hpp>
#include <cca/door/network/channels_functions.hpp>
#include <cca/door/network/values_functions.hpp>

namespace cca::detail::door_network {

struct recorded_port {
  std::uint16_t channel = 0;
  std::size_t axis = 0;
  std::vector<std::pair<std::int64_t, double>> samples{};  // by beat
};
struct input_test_settings {
  door_test_input of{};
  std::string signal{};
  std::int64_t axis = 0;
  double amplitude = 0, frequency = 1, to = 10, duration = 10;
  recorded_port excitation{}, output{};
  std::optional<recorded_port> from{};
};

class input_test {
public:
  // What the test is to be, of the arguments of a call; else why not.
  std::string read(const json& given, const std::vector<door_test_input>& of, const shown_channels& channels);

  const std::string& input() const { return asked.of.input; }
  const std::string& node() const { return asked.of.node; }
  std::uint64_t id() const { return own_id; }  // which it was begun with; 0 after its end
  // The parameters of its node that begin it; else why not.
  std::string fill(const std::vector<door_parameter>& known, door_request& request) const;

  // Its samples come from now on.
  void begin(std::uint64_t with_id, std::int64_t period_of_beat, shown_channels& channels);
  void begun(std::uint64_t time) { began = time; }
  void end(shown_channels& channels);  // of it and of its record
  bool is_running(std::uint64_t now) const {
    return own_id != 0 && !is_cut && (began == none || now < began + nanoseconds(asked.duration));
  }
  // It was ended before its time. `by`: what makes its record useless; empty: what has come can be answered.
  void cut(const std::string& by) { is_cut = true, cut_by = by; }
  void sample(std::uint16_t channel, std::string_view data);
  // Nothing more of it is to come.
  void rest_if_over(std::uint64_t now, shown_channels& channels) {
    if (is_listening && began != none && now > began + nanoseconds(asked.duration + 2 * rest)) {
      is_listening = false;
      listen(channels, false);
    }
  }
  void lost(std::uint64_t count) { lost_messages += is_listening ? count : 0; }

  // Of what has come; `why` says why there is none.
  std::optional<json> response(std::uint64_t now, std::string& why) const;

private:
  static constexpr std::uint64_t none = std::numeric_limits<std::uint64_t>::max();
  static constexpr std::size_t most_samples = 1 << 17;
  static constexpr double rest = 0.5;  // s after the end, for what has not come to rest

  using port = recorded_port;
  using settings = input_test_settings;

  static std::uint64_t nanoseconds(double seconds) { return static_cast<std::uint64_t>(1e9 * seconds); }
  static void take(port& into, std::uint16_t channel, std::string_view data);
  void listen(shown_channels& channels, bool does) const;

  settings asked{};
  std::uint64_t own_id = 0;
  std::uint64_t began = none;
  std::uint64_t lost_messages = 0;
  std::int64_t period = 0;  // ns, of a beat
  bool is_cut = false, is_listening = false;
  std::string cut_by{};
};

}  // namespace cca::detail::door_network
