// Skeletons that are cut between environments: threads of this process, and processes over shared memory.
#include <doctest/doctest.h>

#include <unistd.h>

#include <string>

#include <cca/runtime/transports/shared_memory.hpp>

#include "../../laws/cut_skeletons.hpp"

using namespace cut_skeletons;

namespace {

struct over_memory {
  static auto transport(const std::string& name) { return cca::shared_memory(name); }
  static std::string other_name() { return "/cca_test_farm_" + std::to_string(::getpid()); }
};

template <class Graph, class Deployment>
void check_same(int least) {
  cca::controller<Graph> one;
  cca::deployed<Deployment> apart;
  const witness of_one = played(one);
  CHECK_EQ(words(played(apart)), words(of_one));
  CHECK(of_one.samples >= least);
}

}  // namespace

TEST_SUITE("cut skeletons") {
  TEST_CASE("a farm whose workers run in threads has the bits of one loop") {
    check_same<thinking, spread>(500);
  }
  TEST_CASE("a farm whose workers run in processes has the bits of one loop") {
    a_farm_in_processes<over_memory>();
  }
  TEST_CASE("a pipeline") { check_same<piped, piped_apart>(1000); }
  TEST_CASE("an adaptive component, between its module and its criterion") {
    check_same<tracked, tracked_apart>(5000);
  }
  TEST_CASE("a generator, between oscillator, pattern and criterion") {
    check_same<swung, swung_apart>(5000);
  }
  TEST_CASE("without the option the wires inside are as they were") {
    cca::controller<thinking> c;
    c.load();
    c.start();
    c.run(cca::for_beats<3>{});  // eye, worker and hand each one beat later
    CHECK(c.get<"hand">().samples == 1);
    struct at_once : cca::graph<cca::rate<1000>, cca::node<"eye", eye>,
                                cca::node<"brain", cca::farm<thought, spots, spots>>, cca::node<"hand", hand>,
                                cca::wire<"eye.y", "brain.input">, cca::wire<"brain.output", "hand.x">> {};
    cca::controller<at_once> same_beat;
    same_beat.load();
    same_beat.start();
    same_beat.step();
    CHECK(same_beat.get<"hand">().samples == 1);
  }
}
