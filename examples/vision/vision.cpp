// An arm catches balls that it sees. The arm's loop has beats of 1 ms. The eye takes an image, searches the
// ball on it, and begins anew, as fast as it can: a millisecond where the ball was near, ten where it was
// lost.
//
//   vision                                   in a wall-clock run: the eye runs freely
//   vision --pace fast                       in a fast run: an image in each beat, as in one loop
//   vision --record v.mcap, --replay v.mcap  the same bits again, without an eye
//
// Page: docs/vision.md.
#include <cstdio>

#include <cca/deployment.hpp>
#include <cca/main.hpp>

#if __has_include(<cca/record.hpp>)
#include <cca/record.hpp>                // offers --record
#include <cca/record/replay_option.hpp>  // offers --replay
#endif
#if __has_include(<cca/door.hpp>)
#include <cca/door.hpp>  // offers --door
#endif

#include "catcher.hpp"
#include "eye.hpp"
#include "table.hpp"

namespace vision {

// [architecture]
struct catching : cca::graph<cca::rate<1000>,
                             cca::node<"table", table>,
                             cca::node<"eye", eye, cca::full_speed>,
                             cca::node<"catcher", catcher, cca::timed<1>>,
                             cca::node<"limits", cca::limiter<arm_angle>>,
                             cca::wire<"table.ball", "eye.ball">,  // without delay, both ways
                             cca::wire<"eye.spot", "catcher.spot">,
                             cca::wire<"catcher.command", "limits.command">,
                             cca::wire<"limits.safe", "table.command">> {};

struct with_eye : cca::deployment<catching,
                                  cca::environment<"arm", cca::other_nodes>,
                                  cca::environment<"eye", cca::nodes<"eye">, cca::free_running>>,
                  cca::recordable {};
// [architecture end]

struct program : cca::robot_program<with_eye> {
  program() {
    purpose = "an arm catches balls that it sees";
    settings.seconds = 6;
  }

  int finish(controller_type& c) override {
    const auto& eye = c.get<"eye">();
    const auto& catcher = c.get<"catcher">();
    std::printf(
        "caught %d of %d balls; %lld images, the ball found on %lld; a spot is %.1f ms old when it comes\n",
        c.get<"table">().caught, c.get<"table">().thrown - 1, static_cast<long long>(eye.images),
        static_cast<long long>(eye.found),
        catcher.spots > 0 ? 1e3 * catcher.ages / static_cast<double>(catcher.spots) : 0);
    return settings.speed ? 0 : compare_with_one_loop(c);
  }

  // [one loop]
  static int compare_with_one_loop(const controller_type& c) {
    cca::controller<catching> one;
    one.load();
    one.start();
    one.run(cca::for_some_beats{c.beat_index()});
    const bool is_same = one.get<"table">().angle == c.get<"table">().angle &&
                         one.get<"table">().caught == c.get<"table">().caught &&
                         one.get<"catcher">().ages == c.get<"catcher">().ages &&
                         one.get<"eye">().images == c.get<"eye">().images;
    std::puts(is_same ? "bit for bit as in one loop" : "not as in one loop");
    return is_same ? 0 : 1;
  }
  // [one loop end]
};

}  // namespace vision

int main(int count, char** words) { return cca::robot_main<vision::program>(count, words); }
