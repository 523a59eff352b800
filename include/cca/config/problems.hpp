// All that is wrong with a file, told at once: `trot.toml:12: cpg.frequency: expected a number, got a string
// "fast"`.
#pragma once

#include <algorithm>
#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <toml++/toml.h>

#include <cca/base/refused.hpp>

namespace cca::detail {

class problems {
public:
  explicit problems(std::string_view file) : name(file) {}

  // `where` may be null: then it's a thing that the file doesn't mention.
  void add(const toml::source_region* where, std::string_view path, std::string what) {
    problem next{where ? where->begin.line : 0, where ? where->begin.column : 0, std::string(path),
                 std::move(what)};
    // In the order of the file, whatever the order of reading.
    const auto before = [](const problem& a, const problem& b) {
      return std::pair(a.line, a.column) < std::pair(b.line, b.column);
    };
    found.insert(std::ranges::upper_bound(found, next, before), std::move(next));
  }
  void add(const toml::node& where, std::string_view path, std::string what) {
    add(&where.source(), path, std::move(what));
  }

  std::size_t count() const { return found.size(); }
  const std::string& file() const { return name; }

  // Throws what was found.
  void refuse() const {
    if (found.empty()) return;
    constexpr std::size_t shown = 20;
    std::string text;
    for (std::size_t i = 0; i < std::min(shown, found.size()); ++i) {
      text.append(i ? "\n" : "").append(name).append(":");
      if (found[i].line) text.append(std::to_string(found[i].line)).append(":");
      text.append(" ").append(found[i].path).append(found[i].path.empty() ? "" : ": ").append(found[i].what);
    }
    if (found.size() > shown)
      text.append("\n")
          .append(name)
          .append(": and ")
          .append(std::to_string(found.size() - shown))
          .append(" more");
    throw refused(text);
  }

private:
  struct problem {
    unsigned line, column;
    std::string path, what;
  };
  std::string name;
  std::vector<problem> found;
};

}  // namespace cca::detail
