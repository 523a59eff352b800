// The words of a command line. A command takes the words that it knows; `nothing_left` complains about the
// rest.
//
// `@file` stands for the words in that file, where `#` begins a comment: so a robot's limits can be kept in a
// file. A word `--name` is an option, and the next word is its value, unless it is a flag. Errors:
// usage_error, which says what was expected.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <optional>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <cca/base/file.hpp>

#include "ending.hpp"

namespace cca_can {

// The whole text must be a number. "0x" numbers are integers.
inline std::optional<double> number_in(const std::string& text) {
  char* end = nullptr;
  const double value = std::strtod(text.c_str(), &end);
  if (text.empty() || end != text.c_str() + text.size() || !std::isfinite(value)) return {};
  return value;
}

inline std::vector<std::string> split(std::string_view text, char at) {
  std::vector<std::string> parts;
  for (;;) {
    const std::size_t to = text.find(at);
    parts.emplace_back(text.substr(0, to));
    if (to == text.npos) return parts;
    text.remove_prefix(to + 1);
  }
}

class words {
public:
  explicit words(const std::vector<std::string>& all) {
    for (const std::string& each : all) {
      if (each.size() > 1 && each[0] == '@') add_file(each.substr(1));
      else left.push_back(each);
    }
  }

  bool flag(std::string_view name) {
    const auto at = std::find(left.begin(), left.end(), name);
    if (at == left.end()) return false;
    left.erase(at);
    return true;
  }

  std::optional<std::string> option(std::string_view name) {
    const auto at = std::find(left.begin(), left.end(), name);
    if (at == left.end()) return {};
    if (at + 1 == left.end()) throw usage_error(std::string(name) + ": a value is expected after it");
    std::string value = at[1];
    left.erase(at, at + 2);
    return value;
  }
  std::vector<std::string> all_of(std::string_view name) {
    std::vector<std::string> values;
    while (auto one = option(name)) values.push_back(*one);
    return values;
  }

  // From `least` to `most`; `what` says what the number is, with its unit.
  std::optional<double> number(std::string_view name, std::string_view what, double least, double most) {
    const auto text = option(name);
    if (!text) return {};
    const auto value = number_in(*text);
    if (!value || *value < least || *value > most) {
      std::ostringstream said;
      said << name << ' ' << *text << ": expected " << what << ", from " << least << " to " << most;
      throw usage_error(said.str());
    }
    return value;
  }
  double needed_number(std::string_view name, std::string_view what, double least, double most) {
    const auto value = number(name, what, least, most);
    if (!value) throw usage_error(std::string(name) + " is missing: " + std::string(what));
    return *value;
  }

  // The next word that is no option. Take all options with values first.
  std::optional<std::string> next() {
    const auto at =
        std::find_if(left.begin(), left.end(), [](const std::string& w) { return !w.starts_with("--"); });
    if (at == left.end()) return {};
    std::string word = *at;
    left.erase(at);
    return word;
  }
  std::string needed_next(std::string_view what) {
    auto word = next();
    if (!word) throw usage_error(std::string(what) + " is missing");
    return *word;
  }

  void nothing_left() const {
    if (left.empty()) return;
    throw usage_error("`" + left.front() + "`: this command does not know it; see `cca-can help`");
  }

private:
  void add_file(const std::string& file) {
    std::istringstream text(cca::detail::read_file(file));
    for (std::string line; std::getline(text, line);) {
      std::istringstream parts(line.substr(0, line.find('#')));
      for (std::string word; parts >> word;) left.push_back(word);
    }
  }

  std::vector<std::string> left;
};

}  // namespace cca_can
