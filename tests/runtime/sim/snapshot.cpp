// Same commands, same bits: again, after a copy, after save and restore, and in two threads at once.
#include <thread>
#include <vector>

#include <doctest/doctest.h>

#include "standing.hpp"

using namespace test;

TEST_SUITE("sim snapshot") {
  TEST_CASE("two equal worlds with equal commands are bit-identical") {
    sim::world a(sim::oncilla_defaults, sim::terrain::flat(), crouched());
    sim::world b(sim::oncilla_defaults, sim::terrain::flat(), crouched());
    for (int part = 0; part < 4; ++part) {  // stepped in turns: state that they share by mistake would show
      run(a, 250 * part, 250 * (part + 1));
      run(b, 250 * part, 250 * (part + 1));
      REQUIRE(a.hash() == b.hash());
    }
  }

  TEST_CASE("one bit less of friction is another run") {
    sim::world a(sim::oncilla_defaults, sim::terrain::flat(), crouched());
    sim::world b(sim::oncilla_defaults, sim::terrain::flat().with_friction(std::nextafter(0.75, 0)),
                 crouched());
    run(a, 0, 1000);
    run(b, 0, 1000);
    CHECK(a.hash() != b.hash());
  }

  TEST_CASE("a copy is a snapshot: original and copy go on bit for bit") {
    for (const char* ground : {"flat", "slope:4", "steps:8"}) {
      sim::world original(sim::oncilla_defaults, sim::terrain::named(ground), crouched());
      run(original, 0, 777);
      sim::world copy(original);
      CHECK((copy.hash() == original.hash()));
      run(original, 777, 1500);
      CHECK(!(copy.hash() == original.hash()));
      run(copy, 777, 1500);
      CHECK((copy.hash() == original.hash()));

      sim::world assigned;
      assigned = original;
      sim::world moved(std::move(original));
      run(assigned, 1500, 1800);
      run(moved, 1500, 1800);
      run(copy, 1500, 1800);
      CHECK((assigned.hash() == copy.hash()));
      CHECK((moved.hash() == copy.hash()));
    }
  }

  TEST_CASE("save, run on, restore, run again: the same bits, beat by beat") {
    sim::world w(sim::oncilla_defaults, sim::terrain::flat(), crouched());
    run(w, 0, 600);
    const sim::robot_state saved = w.save();
    std::vector<std::uint64_t> first;
    for (int k = 600; k < 900; ++k) {
      run(w, k, k + 1);
      first.push_back(w.hash());
    }
    w.restore(saved);
    CHECK((w.hash() == saved.hash()));
    for (int k = 600; k < 900; ++k) {
      run(w, k, k + 1);
      REQUIRE(w.hash() == first[static_cast<std::size_t>(k - 600)]);
    }
  }

  TEST_CASE("restoring keeps every bit, also where the engine would normalise") {
    sim::world w(sim::oncilla_defaults, sim::terrain::flat(), crouched());
    run(w, 0, 333);
    for (int k = 333; k < 400; ++k) {
      const sim::robot_state s = w.save();
      w.restore(s);
      REQUIRE((w.hash() == s.hash()));
      run(w, k, k + 1);
    }
  }

  TEST_CASE("two worlds in two threads give the same bits as one world alone") {
    const auto hash_of_run = [] {
      sim::world w(sim::oncilla_defaults, sim::terrain::flat(), crouched());
      run(w, 0, 1500);
      return w.hash();
    };
    const std::uint64_t alone = hash_of_run();
    std::uint64_t left = 0, right = 0;
    std::thread a([&] { left = hash_of_run(); });
    std::thread b([&] { right = hash_of_run(); });
    a.join();
    b.join();
    CHECK(left == alone);
    CHECK(right == alone);
  }

  TEST_CASE("a world may be built in one thread, stepped in another and copied in a third") {
    sim::world w(sim::oncilla_defaults, sim::terrain::flat(), crouched());
    sim::world reference(w);
    run(reference, 0, 400);
    std::thread([&] { run(w, 0, 200); }).join();
    std::thread([&] {
      sim::world copy(w);
      run(copy, 200, 400);
      CHECK(copy.hash() == reference.hash());
    }).join();
  }
}
