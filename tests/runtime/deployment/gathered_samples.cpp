// What the cycles of a free-running environment hand over for queues: whatever the cycles and the beats are,
// a queue that takes it is the one that would have taken all samples.
#include <doctest/doctest.h>

#include <cstdint>
#include <memory>
#include <random>
#include <vector>

#include <cca/runtime/environments/loop/free_arrivals.hpp>

#include "free_running_queues.hpp"

using namespace cca::detail;

namespace {

using apart = free_queues::spread<>;

// The number of the output `eyes.y`.
constexpr int output_of_eyes = [] {
  const auto& plan = plan_of<apart>;
  for (int o = 0; o < counts_of<apart>.output_count; ++o) {
    const auto& call = plan.calls[array_size(plan.outputs[array_size(o)].call)];
    if (plan.nodes[array_size(call.node)].item->from == "eyes" &&
        call.function->outputs[plan.outputs[array_size(o)].port].name == "y")
      return o;
  }
  return -1;
}();
static_assert(is_gathered<apart, output_of_eyes>);

template <int Room, full_kind Full>
struct queue_under_test {
  waiting_samples<1, Room, Full, false, false> waiting{};

  void put(double value) {
    waiting.put(Eigen::Matrix<double, 1, 1>(value), static_cast<std::int64_t>(value), 0, true);
  }
  std::vector<double> take_all() {
    std::vector<double> all;
    for (; !waiting.is_empty(); waiting.take()) all.push_back(waiting.show()->vector()[0]);
    all.push_back(static_cast<double>(waiting.dropped()));
    return all;
  }
  void take_one() { waiting.take(); }
};

struct all_arrive {
  template <int>
  bool arrives(const auto&) const {
    return true;
  }
};

// The same queue twice: one takes what the beats admit, one takes all samples.
template <int Room, full_kind Full>
void check_same(unsigned seed, int most_cycles) {
  std::mt19937 random(seed);
  const auto up_to = [&](int most) { return std::uniform_int_distribution<int>(0, most)(random); };
  const auto shared = std::make_unique<exchange<apart>>();
  auto& results = shared->results<1>();
  results.begin_run();
  arrivals_from<apart, 1> arrivals;
  queue_under_test<Room, Full> of_beats, of_all;
  double published = 0;
  std::uint64_t next = 0, number = 0;
  for (std::int64_t k = 0; k < 200; ++k) {
    for (int cycles = up_to(3) == 0 ? up_to(most_cycles) : up_to(3); cycles > 0; --cycles) {
      if (up_to(4) > 0) {
        ++published;
        results.put<output_of_eyes>(Eigen::Matrix<double, 1, 1>(published), 0, k);
        of_all.put(published);
      }
      results.end_cycle();
    }
    arrivals.admit(*shared, k, all_arrive());
    const auto& ring = shared->gathered<output_of_eyes>();
    for (std::remove_cvref_t<decltype(ring)>::sample one; ring.take(next, k + 1, one);) {
      CHECK_EQ(one.published_in, k);
      const auto is = static_cast<std::uint64_t>(one.vector[1]);
      of_beats.waiting.lose(static_cast<std::int64_t>(is - number));
      number = is + 1;
      of_beats.put(one.vector[0]);
    }
    REQUIRE_EQ(of_beats.waiting.waiting(), of_all.waiting.waiting());
    REQUIRE_EQ(of_beats.waiting.dropped(), of_all.waiting.dropped());
    if (of_all.waiting.waiting() > 0)
      REQUIRE_EQ(of_beats.waiting.show()->vector()[0], of_all.waiting.show()->vector()[0]);
    if (up_to(9) == 0) {
      CHECK_EQ(of_beats.take_all(), of_all.take_all());
    } else if (up_to(1) == 0) {
      of_beats.take_one();
      of_all.take_one();
    }
  }
}

}  // namespace

TEST_CASE("gathered samples: each policy has the queue that takes all samples") {
  constexpr int most = most_waiting<apart, output_of_eyes>;
  for (unsigned seed = 0; seed < 60; ++seed)
    for (const int cycles : {4, 20, 200}) {
      CAPTURE(seed);
      CAPTURE(cycles);
      check_same<most, full_kind::drop_oldest>(seed, cycles);
      check_same<most, full_kind::drop_newest>(seed, cycles);
      check_same<1, full_kind::drop_newest>(seed, cycles);
      check_same<3, full_kind::drop_oldest>(seed, cycles);
    }
}
