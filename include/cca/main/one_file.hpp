// Whether two names are of one file: by another spelling of the path, a link or a hard link, also if it isn't
// there yet. A device or a pipe may be named twice. And what a run that did not end has left beside a file.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include <cca/base/separate/compiled.hpp>

namespace cca {

bool is_one_file(const std::string& a, const std::string& b);

// What names a file: an option and its value.
using named_file = std::pair<std::string, std::string>;

// A sentence about the first two different options that name one file; empty: there are none.
std::string complaint_of_one_file(const std::vector<named_file>& all);

namespace detail {

// Moves away what a run that did not end has left of a file: a sentence about it; empty: nothing was left.
std::string set_aside_left_part(const std::string& file);

}  // namespace detail
}  // namespace cca

#if !CCA_HAS_COMPILED_MAIN
#include <cca/main/one_file_functions.hpp>
#endif
