// The mistake that strategies make which count beats.
#pragma once

#include <cstdint>
#include <string_view>

#include <cca/base/compiler.hpp>

namespace cca::detail {

constexpr std::string_view too_few_beats(std::int64_t count) {
  if (count >= 1) return {};
  return "counts beats by a number below 1: in cca::timed<N> and cca::timeout<N> it is at least 1";
}

}  // namespace cca::detail
