// What cca::live_access sees of the three controllers: which loop runs a component, what a loop observes, and
// which components may be changed now.
#pragma once

#include <string_view>
#include <utility>

#include <cca/graph/deployment/environments.hpp>
#include <cca/graph/items/modes.hpp>
#include <cca/runtime/controller.hpp>
#include <cca/runtime/live/ordered.hpp>

namespace cca {
template <class D>
class deployed;
}

namespace cca::detail {

// Of one loop: a graph, or a set of modes.
template <class Controller>
struct live_loops {
  static constexpr int count = 1;
  static constexpr int of_node(int) { return 0; }
};
template <class D>
struct live_loops<deployed<D>> {
  static constexpr int count = environment_count<D>;
  static constexpr int of_node(int node) { return plan_of<D>.nodes[array_size(node)].place; }
};

// A friend of each controller.
struct live_components {
  // The component. Where another process runs it, this process has one that no loop uses.
  template <int Node, class Controller>
  static auto& at(Controller& c) {
    if constexpr (requires { c.template component_of<Node>(c); }) return c.template component_of<Node>(c);
    else return c.template component<Node>();
  }
  template <class Controller>
  static bool is_here(const Controller& c, int node) {
    return c.is_here(node);
  }
  // The loop whose thread gives the orders of this process: what has effect in several loops, in one beat
  // (environments/links/agreed_changes.hpp). -1: there are none.
  template <class Controller>
  static int ordering_loop(const Controller& c) {
    if constexpr (requires { c.first_here(); }) return c.first_here();
    else return -1;
  }
  // Does what is asked need one? `part`: -1, a mode.
  template <class Controller>
  static bool needs_order([[maybe_unused]] const Controller& c, [[maybe_unused]] int part) {
    if constexpr (requires { c.needs_order(part); }) return c.needs_order(part);
    else return false;
  }
  // The beat in which it has effect; -1: it has had it.
  template <class Controller>
  static std::int64_t give_order([[maybe_unused]] Controller& c,
                                 [[maybe_unused]] ordered what,
                                 [[maybe_unused]] int number) {
    if constexpr (requires { c.order(what, number); }) {
      if (c.is_computing) return c.order(what, number);
      if (what != ordered::mode) c.order_at_rest(number, what == ordered::stop);
      else if constexpr (requires { c.has_part_in_mode(0); }) c.move_to(number);
    }
    return -1;
  }
  // Whether that loop has begun this beat, or the run is over.
  template <class Controller>
  static bool is_over([[maybe_unused]] const Controller& c, [[maybe_unused]] std::int64_t beat) {
    if constexpr (requires { c.next_of_first_here(); })
      return !c.is_computing || c.next_of_first_here() > beat;
    else return true;
  }

  // Whether this process runs the loop that gives the beat.
  template <class Controller>
  static bool gives_beat(const Controller& c) {
    if constexpr (requires { c.here[0]; }) return c.here[0];
    else return true;
  }
  template <class Controller>
  static void refuse(int node) {
    if constexpr (requires { Controller::refuse_elsewhere(node); }) Controller::refuse_elsewhere(node);
  }

  // f(observation) for each output that may ever be observed here.
  template <class Controller, class F>
  static void for_each_output(const Controller& c, F f) {
    if constexpr (requires { c.observed_in_any_mode(f); }) c.observed_in_any_mode(f);
    else c.observed_newest(f);
  }
  // Of all loops, while they rest.
  template <class Controller, class F>
  static void observe_all(const Controller& c, F f) {
    c.observed_newest(f);
  }
  // Of one loop, between two of its beats.
  template <int Loop, class Controller, class F>
  static void observe(const Controller& c, F f) {
    if constexpr (requires { c.template observed_in<Loop>(f); }) c.template observed_in<Loop>(f);
    else c.observed_newest(f);
  }

  // A part stops or starts, as far as this loop has it.
  template <int Loop, class Controller>
  static void set_part(Controller& c, int part, std::string_view path, bool stops) {
    if constexpr (requires { c.template set_part_in<Loop>(part, stops); })
      c.template set_part_in<Loop>(part, stops);
    else if (stops) c.stop(path);
    else c.start(path);
  }

  // ---- modes ----

  template <class Controller>
  static bool has_part_now(const Controller& c, int part) {
    if constexpr (requires { c.has_part(part); }) return c.has_part(part);
    else if constexpr (requires { c.has_part_in_mode(part); }) return c.has_part_in_mode(part);
    else return true;
  }
  template <class Controller>
  static int mode_number(std::string_view name) {
    return Controller::number_of(name);
  }
  template <class Controller, fixed_string Mode>
  static constexpr int mode_number() {
    return Controller::template mode_named<Mode>();
  }
  template <class Controller>
  static std::string_view mode_name(int number) {
    return Controller::all.modes[number].name;
  }
  template <class Controller>
  static int active_mode(const Controller& c) {
    if constexpr (requires { c.active; }) return c.active;
    else if constexpr (requires { c.has_part_in_mode(0); }) return c.number();
    else return 0;
  }
  template <class Controller>
  static void switch_to(Controller& c, int mode) {
    c.move_to(mode);
  }
};

}  // namespace cca::detail
