// What a component asks of the life-cycle, among its results.
//
// A component that has finished returns `done`: it stops itself, and fires again when somebody starts it. Its
// node has the strategy `stoppable` (strategy.not_stoppable). Its other results are published.
//
// One that stops or starts a part of its architecture returns `stops` or `starts`:
//
//   auto process(...) -> std::tuple<cca::out<"step", step_port>, cca::starts<"reach">, cca::stops<"walk">>;
//
// `return {step, is_near, is_near};`: true asks for it, false and an empty one ask for nothing. It has effect
// when the next beat begins: then the hooks on_stop or on_start of the part's components run. Of several
// requests for a part in one beat the later call wins; in a beat that ends by a fault none counts.
//
// A part is a node with the strategy `stoppable`: a component, or an inner graph as a whole. Its path is
// looked up in the graph of the component, then in the graphs around it; with a `/` in front in the outermost
// graph. Errors: part.unknown_path. Example: tests/runtime/core/parts.cpp; docs/controller.md.
#pragma once

#include <concepts>
#include <string_view>

#include <cca/base/fixed_string.hpp>

namespace cca {

class done {
public:
  constexpr done() = default;
  constexpr done(bool is_so) : so(is_so) {}

  explicit constexpr operator bool() const { return so; }

private:
  bool so = false;
};

template <fixed_string Part>
class stops {
public:
  constexpr stops() = default;
  constexpr stops(std::same_as<bool> auto wanted) : is_wanted(wanted) {}

  explicit constexpr operator bool() const { return is_wanted; }

private:
  bool is_wanted = false;
};

template <fixed_string Part>
class starts {
public:
  constexpr starts() = default;
  constexpr starts(std::same_as<bool> auto wanted) : is_wanted(wanted) {}

  explicit constexpr operator bool() const { return is_wanted; }

private:
  bool is_wanted = false;
};

namespace detail {

// What a result asks for: the path of a part.
struct asked_part {
  std::string_view path{};
  bool starts = false;
};

template <class Result>
inline constexpr bool is_part_request = false;
template <fixed_string Part>
inline constexpr bool is_part_request<stops<Part>> = true;
template <fixed_string Part>
inline constexpr bool is_part_request<starts<Part>> = true;

}  // namespace detail
}  // namespace cca
