// The functions that look at the files of a run. one_file.hpp includes this, unless they are compiled
// once for the program (cca/base/separate/compiled.hpp).
#pragma once

#include <filesystem>
#include <string>
#include <system_error>
#include <vector>

#include <cca/base/system/output_file.hpp>
#include <cca/main/one_file.hpp>

namespace cca {

CCA_MAIN_INLINE bool is_one_file(const std::string& a, const std::string& b) {
  if (detail::is_special(a) || detail::is_special(b)) return false;
  std::error_code error;
  if (std::filesystem::equivalent(a, b, error)) return true;
  const auto one = detail::followed(a).string(), other = detail::followed(b).string();
  // What is written beside a file (output_file.hpp) belongs to it.
  return one == other || one + ".part" == other || other + ".part" == one;
}

CCA_MAIN_INLINE std::string complaint_of_one_file(const std::vector<named_file>& all) {
  for (auto b = all.begin(); b != all.end(); ++b)
    for (auto a = all.begin(); a != b; ++a)
      if (a->first != b->first && !a->second.empty() && !b->second.empty() &&
          is_one_file(a->second, b->second))
        return a->first + ' ' + a->second + " and " + b->first + ' ' + b->second +
               " name one file: give each option its own";
  return {};
}

CCA_MAIN_INLINE std::string detail::set_aside_left_part(const std::string& file) {
  const std::string kept = set_aside_part(file);
  return kept.empty() ? kept : "a run that did not end has left a part of " + file + ": it is now " + kept;
}

}  // namespace cca
