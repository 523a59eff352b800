// A whole beat on eight drives: the trot's controller with hardware::oncilla, on buses that cost nothing.
//
//   drives BEATS          runs this many beats (under callgrind); exits with 1 if a guard tripped
//   drives allocations    the allocations of 1000 beats
//
// Each bus is a mirror: it plays drives that go an eighth of the way to each command, and the sensor board.
// Its own cost is subtracted by a second count of its two functions alone (--toggle-collect), so the figure
// is the cost of reading and writing all frames, of the safety chain and of the controller. A real bus adds
// the kernel's work. docs/hardware.md.
#include <algorithm>
#include <array>
#include <cstdio>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <utility>

#include <cca/cca.hpp>

#include "../examples/hardware_in_the_loop/robot.hpp"
#include "../examples/trot/architecture.hpp"
#include "words.hpp"

extern "C" long bench_allocations();

namespace bench {

namespace hw = cca::hardware;

class mirror {
public:
  bool has_board = false;

  [[gnu::noinline]] hw::send_result send(std::span<const hw::can_frame> frames) noexcept {
    for (const hw::can_frame& f : frames) {
      if (f.id.number > 8 || count == answers.size()) continue;
      auto& where = at[f.id.number];
      const bool special = f.data[0] == 0xFF && f.data[1] == 0xFF && f.data[2] == 0xFF;
      const bool stiff = ((f.data[3] & 0xFu) << 8 | f.data[4]) != 0;
      if (!special) {
        const int before = where[0] << 8 | where[1], wanted = f.data[0] << 8 | f.data[1];
        const int now_at = stiff ? before + (wanted - before) / 8 : before;
        const int speed = std::clamp(
            at_rest + static_cast<int>(steps_of_speed * 1000 * (now_at - before) / steps_of_angle), 0, 0xFFF);
        where = {static_cast<std::uint8_t>(now_at >> 8), static_cast<std::uint8_t>(now_at),
                 static_cast<std::uint8_t>(speed >> 4), static_cast<std::uint8_t>((speed & 0xF) << 4 | 7)};
      }
      answers[count++] = {.id = answers_under,
                          .length = 8,
                          .data = {static_cast<std::uint8_t>(f.id.number | 0x10), where[0], where[1],
                                   where[2], where[3], 0xFF, 25, 25}};
    }
    return {frames.size(), hw::send_outcome::sent};
  }
  [[gnu::noinline]] std::size_t receive(std::span<hw::received_frame> into) noexcept {
    now += 1'000'000;
    if (has_board)
      for (const hw::can_frame& f : hil::board::frames({.orientation = {0, 0, 0, 1}}, beat++))
        answers[count++] = f;
    const std::size_t n = std::exchange(count, 0);
    for (std::size_t i = 0; i < n; ++i) into[i] = {answers[i], now};
    return n;
  }
  hw::bus_state state() const noexcept { return hw::bus_state::active; }
  const hw::bus_counters& counters() const noexcept { return none; }
  std::uint64_t in_flight() const noexcept { return 0; }

  // A drive begins in the middle of its joint's range.
  template <class... J>
  void stand(hw::joint_list<J...>) {
    const auto one = [this]<class One>(One) {
      const auto& d =
          One::drive::reply(One::drive_angle_of(0.5 * (One::angle.lower + One::angle.upper)), 0, 0).data;
      at[One::drive::request_id.number] = {d[1], d[2], d[3], d[4]};
      const auto angle_in = [](const auto& frame) { return frame.data[1] << 8 | frame.data[2]; };
      const auto speed_in = [](const auto& frame) { return frame.data[3] << 4 | frame.data[4] >> 4; };
      at_rest = speed_in(One::drive::reply(0, 0, 0));
      steps_of_angle = angle_in(One::drive::reply(1, 0, 0)) - angle_in(One::drive::reply(0, 0, 0));
      steps_of_speed = speed_in(One::drive::reply(0, 1, 0)) - at_rest;
      answers_under = One::drive::reply_id;
    };
    (one(J()), ...);
  }

private:
  std::array<std::array<std::uint8_t, 4>, 9> at{};  // position and velocity as in a frame
  // Of a frame's numbers: the velocity 0, and how many a rad and a rad/s are.
  int at_rest = 0;
  double steps_of_angle = 1, steps_of_speed = 1;
  std::array<hw::can_frame, 32> answers{};
  hw::can_id answers_under{};
  std::size_t count = 0;
  std::int64_t now = 0;
  std::uint8_t beat = 0;
  hw::bus_counters none{};
};

struct trot_on_mirrors : trot::architecture<hil::oncilla<mirror>> {};

struct robot {
  std::array<mirror, hil::buses> buses{};
  cca::controller<trot_on_mirrors> controller{};
  robot() {
    buses[hil::board::bus].has_board = true;
    for (mirror& each : buses) each.stand(hil::joints());
    controller.get<"robot.synchronizer">().connect(buses[0], buses[1], buses[2], buses[3], buses[4]);
    controller.load();
    controller.start();
  }
  bool trots() {
    return controller.get<"robot.emergency_stop">().mode() == hw::motion_mode::run &&
           !controller.get<"robot.rate">().approaching();
  }
};

template <class Robot>
[[gnu::noinline]] void one_beat(Robot& r) {
  r.controller.step();
}

}  // namespace bench

int main(int count, char** arguments) {
  const std::string_view what = count > 1 ? arguments[1] : "";
  if (count != 2) bench::refuse(what, "one word: a number of beats, or `allocations`");
  const int beats = what == "allocations" ? 1000 : bench::beats_in(what);
  const auto r = std::make_unique<bench::robot>();
  constexpr int begin = 2000;  // the drives are enabled and follow the gait
  for (int k = 0; k < begin; ++k) bench::one_beat(*r);
  if (what == "allocations") {
    const long before = bench_allocations();
    for (int k = 0; k < beats; ++k) bench::one_beat(*r);
    std::printf("%ld\n", bench_allocations() - before);
  } else {
    for (int k = 0; k < beats; ++k) bench::one_beat(*r);
  }
  if (r->trots()) return 0;
  const auto cause = r->controller.get<"robot.emergency_stop">().first_cause();
  std::fprintf(stderr, "drives: it does not trot: %s, joint %d, beat %lld\n",
               std::string(cca::hardware::name_of(cause.rule)).c_str(), cause.joint,
               static_cast<long long>(cause.beat));
  return 1;
}
