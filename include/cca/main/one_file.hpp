// Whether two names are of one file: by another spelling of the path, a link or a hard link, also if it isn't
// there yet. A device or a pipe may be named twice.
#pragma once

#include <filesystem>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include <cca/base/system/output_file.hpp>

namespace cca {

inline bool is_one_file(const std::string& a, const std::string& b) {
  if (detail::is_special(a) || detail::is_special(b)) return false;
  std::error_code error;
  if (std::filesystem::equivalent(a, b, error)) return true;
  const auto one = detail::followed(a).string(), other = detail::followed(b).string();
  // What is written beside a file (output_file.hpp) belongs to it.
  return one == other || one + ".part" == other || other + ".part" == one;
}

// What names a file: an option and its value.
using named_file = std::pair<std::string, std::string>;

// A sentence about the first two different options that name one file; empty: there are none.
inline std::string complaint_of_one_file(const std::vector<named_file>& all) {
  for (auto b = all.begin(); b != all.end(); ++b)
    for (auto a = all.begin(); a != b; ++a)
      if (a->first != b->first && !a->second.empty() && !b->second.empty() &&
          is_one_file(a->second, b->second))
        return a->first + ' ' + a->second + " and " + b->first + ' ' + b->second +
               " name one file: give each option its own";
  return {};
}

}  // namespace cca
