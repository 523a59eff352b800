// Parts of an architecture that are stopped and started on their own, while the rest runs: components, and
// inner graphs as a whole. Their nodes have the strategy `stoppable<...>`.
//
//   c.stop<"reach">();         between two beats: none of its components fires any more, their samples age
//   c.start<"reach">();        they fire again; what arrived in the meantime is not fresh
//   c.is_stopped<"reach">();   also where a component stopped it, or it stopped itself (cca::done), and where a
//                              part around it is stopped
//   c.stop("reach");           the same by a path that is known only at run time
//
// In the states `started`, `running` and `faulted`, from the thread that runs the beats. Hooks: on_stop and
// on_start of each component, but no on_stop where a component stopped itself. Errors: cca::refused.
// docs/controller.md.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <cca/base/messages/holds_or_tells.hpp>
#include <cca/base/nearest.hpp>
#include <cca/base/refused.hpp>
#include <cca/component/hooks.hpp>
#include <cca/component/lifecycle.hpp>
#include <cca/graph/verdict/unknown_path.hpp>
#include <cca/runtime/each_component.hpp>

namespace cca::detail {

// Whether a node is in a part, or in one inside of it.
template <class Graph>
constexpr bool is_in_part(int node, int part) {
  int at = plan_of<Graph>.nodes[array_size(node)].part;
  while (at > part) at = kept_parts<Graph>[array_size(at)].parent;
  return at == part;
}

// "skills.reach": the path of a part.
template <class Graph>
std::string path_of_part(int part) {
  const auto& plan = plan_of<Graph>;
  const auto& own = kept_parts<Graph>[array_size(part)];
  std::string path(own.item->from);
  for (int s = own.scope; plan.scopes[array_size(s)].item; s = plan.scopes[array_size(s)].parent)
    path = std::string(plan.scopes[array_size(s)].item->from) + "." + path;
  return path;
}

// The part with this path; -1: there is none.
template <class Graph>
constexpr int part_with_hash(std::uint64_t path) {
  for (int p = 0; p < parts_kept<Graph>; ++p)
    if (kept_parts<Graph>[array_size(p)].hash == path) return p;
  return -1;
}

// As at the beginning, but nothing that has arrived is fresh.
template <class Graph, class State>
void begin_anew(State& state, int node, std::int64_t next) {
  visit_firings<Graph>(state, node, [&](last_firing& one) {
    one.is_first = true;
    one.last = next - 1;
  });
  forget_strategies<Graph>(state, node);
}

// The components of a state, whose parts have changed: those that rest now, or run again from beat `next` on.
template <class Graph, class State>
void note_change(State& state,
                 const std::array<bool, array_size(parts_kept<Graph> + 1)>& rested,
                 std::int64_t next) {
  visit_components<Graph>(
      [&]<class C>(int node, C& component) {
        const int part = plan_of<Graph>.nodes[array_size(node)].part;
        if (part < 0 || state.parts[array_size(part)].rests == rested[array_size(part)]) return;
        if (state.parts[array_size(part)].rests) {
          if constexpr (OnStop<C>) component.on_stop();
          return;
        }
        begin_anew<Graph>(state, node, next);
        if constexpr (OnStart<C>) component.on_start();
      },
      state);
}

// Stops or starts a part, and finds the parts that rest now. A part that runs again runs from beat `next` on.
template <class Graph, class State>
void mark_part(State& state, int part, bool stops, std::int64_t next) {
  state.parts[array_size(part)].is_stopped = stops;
  for (int p = 0; p < parts_kept<Graph>; ++p) {
    auto& one = state.parts[array_size(p)];
    const int around = kept_parts<Graph>[array_size(p)].parent;
    const bool rested = one.rests;
    one.rests = one.is_stopped || (around >= 0 && state.parts[array_size(around)].rests);
    if (rested && !one.rests) one.since = next;
  }
}

template <class Graph, class State>
auto parts_at_rest(const State& state) {
  std::array<bool, array_size(parts_kept<Graph> + 1)> rested{};
  for (int p = 0; p < parts_kept<Graph>; ++p) rested[array_size(p)] = state.parts[array_size(p)].rests;
  return rested;
}

// Stops or starts a part with its hooks.
template <class Graph, class State>
void change_part(State& state, int part, bool stops, std::int64_t next) {
  if (state.parts[array_size(part)].is_stopped == stops) return;
  const auto rested = parts_at_rest<Graph>(state);
  mark_part<Graph>(state, part, stops, next);
  note_change<Graph>(state, rested, next);
}

// The same without hooks, for start(), which calls those of all components.
template <class Graph, class State>
void restart_part(State& state, int part, std::int64_t next) {
  if (!state.parts[array_size(part)].is_stopped) return;
  mark_part<Graph>(state, part, false, next);
  for (int node = 0; node < counts_of<Graph>.node_count; ++node)
    if (is_in_part<Graph>(node, part)) begin_anew<Graph>(state, node, next);
}

// In a beat that ends by a fault no request counts.
template <class State>
void forget_requests(State& state) {
  for (auto& part : state.parts) part.asked = 0;
  state.is_asked = false;
}

// What the components of the last beat have asked for, before beat `next`: all of it at once, so a part in
// another one that starts, which is itself stopped, has neither on_start nor on_stop. f(part, stops) for each
// change.
template <class Graph, class State, class F>
void take_requests(State& state, std::int64_t next, F f) {
  const auto rested = parts_at_rest<Graph>(state);
  bool is_change = false;
  for (int p = 0; p < parts_kept<Graph>; ++p) {
    auto& part = state.parts[array_size(p)];
    const int asked = std::exchange(part.asked, 0);
    if (asked == 0 || part.is_stopped == (asked < 0)) continue;
    mark_part<Graph>(state, p, asked < 0, next);
    is_change = true;
    f(p, asked < 0);
  }
  if (is_change) note_change<Graph>(state, rested, next);
  state.is_asked = false;
}

// Refused: there is none.
template <class Graph>
int part_named(std::string_view path) {
  if (const int part = part_with_hash<Graph>(hash(path)); part >= 0) return part;
  const std::string text = "cca::controller: `" + std::string(path) + "` ";
  if (node_at<Graph>(path) >= 0)
    throw refused(text +
                  "can't be stopped on its own: write cca::stoppable<...> around the strategy of its node");
  if (has_scope<Graph>(hash(path)))
    throw refused(text + "can't be stopped as a whole: write cca::stoppable<> as the strategy of its node");
  std::vector<std::string> paths;
  for (int p = 0; p < parts_kept<Graph>; ++p) paths.push_back(path_of_part<Graph>(p));
  const std::vector<std::string_view> names(paths.begin(), paths.end());
  const auto near = nearest_name(path, names);
  throw refused(text + "is no component" +
                (near.empty() ? "" : "; did you mean `" + std::string(near) + "`?"));
}

// `Self` has, beside what component_host.hpp asks of it:
//
//   for_each_part_state(part, f)   f.template operator()<Loop>(state, next beat) for each loop that has it
//   check_part(call, part)         refuses what can't be stopped or started now
//   tell_part(part, stops)         to a recorder
template <class Self, class Graph>
class stoppable_parts {
public:
  template <fixed_string Path>
  void stop() {
    set_part(part_of<Path>(), true);
  }
  template <fixed_string Path>
  void start() {
    set_part(part_of<Path>(), false);
  }
  template <fixed_string Path>
  bool is_stopped() const {
    return rests(part_of<Path>());
  }

  void stop(std::string_view path) { set_part(part_named<Graph>(path), true); }
  void start(std::string_view path) { set_part(part_named<Graph>(path), false); }
  bool is_stopped(std::string_view path) const { return rests(part_named<Graph>(path)); }

  // f(number) for each part that was itself stopped: for a recorder.
  template <class F>
  void for_each_stopped_part(F f) const {
    for (int p = 0; p < parts_kept<Graph>; ++p)
      if (look(p).is_stopped) f(p);
  }

protected:
  bool rests(int part) const { return look(part).rests; }
  bool is_resting_node(int node) const {
    const int part = plan_of<Graph>.nodes[array_size(node)].part;
    return part >= 0 && rests(part);
  }

  // All that were stopped, for start().
  void start_parts() {
    for (int p = 0; p < parts_kept<Graph>; ++p) {
      bool was_stopped = false;
      start_part(p, was_stopped);
      if (was_stopped) self().tell_part(p, false);
    }
  }

private:
  part_state look([[maybe_unused]] int part) const {
    part_state found;
    if constexpr (parts_kept<Graph> > 0)
      Self::for_each_part_state(
          part, [&]<class Loop>(const auto& state, std::int64_t) { found = state.parts[array_size(part)]; },
          self());
    return found;
  }

  Self& self() { return static_cast<Self&>(*this); }
  const Self& self() const { return static_cast<const Self&>(*this); }

  template <fixed_string Path>
  static constexpr int part_of() {
    static_assert(sizeof(path_refusal<Graph, 0, Path>) != 0);
    constexpr int part = part_with_hash<Graph>(hash(Path.view()));
    static_assert(holds_or_tells<(part >= 0 || !has_path<Graph>(hash(Path.view()))),
                                 never_stopped_alone<Graph, Path>>::value);
    return part;
  }
  void check_state(const char* call, int part) const {
    const state now = self().state();
    if (now == state::created || now == state::loaded)
      throw refused(std::string("cca::controller: ") + call + "(`" + path_of_part<Graph>(part) +
                    "`) is refused in the state `" + std::string(to_string(now)) +
                    "`: start() the controller first");
    self().check_part(call, part);
  }
  void set_part(int part, bool stops) {
    if constexpr (parts_kept<Graph> > 0) {
      check_state(stops ? "stop" : "start", part);
      if constexpr (requires(Self& s) { s.is_ordered(part, stops); })
        if (self().is_ordered(part, stops)) return;
      bool is_change = false;
      Self::for_each_part_state(
          part,
          [&]<class Loop>(auto& state, std::int64_t next) {
            is_change = is_change || state.parts[array_size(part)].is_stopped != stops;
            change_part<Loop>(state, part, stops, next);
          },
          self());
      if (is_change) self().tell_part(part, stops);
    }
  }
  // Without hooks: start() calls those of all components.
  void start_part(int part, bool& was_stopped) {
    if constexpr (parts_kept<Graph> > 0)
      Self::for_each_part_state(
          part,
          [&]<class Loop>(auto& state, std::int64_t next) {
            was_stopped = state.parts[array_size(part)].is_stopped;
            restart_part<Loop>(state, part, next);
          },
          self());
  }
};

}  // namespace cca::detail
