// What `controller` and `deployed` do with their components outside of the loop: the life-cycle, parameters,
// components by path. `Self` is one of the two; it knows where the components are:
//
//   component<Node>()              the component with this number
//   is_here(node)                  whether this process runs it
//   visit(f, self)                 f(number, component) for each, in declaration order
//   forget_runs()                  sets the counts of the runs to zero
//   for_each_state(f)              f.operator()<Graph>(state) for the state of each loop that it runs
//
// Threads: as of `Self`; period() and step_of() may be called by any thread at any time.
#pragma once

#include <string>
#include <string_view>

#include <cca/base/math.hpp>
#include <cca/base/refused.hpp>
#include <cca/component/lifecycle.hpp>
#include <cca/component/parameters.hpp>
#include <cca/component/testing/test_mark.hpp>
#include <cca/graph/verdict/unknown_path.hpp>
#include <cca/runtime/dropped_samples.hpp>
#include <cca/runtime/each_component.hpp>
#include <cca/runtime/observers/loop_observers.hpp>
#include <cca/runtime/parameters_by_path.hpp>
#include <cca/runtime/stoppable_parts.hpp>

namespace cca::detail {

template <class Self, class Graph>
class component_host : public parameters_by_path<Self>,
                       public stoppable_parts<Self, Graph>,
                       public dropped_samples<Self, Graph> {
  friend stoppable_parts<Self, Graph>;
  friend dropped_samples<Self, Graph>;

public:
  // Takes the parameters as they are: the defaults, or what has been set.
  void load() {
    check(transition::load, "load()");
#ifdef CCA_SAME_BITS
    require_same_bits();
#endif
    tell_parameters(self());  // before the hooks, which may read them
    visit([]<class C>(int node, C& component) {
      if constexpr (HasParameters<C>)
        check_parameters(component.p, path_of_node<Graph>(node), detail::step_of<Graph>(node));
    });
    // A hook may refuse, where a file is damaged: then the state stays as it was.
    visit([]<class C>([[maybe_unused]] int node, C& component) {
      if constexpr (OnWired<C>)
        wired_inputs<Graph>::each(node, [&](std::string_view input) { component.on_wired(input); });
      if constexpr (OnLoad<C>) component.on_load();
    });
    move(transition::load, "load()");
    tell_parameters(self());
  }

  // Reads parameters from a file; all or nothing. While it is started, between two beats, it does no more
  // than that, and the state stays. Needs <cca/config.hpp>.
  void load(std::string_view file) {
    static_assert(has_config<Self>, "cca::controller: load(file) needs #include <cca/config.hpp>");
    config_or_none<Self>::load(self(), file);
    if (is_legal(transition::load, now)) load();
    else tell_parameters(self());
  }

  void save() {
    check(transition::save, "save()");
    visit([]<class C>(int, C& component) {
      if constexpr (OnSave<C>) component.on_save();
    });
    move(transition::save, "save()");
  }

  // Writes the parameters into a file. In `loaded` it saves as save() does; between two beats of a started
  // controller it does no more than that, and the state stays.
  void save(std::string_view file) {
    static_assert(has_config<Self>, "cca::controller: save(file) needs #include <cca/config.hpp>");
    if (now == cca::state::created) check(transition::save, "save(file)");
    config_or_none<Self>::save(self(), file);
    if (now == cca::state::loaded) save();
  }

  // One component alone, or those of an inner graph, at a path: reads their parameters from a file, and
  // leaves alone what else it has; writes them into one, which has nothing else then. The hooks on_load and
  // on_save of those that are loaded and not started run: of all in the state `loaded`, else of those whose
  // part is stopped. The state stays.
  template <fixed_string Path>
  void load(std::string_view file) {
    static_assert(sizeof(path_refusal<Graph, 0, Path>) != 0);
    load(Path.view(), file);
  }
  template <fixed_string Path>
  void save(std::string_view file) {
    static_assert(sizeof(path_refusal<Graph, 0, Path>) != 0);
    save(Path.view(), file);
  }
  // The same by a path that is known only at run time.
  void load(std::string_view path, std::string_view file) {
    static_assert(has_config<Self>, "cca::controller: load(path, file) needs #include <cca/config.hpp>");
    check_path(path, "load");
    config_or_none<Self>::load(self(), file, path);
    tell_parameters(self());
    visit_loaded(path, []<class C>(C& component) {
      if constexpr (OnLoad<C>) component.on_load();
    });
    tell_parameters(self());
  }
  void save(std::string_view path, std::string_view file) {
    static_assert(has_config<Self>, "cca::controller: save(path, file) needs #include <cca/config.hpp>");
    if (now == cca::state::created) check(transition::save, "save(path, file)");
    check_path(path, "save");
    config_or_none<Self>::save(self(), file, path);
    visit_loaded(path, []<class C>(C& component) {
      if constexpr (OnSave<C>) component.on_save();
    });
  }

  using stoppable_parts<Self, Graph>::start;  // a part
  using stoppable_parts<Self, Graph>::stop;

  // All components, also those of parts that were stopped.
  void start() {
    move(transition::start, "start()");
    self().forget_runs();
    this->start_parts();
    visit([]<class C>(int, C& component) {
      if constexpr (OnStart<C>) component.on_start();
    });
  }

  void stop() {
    move(transition::stop, "stop()");
    reason = {};
    visit([&]<class C>([[maybe_unused]] int node, C& component) {
      if constexpr (OnStop<C>)
        if (!this->is_resting_node(node)) component.on_stop();
    });
  }

  // Goes on after a fault.
  void resume() {
    move(transition::resume, "resume()");
    reason = {};
    visit([]<class C>(int, [[maybe_unused]] C& component) {
      if constexpr (TestNode<C>) component.end_test();
    });
  }

  cca::state state() const noexcept { return now; }

  // Nanoseconds a beat.
  static constexpr std::int64_t period() { return counts_of<Graph>.period; }

  // What stopped it: a reason and the path of the component; empty in all states but `faulted`.
  cca::fault fault() const noexcept { return reason.fault ? cca::fault(reason.fault) : cca::fault(); }
  // Empty too where no component is the cause, but an overrun.
  std::string fault_path() const {
    return reason.fault && reason.node >= 0 ? path_of_node<Graph>(reason.node) : std::string();
  }

  // A component, by its path; of an inner graph, something with the same `get` for its nodes.
  template <fixed_string Path>
  decltype(auto) get() {
    static_assert(sizeof(path_refusal<Graph, 0, Path>) != 0);
    return found<known_path<Graph, 0, Path>()>(self());
  }
  template <fixed_string Path>
  decltype(auto) get() const {
    static_assert(sizeof(path_refusal<Graph, 0, Path>) != 0);
    return found<known_path<Graph, 0, Path>()>(self());
  }

  // Other parameters of a component, whole, between two beats; refused, and the old ones kept, if they don't
  // hold. In braces they are of the component's own type: `c.set<"cpg">({1.5, 0.0})`.
  using parameters_by_path<Self>::set;  // by a path that is known only at run time
  template <fixed_string Path>
  void set(const typename parameters_at<Graph, Path>::type& parameters) {
    static_assert(sizeof(path_refusal<Graph, 0, Path>) != 0);
    if constexpr (has_parameters<Graph, Path>())
      apply_parameters(get<Path>(), parameters, Path.view(), step_of(Path.view()));
    tell_parameters(self());
  }

  // The time between two firings of the component with this path, in s; one beat if its clock is known only
  // at run time.
  static double step_of(std::string_view path) { return detail::step_of<Graph>(node_at<Graph>(path)); }

  // Refuses a component that another process runs.
  void check_is_here(std::string_view path) const { self().refuse_if_elsewhere(node_at<Graph>(path)); }

  // Calls f(path, component) for each component, in declaration order.
  template <class F>
  void for_each_component(F f) {
    Self::visit([&](int node, auto& component) { f(std::string_view(path_of_node<Graph>(node)), component); },
                self());
  }
  template <class F>
  void for_each_component(F f) const {
    Self::visit(
        [&](int node, const auto& component) { f(std::string_view(path_of_node<Graph>(node)), component); },
        self());
  }

protected:
  // In a beat that the life-cycle does not allow.
  [[gnu::noinline]] void idle() { visit(call_on_idle{}); }

  // Of components of a controller none is elsewhere.
  void refuse_if_elsewhere(int) const {}
  // Before a part is stopped or started: refused where that can't be now. Modes and deployments have such
  // parts.
  void check_part(const char*, int) const {}
  void tell_part(int part, bool stops) { observers().part_changed(part, stops, false, self().beat_index()); }
  void check(transition what, const char* call) const {
    if (!is_legal(what, now))
      throw refused(std::string("cca::controller: ") + call + " is refused in the state `" +
                    std::string(to_string(now)) + "`: " + std::string(remedy(what, now)));
  }
  void move(transition what, const char* call) {
    check(what, call);
    now = after(what, now);
    tell_state();
  }

  // Of a deployment: of its first loop here.
  loop_observers observers() const noexcept {
    loop_observers all;
    if constexpr (Traceable<Graph>) all.track = self().traced_into();
    if constexpr (Recordable<Graph>) all.tap = self().recorded_into();
    return all;
  }
  void tell_state() { observers().moved(now, self().beat_index()); }

  beat_outcome reason{};
  cca::state now = cca::state::created;

private:
  Self& self() { return static_cast<Self&>(*this); }
  const Self& self() const { return static_cast<const Self&>(*this); }

  // Refused: it leads to no node, or to one that another process runs.
  void check_path(std::string_view path, const char* call) const {
    for_each_node_at<Graph>(path, call, [&](int node) { self().refuse_if_elsewhere(node); });
  }
  // Those at a path that are loaded and not started.
  template <class F>
  void visit_loaded(std::string_view path, F f) {
    if (now == cca::state::created) return;
    visit([&](int node, auto& component) {
      if ((now == cca::state::loaded || this->is_resting_node(node)) && is_node_at<Graph>(node, path))
        f(component);
    });
  }
  // Those that run in this process.
  template <class F>
  void visit(F f) {
    Self::visit(
        [&](int node, auto& component) {
          if (self().is_here(node)) f(node, component);
        },
        self());
  }

  // The nodes of an inner graph, whose path has this hash.
  template <class Of, std::uint64_t Scope>
  struct nodes {
    Of& of;

    template <fixed_string Path>
    decltype(auto) get() const {
      static_assert(sizeof(path_refusal<Graph, Scope, Path>) != 0);
      return found<known_path<Graph, Scope, Path>()>(of);
    }
  };

  template <std::uint64_t Path, class Of>
  static decltype(auto) found(Of& of) {
    constexpr int node = node_with_hash<Graph>(Path);
    if constexpr (node >= 0) return (of.template component<node>());
    else return nodes<Of, Path>{of};
  }
};

}  // namespace cca::detail
