// Each skeleton in a graph, and by hand: shows how much of a skeleton is left after compiling.
//
//   skeletons list                  the names
//   skeletons check                 compares the two forms of each, bit for bit; exits with 1 if they differ
//   skeletons NAME FORM BEATS       runs `graph` or `by_hand` for so many beats (under callgrind)
//   skeletons NAME allocations      the allocations of a thousand beats
//
// Other words are refused, with 2.
#include "skeletons.hpp"

#include <cstdio>
#include <cstring>
#include <memory>
#include <string_view>

#include "words.hpp"

extern "C" long bench_allocations();

namespace bench {

template <class Form>
[[gnu::noinline]] void one_beat(Form& form) {
  form.step();
}

// Not inlined, so that the disassembly shows it under its name.
template <class Graph>
struct as_graph {
  cca::controller<Graph> controller;
  as_graph() { controller.load(), controller.start(); }
  void step() { controller.step(); }
  void settle()
    requires requires { Graph::crew; }
  {
    controller.template get<Graph::crew>().wait();
  }
  Eigen::Vector2d result() const { return controller.template get<"end">().sum; }
};

// The threads work between two beats.
template <class Form>
void one_round(Form& form) {
  one_beat(form);
  if constexpr (requires { form.settle(); }) form.settle();
}

template <class Form>
int run(int beats) {
  const auto form = std::make_unique<Form>();
  for (int k = 0; k < beats; ++k) one_round(*form);
  return std::isfinite(form->result()[0]) ? 0 : 1;
}

template <class Graph, class ByHand>
int use(const char* name, int argc, char** argv, bool& is_known) {
  const std::string_view what = argv[1];
  if (what == "list") std::puts(name);
  if (what == "check") {
    const auto g = std::make_unique<as_graph<Graph>>();
    const auto h = std::make_unique<ByHand>();
    for (int k = 0; k < 3000; ++k) {
      one_round(*g), one_round(*h);
      const Eigen::Vector2d a = g->result(), b = h->result();
      if (std::memcmp(a.data(), b.data(), sizeof a) == 0) continue;
      std::fprintf(stderr, "%s, beat %d: %.17g by the graph, %.17g by hand\n", name, k, a[0], b[0]);
      return 1;
    }
  }
  if (what != name) return 0;
  is_known = true;
  constexpr const char* forms = "`allocations`, or `graph` or `by_hand` and a number of beats";
  const std::string_view form = argc > 2 ? argv[2] : "";
  if (form == "allocations" && argc == 3) {
    const auto g = std::make_unique<as_graph<Graph>>();
    one_round(*g);
    const long before = bench_allocations();
    for (int k = 0; k < 1000; ++k) one_round(*g);
    std::printf("%ld\n", bench_allocations() - before);
    return 0;
  }
  if ((form != "graph" && form != "by_hand") || argc != 4) refuse(form, forms);
  const int beats = beats_in(argv[3]);
  return form == "graph" ? run<as_graph<Graph>>(beats) : run<ByHand>(beats);
}

}  // namespace bench

int main(int argc, char** argv) {
  using namespace bench;
  const std::string_view what = argc > 1 ? argv[1] : "";
  bool is_known = (what == "list" || what == "check") && argc == 2;
  const int failed =
      use<splitter_collector, splitter_collector_by_hand>("splitter, collector", argc, argv, is_known) +
      use<pipeline, pipeline_by_hand>("pipeline", argc, argv, is_known) +
      use<pipeline_delayed, pipeline_delayed_by_hand>("pipeline over delays", argc, argv, is_known) +
      use<farm, farm_by_hand>("farm", argc, argv, is_known) +
      use<farm_threads, farm_threads_by_hand>("farm on threads", argc, argv, is_known) +
      use<by_priority, by_priority_by_hand>("arbiter by priority", argc, argv, is_known) +
      use<by_freshness, by_freshness_by_hand>("arbiter by freshness", argc, argv, is_known) +
      use<switched, switched_by_hand>("switch", argc, argv, is_known) +
      use<blended, blended_by_hand>("blend", argc, argv, is_known) +
      use<held, held_by_hand>("hold", argc, argv, is_known) +
      use<decimated, decimated_by_hand>("decimate", argc, argv, is_known) +
      use<averaged, averaged_by_hand>("decimate, averaged", argc, argv, is_known) +
      use<interpolated, interpolated_by_hand>("interpolate", argc, argv, is_known);
  if (!is_known) refuse(what, "list, check, or the name of a skeleton");
  return failed;
}
