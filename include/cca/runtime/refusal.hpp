// The controller of a graph that breaks a rule: one error, which is the message. `check` gives the same error
// without a controller:
//
//   static_assert(cca::check<trot<cca::sim::oncilla>>());
//
// Errors: all rules of graphs. Example: docs/tutorial/5_wrong_wire.md.
#pragma once

#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include <cca/component/fault.hpp>
#include <cca/component/lifecycle.hpp>
#include <cca/graph/verdict/diagnosis.hpp>
#include <cca/graph/verdict/shown_ports.hpp>
#include <cca/graph/layout/nodes_by_path.hpp>

namespace cca {

template <class Graph>
class controller;
template <class D>
class deployed;

namespace detail {

struct anything {
  template <class... Values>
  constexpr anything(Values&&...) {}
};

// The controller of what breaks a rule. What is made from it (a recorder, a tracer, a live_access) does
// nothing, so nothing else is reported.
template <class>
inline constexpr bool is_refused = false;
template <class Graph>
inline constexpr bool is_refused<controller<Graph>> = !well_formed<Graph>;
template <class D>
inline constexpr bool is_refused<deployed<D>> = !well_formed<D>;
template <class Controller> concept Refused = is_refused<Controller>;

}  // namespace detail

// The calls are there so that nothing else is reported.
template <class Graph>
class controller {
  static_assert(sizeof(detail::refusal<Graph>) != 0);

  // A component, or the nodes of an inner graph; also where there is neither.
  template <std::uint64_t Path, int Node>
  struct part {
    using type = typename detail::node_types<Graph, Node>::component&;
  };
  template <std::uint64_t Scope>
  struct part<Scope, -1> {
    using type = part;

    template <fixed_string Path, std::uint64_t Whole = detail::hash(Path.view(), detail::after_dot(Scope))>
    auto get() const -> typename part<Whole, detail::node_with_hash<Graph>(Whole)>::type;
  };

public:
  constexpr operator bool() const { return true; }  // as the result of `check`

  void load(std::string_view = {}) {}
  void save(std::string_view = {}) {}
  void load(std::string_view, std::string_view) {}
  void save(std::string_view, std::string_view) {}
  template <fixed_string>
  void load(std::string_view) {}
  template <fixed_string>
  void save(std::string_view) {}
  void start() {}
  void stop() {}
  template <fixed_string>
  void start() {}
  template <fixed_string>
  void stop() {}
  template <fixed_string>
  bool is_stopped() const {
    return false;
  }
  void start(std::string_view) {}
  void stop(std::string_view) {}
  bool is_stopped(std::string_view) const { return false; }
  void resume() {}
  bool step() noexcept { return false; }
  template <class Duration, class Pace = int, class Between = int>
  cca::state run(const Duration&, const Pace& = {}, Between&& = {}) {
    return {};
  }
  cca::state state() const noexcept { return {}; }
  cca::fault fault() const noexcept { return {}; }
  std::string fault_path() const { return {}; }
  std::int64_t overruns() const noexcept { return 0; }
  std::int64_t lost_periods() const noexcept { return 0; }
  std::int64_t beat_index() const noexcept { return 0; }
  static constexpr std::int64_t period() { return detail::counts_of<Graph>.period; }
  template <fixed_string Path>
  auto get() const -> typename part<detail::hash(Path.view()), detail::node_at<Graph>(Path.view())>::type;
  template <fixed_string Path, class Parameters>
  void set(const Parameters&) {}
  template <fixed_string Path>
  void set(detail::anything) {}  // in braces
  void set(std::string_view, detail::anything) {}
  template <class Type = std::string>
  Type parameter(std::string_view) const {
    return {};
  }
  std::vector<std::string> parameter_paths() const { return {}; }
  template <fixed_string Mode>
  void switch_to() {}
  void switch_to(std::string_view) {}
  std::string_view mode() const noexcept { return {}; }
  template <class F>
  void observed(F) const {}
  template <class F>
  void for_each_component(F) const {}
  template <class F>
  void for_each_queue(F) const {}
  template <fixed_string>
  std::int64_t dropped() const {
    return 0;
  }
  std::int64_t dropped(std::string_view = {}) const { return 0; }
};

// `check<G>()`: true for a sound graph, deployment or set of modes; any other does not compile. It is the
// refused controller itself, so a mistake is reported once, at the line that comes first.
template <class Graph>
using check = std::conditional_t<well_formed<Graph>, detail::checked_shows<Graph>, controller<Graph>>;

}  // namespace cca
