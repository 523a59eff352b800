// A farm: equal workers, each on its part of an array-valued sample (the source document, section 4.4.3:
// "distribute tasks to a set of identical and simultaneously working nodes").
//
//   cca::node<"ik", cca::farm<leg_ik, cca::array_of<paw_position, 4>, cca::array_of<leg_angles, 4>>>
//   cca::node<"ik", cca::farm<leg_ik, all_paws, all_angles>>      axes in order, leg by leg
//   in  "input"    From
//   out "output"   To
//
// The number of workers is the number of worker inputs that fit into From; as many worker outputs must fit
// into To. A worker is a component with one input that must be wired and one output (status outputs do not
// count), or a pipeline. A farm is a graph: `split` divides the sample, `worker0`, `worker1`, ... each fire
// with their part, and `join` puts the results together once all are new (`moderate`). All of it runs in one
// beat, inlined.
//
// With `cca::inner_wires<cca::delayed<1>>` as fourth argument (inner_wires.hpp) the workers may run in
// environments of their own: threads, processes, machines, with the results of one loop, two beats later.
// farm_on_threads.hpp has a thread per worker, whose results come when they are done.
//
// Errors: skeleton.arity; deployment.undelayed. Cost: that of the workers. Example:
// tests/runtime/skeleton/pipeline_farm.cpp; docs/skeletons.md.
#pragma once

#include <type_traits>
#include <utility>

#include <cca/base/messages/holds_or_tells.hpp>
#include <cca/base/array_size.hpp>
#include <cca/skeleton/arity.hpp>
#include <cca/graph/items/inner_wires.hpp>
#include <cca/skeleton/sharing.hpp>
#include <cca/skeleton/stage_ports.hpp>

namespace cca {
namespace detail {

template <class Worker>
using part_taken = typename input_of_stage<Worker>::space;
template <class Worker>
using part_given = typename output_of_stage<Worker>::space;

template <class Worker, class From, class To>
constexpr int workers_in = [] {
  if constexpr (OneInOneOut<Worker>)
    return parts_in<From, part_taken<Worker>> == parts_in<To, part_given<Worker>>
               ? parts_in<From, part_taken<Worker>>
               : 0;
  else return 0;
}();

template <std::size_t I>
inline constexpr auto worker_name = numbered<"worker", I>;

template <class Worker, class From, class To, class Policies, class Numbers>
struct farm_of;
template <class Worker, class From, class To, class Policies, std::size_t... I>
struct farm_of<Worker, From, To, Policies, std::index_sequence<I...>>
    : graph<node<"split", share_out<From, part_taken<Worker>, sizeof...(I)>>,
            node<worker_name<I>, Worker, typename fires_with_input<Worker>::type>...,
            node<"join", gather<To, part_given<Worker>, sizeof...(I)>, moderate>,
            wire_inside<joined_name<"split", part_name<I>>,
                        joined_name<worker_name<I>, input_of_stage<Worker>::name>,
                        Policies>...,
            wire_inside<joined_name<worker_name<I>, output_of_stage<Worker>::name>,
                        joined_name<"join", part_name<I>>,
                        Policies>...,
            expose<"split.input", "input">,
            expose<"join.output", "output">> {
  using stage_input = stage_port<"input", From>;
  using stage_output = stage_port<"output", To>;
  static constexpr auto inner_wires_of = wires_of::this_one;
};

template <class Whole, class Part>
constexpr void put_parts(text& t) {
  t << type_name<Whole>() << " (" << type_name<typename Whole::domain>() << " over " << Whole::axes::count
    << (Whole::axes::count == 1 ? " axis)" : " axes)");
  if (constexpr int count = parts_in<Whole, Part>; count > 0) t << " is " << count << " of ";
  else t << " is no whole number of ";
  t << type_name<Part>() << " (" << type_name<typename Part::domain>() << " over " << Part::axes::count
    << ")";
}

template <class Worker, class From, class To>
struct wrong_farm {
  static constexpr text message() {
    text t;
    if constexpr (!OneInOneOut<Worker>) {
      t << "is a farm whose worker ";
      put_stage_ports<Worker>(t);
    } else {
      t << "cannot be shared out: what comes in, ";
      put_parts<From, part_taken<Worker>>(t);
      t << ", what goes out, ";
      put_parts<To, part_given<Worker>>(t);
      t << "; give it spaces with as many parts of what a worker takes as of what it gives, like "
           "cca::array_of<"
        << type_name<part_taken<Worker>>() << ", 4>";
    }
    return t;
  }
};

template <class Worker, class... Options>
struct bad_farm_options {
  static constexpr void tell(text& m) {
    m << "skeleton.arity: the farm of " << type_name<Worker>() << " has the options ";
    int written = 0;
    ((m << (written++ > 0 ? ", `" : "`") << type_name<Options>() << "`"), ...);
    m << ", and its only one is cca::inner_wires<policies...>, once, after the spaces of what comes in and "
         "what goes out";
  }
};

template <class Worker, class From, class To, class... Options>
constexpr auto farm_kind() {
  static_assert(holds_or_tells<(sizeof...(Options) < 2 && (is_inner_wires<Options> && ...)),
                               bad_farm_options<Worker, Options...>>::value);
  if constexpr (constexpr int count = workers_in<Worker, From, To>; count > 0)
    return std::type_identity<farm_of<Worker, From, To, typename inner_policies<list<>, Options...>::type,
                                      std::make_index_sequence<array_size(count)>>>();
  else return std::type_identity<bad_skeleton<wrong_farm<Worker, From, To>>>();
}

}  // namespace detail

template <class Worker, class From, class To, class... Options>
struct farm : decltype(detail::farm_kind<Worker, From, To, Options...>())::type {};

}  // namespace cca
