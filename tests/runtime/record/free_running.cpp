// A recording of a free-running environment has its samples with the beats in which they arrived, so a replay
// gives the same bits, whatever the machine did.
#include <doctest/doctest.h>

#include <cstdint>
#include <string>
#include <thread>
#include <unistd.h>

#include <cca/deployment.hpp>
#include <cca/record.hpp>
#include <cca/runtime/transports/shared_memory.hpp>

#include "../../laws/process.hpp"
#include "../../laws/temporary_file.hpp"
#include "../deployment/free_running.hpp"

using namespace deployment_test;

namespace {

using robot = cca::environment<"robot", cca::nodes<"device", "reflex">>;
using sight = cca::environment<"eyes", cca::nodes<"eyes", "memory", "history">, cca::free_running>;
using mind = cca::environment<"mind", cca::other_nodes>;

struct seen : cca::deployment<seeing, robot, sight, mind, cca::tolerate<100000>>, cca::recordable {};

// The camera stands beside the beat, too: what only the eyes read is not recorded in a wall-clock run.
struct camera {
  double frames = 0;
  auto sense(cca::beat) -> cca::out<"image", state> {
    ++frames;
    return Eigen::Vector2d(std::sin(0.1 * frames), frames);
  }
};
struct switched : cca::graph<cca::rate<1000>,
                             cca::node<"device", device>,
                             cca::node<"camera", camera, cca::full_speed>,
                             cca::node<"eyes", eyes, cca::full_speed>,
                             cca::node<"glancer", glancer>,
                             cca::wire<"camera.image", "eyes.image">,
                             cca::wire<"eyes.glance", "glancer.glance">,
                             cca::wire<"eyes.level", "glancer.level", cca::delayed<1>>,
                             cca::wire<"glancer.y", "device.command">> {};
struct with_camera : cca::deployment<switched,
                                     cca::environment<"robot", cca::nodes<"device", "glancer">>,
                                     cca::environment<"eyes", cca::other_nodes, cca::free_running>>,
                     cca::recordable {};

// Runs and replays, and again slower where the busy machine left out beats of the mind.
template <class D, class F>
cca::recording::replay_result recorded(F runs) {
  cca::recording::replay_result result;
  const laws::temporary_file file("free.mcap");
  for (const double speed : {0.5, 0.1, 0.03}) {
    {
      cca::deployed<D> d;
      const cca::recording::recorder into(d, file.path);
      d.load();
      d.start();
      runs(d, cca::at_speed(speed));
      d.stop();
    }
    result = cca::recording::replay<D>(file.path);
    if (result.ended_early.find("left out beats") == std::string::npos) break;
  }
  return result;
}

void check_whole(const cca::recording::replay_result& result, std::int64_t beats, std::int64_t least) {
  CAPTURE(result.difference);
  CAPTURE(result.ended_early);
  CHECK(result);
  CHECK_GE(result.beats, beats);
  CHECK_GE(result.samples, least);
}

}  // namespace

TEST_SUITE("recording of what runs freely") {
  TEST_CASE("cycles shorter and longer than a beat are replayed bit for bit") {
    for (const std::int64_t us : {100, 1'700, 9'000}) {
      const cycles_of these(us);
      const auto result = recorded<seen>([](auto& d, auto pace) { d.run(cca::for_beats<150>{}, pace); });
      check_whole(result, 150, 150);  // the reflex in each beat
    }
  }

  TEST_CASE("until the first wall-clock run it is computed, and compared - from then on it is played") {
    const auto result = recorded<seen>([](auto& d, auto pace) {
      const cycles_of these(2'000);
      cycle_in_us = 0;
      d.run(cca::for_beats<100>{});
      cycle_in_us = 2'000;
      d.run(cca::for_beats<60>{}, pace);
      d.run(cca::for_beats<40>{}, pace);
      cycle_in_us = 0;
      d.run(cca::for_beats<100>{});
    });
    // In the first hundred beats also the eyes and the memory.
    check_whole(result, 300, 300 + 2 * 100);
  }

  TEST_CASE("a camera that is read only beside the beat") {
    const cycles_of these(3'000);
    const auto result = recorded<with_camera>([](auto& d, auto pace) {
      d.run(cca::for_beats<120>{}, pace);
      CHECK_GT(d.template get<"camera">().frames, 10);
    });
    check_whole(result, 120, 5);
  }

  TEST_CASE("the process of the first environment has all that a replay needs, of either kind of run") {
    const std::string memory = "/cca_free_" + std::to_string(::getpid());
    const laws::temporary_file mind("mind.mcap"), eye("eyes.mcap"), robot("robot.mcap");
    const auto run = [&](const char* environment, const std::string& into, auto pace, bool again) {
      cycle_in_us = again ? 0 : 4'000;
      cca::deployed<seen> d(cca::only{environment}, cca::shared_memory(memory));
      const cca::recording::recorder recording(d, into);
      d.load();
      d.start();
      std::int64_t beat = 0;
      d.run(cca::for_beats<100>{}, pace, [&](auto& now) {
        beat = now.beat_index();
        return true;
      });
      if (beat < 50) return "it saw beat " + std::to_string(beat) + " last";
      if (again) d.run(cca::for_beats<50>{}, cca::at_speed(0.2)), d.run(cca::for_beats<50>{});
      d.stop();
      return std::string("done");
    };
    const auto result = [&](auto pace, bool again) {
      process minds([&] { return run("mind", mind.path, pace, again); });
      process eyes([&] { return run("eyes", eye.path, pace, again); });
      process robots([&] { return run("robot", robot.path, pace, again); });
      CHECK_EQ(robots.said(), "done");
      CHECK_EQ(eyes.said(), "done");
      CHECK_EQ(minds.said(), "done");
      return cca::recording::replay<seen>(robot.path);
    };
    check_whole(result(cca::at_speed(0.2), false), 100, 100);
    // In a fast run what the others published is computed anew.
    const auto fast = result(cca::as_fast_as_possible(), false);
    check_whole(fast, 100, 100);
    CHECK_LT(fast.samples, 4 * 100);  // and not compared
    // After a wall-clock run it depends on that.
    const auto both = result(cca::as_fast_as_possible(), true);
    CHECK_EQ(both.difference, "");
    CHECK_NE(both.ended_early.find("ran in another process, in a fast run after a wall-clock run"),
             std::string::npos);
  }

  TEST_CASE("a free-running component faults in a wall-clock run: the beats of the others are whole") {
    for (const bool goes_on : {false, true}) {
      const cycles_of these(9'000);
      const auto result = recorded<seen>([goes_on](auto& d, auto pace) {
        d.run(cca::for_beats<20>{}, pace);
        auto p = d.template get<"eyes">().p;
        p.most = -1e9;
        d.template set<"eyes">(p);
        d.run(cca::for_beats<400>{}, pace);
        REQUIRE_EQ(d.fault_path(), "eyes");
        if (!goes_on) return;
        p.most = 1e9;
        d.template set<"eyes">(p);
        d.resume();
        d.run(cca::for_beats<30>{}, pace);
      });
      check_whole(result, goes_on ? 50 : 21, goes_on ? 50 : 21);
      CHECK_EQ(result.fault, goes_on ? "" : "`eyes`: dazzled");
    }
  }
}
