// The controller of a graph: all its components, folded into one loop. It is a value: a copy is a snapshot.
//
//   cca::controller<trot<cca::sim::oncilla>> c;
//   c.load(); c.start(); c.run(cca::for_<10>{});
//
// Outside of the loop, what can't be done is refused by `cca::refused` with a message. In the loop nothing
// throws, allocates or locks. So no other thread may call anything here, `get`, `set` and `observed`
// included, while a beat runs: call them between two beats, in the thread that runs them.
#pragma once

#include <string>
#include <string_view>

#include <cca/component/lifecycle.hpp>
#include <cca/component/parameters.hpp>
#include <cca/base/refused.hpp>
#include <cca/graph/diagnosis/unknown_path.hpp>
#include <cca/runtime/each_component.hpp>
#include <cca/runtime/one_beat.hpp>
#include <cca/runtime/pace.hpp>
#include <cca/runtime/parameters_by_path.hpp>
#include <cca/runtime/refusal.hpp>
#include <cca/runtime/run_record.hpp>

namespace cca {
namespace detail {

template <class Graph>
struct is_watched {
  static constexpr bool holds(std::size_t o) { return plan_of<Graph>.outputs[o].watched; }
};

}  // namespace detail

template <class Graph>
  requires well_formed<Graph>
class controller<Graph> : public detail::parameters_by_path<controller<Graph>> {
public:
  // Takes the parameters as they are: the defaults, or what has been set.
  void load() {
    check(detail::transition::load, "load()");
    visit(
        []<class C>(int node, C& component) {
          if constexpr (HasParameters<C>)
            check_parameters(component.p, path_of(node), detail::step_of<Graph>(node));
        },
        state_of_all);
    // A hook may refuse, where a file is damaged: then the state stays as it was.
    visit(
        []<class C>(int, C& component) {
          if constexpr (detail::OnLoad<C>) component.on_load();
        },
        state_of_all);
    move(detail::transition::load, "load()");
  }

  // Reads parameters from a file; all or nothing. Needs <cca/config.hpp>.
  void load(std::string_view file) {
    static_assert(detail::HasConfig<controller>,
                  "cca::controller: load(file) needs #include <cca/config.hpp>");
    check(detail::transition::load, "load(file)");
    detail::config_backend<controller>::load(*this, file);
    load();
  }

  void save() {
    check(detail::transition::save, "save()");
    visit(
        []<class C>(int, C& component) {
          if constexpr (detail::OnSave<C>) component.on_save();
        },
        state_of_all);
    move(detail::transition::save, "save()");
  }

  // Writes the parameters into a file. In `loaded` it saves as save() does; between two beats of a started
  // controller it does no more than that, and the state stays.
  void save(std::string_view file) {
    static_assert(detail::HasConfig<controller>,
                  "cca::controller: save(file) needs #include <cca/config.hpp>");
    if (now == cca::state::created) check(detail::transition::save, "save(file)");
    detail::config_backend<controller>::save(*this, file);
    if (now == cca::state::loaded) save();
  }

  void start() {
    move(detail::transition::start, "start()");
    runs.overruns = runs.lost_periods = 0;
    visit(
        []<class C>(int, C& component) {
          if constexpr (detail::OnStart<C>) component.on_start();
        },
        state_of_all);
  }

  void stop() {
    move(detail::transition::stop, "stop()");
    reason = {};
    visit(
        []<class C>(int, C& component) {
          if constexpr (detail::OnStop<C>) component.on_stop();
        },
        state_of_all);
  }

  // Goes on after a fault.
  void resume() {
    move(detail::transition::resume, "resume()");
    reason = {};
  }

  // One beat. False where the life-cycle does not allow it: before start(), after stop() and after a fault.
  // Then only the hook `on_idle` of resource nodes runs: a robot goes on stopping.
  bool step() noexcept {
    const bool may_run = detail::is_legal(detail::transition::run, now);
    if (may_run) advance();
    else if constexpr (detail::has_idle_hook<Graph>) idle();
    return may_run;
  }

  // Beats for a time, at a pace, and between them a call of yours: between(*this). Ends at once on a fault,
  // and where `between` returns false. Whatever ends it, an exception too, it is then `started` or `faulted`.
  template <class Duration, class Pace = as_fast_as_possible, class Between = void (*)(controller&)>
  cca::state run(Duration duration, Pace pace = {}, Between&& between = [](controller&) {}) {
    move(detail::transition::run, "run()");
    {
      const detail::end_of_run at_the_end{now};
      const std::int64_t beats = duration.beats(period());
      runs.begin(pace, period());
      for (std::int64_t i = 0; i < beats && now == cca::state::running; ++i) {
        if (const cca::fault late = runs.wait(pace, i * period())) fail({late.reason(), -1});
        else advance();
        if (!detail::goes_on_after(between, *this)) break;
      }
    }
    return now;
  }

  // In the runs at wall-clock speed since start(): the beats that were still running when the next should
  // begin, and the periods in which no beat began.
  std::int64_t overruns() const noexcept { return runs.overruns; }
  std::int64_t lost_periods() const noexcept { return runs.lost_periods; }

  cca::state state() const noexcept { return now; }

  // The next beat.
  std::int64_t beat_index() const noexcept { return k; }

  // Nanoseconds a beat.
  static constexpr std::int64_t period() { return detail::counts_of<Graph>.period; }

  // What stopped it: a reason and the path of the component; empty in all states but `faulted`.
  cca::fault fault() const noexcept { return reason.fault ? cca::fault(reason.fault) : cca::fault(); }
  // Empty too where no component is the cause, but an overrun.
  std::string fault_path() const {
    return reason.fault && reason.node >= 0 ? path_of(reason.node) : std::string();
  }

  // A component, by its path; of an inner graph, something with the same `get` for its nodes.
  template <fixed_string Path>
  decltype(auto) get() {
    constexpr auto path = detail::hash(Path.view());
    static_assert(decltype(detail::check_path<Graph, 0, Path, path>())::value || true);
    return at<path, detail::node_with_hash<Graph>(path)>(*this);
  }
  template <fixed_string Path>
  decltype(auto) get() const {
    constexpr auto path = detail::hash(Path.view());
    static_assert(decltype(detail::check_path<Graph, 0, Path, path>())::value || true);
    return at<path, detail::node_with_hash<Graph>(path)>(*this);
  }

  // Calls f(observation) for each output that an `observe` among the items of a graph names, with its newest
  // sample; fresh: published in the last beat.
  template <class F>
  void observed(F f) const {
    [&]<int... Output>(std::integer_sequence<int, Output...>) {
      const int all[] = {0, (observe_output<Output>(f), 0)...};
      (void)all;
    }(detail::chosen<detail::counts_of<Graph>.output_count, detail::is_watched<Graph>>{});
  }

  // Other parameters of a component, whole, between two beats; refused, and the old ones kept, if they don't
  // hold. In braces they are of the component's own type: `c.set<"cpg">({1.5, 0.0})`.
  using detail::parameters_by_path<controller>::set;  // by a path that is known only at run time
  template <fixed_string Path, class Parameters = typename detail::parameters_at<Graph, Path>::type>
  void set(const Parameters& parameters) {
    if constexpr (detail::can_set<Graph, Path>())
      detail::apply_parameters(get<Path>(), parameters, Path.view(), step_of(Path.view()));
  }

  // The time between two firings of the component with this path, in s; one beat if its clock is known only
  // at run time.
  static double step_of(std::string_view path) {
    return detail::step_of<Graph>(detail::node_at<Graph>(path));
  }

  // Calls f(path, component) for each component, in declaration order.
  template <class F>
  void for_each_component(F f) {
    visit([&](int node, auto& component) { f(std::string_view(path_of(node)), component); }, state_of_all);
  }
  template <class F>
  void for_each_component(F f) const {
    visit([&](int node, const auto& component) { f(std::string_view(path_of(node)), component); },
          state_of_all);
  }

private:
  template <class F, class State>
  static void visit(F f, State& state) {
    detail::visit_components<Graph>(f, state);
  }
  static std::string path_of(int node) { return detail::path_of_node<Graph>(node); }

  // The nodes of an inner graph, whose path has this hash.
  template <class Controller, std::uint64_t Scope>
  struct nodes {
    Controller& of;

    template <fixed_string Path>
    decltype(auto) get() const {
      constexpr auto path = detail::hash(Path.view(), detail::after_dot(Scope));
      static_assert(decltype(detail::check_path<Graph, Scope, Path, path>())::value || true);
      return at<path, detail::node_with_hash<Graph>(path)>(of);
    }
  };

  template <std::uint64_t Path, int Node, class Controller>
  static decltype(auto) at(Controller& controller) {
    if constexpr (Node >= 0) {
      return (detail::component_at<Graph, Node>(controller.state_of_all));
    } else {
      return nodes<Controller, Path>{controller};
    }
  }

  template <int Output, class F>
  void observe_output(F& f) const {
    constexpr detail::place at = detail::layout_of<Graph>.outputs[Output];
    const auto& stored = detail::sample_in<Graph, at.array>(state_of_all, at.index);
    const auto* sample = stored.show(k - 1, 0);
    const double* values =
        sample ? sample->vector().data() : detail::output_port_of<Graph, Output>.space->zero;
    f(observation{detail::path_of_output<Graph, Output>(),
                  {values, static_cast<std::size_t>(detail::size_of_output<Graph, Output>)},
                  sample ? sample->origin() : never,
                  k > 0 && stored.arrived(k - 1, 0) == k - 1});
  }

  void check(detail::transition what, const char* call) const {
    if (!detail::is_legal(what, now))
      throw refused(std::string("cca::controller: ") + call + " is refused in the state `" +
                    std::string(to_string(now)) + "`: " + std::string(detail::remedy(what, now)));
  }
  void move(detail::transition what, const char* call) {
    check(what, call);
    now = detail::after(what, now);
  }

  [[gnu::flatten]] void advance() noexcept {
    detail::beat_outcome beat_outcome;
    detail::beat_of_graph<Graph>::run(state_of_all, beat_outcome, k);
    ++k;
    if constexpr (detail::counts_of<Graph>.may_fault)
      if (beat_outcome.fault) fail(beat_outcome);
  }

  // In the beat of the fault, instead of what would still have come.
  [[gnu::noinline]] void fail(const detail::beat_outcome& beat_outcome) noexcept {
    reason = beat_outcome;
    visit(
        []<class C>(int, C& component) {
          if constexpr (detail::IsResource<C> && detail::OnFault<C>) component.on_fault();
        },
        state_of_all);
    now = detail::after(detail::transition::fail, now);
  }

  [[gnu::noinline]] void idle() noexcept {
    visit(
        []<class C>(int, C& component) {
          if constexpr (detail::IsResource<C> && detail::OnIdle<C>) component.on_idle();
        },
        state_of_all);
  }

  detail::controller_state<Graph> state_of_all;
  std::int64_t k = 0;
  detail::beat_outcome reason{};
  cca::state now = cca::state::created;
  detail::run_record runs{};
};

}  // namespace cca
