// How a door is opened.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <cca/record/page.hpp>

namespace cca {

// What a program does when the connection is lost of the client that holds the right to command.
enum class when_lost { go_on, hold, stop };  // hold: a pause; stop: the run ends

struct door_settings {
  std::uint16_t port = 8765;  // 0: any that is free; `door.port()` tells
  std::string address = "127.0.0.1";
  // What a client must know to change anything. Empty: made at random, and printed with the address. A file
  // must belong to this user, and nobody else may have access to it (mode 600 or 400).
  std::string token{}, token_file{};
  std::vector<std::string> origins{};  // pages of other addresses that may connect: `https://lab.example`
  when_lost on_lost = when_lost::go_on;
  int most_clients = 32;
  bool tells_where = true;  // prints the address and the token at start
  // An HTML file that is served at `/`; empty: none.
  std::string page = recording::page_of_cca();
  // Of the live twin: the controller as WebAssembly, which the page runs; empty: none. And how many bytes of
  // what was sensed are kept for twins that come later: 64 MiB where a twin is named, else none. State it for
  // a twin that has its program from elsewhere.
  std::string twin{};
  std::optional<std::size_t> twin_memory{};

  std::size_t kept_for_twins() const { return twin_memory.value_or(twin.empty() ? 0 : 64 << 20); }
};

}  // namespace cca
