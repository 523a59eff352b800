// Where a door is, and the token that opens it: the words and options of both programs.
#pragma once

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <string>
#include <string_view>
#include <utility>

#include <cca/base/refused.hpp>
#include <cca/main/command_line.hpp>

namespace cca_door {

struct door_address {
  std::string host = "127.0.0.1", port = "8765";

  // As it stands in a URL: that of IPv6 in brackets.
  std::string text() const { return (host.find(':') == host.npos ? host : "[" + host + "]") + ":" + port; }
};

// `8765`, `192.168.1.5:8765`, `robot.local:8765`, `[::1]:8765`.
inline door_address address_in(const std::string& text) {
  const auto wrong = [&](const char* why) {
    return cca::command_line_error(
        text + ": " + why + "; a door is a port, as 8765, or an address and a port, as 192.168.1.5:8765");
  };
  door_address to;
  const std::size_t colon = text.rfind(':');
  to.port = colon == text.npos ? text : text.substr(colon + 1);
  if (to.port.empty() || to.port.size() > 5 || to.port.find_first_not_of("0123456789") != to.port.npos ||
      std::stoi(to.port) < 1 || std::stoi(to.port) > 65535)
    throw wrong("expected a port from 1 to 65535 at its end");
  if (colon == text.npos) return to;
  to.host = text.substr(0, colon);
  const bool has_brackets = to.host.size() > 2 && to.host.front() == '[' && to.host.back() == ']';
  if (has_brackets) to.host = to.host.substr(1, to.host.size() - 2);
  if (to.host.empty()) throw wrong("the address before the colon is missing");
  if (!has_brackets && to.host.find(':') != to.host.npos)
    throw wrong("an address of IPv6 stands in brackets");
  return to;
}

// It travels as the name of a sub-protocol, so it has only letters of such a name; and no door has another.
inline std::string checked_token(std::string token, const std::string& from) {
  constexpr std::string_view others = "-_.~+";
  while (!token.empty() && (token.back() == '\n' || token.back() == '\r' || token.back() == ' '))
    token.pop_back();
  bool is_token = !token.empty() && token.size() <= 256;
  for (const char c : token)
    is_token = is_token && ((c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
                            others.find(c) != others.npos);
  if (!is_token)
    throw cca::command_line_error(from + ": a token has 1 to 256 letters, digits or " + std::string(others));
  return token;
}

// From one of the two options, or from the environment variable CCA_TOKEN. Empty: there is none.
struct token_option {
  std::string token{}, file{};

  void add_to(cca::command_line& line) {
    line.text("--token T", token, "what the program printed at its start; without it you only read");
    line.text("--token-file F", file,
              "the file that has the token, in its first line\n(else the variable CCA_TOKEN)");
  }
  std::string value() const {
    if (!token.empty() && !file.empty())
      throw cca::command_line_error("--token and --token-file: take one of them");
    if (!token.empty()) return checked_token(token, "--token");
    if (!file.empty()) {
      std::ifstream from(file);
      std::string text;
      if (!from) throw cca::refused(file + ": can't be opened: " + std::strerror(errno));
      std::getline(from, text);
      return checked_token(text, file);
    }
    const char* const known = std::getenv("CCA_TOKEN");
    return known && *known ? checked_token(known, "CCA_TOKEN") : std::string();
  }
};

}  // namespace cca_door
