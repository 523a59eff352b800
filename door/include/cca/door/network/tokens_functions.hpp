// Who may change anything: tokens and keys that are valid once.
#pragma once

#include <fcntl.h>
#include <sys/random.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstddef>
#include <mutex>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include <cca/base/refused.hpp>
#include <cca/door/settings.hpp>

namespace cca::detail::door_network {

// 128 bits of the system's random numbers, in hexadecimal digits.
inline std::string random_token() {
  std::array<unsigned char, 16> bytes;
  for (std::size_t have = 0; have < bytes.size();) {
    const ssize_t got = ::getrandom(bytes.data() + have, bytes.size() - have, 0);
    if (got < 0 && errno != EINTR) throw std::system_error(errno, std::generic_category(), "getrandom");
    if (got > 0) have += static_cast<std::size_t>(got);
  }
  std::string text;
  for (const unsigned char byte : bytes)
    (text += "0123456789abcdef"[byte >> 4]) += "0123456789abcdef"[byte & 15];
  return text;
}

// Takes the same time wherever they differ: so nobody finds a token digit by digit.
inline bool is_same_secret(std::string_view offered, std::string_view right) {
  std::size_t difference = offered.size() ^ right.size();
  for (std::size_t i = 0; i < right.size(); ++i)
    difference |=
        static_cast<std::size_t>(static_cast<unsigned char>(right[i]) ^
                                 static_cast<unsigned char>(i < offered.size() ? offered[i] : '\0'));
  return difference == 0;
}

// It travels as the name of a sub-protocol, so it has only letters of such a name.
inline std::string checked_token(std::string token, const std::string& where) {
  constexpr std::string_view others = "-_.~+";
  const bool has_letters = std::all_of(token.begin(), token.end(), [&](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
           others.find(c) != others.npos;
  });
  if (token.size() < 16 || token.size() > 256 || !has_letters)
    throw refused(where + ": the token of a door has 16 to 256 letters, digits or -_.~+: " +
                  "`openssl rand -hex 16` makes one");
  return token;
}

inline std::string token_of_file(const std::string& name) {
  const int file = ::open(name.c_str(), O_RDONLY | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK);
  if (file < 0)
    throw refused("the token's file " + name + " can't be opened: " + std::generic_category().message(errno) +
                  ". It must be a regular file, no link");
  struct closer {
    int of;
    ~closer() { ::close(of); }
  } const closes{file};
  struct stat is{};
  if (::fstat(file, &is) != 0) throw std::system_error(errno, std::generic_category(), name);
  if (!S_ISREG(is.st_mode)) throw refused("the token's file " + name + " is no regular file");
  if (is.st_uid != ::geteuid())
    throw refused("the token's file " + name + " belongs to another user: make your own");
  if (const unsigned mode = is.st_mode & 0777; (mode & 077) != 0)
    throw refused("the token's file " + name + " has mode " + std::to_string(mode >> 6) +
                  std::to_string(mode >> 3 & 7) + std::to_string(mode & 7) +
                  ", so not only its owner has access to it: run `chmod 600 " + name + "`");
  std::array<char, 512> bytes{};
  const ssize_t size = ::read(file, bytes.data(), bytes.size());
  if (size < 0) throw std::system_error(errno, std::generic_category(), name);
  std::string text(bytes.data(), static_cast<std::size_t>(size));
  while (!text.empty() && (text.back() == '\n' || text.back() == '\r' || text.back() == ' ')) text.pop_back();
  return checked_token(std::move(text), "the token's file " + name);
}

inline std::string token_of(const door_settings& settings) {
  if (!settings.token.empty() && !settings.token_file.empty())
    throw refused("a door has a token or a token's file, not both");
  if (!settings.token_file.empty()) return token_of_file(settings.token_file);
  return settings.token.empty() ? random_token() : checked_token(settings.token, "door_settings::token");
}

// Keys for viewers that know only a URL. Made by any thread; the oldest of more than 16 is no longer valid.
class one_time_keys {
public:
  std::string make() {
    const std::scoped_lock lock(guard);
    if (valid.size() == 16) valid.erase(valid.begin());
    return valid.emplace_back(random_token());
  }
  bool has(std::string_view offered) const {
    const std::scoped_lock lock(guard);
    return std::any_of(valid.begin(), valid.end(),
                       [&](const auto& one) { return is_same_secret(offered, one); });
  }
  bool take(std::string_view offered) {
    const std::scoped_lock lock(guard);
    const auto found = std::find_if(valid.begin(), valid.end(),
                                    [&](const auto& one) { return is_same_secret(offered, one); });
    if (found == valid.end()) return false;
    valid.erase(found);
    return true;
  }

private:
  mutable std::mutex guard{};
  std::vector<std::string> valid{};
};

}  // namespace cca::detail::door_network
