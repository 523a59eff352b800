// Wake-ups of a deployment at 1 kHz in real time, for comparison with cyclictest in the same run.
//
//   bench_realtime --core 1 --seconds 10    a line of JSON; bench/measure.py runs cyclictest beside it
//
// The environment is as on a robot: SCHED_FIFO 80, one core, memory locked. Counted is the time from when a
// beat should begin until its thread is awake. Exits with 2, and says why, if the
// system refuses any of it.
#include <time.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <iostream>
#include <map>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include <cca/deployment.hpp>
#include <cca/main/command_line.hpp>
#include <cca/main/run_program.hpp>

namespace {

struct level : cca::space<cca::number, cca::axes<cca::x>> {};

struct source {
  double value = 0;
  auto sense(cca::beat now) -> cca::out<"y", level> { return value + now.dt(); }
  void act(cca::in<"x", level> x) { value = x[cca::x{}]; }
};
struct filter {
  double kept = 0;
  auto process(cca::in<"x", level> x) -> cca::out<"y", level> { return kept += 0.1 * (x[cca::x{}] - kept); }
};

struct loop : cca::graph<cca::rate<1000>,
                         cca::node<"robot", source>,
                         cca::node<"filter", filter>,
                         cca::wire<"robot.y", "filter.x">,
                         cca::wire<"filter.y", "robot.x">> {};

template <int Core>
struct on
    : cca::deployment<loop,
                      cca::environment<"robot", cca::other_nodes, cca::realtime<80, cca::on_core<Core>>>> {};

// The wall clock, which notes how late each wake-up was.
struct noting_clock {
  std::vector<std::int64_t>* late = nullptr;
  std::int64_t now() const {
    timespec t{};
    ::clock_gettime(CLOCK_MONOTONIC, &t);
    return t.tv_sec * std::int64_t{1'000'000'000} + t.tv_nsec;
  }
  void sleep_until(std::int64_t time) const {
    const timespec wake{time / 1'000'000'000, time % 1'000'000'000};
    while (::clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &wake, nullptr) != 0) {}
    if (late->size() < late->capacity()) late->push_back(now() - time);
  }
};

// How often which number of us, as cyclictest tells it.
template <int Core>
int measure(std::int64_t seconds) {
  std::vector<std::int64_t> late;
  cca::deployed<on<Core>> d;
  d.load();
  d.start();
  const auto run = [&](std::int64_t beats) {
    d.run(cca::for_some_beats{beats}, cca::clocked_pace<noting_clock>(1, noting_clock{&late}));
  };
  run(500);  // not noted: the programs beside it are starting
  late.reserve(static_cast<std::size_t>(1000 * seconds));
  run(1000 * seconds);
  std::map<std::int64_t, int> counts;
  for (const std::int64_t ns : late) ++counts[std::max<std::int64_t>(ns, 0) / 1000];
  nlohmann::ordered_json told{
      {"core", Core}, {"overruns", d.overruns()}, {"us", nlohmann::ordered_json::object()}};
  for (const auto& [us, count] : counts) told["us"][std::to_string(us)] = count;
  std::cout << told << '\n';
  return 0;
}

}  // namespace

int main(int count, char** words) {
  std::size_t core = 0;
  std::uint64_t seconds = 10;
  cca::command_line line("wake-ups of a deployment at 1 kHz in real time, as a line of JSON");
  line.one_of("--core N", core, std::array{"0", "1"}, "where it runs (0)");
  line.whole_number("--seconds S", seconds, 1, 86400, "how long (10)");
  return cca::run_program(count, words, line, [&] {
    const auto length = static_cast<std::int64_t>(seconds);
    return core == 0 ? measure<0>(length) : measure<1>(length);
  });
}
