// Rules about a component alone: the message of each mistake, and that the mended one is sound.
#include <string>
#include <tuple>
#include <utility>

#include "rules_parts.hpp"

namespace {

using namespace parts;

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

struct process_and_act {
  void process(cca::beat) {}
  void act(cca::in<"x", signal>) {}
};

struct kinds_of_driver : khz<cca::node<"a", process_and_act>> {};
static_assert(tells<kinds_of_driver, both_kinds_mended>(
    {"component.no_process", "a",
     "`a` (process_and_act) has both `process` and `act`: a component has `process`, a resource node has "
     "`sense` and `act`; make two nodes of it"}));

// A lambda's type has another name on each compiler.
struct of_lambda : khz<cca::node<"a", decltype([](cca::beat) -> cca::out<"y", signal> {
  return {}; })>> {};
static_assert(cca::diagnosis<of_lambda>.rule == "component.no_process" &&
              cca::diagnosis<of_lambda>.where == "a");
static_assert(cca::diagnosis<of_lambda>.message.starts_with("component.no_process: `a` ("));
static_assert(
    cca::diagnosis<of_lambda>.message.ends_with(") is a lambda, which has no `process` from which its ports "
                                                "could be read: write a struct whose `process` "
                                                "does what the lambda does, as in `struct gait { auto "
                                                "process(cca::in<...>) -> cca::out<...>; };`; what it "
                                                "captures becomes members and parameters"));

struct with_number {
  void process(cca::beat, int) {}
};

struct takes_number : khz<cca::node<"a", with_number>> {};
struct takes_number_mended : khz<cca::node<"a", source<>>> {};
static_assert(tells<takes_number, takes_number_mended>(
    {"component.bad_parameter", "a",
     "`a` (with_number): `process` takes `int`, but it may take only ports (cca::in, cca::optional_in, "
     "cca::observe), a cca::derived of one of them and the cca::beat, each by value or by reference to "
     "const; give constants as `parameters`, and data of other components by a wire"}));

struct with_reference {
  void process(cca::in<"x", signal>&) {}
};

struct takes_reference
    : khz<cca::node<"a", with_reference>, cca::node<"s", source<>>, cca::wire<"s.y", "a.x">> {};
struct takes_reference_mended : khz<cca::node<"a", source<>>> {};
static_assert(tells<takes_reference, takes_reference_mended>(
    {"component.bad_parameter", "a",
     "`a` (with_reference): `process` takes `in<x, signal>&`, but it may take only ports (cca::in, "
     "cca::optional_in, cca::observe), a cca::derived of one of them and the cca::beat, each by value or by "
     "reference to const; give constants as `parameters`, and data of other components by a wire"}));

struct with_output {
  void act(cca::out<"x", signal>) {}
};

struct takes_output : khz<cca::node<"a", with_output>> {};
struct takes_output_mended : khz<cca::node<"a", source<>>> {};
static_assert(tells<takes_output, takes_output_mended>(
    {"component.bad_parameter", "a",
     "`a` (with_output): `act` takes `out<x, signal>`, but it may take only ports (cca::in, "
     "cca::optional_in, cca::observe), a cca::derived of one of them and the cca::beat, each by value or by "
     "reference to const; give constants as `parameters`, and data of other components by a wire"}));

struct length_of {
  using value = double;
  static value of(const auto& sample) { return sample.vector().norm(); }
};
struct with_derived {
  void process(cca::in<"x", signal>, cca::derived<length_of, "y">) {}
};
struct with_derived_mended {
  void process(cca::in<"x", signal>, cca::derived<length_of, "x">) {}
};

struct derives_from_nothing
    : khz<cca::node<"a", with_derived>, cca::node<"s", source<>>, cca::wire<"s.y", "a.x">> {};
struct derives_from_nothing_mended
    : khz<cca::node<"a", with_derived_mended>, cca::node<"s", source<>>, cca::wire<"s.y", "a.x">> {};
static_assert(tells<derives_from_nothing, derives_from_nothing_mended>(
    {"component.bad_parameter", "a",
     "`a` (with_derived): `process` takes a cca::derived of `y`, but has no input of that name: name the "
     "cca::in from whose sample the value follows"}));

// Of an observer, which shows more than one sample, nothing can be derived.
struct with_observer {
  void process(cca::observe<"s.*">, cca::derived<length_of, "s.*">) {}
};
struct derives_from_observer : khz<cca::node<"a", with_observer>, cca::node<"s", source<>>> {};
static_assert(tells<derives_from_observer, derives_from_nothing_mended>(
    {"component.bad_parameter", "a",
     "`a` (with_observer): `process` takes a cca::derived of `s.*`, but has no input of that name: name the "
     "cca::in from whose sample the value follows"}));

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

// A correct hook hides no wrong one.
struct faults_with_reason : source<> {
  void on_load() {}
  void on_fault(const char*) {}
};

struct second_hook : khz<cca::node<"a", faults_with_reason>> {};
static_assert(tells<second_hook, hook_mended>(
    {"component.hook_signature", "a",
     "`a` (faults_with_reason) has a hook `on_fault` that would never be called, because it is not `void "
     "on_fault()`: make it a public function of that signature, or give it another name"}));

}  // namespace
