// The messages for recorders, replays and tracers whose graph has no mark, or that get what is no
// controller.
#pragma once

#include <cstdint>

#include <cca/base/messages/holds_or_tells.hpp>

namespace cca::detail {

enum class observer : std::uint8_t { recorder, replay, tracer };

inline constexpr const char* name_of_observer[] = {"cca::recording::recorder", "cca::recording::replay",
                                                   "cca::tracer"};

template <class Graph, observer By>
struct unmarked {
  static constexpr void tell(text& m) {
    const char* const mark = By == observer::tracer ? "cca::traceable" : "cca::recordable";
    m << name_of_observer[static_cast<int>(By)] << ": `" << type_name<Graph>() << "` is not derived from "
      << mark << ", so its beats tell nothing: write `struct " << type_name<Graph>() << " : ..., " << mark
      << " {};`";
  }
};

template <class Type, observer By>
struct not_observed {
  static constexpr void tell(text& m) {
    m << name_of_observer[static_cast<int>(By)] << ": it observes a cca::controller or a cca::deployed, and `"
      << type_name<Type>() << "` is neither: give it the one that runs the graph";
  }
};

}  // namespace cca::detail
