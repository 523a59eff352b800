// Divides a sample of an array-valued space into a sample per part, and puts the parts together again.
//
//   share_out<Whole, Part, N>   in "input": Whole;  out "part0", "part1", ...: Part
//   gather<Whole, Part, N>      in "part0", "part1", ...: Part;  out "output": Whole; use it with `moderate`
//
// Whole is `array_of<Part, N>`, or has the domain type of Part and the axes of N parts in order: eight joint
// angles are four parts of two. In the second case the names of the axes change on the way, and with them
// their limits.
// Cost: none after inlining.
#pragma once

#include <cstddef>
#include <tuple>
#include <utility>

#include <cca/base/array_size.hpp>
#include <cca/component/port.hpp>
#include <cca/space/array.hpp>

namespace cca::detail {

// How many parts a whole has; 0 if the domain types differ or the numbers do not divide.
template <class Whole, class Part>
constexpr int parts_in = [] {
  if constexpr (Whole::axes::count % Part::axes::count != 0) return 0;
  else {
    constexpr int count = Whole::axes::count / Part::axes::count;
    if constexpr (std::is_same_v<typename Whole::domain, array_domain<typename Part::domain, count>>)
      return std::is_same_v<
                 typename Whole::axes,
                 typename array_axes<typename Part::axes, std::make_index_sequence<array_size(count)>>::type>
                 ? count
                 : 0;
    else
      return std::is_same_v<typename Whole::domain, typename Part::domain> &&
                     Whole::size == count * Part::size
                 ? count
                 : 0;
  }
}();

template <std::size_t I>
inline constexpr auto part_name = numbered<"part", I>;

template <class Whole, class Part, class Numbers>
struct share_out_of;
template <class Whole, class Part, std::size_t... I>
struct share_out_of<Whole, Part, std::index_sequence<I...>> {
  auto process(in<"input", Whole> whole) -> std::tuple<out<part_name<I>, Part>...> {
    return {out<part_name<I>, Part>(
        whole.vector().template segment<Part::size>(static_cast<int>(I) * Part::size))...};
  }
};

template <class Whole, class Part, class Numbers>
struct gather_of;
template <class Whole, class Part, std::size_t... I>
struct gather_of<Whole, Part, std::index_sequence<I...>> {
  auto process(in<part_name<I>, Part>... parts) -> out<"output", Whole> {
    typename Whole::vector_type whole;
    ((whole.template segment<Part::size>(static_cast<int>(I) * Part::size) = parts.vector()), ...);
    return whole;
  }
};

template <class Whole, class Part, int Count>
struct share_out : share_out_of<Whole, Part, std::make_index_sequence<array_size(Count)>> {};
template <class Whole, class Part, int Count>
struct gather : gather_of<Whole, Part, std::make_index_sequence<array_size(Count)>> {};

}  // namespace cca::detail
