// One benchmark program: the same arithmetic as a graph, as a loop written by hand, and in the classical way.
//
//   program check                    compares the three, bit for bit, beat by beat; exits with 1 where they differ
//   program <form> <beats>           runs `graph`, `by_hand` or `classical` so many beats (under callgrind)
//   program figures                  allocations a beat and bytes of state, one line a form
//   program [--benchmark_...]        nanoseconds a beat (Google Benchmark)
//
// A form has step() and result(), an Eigen vector.
#pragma once

#include <malloc.h>

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <string_view>

#include <benchmark/benchmark.h>

#include <cca/cca.hpp>

extern "C" long bench_allocations();

namespace bench {

// A beat is a call, as it is where a robot waits between two: nothing of one beat is kept in registers for the next.
template <class Form>
[[gnu::noinline]] void one_beat(Form& form) {
  form.step();
}

// The graph as a form: what `Result` of it is looked at.
template <class Graph, class Result>
struct as_graph {
  static constexpr const char* name = "graph";
  cca::controller<Graph> controller;
  as_graph() {
    controller.load();
    controller.start();
  }
  void step() { controller.step(); }
  auto result() const { return Result{}(controller); }
};

template <class Form>
void run(int beats) {
  const auto form = std::make_unique<Form>();
  for (int k = 0; k < beats; ++k) one_beat(*form);
  benchmark::DoNotOptimize(form->result());
}

template <class Form>
void figures() {
  const std::size_t in_use = mallinfo2().uordblks;
  const auto form = std::make_unique<Form>();
  const std::size_t bytes = mallinfo2().uordblks - in_use;  // with what the form has allocated itself
  one_beat(*form);
  const long before = bench_allocations();
  constexpr int beats = 1000;
  for (int k = 0; k < beats; ++k) one_beat(*form);
  const long after = bench_allocations();
  std::printf("%s %.3f %zu\n", Form::name, static_cast<double>(after - before) / beats, bytes);
}

template <class Form>
void time(benchmark::State& state) {
  const auto form = std::make_unique<Form>();
  for (auto _ : state) one_beat(*form);
  benchmark::DoNotOptimize(form->result());
}

template <class A, class B>
bool same_bits(const A& a, const B& b) {
  for (int i = 0; i < a.size(); ++i)
    if (const double x = a[i], y = b[i]; std::memcmp(&x, &y, sizeof x) != 0) return false;
  return true;
}

template <class Graph, class ByHand, class Classical>
int check() {
  const auto g = std::make_unique<Graph>();
  const auto h = std::make_unique<ByHand>();
  const auto c = std::make_unique<Classical>();
  for (int k = 0; k < 3000; ++k) {
    g->step();
    h->step();
    c->step();
    if (!same_bits(g->result(), h->result()) || !same_bits(g->result(), c->result())) {
      std::fprintf(stderr, "beat %d: the three forms differ: %.17g, %.17g, %.17g\n", k, g->result()[0], h->result()[0], c->result()[0]);
      return 1;
    }
  }
  return 0;
}

template <class Graph, class ByHand, class Classical>
int program(int argc, char** argv) {
  const std::string_view what = argc > 1 ? argv[1] : "";
  if (what == "check") return check<Graph, ByHand, Classical>();
  if (what == "figures") {
    figures<Graph>();
    figures<ByHand>();
    figures<Classical>();
    return 0;
  }
  if (argc == 3) {
    const int beats = std::atoi(argv[2]);
    if (what == "graph") run<Graph>(beats);
    else if (what == "by_hand") run<ByHand>(beats);
    else if (what == "classical") run<Classical>(beats);
    else return 2;
    return 0;
  }
  benchmark::RegisterBenchmark("graph", time<Graph>);
  benchmark::RegisterBenchmark("by_hand", time<ByHand>);
  benchmark::RegisterBenchmark("classical", time<Classical>);
  benchmark::Initialize(&argc, argv);
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}

}  // namespace bench
