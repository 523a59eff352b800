// The trot on drives whose gait is on another machine: what the drives do while the cable is cut.
//
//   cca_drives_over_cable buses OWN OTHER
//   cca_drives_over_cable gait OWN OTHER
//
// The side of the buses trots, then keeps a clock until it loses contact. From then on its drives may hold no
// position any more. It shuts down in order; at a line of the standard input it is put on its feet again, and
// trots on.
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <iostream>
#include <string>
#include <string_view>
#include <thread>

#include <cca/dds.hpp>

#include "../laws/trot_in_two.hpp"

namespace {

using laws::trot_in_two;

constexpr std::int64_t before = 1500, after = 1000;  // beats of trot

double seconds() { return 1e-9 * static_cast<double>(cca::detail::monotonic_clock::now()); }

// It notes when the newest beat began.
class noting_clock : public laws::clock_of_drives {
public:
  noting_clock(hil::memory_buses& drives, double& newest) : clock_of_drives(drives), begun(newest) {}
  void wait(std::int64_t since) {
    clock_of_drives::wait(since);
    begun = seconds();
  }

private:
  double& begun;
};

int run_buses(const cca::dds::domain& net) {
  trot_in_two robot(cca::only{"buses"}, net);
  hil::memory_buses far;
  far.connect(robot);
  robot.load();
  robot.start();
  robot.run(cca::for_some_beats{before}, far.pace());
  const bool trots = laws::trots(far);
  std::printf("at %.3f s: both run, %s\n", seconds(),
              trots ? "the robot trots" : "but the robot does not trot");
  std::fflush(stdout);
  far.pass_millisecond();
  double begun = 0;
  robot.run(cca::without_end{}, noting_clock(far, begun));

  const std::string reason = robot.fault().reason();
  const std::int64_t late = robot.late();
  const int driven = laws::driven_after(robot, far);
  const auto off = far.shut_down(robot);
  std::printf("stopped at %.3f s: %s, after %lld late beats; then driven for %d ms; %s\n", begun,
              reason.c_str(), static_cast<long long>(late), driven,
              off.complete() ? "all drives are off" : off.text().c_str());
  std::fflush(stdout);
  std::string line;
  if (!std::getline(std::cin, line)) return 1;
  far.put_down(hil::put_down(), cca::sim::disturbance::none());
  robot.start();
  std::this_thread::sleep_for(
      std::chrono::milliseconds(500));  // until the other side has seen that, and has started
  robot.run(cca::for_some_beats{after}, far.pace());
  const bool goes_on = !robot.fault() && laws::is_driven(far) && far.world().trunk_position()[0] > 0.1;
  std::printf("%s: beat %lld, at %.2f m%s%s\n", goes_on ? "it trots again" : "it does not trot again",
              static_cast<long long>(robot.beat_index()), far.world().trunk_position()[0],
              robot.fault() ? ", " : "", robot.fault().reason());
  far.shut_down(robot);
  return trots && late > laws::tolerated_late_beats && driven <= 2 && off.complete() && goes_on ? 0 : 1;
}

// It follows: what the other side stops is stopped here, and it starts again until the other side has
// started.
int run_gait(const cca::dds::domain& net) {
  trot_in_two gait(cca::only{"gait"}, net);
  gait.load();
  for (int sessions = 0; sessions < 2;) {
    const std::int64_t first = gait.beat_index();
    gait.start();
    while (gait.state() != cca::state::loaded) {
      if (gait.state() == cca::state::faulted) gait.resume();
      gait.run(cca::without_end{});
    }
    if (gait.beat_index() != first) ++sessions;
    else std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
  return 0;
}

}  // namespace

int main(int count, char** words) {
  if (count != 4) return 2;
  try {
    const cca::dds::domain net(7, "cca_drives_over_cable", cca::dds::network::between(words[2], {words[3]}));
    return std::string_view(words[1]) == "buses" ? run_buses(net) : run_gait(net);
  } catch (const cca::refused& why) { return std::fprintf(stderr, "%s\n", why.what()), 1; }
}
