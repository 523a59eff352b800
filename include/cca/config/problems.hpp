// Collects all problems of a file and reports them at once: `trot.toml:12: cpg.frequency: expected a number,
// got a string "fast"`.
#pragma once

#include <algorithm>
#include <cstddef>
#include <string>
#include <string_view>
#include <tuple>
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
    found.push_back(
        {where ? where->begin.line : 0, where ? where->begin.column : 0, std::string(path), std::move(what)});
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
    // By the position in the file; without one, in the order in which they were found.
    std::vector<const problem*> sorted;
    for (const problem& one : found) sorted.push_back(&one);
    std::ranges::sort(sorted, {}, [](const problem* p) { return std::tuple(p->line, p->column, p); });
    std::string text;
    for (std::size_t i = 0; i < std::min(shown, sorted.size()); ++i) {
      const problem& p = *sorted[i];
      text.append(i ? "\n" : "").append(name).append(":");
      if (p.line) text.append(std::to_string(p.line)).append(":");
      text.append(" ").append(p.path).append(p.path.empty() ? "" : ": ").append(p.what);
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
