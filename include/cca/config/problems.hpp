// Collects all problems of a file and reports them at once: `trot.toml:12: cpg.frequency: expected a number,
// got a string "fast"`.
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

  // `where` is null if the file does not mention the value.
  void add(const toml::source_region* where, std::string_view path, std::string what) {
    problem next{where ? where->begin.line : 0, where ? where->begin.column : 0, std::string(path),
                 std::move(what)};
    // Sorted by the position in the file.
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

  // Throws if there are problems.
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
