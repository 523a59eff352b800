// One benchmark program: the same arithmetic as a graph, as a loop written by hand, and in the classical way.
//
//   program check [BEATS]         compares the three, bit for bit, beat by beat; exits with 1 if they differ,
//                                 and prints the first number of each form that does
//   program FORM BEATS            runs `graph`, `by_hand` or `classical` for so many beats (under callgrind)
//   program figures               allocations per beat and bytes of state, one line per form
//   program [--benchmark_...]     nanoseconds per beat (Google Benchmark)
//
// Other words are refused, with 2.
//
// A form has step() and result(), an Eigen vector.
#pragma once

#include <malloc.h>

#include <cstdio>
#include <cstring>
#include <memory>
#include <string_view>
#include <tuple>
#include <type_traits>

#include <benchmark/benchmark.h>

#include <cca/cca.hpp>

#include "words.hpp"

extern "C" long bench_allocations();

namespace bench {

// Each beat is one call, as on a robot that waits between beats: no value stays in registers from beat to
// beat.
template <class Form>
[[gnu::noinline]] void one_beat(Form& form) {
  form.step();
}

// The graph as a form; `Result` reads the result from it.
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
  const std::size_t bytes = mallinfo2().uordblks - in_use;  // with the form's own allocations
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

// First the graph, then the forms to compare with it. All make the beat before one is compared.
template <class Graph, class... Others>
int check(int beats) {
  const auto g = std::make_unique<Graph>();
  const auto others = std::make_tuple(std::make_unique<Others>()...);
  for (int k = 0; k < beats; ++k) {
    g->step();
    std::apply([](const auto&... one) { (one->step(), ...); }, others);
    const auto expected = g->result();
    const auto differs = [&]<class Form>(const Form& form) {
      const auto found = form.result();
      for (int i = 0; i < expected.size(); ++i) {
        const double x = expected[i], y = found[i];
        if (std::memcmp(&x, &y, sizeof x) == 0) continue;
        std::fprintf(stderr, "beat %d: number %d of `%s` is %.17g, that of the graph %.17g\n", k, i,
                     Form::name, y, x);
        return true;
      }
      return false;
    };
    if (std::apply([&](const auto&... one) { return (differs(*one) + ... + 0) > 0; }, others)) return 1;
  }
  return 0;
}

template <class Graph, class... Others>
int program(int argc, char** argv) {
  const std::string_view what = argc > 1 ? argv[1] : "";
  if (what == "check" && argc <= 3) return check<Graph, Others...>(argc > 2 ? beats_in(argv[2]) : 3000);
  if (what == "figures" && argc == 2) {
    figures<Graph>();
    (figures<Others>(), ...);
    return 0;
  }
  if (argc > 1 && !what.starts_with("--")) {
    const bool is_form = what == Graph::name || ((what == Others::name) || ...);
    if (!is_form || argc != 3)
      refuse(what, "check [BEATS], figures, or graph, by_hand or classical and a number of beats");
    const int beats = beats_in(argv[2]);
    const auto run_if = [&]<class Form>(std::type_identity<Form>) {
      return what == Form::name && (run<Form>(beats), true);
    };
    return run_if(std::type_identity<Graph>{}) || (run_if(std::type_identity<Others>{}) || ...) ? 0 : 2;
  }
  benchmark::RegisterBenchmark(Graph::name, time<Graph>);
  (benchmark::RegisterBenchmark(Others::name, time<Others>), ...);
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}

}  // namespace bench
