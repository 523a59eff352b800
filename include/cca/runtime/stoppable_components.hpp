// Components that are stopped and started on their own, while the architecture runs. The strategy of their
// nodes is `stoppable<...>`.
//
//   c.stop<"camera">();         between two beats: it does not fire any more, its last sample ages
//   c.start<"camera">();        it fires again; what arrived in the meantime is not fresh
//   c.is_stopped<"camera">();   also where it stopped itself, by `cca::done`
//   c.stop("camera");           the same by a path that is known only at run time
//
// In the states `started`, `running` and `faulted`, from the thread that runs the beats. Hooks: on_stop and
// on_start of the component, but no on_stop where it stopped itself. Errors: cca::refused.
// docs/controller.md.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <cca/base/nearest.hpp>
#include <cca/base/refused.hpp>
#include <cca/component/hooks.hpp>
#include <cca/component/lifecycle.hpp>
#include <cca/graph/diagnosis/unknown_path.hpp>
#include <cca/runtime/each_component.hpp>

namespace cca::detail {

template <class Graph>
constexpr bool is_stoppable_node(int node) {
  return plan_of<Graph>.nodes[array_size(node)].item->is_stoppable();
}

// Refused: there is none.
template <class Graph>
int stoppable_node_named(std::string_view path) {
  const int node = node_at<Graph>(path);
  if (node >= 0 && is_stoppable_node<Graph>(node)) return node;
  const std::string text = "cca::controller: `" + std::string(path) + "` ";
  if (node >= 0)
    throw refused(text +
                  "can't be stopped on its own: write cca::stoppable<...> around the strategy of its node");
  std::vector<std::string> paths;
  for (int n = 0; n < counts_of<Graph>.node_count; ++n)
    if (is_stoppable_node<Graph>(n)) paths.push_back(path_of_node<Graph>(n));
  const std::vector<std::string_view> names(paths.begin(), paths.end());
  const auto near = nearest_name(path, names);
  throw refused(text + "is no component" +
                (near.empty() ? "" : "; did you mean `" + std::string(near) + "`?"));
}

template <class Self, class Graph>
class stoppable_components {
public:
  template <fixed_string Path>
  void stop() {
    stop_node(node_of<Path>());
  }
  template <fixed_string Path>
  void start() {
    start_node(node_of<Path>());
  }
  template <fixed_string Path>
  bool is_stopped() const {
    return is_stopped_node(node_of<Path>());
  }

  void stop(std::string_view path) { stop_node(stoppable_node_named<Graph>(path)); }
  void start(std::string_view path) { start_node(stoppable_node_named<Graph>(path)); }
  bool is_stopped(std::string_view path) const { return is_stopped_node(stoppable_node_named<Graph>(path)); }

protected:
  bool is_stopped_node(int node) const {
    bool is_stopped = false;
    if (is_stoppable_node<Graph>(node))
      Self::visit_firings(node, [&](const last_firing& one) { is_stopped = one.is_stopped; }, self());
    return is_stopped;
  }
  // As at the beginning, but that nothing which has arrived is fresh.
  void begin_anew(int node) {
    Self::visit_firings(
        node,
        [&](last_firing& one) {
          one.is_stopped = false;
          one.is_first = true;
          one.last = self().next_beat_of(node) - 1;
        },
        self());
  }

private:
  Self& self() { return static_cast<Self&>(*this); }
  const Self& self() const { return static_cast<const Self&>(*this); }

  template <fixed_string Path>
  static constexpr int node_of() {
    static_assert(sizeof(path_refusal<Graph, 0, Path>) != 0);
    constexpr int node = node_at<Graph>(Path.view());
    static_assert(node < 0 || is_stoppable_node<Graph>(node),
                  "cca::controller: this component can't be stopped on its own: write cca::stoppable<...> "
                  "around the strategy of its node");
    return node;
  }
  void check_state(const char* call, int node) const {
    const state now = self().state();
    if (now == state::created || now == state::loaded)
      throw refused(std::string("cca::controller: ") + call + "(`" + path_of_node<Graph>(node) +
                    "`) is refused in the state `" + std::string(to_string(now)) +
                    "`: start() the controller first");
    self().check_runs(call, node);
  }
  void stop_node(int node) {
    check_state("stop", node);
    if (is_stopped_node(node)) return;
    Self::visit_firings(node, [](last_firing& one) { one.is_stopped = true; }, self());
    Self::visit(
        [node]<class C>(int n, C& component) {
          if constexpr (OnStop<C>)
            if (n == node) component.on_stop();
        },
        self());
  }
  void start_node(int node) {
    check_state("start", node);
    if (!is_stopped_node(node)) return;
    begin_anew(node);
    Self::visit(
        [node]<class C>(int n, C& component) {
          if constexpr (OnStart<C>)
            if (n == node) component.on_start();
        },
        self());
  }
};

}  // namespace cca::detail
