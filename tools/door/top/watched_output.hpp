// An output of the program: how often it publishes, and how old its last sample is, in virtual time.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>

#include "../known_door.hpp"
#include "../sample_fields.hpp"

namespace cca_door {

class watched_output {
public:
  explicit watched_output(const channel& of)
      : channel_id(of.id),
        path(path_of(of.topic)),
        node(path.substr(0, path.rfind('.'))),
        schema(of.schema) {}

  std::uint32_t channel_id = 0;
  std::string path, node;
  message_schema schema;
  std::uint32_t subscription = 0;   // 0: none; nothing comes then, and nothing is known of its age
  std::uint64_t watched_since = 0;  // ns, virtual
  std::string last{};               // bytes of the last sample

  void begin(std::uint32_t number, std::uint64_t now) {
    subscription = number, watched_since = now;
    has_sample = false, measured = 0, count = 0;
    last.clear();
  }
  void take(std::uint64_t time, std::string bytes) {
    last = std::move(bytes);
    // A recording that begins again, or a sample out of order: begin again, too.
    if (!has_sample || time < last_time) first_time = time, count = 0, measured = 0;
    has_sample = true;
    last_time = time;
    ++count;
  }
  // Once a second: from the first to the last sample of a stretch, so it is exact also for few.
  void measure(std::uint64_t now) {
    if (count >= 2 && last_time > first_time) {
      measured = static_cast<double>(count - 1) / (static_cast<double>(last_time - first_time) * 1e-9);
      first_time = last_time, count = 1;
    } else if (has_sample && now > last_time && static_cast<double>(now - last_time) * 1e-9 * measured > 3 &&
               now - last_time > 1'000'000'000) {
      measured = 0, first_time = last_time, count = 1;  // it has ended
    }
  }

  // Hz; 0: not known, or silent. Before the first second is over, by what there is.
  double rate() const {
    constexpr std::uint64_t enough = 200'000'000;
    if (measured > 0 || count < 3 || last_time - first_time < enough) return measured;
    return static_cast<double>(count - 1) / (static_cast<double>(last_time - first_time) * 1e-9);
  }
  // Seconds since the last sample; empty: none has come since it is watched.
  std::optional<double> age(std::uint64_t now) const {
    if (!has_sample) return {};
    return now > last_time ? static_cast<double>(now - last_time) * 1e-9 : 0.0;
  }

private:
  bool has_sample = false;
  std::uint64_t first_time = 0, last_time = 0, count = 0;
  double measured = 0;
};

}  // namespace cca_door
