// EXPECT no_number_of_axis: space\.unknown_axis: attitude \(orientation<world> over x, y, z\) has 4 numbers over 3 axes, so none of them is that of an axis
// EXPECT no_number_of_output: space\.unknown_axis: attitude \(orientation<world> over x, y, z\) has 4 numbers over 3 axes, so none of them is that of an axis
// EXPECT many_states: space\.unknown_axis: two_states \(status over hip, knee\) has a state along each of its axes: name one, as in `as<mood>\(hip\{\}\)`
// EXPECT no_state: cca::status: `as<int>\(\)` reads a sample of state \(status over x\), whose numbers are states
// EXPECT array_of_numbers: space\.bad_domain: the elements of `cca::array_of<int, 3>` are no space: name a struct derived from cca::space<\.\.\.>
// EXPECT empty_array: space\.bad_axes: `cca::array_of<leg_angles, 0>` is to have as many elements, and an array has at least one
// EXPECT bounds_swapped: component\.bad_parameter: the lower bound of a parameter, 5, is above its upper bound, 2\.5, so no value fits
// EXPECT derived_without_value: component\.bad_parameter: `step` stands in a cca::derived, but states no `value`: write `using value = \.\.\.;` and a static function `of`
// EXPECT derived_text: component\.bad_parameter: the value of `text_of` has a destructor that does something
// EXPECT derived_from_itself: component\.bad_parameter: `half` stands in a cca::derived, and builds on its own value: take it out of the `cca::from` of those on which it builds
// EXPECT derived_of_port: component\.bad_parameter: `of_port` makes no `double` of `sample<signal>`: a cca::derived needs a function `static value of\(\.\.\.\)` for that
// EXPECT derived_of_two: component\.bad_parameter: `of_two` makes no `double` of `double` and `double`: a cca::derived needs a function `static value of\(\.\.\.\)` for that
// EXPECT derived_of_other_input: component\.bad_parameter: `of` of a cca::derived of `number` takes the input `x`, whose value it is, and got `other`: name the input alike in both, or for the value of another sample call `anew`
// EXPECT derived_of_sample: component\.bad_parameter: `of` of a cca::derived of `number` takes the input `x`, whose value it is, and got a `sample<signal>`: name the input alike in both, or for the value of another sample call `anew`
// EXPECT derived_view: component\.bad_parameter: the value of `view` is `Ref<const Matrix<double, 1, 1[^>]*>>`: a cca::derived keeps a value of its own: state a type that owns its numbers, not a pointer, a reference, a view or an expression
// EXPECT derived_nothing: component\.bad_parameter: the value of `nothing` is `void`: a cca::derived keeps a value of its own: state a type that owns its numbers, not a pointer, a reference, a view or an expression
// EXPECT derived_narrow: component\.bad_parameter: `narrow` makes `double` and no `int` of `sample<signal>`: a cca::derived needs a function `static value of\(\.\.\.\)` for that
// EXPECT derived_no_list: component\.bad_parameter: the `from` of `no_list` is `number`: write `using from = cca::from<\.\.\.>;` with the functions on whose values it builds
// EXPECT twice_limited: space\.bad_limits: a `cca::limits` lists `angle` twice: state one range for each quantity
// EXPECT never_stopped: strategy\.not_stoppable: the component `walk\.step` \(step\) of walking can not be stopped on its own: write `cca::stoppable<\.\.\.>` around its strategy
// EXPECT never_stopped_graph: strategy\.not_stoppable: the inner graph `walk` of walking can not be stopped on its own: write `cca::stoppable<>` behind the graph
// EXPECT farm_options: skeleton\.arity: the farm of step has the options `latest`, `delayed<1>`, and its only one is cca::inner_wires<policies\.\.\.>
// EXPECT read_as_other: cca::controller::parameter: a parameter is read as `char ?\*`, which is neither std::string, bool, an integer nor a number
// EXPECT no_deployment: cca::deployed: `walking` is no deployment: derive one from `cca::deployment<walking, cca::environment<\.\.\.>, \.\.\.>`, or run the graph by `cca::controller<walking>`
// EXPECT no_core: deployment\.bad_environment: `cca::on_core<-1>` is no core: they are counted from 0
// EXPECT no_priority: deployment\.bad_environment: the priority 100 of cca::realtime is none: they go from 1 to 99
// EXPECT no_tracing: cca::tracer: `walking` is not derived from cca::traceable, so its beats tell nothing
// EXPECT nothing_traced: cca::tracer: it observes a cca::controller or a cca::deployed, and `walking` is neither
// EXPECT no_recording: cca::recording::recorder: `walking` is not derived from cca::recordable, so its beats tell nothing: write `struct walking : \.\.\., cca::recordable \{\};`
// EXPECT nothing_recorded: cca::recording::recorder: it observes a cca::controller or a cca::deployed, and `walking` is neither
// EXPECT no_replay: cca::recording::replay: `walking` is not derived from cca::recordable
// EXPECT nothing_live: cca::live_access: it is made from a cca::controller or a cca::deployed, and `walking` is neither
// LINES: 25
// What a template of the core takes, and what it says of an argument that it can't use. Up to nine of the
// lines are of this file: an alias and a function between the mistake and where it is asked for.
#include <cca/cca.hpp>
#include <cca/config.hpp>
#include <cca/deployment.hpp>
#include <cca/record.hpp>
#include <cca/runtime/live/live_access.hpp>
#include <cca/trace/tracer.hpp>

#include "../parts.hpp"
#include "late.hpp"

enum class mood { calm, angry };
struct state : cca::space<cca::status, cca::axes<cca::x>> {};
struct two_states : cca::space<cca::status, cca::axes<hip, knee>> {};
struct signal : cca::space<cca::number, cca::axes<cca::x>> {};
struct source {
  auto process(cca::beat) -> cca::out<"y", signal> { return 1.0; }
};
struct step {
  auto process(cca::in<"x", signal> x) -> cca::out<"y", signal> { return x.vector(); }
};
struct text_of {
  using value = std::string;
  static value of(const auto&) { return "text"; }
};
struct other_half;
struct half {
  using value = double;
  using from = cca::from<other_half>;
  static value of(double whole) { return whole / 2; }
};
struct other_half {
  using value = double;
  using from = cca::from<half>;
  static value of(double other) { return other; }
};
struct of_port {
  using value = double;
  static value of(cca::in<"x", signal> x) { return x.vector()[0]; }
};
struct number {
  using value = double;
  static value of(const auto& x) { return x.vector()[0]; }
};
struct of_two {
  using value = double;
  using from = cca::from<number, number>;
  static value of(double one) { return one; }
};
struct view {
  using value = Eigen::Ref<const signal::vector_type>;
  static value of(const auto& x) { return x.vector(); }
};
struct nothing {
  using value = void;
  static void of(const auto&) {}
};
struct narrow {
  using value = int;
  static double of(const auto& x) { return x.vector()[0]; }
};
struct no_list {
  using value = double;
  using from = number;
  static double of(double x) { return x; }
};
struct sink {
  void process(cca::in<"x", signal>) {}
};
struct walk : cca::graph<cca::node<"step", step>, cca::expose<"step.x", "x">, cca::expose<"step.y", "y">> {};
struct walking : cca::graph<cca::rate<1000>,
                            cca::node<"from", source>,
                            cca::node<"walk", walk>,
                            cca::node<"to", sink>,
                            cca::wire<"from.y", "walk.x">,
                            cca::wire<"walk.y", "to.x">> {};
static_assert(cca::well_formed<walking>);

namespace broken {

template <class Sample>
auto read_hip(const Sample& now) {
  return now[cca::x{}];
}
template <class Port>
auto write_hip() {
  Port port;
  return port[cca::x{}] = 1;
}
template <class State, class Sample>
auto state_of(const Sample& now) {
  return now.template as<State>();
}
template <cca::fixed_string Path, class Controller>
auto stop(Controller& c) {
  c.template stop<Path>();
  return 0;
}
template <class Function, class Sample>
auto derive(const Sample& x) {
  return cca::derived<Function, "x">().of(x);
}
template <class Type, class Controller>
auto read(const Controller& c) {
  return c.template parameter<Type>("walk.step.gain");
}
template <class Graph>
auto replayed() {
  return cca::recording::replay<Graph>("walk.mcap");
}

using walker = cca::controller<walking>;

template <class T>
using no_number_of_axis = decltype(read_hip(std::declval<late<cca::sample<attitude>, T>>()));
template <class T>
using no_number_of_output = decltype(write_hip<late<cca::out<"y", attitude>, T>>());
template <class T>
using many_states = decltype(state_of<mood>(std::declval<late<cca::sample<two_states>, T>>()));
template <class T>
using no_state = decltype(state_of<int>(std::declval<late<cca::sample<state>, T>>()));
template <class T>
using empty_array = cca::array_of<late<leg_angles, T>, 0>;
template <class T>
using array_of_numbers = cca::array_of<late<int, T>, 3>;
template <class T>
using bounds_swapped = cca::bounded<late<double, T>, 5.0, 2.5>;
template <class T>
using derived_without_value = cca::derived<late<step, T>, "x">;
template <class T>
using derived_text = cca::derived<late<text_of, T>, "x">;
template <class T>
using derived_from_itself = cca::derived<late<half, T>, "x">;
template <class T>
using derived_of_port = decltype(derive<of_port>(std::declval<late<cca::in<"x", signal>, T>>()));
template <class T>
using derived_of_two = decltype(derive<of_two>(std::declval<late<cca::in<"x", signal>, T>>()));
template <class T>
using derived_of_other_input = decltype(derive<number>(std::declval<late<cca::in<"other", signal>, T>>()));
template <class T>
using derived_of_sample = decltype(derive<number>(std::declval<late<cca::sample<signal>, T>>()));
template <class T>
using derived_view = cca::derived<late<view, T>, "x">;
template <class T>
using derived_nothing = cca::derived<late<nothing, T>, "x">;
template <class T>
using derived_narrow = decltype(derive<narrow>(std::declval<late<cca::in<"x", signal>, T>>()));
template <class T>
using derived_no_list = cca::derived<late<no_list, T>, "x">;
template <class T>
using twice_limited = cca::limits<late<cca::angle, T>, cca::angle>;
template <class T>
using never_stopped = decltype(stop<"walk.step">(std::declval<late<walker, T>&>()));
template <class T>
using never_stopped_graph = decltype(stop<"walk">(std::declval<late<walker, T>&>()));
template <class T>
using farm_options = cca::farm<late<step, T>, signal, signal, cca::latest, cca::delayed<1>>;
template <class T>
using read_as_other = decltype(read<char*>(std::declval<late<walker, T>>()));
template <class T>
using no_deployment = cca::deployed<late<walking, T>>;
template <class T>
using no_core = late<cca::on_core<-1>, T>;
template <class T>
using no_priority =
    std::integral_constant<int, cca::detail::wish_of<late<cca::realtime<100>, T>>::value.priority>;
template <class T>
using no_tracing = cca::tracer<late<walker, T>>;
template <class T>
using nothing_traced = cca::tracer<late<walking, T>>;
template <class T>
using no_recording = cca::recording::recorder<late<walker, T>>;
template <class T>
using nothing_recorded = cca::recording::recorder<late<walking, T>>;
template <class T>
using no_replay = decltype(replayed<late<walking, T>>());
template <class T>
using nothing_live = cca::live_access<late<walking, T>>;
template <class T>
using none = cca::array_of<late<leg_angles, T>, 2>;

}  // namespace broken

#ifndef CCA_REJECT
constexpr auto size = sizeof(broken::none<signal>);
#else
constexpr auto size = sizeof(broken::CCA_REJECT<signal>);
#endif
