// Merged wires, delayed queues, strategies with a state and what full queues lose: recorded and replayed, bit
// for bit, in one loop and in a deployment.
#include <doctest/doctest.h>

#include <cstdint>
#include <string>

#include <cca/deployment.hpp>

#include "graphs.hpp"

using namespace record_test;

namespace {

struct value : cca::space<cca::number, cca::axes<cca::x>> {};

// What it senses only the recording knows: now and then nothing.
struct sensor {
  std::uint64_t seed = 17;
  auto sense() -> std::tuple<cca::maybe<"y", value>, cca::out<"z", value>> {
    seed = seed * 6364136223846793005u + 1442695040888963407u;
    const double noise = static_cast<double>(seed >> 40) / (1 << 24);
    return {noise < 0.4 ? cca::maybe<"y", value>(noise) : cca::maybe<"y", value>(), noise};
  }
};
struct sum {
  double all = 0;
  auto process(cca::in<"x", value> x) -> cca::out<"y", value> {
    all = 0.5 * all + x[cca::x{}] + 1e-3 * static_cast<double>(x.dropped());
    return all;
  }
};
template <cca::fixed_string Input, int N>
struct every_nth {
  int come = 0;
  template <class Inputs>
  bool fires(cca::beat, const Inputs& in) {
    come += in.template arrivals<Input>();
    if (come < N) return false;
    come -= N;
    return true;
  }
};

template <int Room, class Reader = cca::timed<2, 1>>
struct buffers
    : cca::graph<cca::rate<1000>,
                 cca::node<"sensor", sensor>,
                 cca::node<"slow", sum, cca::timed<3>>,
                 cca::node<"counts", sum, every_nth<"x", 5>>,
                 cca::node<"last", sum, Reader>,
                 cca::wire<"sensor.y", "slow.x", cca::merged<3>, cca::delayed<2>>,
                 cca::wire<"sensor.z", "slow.x", cca::merged<3>, cca::delayed<1>>,
                 cca::wire<"sensor.y", "counts.x", cca::queue<4>, cca::delayed<1>>,
                 cca::wire<"slow.y", "last.x", cca::merged<Room, cca::reject>, cca::delayed<4>>,
                 cca::wire<"counts.y", "last.x", cca::merged<Room, cca::reject>, cca::delayed<1>>> {};

struct in_one_loop : buffers<50>, cca::recordable {};
struct that_overflows : buffers<3, cca::timed<3, 1>>, cca::recordable {};
template <class Graph>
struct apart : cca::deployment<Graph,
                               cca::environment<"robot", cca::nodes<"sensor">>,
                               cca::environment<"slow", cca::nodes<"slow">>,
                               cca::environment<"rest", cca::other_nodes>>,
               cca::recordable {};

template <class Played>
std::string recorded(const std::string& file, std::string& fault) {
  Played c;
  cca::recording::recorder recording(c, file, {.waits = true});
  c.load();
  c.start();
  c.run(cca::for_beats<4000>{});
  recording.close();
  CHECK(recording.problem() == "");
  CHECK(c.template dropped<"slow.x">() > 10);
  CHECK(c.template dropped<"counts.x">() > 0);
  if (c.state() == cca::state::faulted) fault = "`" + c.fault_path() + "`: " + c.fault().reason();
  return std::to_string(c.beat_index());
}

template <class Played, class Graph>
void check(const std::string& expected_fault) {
  const temporary_file file("queues");
  std::string fault;
  const std::string beats = recorded<Played>(file.path, fault);
  CHECK(fault == expected_fault);
  const auto result = cca::recording::replay<Graph>(file.path);
  INFO(result);
  CHECK(result);
  CHECK(std::to_string(result.beats) == beats);
  CHECK(result.fault == expected_fault);
}

}  // namespace

TEST_CASE("queues: a replay of one loop and of a deployment gives the same samples") {
  check<cca::controller<in_one_loop>, in_one_loop>("");
  check<cca::deployed<apart<buffers<50>>>, apart<buffers<50>>>("");
}

TEST_CASE("queues: a replay ends in the beat in which a sample arrived at a full queue") {
  check<cca::controller<that_overflows>, that_overflows>("`last`: a sample arrived while the queue was full");
  check<cca::deployed<apart<that_overflows>>, apart<that_overflows>>(
      "`last`: a sample arrived while the queue was full");
}
