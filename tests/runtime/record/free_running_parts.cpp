// Parts with components in free-running environments: what stops and starts in a wall-clock run is replayed
// bit for bit, also where a stopped component's last results arrive.
#include <doctest/doctest.h>

#include <cstdint>
#include <string>

#include <cca/record.hpp>

#include "../../laws/temporary_file.hpp"
#include "../deployment/free_running_parts.hpp"

using namespace free_parts;

namespace {

struct apart : spread<cca::tolerate<100000>>, cca::recordable {};

}  // namespace

TEST_SUITE("recording of free-running parts") {
  TEST_CASE("cycles shorter and longer than a beat") {
    for (const std::int64_t us : {0, 300, 4'000}) {
      CAPTURE(us);
      cca::recording::replay_result result;
      const laws::temporary_file file("free_parts.mcap");
      for (const double speed : {0.5, 0.1, 0.03}) {  // slower where the busy machine left out beats
        {
          cca::deployed<apart> d;
          const cca::recording::recorder into(d, file.path);
          d.load();
          d.start();
          d.run(cca::for_beats<40>{});
          cycle_in_us = us;
          d.run(cca::for_beats<90>{}, cca::at_speed(speed));
          d.stop<"sight">();
          d.run(cca::for_beats<10>{}, cca::at_speed(speed));
          d.start<"sight">();
          d.run(cca::for_beats<60>{}, cca::at_speed(speed));
          cycle_in_us = 0;
          CHECK_GT(d.get<"sight.look">().stops, 3);
          d.stop();
        }
        result = cca::recording::replay<apart>(file.path);
        if (result.ended_early.empty()) break;
      }
      CAPTURE(result.difference);
      CAPTURE(result.ended_early);
      CHECK(result);
      CHECK_GE(result.beats, 200);
    }
  }
}
