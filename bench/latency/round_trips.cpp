// Round trips between a driver and BENCH_FAN_OUT reflectors: the source's benchmark (AMARSi D7.3, 5.1.3).
//
//   latency_4 [--quick]    a line of JSON for each transport, form and size; bench/measure.py reads them
//
// Forms: `cca`; `raw`, the same by the bare means of the transport; `tcp`. All are measured in turn, so that
// what the machine does meanwhile meets all of them. Exits with 1 if a message comes back changed.
#include <cstdio>
#include <exception>
#include <string>
#include <vector>

#include <cca/main/command_line.hpp>
#include <cca/main/run_program.hpp>

#include "library.hpp"
#include "mailboxes.hpp"
#include "tcp.hpp"
#ifdef BENCH_CYCLONE
#include "cyclone.hpp"
#endif
#ifdef BENCH_CCA_DDS
#include <cca/dds.hpp>
#endif

namespace bench {

constexpr int fan_out = BENCH_FAN_OUT;

// One form: what it is called, how much of it, and how it makes a round.
template <class Round>
struct form {
  const char* transport;
  const char* name;
  const amount& of;
  Round make;
};
template <class Round>
form(const char*, const char*, const amount&, Round) -> form<Round>;

// A round that fails is told and left out.
template <class Form>
void make_round(const Form& one, std::vector<round_of_times>& found) {
  try {
    found.push_back(one.make(one.of));
  } catch (const std::exception& e) {
    std::fprintf(stderr, "%s, %s: a round failed: %s\n", one.transport, one.name, e.what());
  }
}

// False: a message came back changed, or a form has no round.
template <class... Form>
bool measure(std::size_t bytes, int most, const Form&... forms) {
  std::vector<round_of_times> found[sizeof...(Form)];
  for (int n = 0; n < most; ++n) {
    int f = 0;
    ((n < forms.of.rounds ? make_round(forms, found[f]) : void(), ++f), ...);
  }
  int f = 0;
  ((found[f].empty() ? void() : print(forms.transport, forms.name, fan_out, bytes, found[f]), ++f), ...);
  bool is_right = true;
  for (const auto& rounds : found) {
    is_right = is_right && !rounds.empty();
    for (const auto& round : rounds) is_right = is_right && round.wrong == 0;
  }
  return is_right;
}

template <int Words>
bool measure_size(bool is_quick) {
  constexpr std::size_t bytes = 8 * std::size_t{Words};
  const amount of = amount_of(fan_out, bytes, is_quick);
  const std::string memory = "/cca_bench_" + std::to_string(::getpid());
  const cca::shared_memory shared(memory);
  const amount little = of.over_network();
  return measure(
      bytes, of.rounds, form{"loop", "cca", of, [](const amount& a) { return loop<Words, fan_out>(a); }},
      form{"loop", "raw", of, [](const amount& a) { return raw_loop<Words, fan_out>(a); }},
      form{"threads", "cca", of, [](const amount& a) { return threads<Words, fan_out>(a); }},
      form{"threads", "raw", of, [](const amount& a) { return raw_threads<Words, fan_out>(a); }},
      form{"shared_memory", "cca", of, [&](const amount& a) { return processes<Words, fan_out>(a, shared); }},
      form{"shared_memory", "raw", of, [](const amount& a) { return raw_shared_memory<Words, fan_out>(a); }},
#ifdef BENCH_CCA_DDS
      form{"dds", "cca", little,
           [](const amount& a) { return processes<Words, fan_out>(a, cca::dds::domain(78)); }},
#endif
#ifdef BENCH_CYCLONE
      form{"dds", "raw", little, [&](const amount& a) { return raw_dds(fan_out, bytes, a); }},
#endif
      form{"tcp", "raw", little, [&](const amount& a) { return tcp(fan_out, bytes, a); }});
}

}  // namespace bench

int main(int count, char** words) {
  bool is_quick = false;
  cca::command_line line("round trips between a driver and " + std::to_string(bench::fan_out) +
                         " reflectors, as lines of JSON");
  line.flag("--quick", is_quick, "few round trips, only to see that it runs");
  return cca::run_program(count, words, line, [&] {
#ifdef BENCH_CYCLONE
    bench::use_only_this_machine();
#endif
    using bench::measure_size;
    bool is_right = measure_size<1>(is_quick);
#ifndef BENCH_ONE_SIZE
    is_right = measure_size<128>(is_quick) && is_right;
    is_right = measure_size<4096>(is_quick) && is_right;
    if constexpr (bench::fan_out <= 8)  // with 16, compiling takes more than 9 GB
      is_right = measure_size<131072>(is_quick) && is_right;
#endif
    if (!is_right) std::fprintf(stderr, "a message came back changed, or a form could not be measured\n");
    return is_right ? 0 : 1;
  });
}
