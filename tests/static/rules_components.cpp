// Rules about a node alone: what it is told, and that the mended one is sound.
#include <string>
#include <tuple>
#include <utility>

#include "rules_parts.hpp"

namespace {

using namespace parts;

struct twice : khz<cca::node<"a", source<>>, cca::node<"a", step<>>, cca::wire<"a.y", "a.x">> {};
struct twice_mended : khz<cca::node<"a", source<>>, cca::node<"b", step<>>, cca::wire<"a.y", "b.x">> {};
static_assert(tells<twice, twice_mended>({"node.duplicate_name", "a",
                                          "two nodes of twice are named `a` (source<>, step<>), so a path to "
                                          "them has two meanings: give one of them another name"}));

struct twice_outside : khz<cca::node<"a", source<>>,
                           cca::node<"b", source<>>,
                           cca::expose<"a.y", "y">,
                           cca::expose<"b.y", "y">> {};
struct twice_outside_mended : khz<cca::node<"a", source<>>,
                                  cca::node<"b", source<>>,
                                  cca::expose<"a.y", "y">,
                                  cca::expose<"b.y", "z">> {};
static_assert(tells<twice_outside, twice_outside_mended>(
    {"node.duplicate_name", "b.y",
     "two outputs are exposed as `y` by twice_outside: give one of them another name"}));

struct twice_inside : khz<cca::node<"g", twice>> {};
struct twice_inside_mended : khz<cca::node<"g", twice_mended>> {};
static_assert(tells<twice_inside, twice_inside_mended>(
    {"node.duplicate_name", "g.a",
     "two nodes of twice are named `a` (source<>, step<>), so a path to them has two meanings: give one of "
     "them another name"}));

struct nothing {};

struct empty : khz<cca::node<"a", nothing>> {};
struct empty_mended : khz<cca::node<"a", source<>>> {};
static_assert(tells<empty, empty_mended>(
    {"component.no_process", "a",
     "`a` (nothing) has no `process` from which its ports could be read: give it one, public, neither "
     "overloaded nor a template, as in `auto process(cca::in<...>) -> cca::out<...>`; a resource node has "
     "`sense` and `act` instead"}));

struct number : khz<cca::node<"a", int>> {};
struct number_mended : khz<cca::node<"a", source<>>> {};
static_assert(tells<number, number_mended>(
    {"component.no_process", "a",
     "`a` (int) has no `process` from which its ports could be read: give it one, public, neither overloaded "
     "nor a template, as in `auto process(cca::in<...>) -> cca::out<...>`; a resource node has `sense` and "
     "`act` instead"}));

struct unchanging : khz<cca::node<"a", const source<>>> {};
struct unchanging_mended : khz<cca::node<"a", source<>>> {};
static_assert(tells<unchanging, unchanging_mended>(
    {"component.no_process", "a",
     "`a` (source<>) is const, but a component changes as it runs: remove the `const`"}));

struct two_processes {
  void process(cca::in<"x", signal>) {}
  void process(cca::beat) {}
};

struct overloaded : khz<cca::node<"a", two_processes>> {};
struct overloaded_mended : khz<cca::node<"a", source<>>> {};
static_assert(tells<overloaded, overloaded_mended>(
    {"component.no_process", "a",
     "`a` (two_processes) has no `process` from which its ports could be read: give it one, public, neither "
     "overloaded nor a template, as in `auto process(cca::in<...>) -> cca::out<...>`; a resource node has "
     "`sense` and `act` instead"}));

class private_process {
  void process(cca::beat) {}
};

struct hidden : khz<cca::node<"a", private_process>> {};
struct hidden_mended : khz<cca::node<"a", source<>>> {};
static_assert(tells<hidden, hidden_mended>(
    {"component.no_process", "a",
     "`a` (private_process) has no `process` from which its ports could be read: give it one, public, "
     "neither overloaded nor a template, as in `auto process(cca::in<...>) -> cca::out<...>`; a resource "
     "node has `sense` and `act` instead"}));

struct template_process {
  template <class Port>
  void process(Port) {}
};

struct generic : khz<cca::node<"a", template_process>> {};
struct generic_mended : khz<cca::node<"a", source<>>> {};
static_assert(tells<generic, generic_mended>(
    {"component.no_process", "a",
     "`a` (template_process) has no `process` from which its ports could be read: give it one, public, "
     "neither overloaded nor a template, as in `auto process(cca::in<...>) -> cca::out<...>`; a resource "
     "node has `sense` and `act` instead"}));

struct process_is_data {
  int process = 0;
};

struct data : khz<cca::node<"a", process_is_data>> {};
struct data_mended : khz<cca::node<"a", source<>>> {};
static_assert(tells<data, data_mended>(
    {"component.no_process", "a",
     "`a` (process_is_data) has no `process` from which its ports could be read: give it one, public, "
     "neither overloaded nor a template, as in `auto process(cca::in<...>) -> cca::out<...>`; a resource "
     "node has `sense` and `act` instead"}));

struct process_and_sense {
  void process(cca::beat) {}
  auto sense() -> cca::out<"y", signal> { return {}; }
};

struct both_kinds : khz<cca::node<"a", process_and_sense>> {};
struct both_kinds_mended : khz<cca::node<"a", source<>>> {};
static_assert(tells<both_kinds, both_kinds_mended>(
    {"component.no_process", "a",
     "`a` (process_and_sense) has both `process` and `sense`: a component has `process`, a resource node has "
     "`sense` and `act`; make two nodes of it"}));

struct with_number {
  void process(cca::beat, int) {}
};

struct takes_number : khz<cca::node<"a", with_number>> {};
struct takes_number_mended : khz<cca::node<"a", source<>>> {};
static_assert(tells<takes_number, takes_number_mended>(
    {"component.bad_parameter", "a",
     "`a` (with_number): `process` takes `int`, but it may take only ports (cca::in, cca::optional_in, "
     "cca::observe) and the cca::beat, each by value or by reference to const; give constants as "
     "`parameters`, and data of other components by a wire"}));

struct with_reference {
  void process(cca::in<"x", signal>&) {}
};

struct takes_reference
    : khz<cca::node<"a", with_reference>, cca::node<"s", source<>>, cca::wire<"s.y", "a.x">> {};
struct takes_reference_mended : khz<cca::node<"a", source<>>> {};
static_assert(tells<takes_reference, takes_reference_mended>(
    {"component.bad_parameter", "a",
     "`a` (with_reference): `process` takes `in<x, signal>&`, but it may take only ports (cca::in, "
     "cca::optional_in, cca::observe) and the cca::beat, each by value or by reference to const; give "
     "constants as `parameters`, and data of other components by a wire"}));

struct with_output {
  void act(cca::out<"x", signal>) {}
};

struct takes_output : khz<cca::node<"a", with_output>> {};
struct takes_output_mended : khz<cca::node<"a", source<>>> {};
static_assert(tells<takes_output, takes_output_mended>(
    {"component.bad_parameter", "a",
     "`a` (with_output): `act` takes `out<x, signal>`, but it may take only ports (cca::in, "
     "cca::optional_in, cca::observe) and the cca::beat, each by value or by reference to const; give "
     "constants as `parameters`, and data of other components by a wire"}));

struct same_inputs {
  void process(cca::in<"x", signal>, cca::in<"x", signal>) {}
};

struct two_inputs : khz<cca::node<"a", same_inputs>, cca::node<"s", source<>>, cca::wire<"s.y", "a.x">> {};
struct two_inputs_mended : khz<cca::node<"a", source<>>> {};
static_assert(
    tells<two_inputs, two_inputs_mended>({"component.bad_parameter", "a",
                                          "`a` (same_inputs) has two inputs named `x`, so a wire to it would "
                                          "have two meanings: give one of them another name"}));

struct same_in_halves {
  auto sense(cca::in<"w", signal>) -> cca::out<"y", signal> { return {}; }
  void act(cca::in<"v", signal>, cca::in<"w", signal>) {}
};

struct two_inputs_of_halves
    : khz<cca::node<"a", same_in_halves>, cca::node<"s", source<>>, cca::wire<"s.y", "a.x">> {};
struct two_inputs_of_halves_mended : khz<cca::node<"a", source<>>> {};
static_assert(tells<two_inputs_of_halves, two_inputs_of_halves_mended>(
    {"component.bad_parameter", "a",
     "`a` (same_in_halves) has two inputs named `w`, so a wire to it would have two meanings: give one of "
     "them another name"}));

struct same_outputs {
  auto process(cca::beat) -> std::tuple<cca::out<"y", signal>, cca::maybe<"y", signal>> { return {}; }
};

struct two_outputs : khz<cca::node<"a", same_outputs>> {};
struct two_outputs_mended : khz<cca::node<"a", source<>>> {};
static_assert(
    tells<two_outputs, two_outputs_mended>({"component.bad_result", "a",
                                            "`a` (same_outputs) has two outputs named `y`, so a wire to it "
                                            "would have two meanings: give one of them another name"}));

struct gives_number {
  double process(cca::beat) { return 0; }
};

struct returns_number : khz<cca::node<"a", gives_number>> {};
struct returns_number_mended : khz<cca::node<"a", source<>>> {};
static_assert(tells<returns_number, returns_number_mended>(
    {"component.bad_result", "a",
     "`a` (gives_number): `process` returns `double`, but it may return only ports (cca::out, cca::maybe), "
     "a cca::fault, a cca::done, cca::switch_to<...>, cca::stops<...> and cca::starts<...>, one or several "
     "in a "
     "std::tuple, or void"}));

struct gives_pair {
  auto process(cca::beat) -> std::pair<cca::out<"y", signal>, int> { return {}; }
};

struct returns_pair : khz<cca::node<"a", gives_pair>> {};
struct returns_pair_mended : khz<cca::node<"a", source<>>> {};
static_assert(tells<returns_pair, returns_pair_mended>(
    {"component.bad_result", "a",
     "`a` (gives_pair): `process` returns `pair<out<y, signal>, int>`, but it may return only ports "
     "(cca::out, cca::maybe), a cca::fault, a cca::done, cca::switch_to<...>, cca::stops<...> and "
     "cca::starts<...>, one or several in a std::tuple, or void"}));

struct gives_tuple {
  auto sense() -> std::tuple<cca::out<"y", signal>, bool> { return {}; }
};

struct returns_tuple : khz<cca::node<"a", gives_tuple>> {};
struct returns_tuple_mended : khz<cca::node<"a", source<>>> {};
static_assert(tells<returns_tuple, returns_tuple_mended>(
    {"component.bad_result", "a",
     "`a` (gives_tuple): `sense` returns `bool`, but it may return only ports (cca::out, cca::maybe), a "
     "cca::fault, a cca::done, cca::switch_to<...>, cca::stops<...> and cca::starts<...>, one or several in "
     "a "
     "std::tuple, or void"}));

struct starts_with_beat : source<> {
  void on_start(cca::beat) {}
};

struct hook : khz<cca::node<"a", starts_with_beat>> {};
struct hook_mended : khz<cca::node<"a", source<>>> {};
static_assert(tells<hook, hook_mended>(
    {"component.hook_signature", "a",
     "`a` (starts_with_beat) has a hook `on_start` that would never be called, because it is not `void "
     "on_start()`: make it a public function of that signature, or give it another name"}));

class loads_in_private : public source<> {
  void on_load() {}
};

struct hook_hidden : khz<cca::node<"a", loads_in_private>> {};
struct hook_hidden_mended : khz<cca::node<"a", source<>>> {};
static_assert(tells<hook_hidden, hook_hidden_mended>(
    {"component.hook_signature", "a",
     "`a` (loads_in_private) has a hook `on_load` that would never be called, because it is not `void "
     "on_load()`: make it a public function of that signature, or give it another name"}));

struct stops_in_two_ways : source<> {
  int on_stop() { return 0; }
  void on_save(int) {}
  void on_save() {}
};
struct stops : source<> {
  void on_stop() noexcept {}
  void on_save() const {}
  static void on_load() {}
};

struct hook_overloaded : khz<cca::node<"a", stops_in_two_ways>> {};
struct hook_overloaded_mended : khz<cca::node<"a", stops>> {};
static_assert(tells<hook_overloaded, hook_overloaded_mended>(
    {"component.hook_signature", "a",
     "`a` (stops_in_two_ways) has a hook `on_stop` that would never be called, because it is not `void "
     "on_stop()`: make it a public function of that signature, or give it another name"}));

struct fault_is_data : source<> {
  bool on_fault = false;
};

struct hook_is_data : khz<cca::node<"a", fault_is_data>> {};
struct hook_is_data_mended : khz<cca::node<"a", source<>>> {};
static_assert(tells<hook_is_data, hook_is_data_mended>(
    {"component.hook_signature", "a",
     "`a` (fault_is_data) has a hook `on_fault` that would never be called, because it is not `void "
     "on_fault()`: make it a public function of that signature, or give it another name"}));

struct with_pointer : source<> {
  struct parameters {
    BOOST_HANA_DEFINE_STRUCT(parameters, (double, gain), (void*, table));
  };
  parameters p{};
};
struct with_gain : source<> {
  struct parameters {
    BOOST_HANA_DEFINE_STRUCT(parameters, (double, gain), (bool, on));
  };
  parameters p{1, true};
};

struct parameter : khz<cca::node<"a", with_pointer>> {};
struct parameter_mended : khz<cca::node<"a", with_gain>> {};
static_assert(tells<parameter, parameter_mended>(
    {"parameters.unsupported_type", "a",
     "`a` (with_pointer): its parameter `table` is a `void*`, which no file can hold: use a number, bool, "
     "enum class, cca::bounded, cca::quantity, cca::text, a std::array or Eigen vector of fixed size of "
     "these, or a struct with BOOST_HANA_DEFINE_STRUCT"}));

struct tuning {
  BOOST_HANA_DEFINE_STRUCT(tuning, (int, order), (std::string, model));
};
struct with_inner_text : source<> {
  struct parameters {
    BOOST_HANA_DEFINE_STRUCT(parameters, (double, gain), (tuning, filter));
  };
  parameters p{};
};

struct parameter_nested : khz<cca::node<"a", with_inner_text>> {};
struct parameter_nested_mended : khz<cca::node<"a", with_gain>> {};
static_assert(tells<parameter_nested, parameter_nested_mended>(
    {"parameters.unsupported_type", "a",
     "`a` (with_inner_text): its parameter `filter.model` is a `std::string`, which no file can hold: use a "
     "number, bool, enum class, cca::bounded, cca::quantity, cca::text, a std::array or Eigen vector of "
     "fixed size of these, or a struct with BOOST_HANA_DEFINE_STRUCT"}));

struct without_p : source<> {
  struct parameters {
    BOOST_HANA_DEFINE_STRUCT(parameters, (double, gain));
  };
};

struct parameter_forgotten : khz<cca::node<"a", without_p>> {};
struct parameter_forgotten_mended : khz<cca::node<"a", with_gain>> {};
static_assert(tells<parameter_forgotten, parameter_forgotten_mended>(
    {"parameters.unsupported_type", "a",
     "`a` (without_p) has a struct `parameters` but no public member `parameters p`, so nothing would ever "
     "set them: add `parameters p{...};` with the default values"}));

struct without_names : source<> {
  struct parameters {
    double gain;
  };
  parameters p{};
};

struct parameter_unknown : khz<cca::node<"a", without_names>> {};
struct parameter_unknown_mended : khz<cca::node<"a", with_gain>> {};
static_assert(tells<parameter_unknown, parameter_unknown_mended>(
    {"parameters.unsupported_type", "a",
     "`a` (without_names): its parameter `p` is a `without_names::parameters`, whose fields are unknown: "
     "name them in it with BOOST_HANA_DEFINE_STRUCT, and make it copyable"}));

struct hip_twice : cca::space<cca::joint_angles, cca::axes<hip, knee, hip>> {};

struct axis_twice : khz<cca::node<"a", source<hip_twice>>> {};
struct axis_twice_mended : khz<cca::node<"a", source<angles>>> {};
static_assert(tells<axis_twice, axis_twice_mended>(
    {"space.duplicate_axis", "a.y",
     "the space hip_twice of `a.y` has the axis `hip` twice, so reading along it has two meanings: name each "
     "axis once in cca::axes<...>"}));

struct axis_twice_read : khz<cca::node<"a", listener<hip_twice>>> {};
struct axis_twice_read_mended : khz<cca::node<"a", source<angles>>> {};
static_assert(tells<axis_twice_read, axis_twice_read_mended>(
    {"space.duplicate_axis", "a.x",
     "the space hip_twice of `a.x` has the axis `hip` twice, so reading along it has two meanings: name each "
     "axis once in cca::axes<...>"}));

struct trigger : khz<cca::node<"a", source<>>,
                     cca::node<"b", sink<>, cca::port_triggered<"xx">>,
                     cca::wire<"a.y", "b.x">> {};
struct trigger_mended : khz<cca::node<"a", source<>>,
                            cca::node<"b", sink<>, cca::port_triggered<"x">>,
                            cca::wire<"a.y", "b.x">> {};
static_assert(tells<trigger, trigger_mended>(
    {"strategy.unknown_port", "b",
     "`b` (sink<>) is cca::port_triggered by `xx`, but it has no such input; did you mean `x`?"}));

struct trigger_within
    : khz<cca::node<"a", source<>>,
          cca::node<"b",
                    sink<>,
                    cca::any_of<cca::timed<3>, cca::all_of<cca::timed<5>, cca::port_triggered<"x", "y">>>>,
          cca::wire<"a.y", "b.x">> {};
struct trigger_within_mended
    : khz<cca::node<"a", source<>>,
          cca::node<"b",
                    sink<>,
                    cca::any_of<cca::timed<3>, cca::all_of<cca::timed<5>, cca::port_triggered<"x">>>>,
          cca::wire<"a.y", "b.x">> {};
static_assert(tells<trigger_within, trigger_within_mended>(
    {"strategy.unknown_port", "b",
     "`b` (sink<>) is cca::port_triggered by `y`, but it has no such input; did you mean `x`?"}));

struct trigger_none : khz<cca::node<"a", source<>, cca::port_triggered<"x">>> {};
struct trigger_none_mended : khz<cca::node<"a", source<>>> {};
static_assert(tells<trigger_none, trigger_none_mended>(
    {"strategy.unknown_port", "a",
     "`a` (source<>) is cca::port_triggered by `x`, but it has no such input: it has no inputs at all"}));

struct resource_waits : khz<cca::node<"r", robot<signal>, cca::restless>,
                            cca::node<"a", source<>>,
                            cca::wire<"a.y", "r.command">> {};
struct resource_waits_mended : khz<cca::node<"r", robot<signal>, cca::timed<1>>,
                                   cca::node<"a", source<>>,
                                   cca::wire<"a.y", "r.command">> {};
static_assert(tells<resource_waits, resource_waits_mended>(
    {"strategy.misplaced", "r",
     "`r` (robot<parts::signal>) is a resource node, which runs at fixed beats: it may be cca::timed, "
     "cca::full_speed or cca::inactive"}));

struct inner : cca::graph<cca::node<"a", source<>>, cca::node<"b", sink<>>, cca::wire<"a.y", "b.x">> {};

struct graph_fires : khz<cca::node<"g", inner, cca::timed<2>>> {};
struct graph_fires_mended : khz<cca::node<"g", inner>> {};
static_assert(tells<graph_fires, graph_fires_mended>(
    {"strategy.misplaced", "g",
     "`g` (inner) is a graph, and a strategy stands on components: give it to the nodes inside"}));

struct no_item : khz<cca::node<"a", source<>>, source<>> {};
struct no_item_mended : khz<cca::node<"a", source<>>> {};
static_assert(tells<no_item, no_item_mended>(
    {"graph.unknown_item", "no_item",
     "`source<>` in no_item is no item of a graph, so it would be ignored: write cca::node<`name`, type> for "
     "a component or graph; the others are cca::wire, cca::expose, cca::observe, cca::rate and "
     "cca::require<cca::latency<...>, cca::beats<N>>"}));

struct no_bound : khz<cca::node<"a", source<>>,
                      cca::node<"b", sink<>>,
                      cca::wire<"a.y", "b.x">,
                      cca::require<cca::latency<"a.y", "b.x">, cca::rate<2>>> {};
struct no_bound_mended : khz<cca::node<"a", source<>>,
                             cca::node<"b", sink<>>,
                             cca::wire<"a.y", "b.x">,
                             cca::require<cca::latency<"a.y", "b.x">, cca::beats<2>>> {};
static_assert(tells<no_bound, no_bound_mended>(
    {"graph.unknown_item", "no_bound",
     "`require<latency<a.y, b.x>, rate<2>>` in no_bound is no item of a graph, so it would be ignored: write "
     "cca::node<`name`, type> for a component or graph; the others are cca::wire, cca::expose, cca::observe, "
     "cca::rate and cca::require<cca::latency<...>, cca::beats<N>>"}));

struct dotted_node : khz<cca::node<"a.b", source<>>> {};
struct dotted_node_mended : khz<cca::node<"a_b", source<>>> {};
static_assert(
    tells<dotted_node, dotted_node_mended>({"node.bad_name", "a.b",
                                            "a node of dotted_node is named `a.b`, but dots join names to "
                                            "paths, and `*` stands for any name: use neither in a name"}));

struct nameless_node : khz<cca::node<"", source<>>> {};
struct nameless_node_mended : khz<cca::node<"a", source<>>> {};
static_assert(tells<nameless_node, nameless_node_mended>(
    {"node.bad_name", "nameless_node",
     "a node of nameless_node has no name, so no wire could name it: give it one"}));

struct with_dotted_port {
  void process(cca::optional_in<"x.1", signal>, cca::beat) {}
};

struct dotted_port : khz<cca::node<"a", with_dotted_port>> {};
struct dotted_port_mended : khz<cca::node<"a", source<>>> {};
static_assert(tells<dotted_port, dotted_port_mended>(
    {"node.bad_name", "a",
     "a port of `a` (with_dotted_port) is named `x.1`, but dots join names to paths, and `*` stands for any "
     "name: use neither in a name"}));

struct starred_expose : khz<cca::node<"a", source<>>, cca::expose<"a.y", "all.*">> {};
struct starred_expose_mended : khz<cca::node<"a", source<>>, cca::expose<"a.y", "all">> {};
static_assert(tells<starred_expose, starred_expose_mended>(
    {"node.bad_name", "a.y",
     "a port that starred_expose exposes is named `all.*`, but dots join names to paths, and `*` stands for "
     "any name: use neither in a name"}));

struct no_strategy : khz<cca::node<"a", source<>, signal>> {};
struct no_strategy_mended : khz<cca::node<"a", source<>>> {};
static_assert(tells<no_strategy, no_strategy_mended>(
    {"strategy.no_fires", "a",
     "`a` (source<>) has the strategy `signal`, which cannot say when it fires: use one like cca::timed<10> "
     "or cca::moderate, or give it `template <class Inputs> static bool fires(cca::beat, const Inputs&)` "
     "(not "
     "static if it has a state) and a constructor without arguments"}));

struct fires_by_beat_only {
  static bool fires(cca::beat) { return true; }
};
struct fires_at_once {
  static bool fires(cca::beat, const auto&) { return true; }
};

struct no_template_strategy
    : khz<cca::node<"a", source<>>, cca::node<"b", sink<>, fires_by_beat_only>, cca::wire<"a.y", "b.x">> {};
struct no_template_strategy_mended
    : khz<cca::node<"a", source<>>, cca::node<"b", sink<>, fires_at_once>, cca::wire<"a.y", "b.x">> {};
static_assert(tells<no_template_strategy, no_template_strategy_mended>(
    {"strategy.no_fires", "b",
     "`b` (sink<>) has the strategy `fires_by_beat_only`, which cannot say when it fires: use one like "
     "cca::timed<10> or cca::moderate, or give it `template <class Inputs> static bool fires(cca::beat, "
     "const Inputs&)` (not static if it has a state) and a constructor without arguments"}));

// A component, and not even that, in place of a graph.
static_assert(!cca::well_formed<nothing> && !cca::well_formed<int>);
static_assert(told{
    "graph.unknown_item", "nothing",
    "`nothing` is no graph: a controller runs a struct derived from cca::graph<...>; put a "
    "component into one as cca::node<`name`, nothing>; if another error names nothing, mend that "
    "first: a comma may be missing between two items of the graph, or a value (a lambda, an object) stands "
    "where a type should"}
                  .by(cca::diagnosis<nothing>));

}  // namespace
