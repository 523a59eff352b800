// The outputs that cca::shows names. Their paths may lead through what inner graphs expose, as those of
// wires.
//
// Errors: recording.unknown_port, recording.wrong_port; from a recorder, and from cca::check.
#pragma once

#include <string_view>

#include <cca/graph/verdict/diagnosis.hpp>
#include <cca/base/messages/holds_or_tells.hpp>
#include <cca/graph/diagnosis/nearest_output.hpp>
#include <cca/graph/items/shows.hpp>
#include <cca/space/info.hpp>

namespace cca::detail {

struct shown_ports {
  int angles = -1, orientation = -1;  // outputs; -1: none is stated
  text mistake{};                     // empty if there is none
};

constexpr void tell_unknown_output(text& said, const flat_view& g, std::string_view path) {
  const text nearest = nearest_output(g, path);
  said << "recording.unknown_port: cca::shows names `" << path << "`, which is no output of "
       << g.scopes[0].graph->name;
  if (nearest.size > 0) said << "; did you mean `" << nearest.view() << "`?";
  else said << ": give the path of an output, as in `robot.angles`";
}

template <class Graph>
consteval shown_ports find_shown_ports() {
  using axes = axes_facts<typename Graph::cca_shown_body::axes>;
  const auto& plan = plan_of<Graph>;
  const flat_view g = plan.view();
  shown_ports shown;
  shown.angles = output_named(g, Graph::cca_shown_angles);
  if (shown.angles < 0) {
    tell_unknown_output(shown.mistake, g, Graph::cca_shown_angles);
    return shown;
  }
  const space_info& of_angles = *port_of(g, g.outputs[shown.angles]).space;
  for (std::size_t a = 0; a + 1 < axes::labels.size(); ++a) {
    bool has_axis = false;
    for (int i = 0; i < of_angles.axis_count; ++i)
      has_axis = has_axis || of_angles.labels[i] == axes::labels[a];
    if (has_axis) continue;
    shown.mistake << "recording.wrong_port: cca::shows names `" << Graph::cca_shown_angles
                  << "` for the angles, but ";
    add_space(shown.mistake, of_angles);
    shown.mistake << " lacks the axis `" << axes::labels[a] << "` of the body "
                  << type_name<typename Graph::cca_shown_body>() << ": name an output with all of its axes";
    return shown;
  }
  if (Graph::cca_shown_orientation.empty()) return shown;
  shown.orientation = output_named(g, Graph::cca_shown_orientation);
  if (shown.orientation < 0) {
    tell_unknown_output(shown.mistake, g, Graph::cca_shown_orientation);
    return shown;
  }
  const space_info& of_base = *port_of(g, g.outputs[shown.orientation]).space;
  if (of_base.domain.starts_with("orientation<") && of_base.size == 4) return shown;
  shown.mistake << "recording.wrong_port: cca::shows names `" << Graph::cca_shown_orientation
                << "` for the orientation of the base, but ";
  add_space(shown.mistake, of_base);
  shown.mistake << " is none: name an output whose space is a cca::orientation<...>";
  return shown;
}
template <class Graph>
inline constexpr shown_ports shown_ports_of = find_shown_ports<Graph>();

template <class Graph>
struct wrong_shown_port {
  static constexpr void tell(text& m) { m << shown_ports_of<Graph>.mistake.view(); }
};

// Of a sound graph: whether what it shows is sound too.
template <class Graph>
constexpr bool shows_known_ports() {
  if constexpr (ShowsBody<Graph>) return shown_ports_of<Graph>.mistake.size == 0;
  else return true;
}

// A class, so a recorder and cca::check report the mistake once.
template <class Graph>
struct checked_shows {
  static_assert(holds_or_tells<shows_known_ports<Graph>(), wrong_shown_port<Graph>>::value);
  constexpr operator bool() const { return true; }
};

}  // namespace cca::detail
