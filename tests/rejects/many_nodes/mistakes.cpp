// EXPECT graph_unknown_item: graph\.unknown_item: `sink` in graph_unknown_item is no item of a graph, so it would be ignored: write cca::node<`name`, type> for a component or
// EXPECT node_bad_name: node\.bad_name: a node of node_bad_name is named `extra\.one`, but dots join names to paths, and `\*` stands for any name: use neither in a
// EXPECT strategy_no_fires: strategy\.no_fires: `extra` \(source\) has the strategy `sink`, which cannot say when it fires: use one like cca::timed<10> or cca::moderate, or give it
// EXPECT wire_bad_option: wire\.bad_option: the wire `n7\.y` -> `extra\.x` has the option `timed<2>`, which is no option of a wire: it may have a policy \(cca::latest, cca::delayed<N>,
// EXPECT node_duplicate_name: node\.duplicate_name: two nodes of node_duplicate_name are named `n7` \(step, sink\), so a path to them has two meanings: give one of them another name
// EXPECT skeleton_arity: skeleton\.arity: `extra` \(switch_between<.*>\) has 1 source, but between fewer than two there is nothing to choose or to mix: name two or more, or
// EXPECT component_no_process: component\.no_process: `extra` \(without_function\) has no `process` from which its ports could be read: give it one, public, neither overloaded nor a template
// EXPECT component_bad_parameter: component\.bad_parameter: `extra` \(takes_number\): `process` takes `double`, but it may take only ports \(cca::in, cca::optional_in, cca::observe\), a cca::derived of one of them and
// EXPECT component_bad_result: component\.bad_result: `extra` \(returns_number\): `process` returns `double`, but it may return only ports \(cca::out, cca::maybe\), a cca::fault, a cca::done
// EXPECT component_hook_signature: component\.hook_signature: `extra` \(starts_with_number\) has a hook `on_start` that would never be called, because it is not `void on_start\(\)`: make it a
// EXPECT parameters_unsupported_type: parameters\.unsupported_type: `extra` \(has_pointer\): its parameter `table` is a `const double ?\*`, which no file can hold: use a number, bool, enum
// EXPECT space_duplicate_axis: space\.duplicate_axis: the space angle_twice of `extra\.y` has the axis `hip` twice, so reading along it has two meanings: name each axis once in
// EXPECT strategy_unknown_port: strategy\.unknown_port: `extra` \(merge\) is cca::port_triggered by `c`, but it has no such input; did you mean `a`\?
// EXPECT strategy_misplaced: strategy\.misplaced: `extra` \(actuator<signal>\) is a resource node, which runs at fixed beats: it may be cca::timed, cca::full_speed or cca::inactive
// EXPECT strategy_not_stoppable: strategy\.not_stoppable: `extra` \(finishing\) returns cca::done, by which it stops itself, but its strategy does not let it be stopped: write cca::stoppable<\.\.\.>
// EXPECT part_unknown_path: part\.unknown_path: `extra` \(stops_others\) stops or starts `n77`, but there is no node of this path in its graph, nor in the graphs around it
// EXPECT wire_unknown_port: wire\.unknown_port: the wire `n8\.out` -> `extra\.b` in wire_unknown_port names `n8\.out`, but `n8` \(step\) has no such output; did you mean `n8\.y`\?
// EXPECT wire_direction: wire\.direction: a wire leads from an output to an input, but in `extra\.x` -> `n7\.y` in wire_direction `extra\.x` is an input and `n7\.y` an output:
// EXPECT wire_two_writers: wire\.two_writers: `n23\.x` is written by `n22\.y` and by `n7\.y`, but an input has one writer: put an arbiter in front, cca::arbiter<`x`, signal,
// EXPECT wire_bad_initial: wire\.bad_initial: cca::initial of the wire `n7\.y` -> `extra\.x` gives 2 numbers, but `extra\.x` has 1: give one for each, or one for all
// EXPECT space_mismatch: space\.mismatch: `extra\.y` publishes hip_angle \(joint_angles over hip\) but `end\.x` expects signal \(number over x\): the domain types differ; put a
// EXPECT learner_request: learner\.request: `extra\.y` may request of `pupil\.learn` what is not possible there: `learn` needs a learner that learns online, and this one learns in batches only
// EXPECT wire_unconnected_input: wire\.unconnected_input: `extra\.b` is not connected: in wire_unconnected_input, wire an output of signal \(number over x\) to `extra\.b`, or expose it,
// EXPECT observe_bad_policy: observe\.bad_policy: cca::observe<`n7\.y`> in observe_bad_policy is cca::merged, but what it hears may be of several spaces, and each has a queue of its own
// EXPECT observe_nothing: observe\.nothing: `extra` \(listens_to<n7\.\*\.\*>\) observes `n7\.\*\.\*`, which names nothing in observe_nothing or in a graph around it, so it would hear nothing
// EXPECT plan_unknown_path: plan\.unknown_path: `extra` \(asks_for_path\) asks for `n7\.z`, which nobody publishes under what it observes \(`n7\.\*`\), so it would wait for ever; did you mean `n7\.y`
// EXPECT rate_missing: rate\.missing: neither rate_missing nor any of its spaces states a rate, so a beat has no length: add cca::rate<1000> to the graph
// EXPECT strategy_never_fires: strategy\.never_fires: `extra` \(listener\) fires only when a sample arrives, but no input that it waits for is wired: wire one, or make it cca::timed
// EXPECT graph_algebraic_loop: graph\.algebraic_loop: `p\.y` -> `q\.x`, `q\.y` -> `p\.x` are a loop without delay, so none of their components can come first; say where it may be a beat
// EXPECT rate_mismatch: rate\.mismatch: `extra\.y` is published every 2 beats, that is at 500 Hz, but its space is fast_signal \(number over x at 1000 Hz\): change the strategy
// EXPECT rate_unstated: rate\.unstated: `n7\.y` is published every beat but `extra\.x` is read every 10 beats, and the wire does not say what happens between them: write
// EXPECT queue_overflow: queue\.overflow: `n7\.y` is published every beat but `extra\.x` is read every 10 beats, so the queue of 4 between them is full sooner or later, which
// EXPECT strategy_coordination: strategy\.coordination: `extra` \(merge\) is cca::coordinated, but `extra\.a` \(from `even\.y`, every 2 beats\) and `extra\.b` \(from `odd\.y`, every 2 beats
// EXPECT space_missing_limits: space\.missing_limits: `limits\.command` takes commands of leg_angles, but its axis `knee` states no limits of angle to keep them within: add `static
// EXPECT robot_unlimited_command: robot\.unlimited_command: `extra\.y` reaches the actuator `leg\.command` without passing a limiter: put a cca::limiter<hip_angle> between them \(its
// EXPECT latency_exceeded: latency\.exceeded: a sample of `n0\.y` can be 5 beats old when `extra\.x` is read, but latency_exceeded requires at most 4: shorten a delay or a queue
// EXPECT deployment_bad_environment: deployment\.bad_environment: `sink` in deployment_bad_environment is no item of a deployment, so it would be ignored: write cca::environment<`name`, cca::nodes
// EXPECT deployment_unknown_node: deployment\.unknown_node: environment `one` names `extras`, but deployable has no such node; did you mean `extra`\?
// EXPECT deployment_unplaced: deployment\.unplaced: `n0` \(source\) runs in no environment of deployment_unplaced: add its path to the cca::nodes<\.\.\.> of this environment, or give one cca
// EXPECT deployment_placed_twice: deployment\.placed_twice: `n49` \(sink\) runs in environment `one` and in environment `two`: a component runs in one environment; remove it from one
// EXPECT deployment_free_running: deployment\.free_running: `extra` \(sink\) runs in environment `two`, whose cycles begin without pause, but its strategy is restless: write cca::node<`extra`, sink, cca::full_speed>
// EXPECT deployment_undelayed: deployment\.undelayed: `n6\.y` is published in environment `two` and read in environment `one`, so it takes at least a beat to get there: write cca::wire<`n6\.y`, `n7\.x`
// EXPECT modes_bad_mode: modes\.bad_mode: modes_bad_mode has 1 mode, so there is nothing to switch to: write two or more
// EXPECT modes_two_rates: modes\.two_rates: mode `one` of modes_two_rates runs at 1000 Hz but mode `two` at 100 Hz: all modes share the beat
// EXPECT modes_two_types: modes\.two_types: `extra` is sink in mode `one` but merge in mode `two`: modes share what is at a path
// EXPECT modes_missing_robot: modes\.missing_robot: the resource node `leg` \(actuator<signal>\) is in mode `one` but not in mode `two`, so after a switch nothing would command it
// EXPECT modes_unknown_mode: modes\.unknown_mode: `extra` \(asks_for_mode\) returns a cca::switch_to<`three`>, but modes_unknown_mode has no such mode
// EXPECT modes_command_jumps: modes\.command_jumps: `leg\.command` gets its commands from `limits\.safe` in mode `one` but from `others\.safe` in mode `two`, so at a switch they could jump
// Each rule of a graph, broken in one of fifty nodes.
#include <cca/adaptive/module_status.hpp>
#include <cca/deployment.hpp>
#include <cca/modes.hpp>

#include "fifty_nodes.hpp"

struct hip : cca::dimension<"hip"> {
  static constexpr auto limits = cca::limits{cca::angle{-0.9, 0.9}};
};
struct knee : cca::dimension<"knee"> {};
struct hip_angle : cca::space<cca::joint_angles, cca::axes<hip>> {};
struct leg_angles : cca::space<cca::joint_angles, cca::axes<hip, knee>> {};
struct angle_twice : cca::space<cca::joint_angles, cca::axes<hip, hip>> {};
struct fast_signal : cca::space<cca::number, cca::axes<cca::x>, cca::rate<1000>> {};

template <cca::fixed_string Pattern, class... Policies>
struct listens_to {
  void process(cca::observe<Pattern, Policies...>) {}
};
struct asks_for_path : listens_to<"n7.*"> {
  static constexpr std::array asked_paths{cca::asked_path{"n7.z"}};
};

struct without_function {};
struct takes_number {
  void process(double) {}
};
struct returns_number {
  double process(cca::in<"x", signal>) { return 0; }
};
struct starts_with_number {
  void process(cca::in<"x", signal>) {}
  void on_start(int) {}
};
struct has_pointer {
  struct parameters {
    BOOST_HANA_DEFINE_STRUCT(parameters, (double, gain), (const double*, table));
  };
  parameters p{};
  void process(cca::in<"x", signal>) {}
};
template <class Space>
struct source_of {
  auto process(cca::beat) -> cca::out<"y", Space> { return {}; }
};
struct merge {
  void process(cca::in<"a", signal>, cca::in<"b", signal>) {}
};
struct finishing {
  auto process(cca::in<"x", signal>) -> cca::done { return true; }
};
struct stops_others {
  auto process(cca::in<"x", signal>) -> cca::stops<"n77"> { return {}; }
};
using requests_to_learn = cca::learning_requests<cca::learning_call::learn>;
struct slow_pupil {
  void process(cca::in<"learn", cca::learning_request>) {}
  static constexpr std::string_view refusal(std::string_view, double) {
    return "`learn` needs a learner that learns online, and this one learns in batches only";
  }
};
struct listener {
  void process(cca::optional_in<"x", signal>) {}
};
template <class Space>
struct actuator {
  void act(cca::in<"command", Space>) {}
};

using at_1000_hz = cca::rate<1000>;

namespace broken {

struct graph_unknown_item : fifty_nodes_and<at_1000_hz, sink> {};
struct node_bad_name : fifty_nodes_and<at_1000_hz, cca::node<"extra.one", source>> {};
struct node_duplicate_name : fifty_nodes_and<at_1000_hz, cca::node<"n7", sink>, cca::wire<"n6.y", "n7.x">> {};
struct skeleton_arity : fifty_nodes_and<at_1000_hz,
                                        cca::node<"extra", cca::switch_between<"y", signal, "a">>,
                                        cca::wire<"n7.y", "extra.a">> {};
struct component_no_process : fifty_nodes_and<at_1000_hz, cca::node<"extra", without_function>> {};
struct component_bad_parameter : fifty_nodes_and<at_1000_hz, cca::node<"extra", takes_number>> {};
struct component_bad_result
    : fifty_nodes_and<at_1000_hz, cca::node<"extra", returns_number>, cca::wire<"n7.y", "extra.x">> {};
struct component_hook_signature
    : fifty_nodes_and<at_1000_hz, cca::node<"extra", starts_with_number>, cca::wire<"n7.y", "extra.x">> {};
struct parameters_unsupported_type
    : fifty_nodes_and<at_1000_hz, cca::node<"extra", has_pointer>, cca::wire<"n7.y", "extra.x">> {};
struct space_duplicate_axis : fifty_nodes_and<at_1000_hz, cca::node<"extra", source_of<angle_twice>>> {};
struct strategy_no_fires : fifty_nodes_and<at_1000_hz, cca::node<"extra", source, sink>> {};
struct strategy_unknown_port : fifty_nodes_and<at_1000_hz,
                                               cca::node<"extra", merge, cca::port_triggered<"a", "c">>,
                                               cca::wire<"n7.y", "extra.a">,
                                               cca::wire<"n8.y", "extra.b">> {};
struct strategy_misplaced : fifty_nodes_and<at_1000_hz,
                                            cca::node<"extra", actuator<signal>, cca::moderate>,
                                            cca::wire<"n7.y", "extra.command">> {};
struct strategy_not_stoppable
    : fifty_nodes_and<at_1000_hz, cca::node<"extra", finishing>, cca::wire<"n7.y", "extra.x">> {};
struct part_unknown_path
    : fifty_nodes_and<at_1000_hz, cca::node<"extra", stops_others>, cca::wire<"n7.y", "extra.x">> {};
struct wire_unknown_port : fifty_nodes_and<at_1000_hz,
                                           cca::node<"extra", merge>,
                                           cca::wire<"n7.y", "extra.a">,
                                           cca::wire<"n8.out", "extra.b">> {};
struct observe_bad_policy : fifty_nodes_and<at_1000_hz, cca::observe<"n7.y", cca::merged<4>>> {};
struct observe_nothing : fifty_nodes_and<at_1000_hz, cca::node<"extra", listens_to<"n7.*.*">>> {};
struct plan_unknown_path : fifty_nodes_and<at_1000_hz, cca::node<"extra", asks_for_path>> {};
struct wire_direction : fifty_nodes_and<at_1000_hz, cca::node<"extra", sink>, cca::wire<"extra.x", "n7.y">> {
};
struct wire_two_writers : fifty_nodes_and<at_1000_hz, cca::wire<"n7.y", "n23.x", cca::latest>> {};
struct wire_bad_option
    : fifty_nodes_and<at_1000_hz, cca::node<"extra", sink>, cca::wire<"n7.y", "extra.x", cca::timed<2>>> {};
struct wire_bad_initial : fifty_nodes_and<at_1000_hz,
                                          cca::node<"extra", sink>,
                                          cca::wire<"n7.y", "extra.x", cca::initial<1, 2>>> {};
struct space_mismatch : fifty_nodes_and<at_1000_hz,
                                        cca::node<"extra", source_of<hip_angle>>,
                                        cca::node<"end", sink>,
                                        cca::wire<"extra.y", "end.x">> {};
struct learner_request : fifty_nodes_and<at_1000_hz,
                                         cca::node<"extra", source_of<requests_to_learn>>,
                                         cca::node<"pupil", slow_pupil>,
                                         cca::wire<"extra.y", "pupil.learn">> {};
struct wire_unconnected_input
    : fifty_nodes_and<at_1000_hz, cca::node<"extra", merge>, cca::wire<"n7.y", "extra.a">> {};
struct rate_missing : fifty_nodes_and<> {};
struct strategy_never_fires : fifty_nodes_and<at_1000_hz, cca::node<"extra", listener>> {};
struct graph_algebraic_loop : fifty_nodes_and<at_1000_hz,
                                              cca::node<"extra", merge>,
                                              cca::node<"p", step>,
                                              cca::node<"q", step>,
                                              cca::wire<"p.y", "q.x">,
                                              cca::wire<"q.y", "p.x">,
                                              cca::wire<"p.y", "extra.a">,
                                              cca::wire<"n7.y", "extra.b">> {};
struct rate_mismatch
    : fifty_nodes_and<at_1000_hz, cca::node<"extra", source_of<fast_signal>, cca::timed<2>>> {};
struct rate_unstated
    : fifty_nodes_and<at_1000_hz, cca::node<"extra", sink, cca::timed<10>>, cca::wire<"n7.y", "extra.x">> {};
struct queue_overflow : fifty_nodes_and<at_1000_hz,
                                        cca::node<"extra", sink, cca::timed<10>>,
                                        cca::wire<"n7.y", "extra.x", cca::queue<4, cca::reject>>> {};
struct strategy_coordination : fifty_nodes_and<at_1000_hz,
                                               cca::node<"even", source, cca::timed<2, 0>>,
                                               cca::node<"odd", source, cca::timed<2, 1>>,
                                               cca::node<"extra", merge, cca::coordinated>,
                                               cca::wire<"even.y", "extra.a">,
                                               cca::wire<"odd.y", "extra.b">> {};
struct space_missing_limits : fifty_nodes_and<at_1000_hz,
                                              cca::node<"extra", source_of<leg_angles>>,
                                              cca::node<"limits", cca::limiter<leg_angles>>,
                                              cca::node<"leg", actuator<leg_angles>>,
                                              cca::wire<"extra.y", "limits.command">,
                                              cca::wire<"limits.safe", "leg.command">> {};
struct robot_unlimited_command : fifty_nodes_and<at_1000_hz,
                                                 cca::node<"extra", source_of<hip_angle>>,
                                                 cca::node<"leg", actuator<hip_angle>>,
                                                 cca::wire<"extra.y", "leg.command">> {};
struct latency_exceeded : fifty_nodes_and<at_1000_hz,
                                          cca::node<"extra", sink>,
                                          cca::wire<"n7.y", "extra.x", cca::delayed<5>>,
                                          cca::require<cca::latency<"n0.y", "extra.x">, cca::beats<4>>> {};

struct deployable
    : fifty_nodes_and<at_1000_hz, cca::node<"extra", sink>, cca::wire<"n7.y", "extra.x", cca::delayed<1>>> {};
template <class... Items>
using deployed_with = cca::deployment<deployable, Items..., cca::environment<"two", cca::other_nodes>>;
struct deployment_bad_environment : deployed_with<cca::environment<"one", cca::nodes<"extra">>, sink> {};
struct deployment_unknown_node : deployed_with<cca::environment<"one", cca::nodes<"extras">>> {};
struct deployment_unplaced : cca::deployment<deployable, cca::environment<"one", cca::nodes<"extra">>> {};
struct deployment_placed_twice : cca::deployment<deployable,
                                                 cca::environment<"one", cca::nodes<"extra", "n49">>,
                                                 cca::environment<"two", cca::nodes<"n49">>> {};
struct deployment_undelayed : deployed_with<cca::environment<"one", cca::nodes<"n7">>> {};
struct deployment_free_running
    : cca::deployment<deployable,
                      cca::environment<"one", cca::other_nodes>,
                      cca::environment<"two", cca::nodes<"extra">, cca::free_running>> {};

struct mode_none : fifty_nodes_and<at_1000_hz> {};
struct mode_sink : fifty_nodes_and<at_1000_hz, cca::node<"extra", sink>, cca::wire<"n7.y", "extra.x">> {};
struct mode_merge : fifty_nodes_and<at_1000_hz,
                                    cca::node<"extra", merge>,
                                    cca::wire<"n7.y", "extra.a">,
                                    cca::wire<"n7.y", "extra.b">> {};
struct mode_slow : fifty_nodes_and<cca::rate<100>> {};
struct mode_moving
    : fifty_nodes_and<at_1000_hz, cca::node<"leg", actuator<signal>>, cca::wire<"n7.y", "leg.command">> {};
struct asks_for_mode {
  auto process(cca::in<"x", signal>) -> cca::switch_to<"three"> { return true; }
};
struct mode_asking
    : fifty_nodes_and<at_1000_hz, cca::node<"extra", asks_for_mode>, cca::wire<"n7.y", "extra.x">> {};
template <cca::fixed_string Limits, cca::fixed_string Command, cca::fixed_string Safe>
struct mode_limited : fifty_nodes_and<at_1000_hz,
                                      cca::node<"wish", source_of<hip_angle>>,
                                      cca::node<Limits, cca::limiter<hip_angle>>,
                                      cca::node<"leg", actuator<hip_angle>>,
                                      cca::wire<"wish.y", Command>,
                                      cca::wire<Safe, "leg.command">> {};
template <class One, class Two>
using two_modes = cca::modes<cca::mode<"one", One>, cca::mode<"two", Two>>;
struct modes_bad_mode : cca::modes<cca::mode<"one", mode_none>> {};
struct modes_two_rates : two_modes<mode_none, mode_slow> {};
struct modes_two_types : two_modes<mode_sink, mode_merge> {};
struct modes_missing_robot : two_modes<mode_moving, mode_none> {};
struct modes_unknown_mode : two_modes<mode_none, mode_asking> {};
struct modes_command_jumps : two_modes<mode_limited<"limits", "limits.command", "limits.safe">,
                                       mode_limited<"others", "others.command", "others.safe">> {};

struct none : fifty_nodes_and<at_1000_hz> {};
struct switched : two_modes<mode_none, mode_sink> {};
struct placed : deployed_with<cca::environment<"one", cca::nodes<"extra">>> {};

}  // namespace broken

#ifndef CCA_REJECT
static_assert(cca::well_formed<broken::none> && cca::well_formed<broken::placed> &&
              cca::well_formed<broken::switched>);
#else
cca::controller<broken::CCA_REJECT> c;
#endif
