// The outputs that cca::shows names. Their paths may lead through what inner graphs expose, as those of
// wires.
//
// Errors: recording.unknown_port, recording.wrong_port; from a recorder, and from cca::check.
#pragma once

#include <string_view>

#include <cca/graph/verdict/diagnosis.hpp>
#include <cca/graph/items/shows.hpp>
#include <cca/space/info.hpp>

namespace cca::detail {

// The number of the output with this path; -1: there is none.
constexpr int output_named(const flat_view& g, std::string_view path) {
  for (int o = 0; o < g.output_count - g.taken_count; ++o) {
    text known;
    add_port(known, g, g.outputs[o]);
    if (known.view() == path) return o;
  }
  for (int s = 1; s < g.scope_count; ++s) {
    text inner;
    add_scope_path(inner, g, s);
    if (!path.starts_with(inner.view())) continue;
    const std::string_view name = path.substr(inner.size);
    for (int i = 0; i < g.scopes[s].graph->count; ++i)
      if (const auto& item = g.scopes[s].graph->items[i]; item.kind == item_kind::expose && item.to == name)
        return output_named(g, (inner << item.from).view());
  }
  return -1;
}

// Of all outputs, and of those that an inner graph exposes; empty if none is near.
constexpr text nearest_output(const flat_view& g, std::string_view wrong) {
  text nearest;
  std::size_t least = wrong.size() / 3 + 2;
  const auto consider = [&](const text& candidate) {
    const auto size = candidate.size;
    if ((size < wrong.size() ? wrong.size() - size : size - wrong.size()) >= least) return;
    if (const auto distance = edit_distance(wrong, candidate.view()); distance < least) {
      least = distance;
      nearest = candidate;
    }
  };
  for (int s = 1; s < g.scope_count; ++s)
    for (int i = 0; i < g.scopes[s].graph->count; ++i) {
      const auto& item = g.scopes[s].graph->items[i];
      if (item.kind != item_kind::expose) continue;
      text candidate;
      add_scope_path(candidate, g, s);
      candidate << item.to;
      if (output_named(g, candidate.view()) >= 0) consider(candidate);
    }
  for (int o = 0; o < g.output_count - g.taken_count; ++o) {
    text candidate;
    add_port(candidate, g, g.outputs[o]);
    consider(candidate);
  }
  return nearest;
}

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
struct said_of_shown_ports {
  static constexpr std::string_view view() { return shown_ports_of<Graph>.mistake.view(); }
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
  static_assert(sizeof(printed<said_of_shown_ports<Graph>>) != 0);
  constexpr operator bool() const { return true; }
};
template <class Graph>
  requires(shows_known_ports<Graph>())
struct checked_shows<Graph> {
  constexpr operator bool() const { return true; }
};

}  // namespace cca::detail
