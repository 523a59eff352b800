// The inertial units of a described robot in a compiled world: where they are.
#pragma once

#include <array>
#include <cstddef>

#include <cca/robots/inertial.hpp>
#include <cca/sim/compiled/compiled_tree.hpp>

namespace cca::sim::detail {

// A place for each part with inertial sensors, in the order of the description.
template <class R>
constexpr auto inertial_places = []<class... Sensors>(robots::sensors<Sensors...>) {
  std::array<place_on_link, robots::detail::unit_count(robots::sensors<Sensors...>())> all{};
  constexpr robots::detail::inertial_units<Sensors...> units;
  constexpr auto ends = ends_of<typename R::body>();
  for (std::size_t i = 0; i < all.size(); ++i) {
    const int part = part_index<typename R::body>(units.parts[i]);
    if (part >= 0) all[i] = ends[static_cast<std::size_t>(part)];
  }
  return all;
}(robots::sensors_of<R>());

}  // namespace cca::sim::detail
