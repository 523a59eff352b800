// The size of an array, from one of the whole numbers by which a graph counts: these are `int`, sizes are
// `std::size_t`, and a compiler may warn about the conversion (-Wsign-conversion).
#pragma once

#include <cstddef>

namespace cca::detail {

constexpr std::size_t array_size(int count) { return static_cast<std::size_t>(count); }

}  // namespace cca::detail
