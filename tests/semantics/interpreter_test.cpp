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
  TEST_CASE("queue, delayed: it enters when it arrives") {
    CHECK(
        values(made(source + "component r timed 1 0\n" + sink + "delayed 2 queue 8 drop_oldest initial 7", 5),
               1) == numbers{7, 7, 0, 1, 2});
    // Arrivals: 0 in beat 2, 1 in 3, ...; read in beats 2, 5, 8.
    const std::string late = "component r timed 3 2\n";
    CHECK(values(made(source + late + sink + "delayed 2 queue 2 drop_oldest", 9), 1) == numbers{0, 2, 5});
    CHECK(values(made(source + late + sink + "delayed 2 queue 2 drop_newest", 9), 1) == numbers{0, 1, 2});
    const interpreter i = made(source + "component r timed 9 8\n" + sink + "delayed 3 queue 2 reject", 9);
    CHECK(i.faulted);
    CHECK(i.k == 5);                             // 0 arrives in beat 3, 1 in 4
    CHECK(fired(i, 0) == beats{0, 1, 2, 3, 4});  // nothing fires in beat 5
    CHECK(fired(made(source + "component r restless\n" + sink + "delayed 2 queue 4 drop_oldest", 5), 1) ==
          beats{2, 3, 4});
  }
  TEST_CASE("merged: by arrival, of one beat by publication") {
    const std::string two = slow + "component q timed 3 1\nprocess\nin x 1\nout y 1\ncomponent r ";
    const std::string ports = "\nprocess\nin x 1\nwire s.y q.x latest initial 0\n";
    const auto from = [](const std::string& writer, const std::string& policy) {
      return "wire " + writer + ".y r.x " + policy + "\n";
    };
    // s publishes its beat in 1, 4, 7; q passes it on in the same beat.
    CHECK(fired(made(two + "restless" + ports + from("q", "merged 8 drop_oldest") +
                         from("s", "merged 8 drop_oldest"),
                     9),
                2) == beats{1, 2, 4, 5, 7, 8});
    CHECK(values(made(two + "restless" + ports + from("q", "merged 8 drop_oldest") +
                          from("s", "delayed 3 merged 8 drop_oldest"),
                      9),
                 2) == numbers{1, 1, 4, 4, 7});
    CHECK(values(made(two + "timed 3 1" + ports + from("q", "merged 1 drop_newest") +
                          from("s", "merged 1 drop_newest"),
                      9),
                 2) == numbers{1, 4, 7});
    CHECK(made(two + "timed 3 1" + ports + from("q", "merged 1 reject") + from("s", "merged 1 reject"), 9)
              .faulted);
  }
  TEST_CASE("merged: a sample that closes a loop does not count for the origin, the others do") {
    const std::string text =
        slow +
        "component m timed 1 0\nprocess\nin x 1\nout y 1\n"
        "component r timed 1 0\nprocess\nin x 1\n"
        "wire s.y m.x merged 4 drop_oldest\nwire m.y m.x delayed 2 merged 4 drop_oldest\n"
        "wire m.y r.x latest\n";
    // m reads: nothing; s's of beat 1; its own of 0, 1, 2; s's of beat 4, which came after that; its own
    // of 3.
    CHECK(origins(made(text, 7), 2) == beats{0, 10, 20, 30, 40, 40, 60});
  }
  TEST_CASE("every_nth, while_waiting") {
    CHECK(fired(made(source + "component r user every_nth x 3 0\n" + sink + "latest", 10), 1) ==
          beats{2, 5, 8});
    CHECK(
        fired(made(slow + "component r user every_nth x 2 0\n" + sink + "delayed 2 queue 4 drop_oldest", 14),
              1) == beats{6, 12});
    CHECK(fired(made(slow + "component r any_of 2 timed 5 0 user every_nth x 2 0\n" + sink + "latest", 12),
                1) == beats{0, 4, 5, 10});
    CHECK(fired(made(slow + "component r user while_waiting x 2 0\n" + sink + "queue 4 drop_oldest", 12),
                1) == beats{4, 7, 10});
  }
  TEST_CASE("what several threads record comes in one order") {
    firing a, b;
    a.inputs.push_back({"x", {1.0}});
    b.inputs.push_back({"x", {2.0}});
    const semantics::log one = merged({a, b}), other = merged({b, a});
    CHECK(same(one[0], other[0]));
    CHECK(same(one[1], other[1]));
    CHECK_FALSE(same(one[0], one[1]));
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
