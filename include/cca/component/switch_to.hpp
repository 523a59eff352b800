// A component that may switch the mode of its controller says so in its results, as it does with a fault:
//
//   auto process(cca::in<"load", load> on_foot) -> std::tuple<cca::out<"angles", leg_angles>,
//                                                             cca::switch_to<"stand">>;
//
// `return {angles, on_foot[x{}] < 5};`: true asks for the mode. The controller switches when the beat is
// done; of two requests in one beat the later call wins. In a controller of one graph there is nothing to
// switch. Errors: modes.unknown_mode. Example: docs/modes.md.
#pragma once

#include <concepts>

#include <cca/base/fixed_string.hpp>

namespace cca {

template <fixed_string Mode>
class switch_to {
public:
  constexpr switch_to() = default;
  constexpr switch_to(std::same_as<bool> auto wanted) : is_wanted(wanted) {}

  explicit constexpr operator bool() const { return is_wanted; }

private:
  bool is_wanted = false;
};

namespace detail {

template <class Result>
inline constexpr bool is_mode_request = false;
template <fixed_string Mode>
inline constexpr bool is_mode_request<switch_to<Mode>> = true;

}  // namespace detail
}  // namespace cca
