// What files say about a policy, and where: statements by key, as they are written in a map. Two files that
// say the same key must agree.
#pragma once

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "lowering.hpp"

namespace cca_policy {

struct statement {
  std::vector<double> numbers;
  std::vector<std::string> words;  // instead of numbers
  std::string where;               // "walk.toml:3"
  double rounding = 1e-6;          // of a file with three decimals: half of the last
  double relative = 1e-6;          // of a file with three significant digits: half of the last

  bool is_text() const { return !words.empty(); }
};

inline std::string shown(const statement& s) {
  std::string all;
  const std::size_t count = s.is_text() ? s.words.size() : s.numbers.size();
  for (std::size_t i = 0; i < count && i < 24; ++i)
    all += (i ? ", " : "") + (s.is_text() ? s.words[i].substr(0, 60) : text_of(s.numbers[i]));
  return all + (count > 24 ? ", ..." : "");
}

// All mistakes, each once, in the order in which they were found.
class complaints {
public:
  void add(const std::string& text) {
    if (std::ranges::find(all_, text) == all_.end()) all_.push_back(text);
  }
  const std::vector<std::string>& all() const { return all_; }

private:
  std::vector<std::string> all_;
};

class statements {
public:
  void add(const std::string& key, statement s) { said_[key].push_back(std::move(s)); }
  bool has(const std::string& key) const { return said_.contains(key); }
  const std::map<std::string, std::vector<statement>>& all() const { return said_; }

  // What is said under a key: the most exact of those who agree. Null: nobody says it.
  const statement* get(const std::string& key, complaints& wrong) const {
    const auto found = said_.find(key);
    if (found == said_.end()) return nullptr;
    const statement* best = &found->second.front();
    for (const statement& other : found->second) {
      if (const std::string why = difference(*best, other); !why.empty() && once_.insert(key).second)
        wrong.add("`" + key + "` is said twice, and differs: " + why + " (" + best->where + " and " +
                  other.where + "): they are not of one export, or one of them is wrong");
      if (other.rounding + other.relative <= best->rounding + best->relative) best = &other;
    }
    return best;
  }

private:
  static std::string difference(const statement& a, const statement& b) {
    if (a.is_text() != b.is_text()) return shown(a) + " and " + shown(b);
    if (a.is_text()) {
      for (std::size_t i = 0; i < std::max(a.words.size(), b.words.size()); ++i)
        if (i >= a.words.size() || i >= b.words.size() || a.words[i] != b.words[i])
          return "number " + std::to_string(i) + " is " + (i < a.words.size() ? a.words[i] : "missing") +
                 " and " + (i < b.words.size() ? b.words[i] : "missing");
      return {};
    }
    const std::size_t count = std::max(a.numbers.size(), b.numbers.size());
    const auto at = [&](const statement& s, std::size_t i) {
      return s.numbers[s.numbers.size() == 1 ? 0 : i];
    };
    if ((a.numbers.size() != count && a.numbers.size() != 1) ||
        (b.numbers.size() != count && b.numbers.size() != 1))
      return std::to_string(a.numbers.size()) + " numbers and " + std::to_string(b.numbers.size());
    const double near = std::max(a.rounding, b.rounding), part = std::max(a.relative, b.relative);
    for (std::size_t i = 0; i < count; ++i)
      if (!(std::abs(at(a, i) - at(b, i)) <= near + part * std::abs(at(a, i))))
        return "number " + std::to_string(i) + " is " + text_of(at(a, i)) + " and " + text_of(at(b, i));
    return {};
  }

  std::map<std::string, std::vector<statement>> said_;
  mutable std::set<std::string> once_;
};

// A number; nothing: it is none.
inline std::optional<double> number_in(std::string_view text) {
  while (!text.empty() && (text.front() == ' ' || text.front() == '[')) text.remove_prefix(1);
  while (!text.empty() && (text.back() == ' ' || text.back() == ']')) text.remove_suffix(1);
  double n = 0;
  const auto read = std::from_chars(text.data(), text.data() + text.size(), n);
  if (read.ec != std::errc() || read.ptr != text.data() + text.size() || !std::isfinite(n)) return {};
  return n;
}

inline std::vector<std::string> parts_of(const std::string& text, char between = ',') {
  std::vector<std::string> all;
  std::string one;
  for (const char c : text) {
    if (c == between) {
      all.push_back(one);
      one.clear();
    } else if (c != ' ' && c != '[' && c != ']' && c != '\'' && c != '"') one += c;
  }
  all.push_back(one);
  return all;
}

}  // namespace cca_policy
