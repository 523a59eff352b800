// Where the architecture of a recording and that of a program differ first, in words.
//
// The texts of two architectures (architecture_text.hpp) have of a space only its hash. What the hash stands
// for is in the file, with the topic of each port that has this space: here the two are compared, so that the
// message names the axis, unit, domain type, frame, limits or rate that differ. The file's words may be any
// bytes; a message has no more than the first 60 of each.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>

#include <cca/base/separate/compiled.hpp>
#include <cca/graph/items/modes.hpp>
#include <cca/record/mcap/reader.hpp>
#include <cca/runtime/each_component.hpp>
#include <cca/space/space_schema.hpp>

namespace cca::recording::detail {

// The spaces of all outputs, by their hash.
using spaces_by_hash = std::map<std::uint64_t, const cca::detail::space_info*>;
template <class Graph>
void add_spaces(spaces_by_hash& all) {
  if constexpr (Modes<Graph>) {
    [&]<fixed_string... Name, class... G>(cca::detail::list<mode<Name, G>...>) {
      (add_spaces<G>(all), ...);
    }(typename Graph::cca_modes{});
  } else {
    const cca::detail::flat_view g = cca::detail::plan_of<Graph>.view();
    for (int o = 0; o < g.output_count; ++o) {
      const cca::detail::space_info& space = *port_of(g, g.outputs[o]).space;
      all[space_schema(space).hash()] = &space;
    }
  }
}

// "the output `s.y` has another axis 2: ..."; or the first line that differs.
std::string architecture_difference(std::string_view here,
                                    std::string_view there,
                                    const spaces_by_hash& spaces,
                                    const mcap_reader& file);

}  // namespace cca::recording::detail

#if !CCA_HAS_COMPILED_RECORD
#include <cca/record/replay/architecture_difference_functions.hpp>
#endif
