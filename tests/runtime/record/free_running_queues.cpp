// Queues and merged wires from and to free-running environments: recorded in a wall-clock run with all
// samples that arrived in a beat, and what is missing between them, so a replay gives the same bits.
#include <doctest/doctest.h>

#include <cstdint>
#include <string>

#include <cca/record.hpp>

#include "../../laws/temporary_file.hpp"
#include "../deployment/free_running_queues.hpp"

using namespace free_queues;

namespace {

struct apart : spread<cca::tolerate<100000>>, cca::recordable {};

// Runs and replays, and again slower where the busy machine left out beats of the mind.
template <class F>
cca::recording::replay_result recorded(F runs) {
  cca::recording::replay_result result;
  const laws::temporary_file file("free_queues.mcap");
  for (const double speed : {0.5, 0.1, 0.03, 0.03}) {
    {
      cca::deployed<apart> d;
      const cca::recording::recorder into(d, file.path);
      d.load();
      d.start();
      runs(d, cca::at_speed(speed));
      d.stop();
    }
    result = cca::recording::replay<apart>(file.path);
    if (result.ended_early.empty()) break;
  }
  return result;
}

}  // namespace

TEST_SUITE("recording of free-running queues") {
  TEST_CASE("cycles shorter and longer than a beat: all that was taken and lost is replayed bit for bit") {
    for (const std::int64_t us : {0, 300, 9'000}) {
      cycle_in_us = us;
      CAPTURE(us);
      const auto result = recorded([&](auto& d, auto pace) {
        cycle_in_us = 0;
        d.run(cca::for_beats<40>{});
        cycle_in_us = us;
        d.run(cca::for_beats<60>{}, pace);
        d.run(cca::for_beats<60>{}, pace);
        // Far more cycles than a queue can hold: some are lost in one beat.
        if (us == 0) CHECK_GT(d.template dropped<"late.x">(), 100);
      });
      CAPTURE(result.difference);
      CAPTURE(result.ended_early);
      CHECK(result);
      CHECK_GE(result.beats, 160);
      CHECK_GE(result.samples, 160 * 3);
    }
    cycle_in_us = 0;
  }
}
