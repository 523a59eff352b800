// An open door with a fake program behind it.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include <cca/door/server.hpp>

#include "client.hpp"
#include "fake_controls.hpp"

namespace door_test {

inline const std::string token = "0123456789abcdef0123456789abcdef";

inline cca::door_settings quiet(cca::door_settings with = {}) {
  with.port = 0;
  with.tells_where = false;
  if (with.token_file.empty()) with.token = token;
  return with;
}

struct opened {
  explicit opened(const cca::door_settings& with = {}, const cca::detail::door_limits& limits = {})
      : door(quiet(with), controls, limits) {}

  fake_controls controls{};
  cca::detail::door_server door;

  std::uint16_t port() const { return door.port(); }
  void channel(std::uint16_t id, const std::string& topic, bool is_kept = false) {
    door.sink().channel(
        {.id = id, .topic = topic, .type = "cca/msg/one", .schema = "uint64 beat\n", .is_kept = is_kept});
  }
  void message(std::uint16_t channel, std::uint64_t time, std::string_view data) {
    door.sink().message(channel, time, time,
                        {reinterpret_cast<const unsigned char*>(data.data()), data.size()});
    door.sink().hand_over();
  }
};

}  // namespace door_test
