// Traces a controller into a file that Perfetto (ui.perfetto.dev) and chrome://tracing open, from now on
// until it is destroyed or closed: when each component fired and how long it took, a track for each
// environment, overruns, late samples, faults and the life-cycle as marks.
//
//   cca::controller<trot> c;                    // struct trot : cca::graph<...>, cca::traceable {};
//   cca::tracer trace(c, "trot.json");          // or a cca::deployed, or the controller of a set of modes
//   c.load(); c.start(); c.run(...);
//   trace.close();
//   std::cout << trace.summary();
//
// A thread of its own writes. The loop puts its events into a ring: no allocation, no lock, no wait, no
// system call. Beats that don't fit are counted, and marked in the file.
//
// Errors: std::system_error if the file can't be opened, cca::refused if it is traced already. If writing
// fails later, the loop goes on, and `problem()` says what happened. Threads: all of it for one thread, while
// no beat runs. A cca::deployed must not be moved meanwhile. Cost: docs/traces.md. Test:
// tests/runtime/trace/.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>

#include <cca/graph/marks/unmarked.hpp>
#include <cca/base/refused.hpp>
#include <cca/base/type_name.hpp>
#include <cca/graph/deployment/deployed_modes.hpp>
#include <cca/graph/modes/plan_of_modes.hpp>
#include <cca/runtime/controller.hpp>
#include <cca/trace/trace_writer.hpp>

namespace cca {

struct trace_settings {
  std::string name{};                     // of the program; empty: that of the graph
  std::size_t buffered_events = 1 << 16;  // of each environment, at least: 2 MB
  bool waits = false;                     // the loop may wait for the file: it is a fast run
};

template <class D>
class deployed;

namespace detail {

// What a tracer must know of each loop of a controller.
template <class Controller>
struct traced_loops {
  static_assert(holds_or_tells<false, not_observed<Controller, observer::tracer>>::value);
  struct graph : traceable {};
};
template <class Graph>
  requires(!Modes<Graph>)
struct traced_loops<controller<Graph>> {
  using graph = Graph;

  static trace_names names(int, const std::string& program) {
    trace_names all;
    all.track = program;
    all.components = paths_of_components<Graph>();
    add_calls<Graph>(all.calls);
    return all;
  }
  static trace_track::room room(int) {
    trace_track::room one{.in_beat = array_size(counts_of<Graph>.order_count)};
    if constexpr (Recordable<Graph>) one.words = array_size(frame_layout_of<Graph>.words);
    return one;
  }
};
template <class D>
struct traced_loops<deployed<D>> {
  using graph = D;

  static trace_names names(int environment, const std::string&) {
    trace_names all;
    all.track = name_of_environment<D>(array_size(environment));
    all.components = paths_of_components<D>();
    for (const auto& one : environments_of<D>::all) all.environments.push_back(one.name);
    if constexpr (DeploymentOfModes<D>) {
      for_each_deployed_mode<D>([&]<class Mode>() {
        add_calls<Mode>(all.calls);
        all.modes.push_back(Mode::cca_mode_name);
      });
    } else {
      add_calls<D>(all.calls);
    }
    return all;
  }
  static trace_track::room room(int) {
    trace_track::room one{.in_beat = array_size(counts_of<D>.order_count)};
    if constexpr (DeploymentOfModes<D>)
      for_each_deployed_mode<D>([&]<class Mode>() {
        one.in_beat = std::max(one.in_beat, array_size(counts_of<Mode>.order_count));
      });
    if constexpr (Recordable<D>)
      one.words = most_words(std::make_integer_sequence<int, environment_count<D>>{});
    return one;
  }
  template <int... E>
  static constexpr std::size_t most_words(std::integer_sequence<int, E...>) {
    if constexpr (DeploymentOfModes<D>)
      return std::max({std::size_t{0}, array_size(frame_layout_of<modes_in<D, E>>.words)...});
    else return std::max({std::size_t{0}, array_size(frame_layout_of<part<D, E>>.words)...});
  }
};
template <Modes M>
struct traced_loops<controller<M>> {
  using graph = M;

  static trace_names names(int, const std::string& program) {
    trace_names all;
    all.track = program;
    all.components = paths_of_components<M>();
    [&]<int... I>(std::integer_sequence<int, I...>) {
      (add_calls<mode_part<M, I>>(all.calls), ...);
    }(std::make_integer_sequence<int, mode_count<M>>{});
    for (int m = 0; m < mode_count<M>; ++m) all.modes.push_back(modes_of<M>::value.modes[m].name);
    return all;
  }
  static trace_track::room room(int) {
    std::size_t most = 0;
    [&]<int... I>(std::integer_sequence<int, I...>) {
      ((most = std::max(most, array_size(counts_of<mode_part<M, I>>.order_count))), ...);
    }(std::make_integer_sequence<int, mode_count<M>>{});
    trace_track::room one{.in_beat = most};
    if constexpr (Recordable<M>) one.words = array_size(frame_layout_of<M>.words);
    return one;
  }
};

}  // namespace detail

template <class Controller>
class tracer {
  using loops = detail::traced_loops<Controller>;
  static_assert(
      detail::holds_or_tells<detail::Traceable<typename loops::graph>,
                             detail::unmarked<typename loops::graph, detail::observer::tracer>>::value);

public:
  tracer(Controller& c, const std::string& file, const trace_settings& s = {})
      : writer(refuse_if_traced(c, file), name_of(s)) {
    c.for_each_trace([&](int loop, detail::trace_pointer& from) {
      detail::trace_track::room room = loops::room(loop);
      room.in_beat = 2 * room.in_beat + 4;  // each call may wait before; the beat, and those lost before it
      room.events = s.buffered_events;
      room.waits = s.waits;
      writer.add(from, loops::names(loop, name_of(s)), room);
    });
    writer.begin();
    c.traced_into()->moved(c.state());
  }

  // Ends the trace. Not while a beat runs.
  void close() { writer.close(); }
  // Ends it too, and leaves no file: an older one of this name stays.
  void discard() { writer.discard(); }

  // After close().
  trace_summary summary() const { return writer.summary(); }

  // Beats that did not fit.
  std::int64_t lost_beats() const { return writer.lost_beats(); }
  // Why nothing more is written; empty: all is well.
  std::string problem() const { return writer.problem(); }

private:
  static std::string name_of(const trace_settings& s) {
    return s.name.empty() ? std::string(detail::type_name<typename loops::graph>()) : s.name;
  }
  static std::string refuse_if_traced(const Controller& c, const std::string& file) {
    if (c.traced_into()) throw refused("cca::tracer: this controller is being traced already");
    return file;
  }

  detail::trace_writer writer;
};

// Of a controller that breaks a rule: the message is the controller's.
template <detail::Refused Controller>
class tracer<Controller> {
public:
  tracer(Controller&, const std::string&, const trace_settings& = {}) {}
  ~tracer() {}
  void close() {}
  void discard() {}
  trace_summary summary() const { return {}; }
  std::int64_t lost_beats() const { return 0; }
  std::string problem() const { return {}; }
};

template <class Controller>
tracer(Controller&, const std::string&, const trace_settings& = {}) -> tracer<Controller>;

}  // namespace cca
