// Modes with a free-running environment: one file has all environments, the switches and the beats in which
// results arrived, and is replayed bit for bit in one loop.
#include <doctest/doctest.h>

#include <cstdint>
#include <string>

#include <cca/record.hpp>

#include "../../laws/temporary_file.hpp"
#include "../deployment/free_modes.hpp"

using namespace free_modes;

namespace {

struct recorded : turning<>, cca::recordable {};

}  // namespace

TEST_SUITE("recording of free-running modes") {
  TEST_CASE("cycles shorter and longer than a beat and than a mode - who runs freely asks for modes, too") {
    for (const std::int64_t us : {100, 3'000, 20'000}) {
      CAPTURE(us);
      const cycles_of these(us);
      std::size_t cycles = 0;
      const laws::temporary_file file("free_modes.mcap");
      {
        cca::deployed<recorded> d;
        const cca::recording::recorder into(d, file.path);
        cycle_in_us = 0;
        d.load();
        d.start();
        d.run(cca::for_beats<40>{});
        cycle_in_us = us;
        d.run(cca::for_beats<90>{}, cca::at_speed(0.5));
        d.get<"aims_left">().asks_every = 3;
        d.get<"aims_right">().asks_every = 4;
        d.run(cca::for_beats<60>{}, cca::at_speed(0.5));
        d.switch_to<"left">();
        d.run(cca::for_beats<30>{}, cca::at_speed(0.5));
        cycle_in_us = 0;
        d.run(cca::for_beats<40>{});
        d.switch_to<"right">();
        d.run(cca::for_beats<40>{}, cca::at_speed(0.5));
        cycles = d.get<"aims_right">().all.size();
        d.stop();
      }
      CHECK_GT(cycles, 20);
      const auto result = cca::recording::replay<recorded>(file.path);
      CAPTURE(result.difference);
      CAPTURE(result.ended_early);
      CHECK(result);
      CHECK_GE(result.beats, 300);
      CHECK_GE(result.samples, 300);  // the reader in each beat
    }
  }
}
