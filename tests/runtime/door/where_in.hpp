// Where a program of a test has opened its door.
#pragma once

#include <doctest/doctest.h>

#include <cstdint>
#include <string>

namespace door_test {

struct where {
  std::uint16_t port = 0;
  std::string token{};
};
// "door: ws://127.0.0.1:9100, token 0123..."
inline where where_in(const std::string& said) {
  where found;
  const auto address = said.find("127.0.0.1:");
  const auto token = said.find("token ");
  REQUIRE(address != said.npos);
  REQUIRE(token != said.npos);
  found.port = static_cast<std::uint16_t>(std::stoi(said.substr(address + 10)));
  found.token = said.substr(token + 6, 32);
  return found;
}

}  // namespace door_test
