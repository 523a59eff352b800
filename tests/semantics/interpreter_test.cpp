// Checks the interpreter against values worked out by hand from the text, before it judges anything else.
#include <doctest/doctest.h>

#include <map>

#include "description.hpp"

using namespace semantics;

namespace {

// A source publishes the beat's index, every other component the sum of its inputs.
interpreter made(const std::string& text, int beats) {
  interpreter i(described(text));
  int id = 0;
  for (node& n : i.g.nodes) {
    n.id = id++;
    n.does = [](firing& f) {
      double sum = f.inputs.empty() ? static_cast<double>(f.beat) : 0.0;
      for (const recorded_input& s : f.inputs) sum += s.value[0];
      for (recorded_output& t : f.outputs) t.value[0] = sum;
    };
  }
  for (int k = 0; k < beats; ++k) i.beat();
  return i;
}

std::vector<std::int64_t> fired(const interpreter& i, int id) {
  std::vector<std::int64_t> beats;
  for (const firing& f : i.firings)
    if (f.id == id && f.which != function::on_fault) beats.push_back(f.beat);
  return beats;
}

std::vector<double> values(const interpreter& i, int id, std::size_t input = 0) {
  std::vector<double> all;
  for (const firing& f : i.firings)
    if (f.id == id) all.push_back(f.inputs[input].value[0]);
  return all;
}

std::vector<std::int64_t> origins(const interpreter& i, int id, std::size_t input = 0) {
  std::vector<std::int64_t> all;
  for (const firing& f : i.firings)
    if (f.id == id) all.push_back(f.inputs[input].origin);
  return all;
}

using beats = std::vector<std::int64_t>;
using numbers = std::vector<double>;

const std::string source = "period 10\ncomponent s timed 1 0\nprocess\nout y 1\n";
const std::string slow = "period 10\ncomponent s timed 3 1\nprocess\nout y 1\n";
const std::string sink = "process\nin x 1\nwire s.y r.x ";

}  // namespace

TEST_SUITE("interpreter") {
  TEST_CASE("timed and its phase") {
    CHECK(fired(made("component s timed 3 1\nprocess\n", 9), 0) == beats{1, 4, 7});
    CHECK(fired(made("component s timed 3 5\nprocess\n", 9), 0) == beats{2, 5, 8});
    CHECK(fired(made("component s timed 3 -1\nprocess\n", 9), 0) == beats{2, 5, 8});
    CHECK(fired(made("component s default\nprocess\n", 3), 0) == beats{0, 1, 2});
    CHECK(fired(made("component s inactive\nprocess\n", 3), 0).empty());
  }
  TEST_CASE("timeout counts from beat 0 until it has fired") {
    CHECK(fired(made("component s timeout 4\nprocess\n", 13), 0) == beats{4, 8, 12});
    CHECK(fired(made(slow + "component r any_of 2 moderate timeout 2\n" + sink + "latest", 9), 1) ==
          beats{1, 3, 4, 6, 7});
  }
  TEST_CASE("latest sees this beat's sample, delayed N beats later") {
    CHECK(values(made(source + "component r timed 1 0\n" + sink + "latest", 4), 1) == numbers{0, 1, 2, 3});
    CHECK(values(made(source + "component r timed 1 0\n" + sink + "delayed 2 initial 7", 5), 1) ==
          numbers{7, 7, 0, 1, 2});
    CHECK(origins(made(source + "component r timed 1 0\n" + sink + "delayed 2", 4), 1) ==
          beats{never, never, 0, 10});
  }
  TEST_CASE("restless and moderate") {
    const std::string two = "component q timed 2 0\nprocess\nout y 1\ncomponent r ";
    const std::string ports = "\nprocess\nin x 1\nin z 1\nwire s.y r.x latest\nwire q.y r.z latest\n";
    CHECK(fired(made(slow + two + "restless" + ports, 9), 2) == beats{0, 1, 2, 4, 6, 7, 8});
    CHECK(fired(made(slow + two + "moderate" + ports, 9), 2) == beats{1, 4, 7});
    CHECK(fired(made(slow + two + "port_triggered 1 x" + ports, 9), 2) == beats{1, 4, 7});
    CHECK(fired(made(slow + two + "all_of 2 restless timed 3 0" + ports, 9), 2) == beats{0, 3, 6});
    CHECK(fired(made(slow + "component r restless\n" + sink + "delayed 2", 9), 1) == beats{3, 6});
  }
  TEST_CASE("queue: one sample a firing, then what it took last") {
    const std::string late = "component r timed 2 3\n";
    CHECK(values(made(source + late + sink + "queue 8 drop_oldest", 10), 1) == numbers{0, 1, 2, 3, 4});
    CHECK(values(made(source + late + sink + "queue 2 drop_oldest", 10), 1) == numbers{0, 2, 4, 6, 8});
    CHECK(values(made(source + late + sink + "queue 2 drop_newest", 10), 1) == numbers{0, 1, 2, 4, 6});
    CHECK(values(made(slow + "component r timed 1 0\n" + sink + "queue 2 drop_newest initial -1", 6), 1) ==
          numbers{-1, 1, 1, 1, 4, 4});
    const interpreter i = made(source + late + sink + "queue 2 reject", 10);
    CHECK(i.faulted);
    CHECK(i.k ==
          3);  // 0 and 1 wait, 0 is taken in beat 1, 2 waits, 3 comes before the reader is called: full
  }
  TEST_CASE("coordinated") {
    // s -> a -> r.x and s -> r.z, but a fires every second beat only.
    const std::string text =
        source +
        "component a timed 2 1\nprocess\nin x 1\nout y 1\ncomponent r coordinated\nprocess\nin x 1\nin z 1\n"
        "wire s.y a.x latest\nwire a.y r.x latest\nwire s.y r.z latest\n";
    CHECK(fired(made(text, 6), 2) == beats{1, 3, 5});
  }
  TEST_CASE("origin: the oldest that counts") {
    // q holds s's slow sample and its own loop's: the loop does not count.
    const std::string text = slow +
                             "component q timed 1 0\nprocess\nin x 1\nin back 1\nout y 1\nwire s.y q.x "
                             "latest\nwire q.y q.back delayed 1\n"
                             "component r timed 1 0\nprocess\nin x 1\nwire q.y r.x latest\n";
    CHECK(origins(made(text, 6), 2) == beats{0, 10, 10, 10, 40, 40});
  }
  TEST_CASE("a resource node: sense before, act after, one node") {
    const std::string text =
        "period 10\nresource b timed 1 0\nsense\nout y 1\nact\nin u 1\ncomponent c restless\nprocess\nin x "
        "1\nout y 1\n"
        "wire b.y c.x delayed 1\nwire c.y b.u latest\n";
    const interpreter i = made(text, 3);
    std::string order;
    for (const firing& f : i.firings)
      order += f.which == function::sense ? 's' : f.which == function::process ? 'p' : 'a';
    CHECK(order == "saspaspa");
    CHECK(i.firings[4].inputs[0].origin ==
          10);  // the delayed wire closes a loop: it doesn't count, so it's the beat's time
  }
  TEST_CASE("the call order: first declared whose predecessors have been called") {
    const std::string text =
        "component d timed 1 0\nprocess\nin x 1\ncomponent c timed 1 0\nprocess\nin x 1\ncomponent b timed 1 "
        "0\nprocess\nout y "
        "1\n"
        "component a timed 1 0\nprocess\nout y 1\nwire a.y d.x latest\nwire b.y c.x latest\n";
    const interpreter i = made(text, 1);
    std::vector<int> order;
    for (const firing& f : i.firings) order.push_back(f.id);
    CHECK(order == std::vector<int>{2, 1, 3, 0});
  }
  TEST_CASE("dt") {
    const interpreter i = made("period 2000000\ncomponent s timed 3 1\nprocess\n", 5);
    CHECK(i.firings[0].dt == 0.006);
    CHECK(made("period 2000000\ncomponent s any_of 1 timed 3 1\nprocess\n", 5).firings[0].dt == 0.002);
    CHECK(made("period 2000000\ncomponent s any_of 1 timed 3 1\nprocess\n", 5).firings[1].dt == 0.006);
  }
}
