// Do the drives get their frames while a run ends? A pendulum on a virtual drive that lives in a wall-clock
// run; many orderly ends, by a function between two beats as ctrl-C is; the longest time between two
// batches of frames from the call of run() until it has returned, in periods. Beside it a bare
// clock_nanosleep loop of the same period says what the machine adds.
//
//   bench_ending [ENDS]      200
//
//   thinker   in another environment, 8 ms in each tenth beat: in a thread, over shared memory, over DDS
//   seldom    in another environment, once in 100 beats: it sleeps when the run ends
//   farm      in the robot's loop, a worker that takes 3 s: the controller stops
//   hang      the thinker hangs for 3 s: contact is lost, and the stop is confirmed while it still hangs
#include <pthread.h>
#include <sched.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <charconv>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <system_error>
#include <thread>
#include <vector>

#include <cca/deployment.hpp>
#ifdef BENCH_CCA_DDS
#include <cca/dds.hpp>
#endif
#include <cca/hardware/robot/robot.hpp>
#include <cca/hardware/robot/shut_down.hpp>
#include <cca/hardware/virtual_drives/virtual_of.hpp>
#include <cca/hardware/virtual_robot.hpp>
#include <cca/robot/limiter.hpp>
#include <cca/skeleton/farm_on_threads.hpp>

#include "../tests/runtime/robot_on_drives/pendulum.hpp"

namespace {

namespace hw = cca::hardware;
namespace robots = cca::robots;
using pendulum_test::end_of_wire, pendulum_test::swing_joint, pendulum_test::wire;
using clock_ns = cca::detail::monotonic_clock;

constexpr std::int64_t ms = 1'000'000;

// ---- the drive, in a wall-clock run ----

struct drive_side {
  wire bus{};
  end_of_wire far_end{bus.end(1)};
  hw::virtual_robot<end_of_wire, hw::virtual_of, hw::no_board, hw::joint_list<swing_joint>> far{};
  hw::virtual_motor motor{};
  std::int64_t began = clock_ns::now(), at = 0;

  drive_side() {
    motor.now.position = 0.3, motor.inertia = 0.02, motor.friction = 0.01, motor.most_torque = 5;
    far.connect(far_end);
  }
  void catch_up() {
    const std::int64_t now = clock_ns::now() - began;
    for (; at + ms <= now; bus.advance((at += ms) - 1)) {
      listen(at + ms / 2);
      motor.advance(far.laws(at + ms / 2)[0], 0, 1e-3);
      far.tell({motor.now}, {});
    }
    listen(now);  // no frame waits for the next whole millisecond: the robot would not send before it is on
                  // the bus
  }
  void listen(std::int64_t now) {
    bus.advance(now);
    far.listen(now, [](std::size_t, const hw::can_frame&) {});
  }
};

// The robot's end of the bus: the drive lives up to now whenever the robot looks, and the longest time
// between two batches is kept.
struct live_end {
  drive_side* drive;
  end_of_wire near;
  std::int64_t last = 0, longest = 0;

  explicit live_end(drive_side& d) : drive(&d), near(d.bus.end(0)) {}
  hw::send_result send(std::span<const hw::can_frame> frames) noexcept {
    look();
    last = clock_ns::now();
    return near.send(frames);
  }
  std::size_t receive(std::span<hw::received_frame> into) noexcept {
    drive->catch_up();
    return near.receive(into);
  }
  hw::bus_state state() const noexcept { return near.state(); }
  const hw::bus_counters& counters() const noexcept { return near.counters(); }
  std::uint64_t in_flight() const noexcept { return near.in_flight(); }

  void look() noexcept { longest = std::max(longest, clock_ns::now() - last); }
  void begin() noexcept { last = clock_ns::now(), longest = 0; }
};

struct pendulum {
  using body = pendulum_test::pendulum_body;
  using rate = cca::rate<1000>;
  using commands = robots::commands<robots::torque_command>;
  static constexpr std::array drives{robots::joint_drive{.motor = {3, 16}, .stiffness = 20, .damping = 0.6}};
};
using torque = robots::commanded<pendulum, robots::torque_command>;
struct on_drive : hw::robot<pendulum, live_end, swing_joint> {};

// Of the robot's side, if the system allows it: what is measured then is the library, not who else computes.
// The mind has no priority.
void in_real_time() {
  const sched_param high{.sched_priority = 80};
  ::pthread_setschedparam(::pthread_self(), SCHED_FIFO, &high);
}
void in_normal_time() {
  const sched_param none{};
  ::pthread_setschedparam(::pthread_self(), SCHED_OTHER, &none);
}

// ---- what ends late ----

void compute(std::int64_t ns) {
  for (const std::int64_t end = clock_ns::now() + ns; clock_ns::now() < end;) {}
}

struct thought : cca::space<cca::number, cca::axes<cca::x>> {};

struct mind {
  std::int64_t needs = 8 * ms, hangs_in = -1;
  auto process(cca::beat now) -> cca::out<"thought", thought> {
    in_normal_time();  // its thread inherits what this program has
    if (now.index() == hangs_in) clock_ns::sleep_until(clock_ns::now() + 3000 * ms);
    compute(needs);
    return 0.0;
  }
};

struct reflex {
  auto process(cca::in<"thought", thought> x, cca::beat now) -> cca::out<"torque", torque> {
    return cca::out<"torque", torque>(x[cca::x{}]).with_origin(now.time());  // it answers for its age
  }
};

template <int Every>
struct thinking : cca::graph<cca::rate<1000>,
                             cca::node<"mind", mind, cca::timed<Every>>,
                             cca::node<"reflex", reflex, cca::timed<1>>,
                             cca::node<"limits", cca::limiter<torque>>,
                             cca::node<"robot", on_drive>,
                             cca::wire<"mind.thought", "reflex.thought", cca::delayed<Every>>,
                             cca::wire<"reflex.torque", "limits.command">,
                             cca::wire<"limits.safe", "robot.torque">> {};
template <int Every>
struct apart : cca::deployment<thinking<Every>,
                               cca::environment<"robot", cca::nodes<"robot", "limits", "reflex">>,
                               cca::environment<"mind", cca::other_nodes>,
                               cca::tolerate<60>> {};

using task = cca::array_of<thought, 1>;
struct source {
  auto process() -> std::tuple<cca::out<"torque", torque>, cca::out<"task", task>> {
    return {0.0, task::vector_type::Zero()};
  }
};
struct slow_worker {
  auto process(cca::in<"x", thought>) -> cca::out<"y", thought> {
    in_normal_time();
    clock_ns::sleep_until(clock_ns::now() + 3000 * ms);
    return 0.0;
  }
};
struct with_farm : cca::graph<cca::rate<1000>,
                              cca::node<"source", source>,
                              cca::node<"farm", cca::farm_on_threads<slow_worker, task, task>>,
                              cca::node<"limits", cca::limiter<torque>>,
                              cca::node<"robot", on_drive>,
                              cca::wire<"source.task", "farm.input">,
                              cca::wire<"source.torque", "limits.command">,
                              cca::wire<"limits.safe", "robot.torque">> {};

// ---- the machine ----

// The same period, without anything to do.
class bare_loop {
public:
  bare_loop()
      : runs([this] {
          std::int64_t last = clock_ns::now();
          for (std::int64_t next = last + ms; !is_over; next = std::max(next + ms, last)) {
            clock_ns::sleep_until(next);
            const std::int64_t now = clock_ns::now();
            if (now - last > longest) longest = now - last;
            last = now;
          }
        }) {}
  ~bare_loop() { is_over = true, runs.join(); }
  bare_loop(const bare_loop&) = delete;
  bare_loop& operator=(const bare_loop&) = delete;
  std::int64_t take() { return longest.exchange(0); }

private:
  std::atomic<std::int64_t> longest{0};
  std::atomic<bool> is_over{false};
  std::thread runs;
};

struct gaps {
  std::vector<double> robot{}, bare{};
  void add(const live_end& end, bare_loop& machine) {
    robot.push_back(1e-6 * static_cast<double>(end.longest));
    bare.push_back(1e-6 * static_cast<double>(machine.take()));
  }
  void print(const char* what) {
    std::ranges::sort(robot), std::ranges::sort(bare);
    const auto beyond = [](const std::vector<double>& all) {
      return std::ranges::count_if(all, [](double g) { return g > 2; });
    };
    const auto tell = [&](const std::vector<double>& all) {
      std::printf("  %6.2f %6.2f %6.2f  %3td", all[all.size() / 2], all[all.size() * 99 / 100], all.back(),
                  beyond(all));
    };
    std::printf("%-22s %4zu", what, robot.size());
    tell(robot), tell(bare);
    std::printf("\n");
    std::fflush(stdout);
  }
};

template <class C>
void connect(C& c, live_end& end) {
  c.template get<"robot.synchronizer">().connect(end);
}
template <class C>
bool is_running(C& c) {
  return c.template get<"robot.synchronizer">().phase() == hw::motion_phase::running;
}

// Runs of some 40 beats, each ended by `between`. The robot moves all the time.
template <class D>
void orderly_ends(const char* what, D& d, int ends) {
  drive_side drive;
  live_end end(drive);
  connect(d, end);
  d.load();
  bare_loop machine;
  gaps all;
  int trips = -1;
  for (int i = 0; i < ends; ++i) {
    if (d.state() != cca::state::started || !is_running(d)) {
      ++trips;
      hw::shut_down(d);
      d.start();
      d.run(cca::for_<4>{}, cca::at_wall_clock(), [&](auto& c) { return !is_running(c); });
    }
    int left = 35 + i % 23;
    machine.take();
    end.begin();
    d.run(cca::without_end{}, cca::at_wall_clock(), [&](auto&) { return --left > 0; });
    end.look();
    // A trip stops the robot 1000 beats later: the gap that was its cause has been counted.
    if (is_running(d)) all.add(end, machine);
  }
  all.print(what);
  if (trips > 0) std::printf("  tripped %d times: the loop or the drive stood still\n", trips);
  std::printf("  %s\n", hw::shut_down(d).text().c_str());
}

template <int Every, class Open>
void in_processes(const char* what, int ends, Open open) {
  std::fflush(stdout);
  const pid_t child = ::fork();
  if (child == 0) {
    in_normal_time();
    cca::deployed<apart<Every>> d(cca::only{"mind"}, open());
    d.load();
    d.start();
    for (;;) {  // until it is killed
      if (d.state() == cca::state::loaded) d.start();
      if (d.state() == cca::state::faulted) d.resume();
      d.run(cca::without_end{}, cca::at_wall_clock());
    }
  }
  {
    in_normal_time();  // threads of a transport inherit it
    cca::deployed<apart<Every>> d(cca::only{"robot"}, open());
    in_real_time();
    orderly_ends(what, d, ends);
  }
  ::kill(child, SIGKILL);
  ::waitpid(child, nullptr, 0);
}

#ifdef BENCH_CCA_DDS
template <class F>
void alone(F f) {
  std::fflush(stdout);
  const pid_t child = ::fork();
  if (child == 0) f(), std::fflush(stdout), ::_exit(0);
  ::waitpid(child, nullptr, 0);
}
#endif

void farm_ends(int ends) {
  cca::controller<with_farm> c;
  drive_side drive;
  live_end end(drive);
  connect(c, end);
  c.load();
  bare_loop machine;
  gaps all;
  for (int i = 0; i < ends; ++i) {
    c.start();
    int left = 20;
    c.run(cca::for_<4>{}, cca::at_wall_clock(), [&](auto& same) { return !is_running(same) || --left > 0; });
    machine.take();
    end.begin();
    c.stop();
    for (cca::at_speed pace = cca::at_wall_clock(); left < 10; ++left) {
      if (left == 0) pace.begin();
      pace.wait(left * ms);
      c.step();
    }
    end.look();
    all.add(end, machine);
  }
  all.print("farm of 3 s");
  std::printf("  %s\n", hw::shut_down(c).text().c_str());
}

void hang() {
  cca::deployed<apart<10>> d;
  drive_side drive;
  live_end end(drive);
  connect(d, end);
  d.load();
  d.start();
  d.run(cca::for_<2>{}, cca::at_wall_clock(), [&](auto& c) { return !is_running(c); });
  d.get<"mind">().hangs_in = (d.beat_index() / 10 + 10) * 10;
  bare_loop machine;
  gaps all;
  end.begin();
  d.run(cca::for_<20>{}, cca::at_wall_clock());
  all.add(end, machine);
  all.print("hangs for 3 s");
  const auto& s = d.get<"robot.synchronizer">();
  std::printf("  %s: %s\n  when run() returned, the drive was %s\n", d.fault().reason(),
              d.fault_cause().c_str(),
              s.stopping()       ? "still stopping"
              : s.unconfirmed(0) ? "not confirmed to be off"
                                 : "confirmed to be off");
}

constexpr const char* usage =
    "bench_ending [ENDS]   measures how long the drives get no frame while a run ends\n\n"
    "  ENDS   how many orderly ends of each kind, from 1 to 100000; 200\n";

// 0: no number of ends.
int number_of_ends(std::string_view word) {
  int ends = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), ends);
  const bool is_number = error == std::errc() && end == word.data() + word.size();
  return is_number && ends >= 1 && ends <= 100'000 ? ends : 0;
}

}  // namespace

int main(int count, char** words) {
  const std::string_view word = count > 1 ? words[1] : "200";
  if (count == 2 && (word == "--help" || word == "-h")) return std::fputs(usage, stdout), 0;
  const int ends = count <= 2 ? number_of_ends(word) : 0;
  if (ends == 0) {
    std::fprintf(stderr, "bench_ending: `%s` is no number of ends\n\n%s", words[count - 1], usage);
    return 2;
  }
  in_real_time();
  std::printf("%-22s %4s  %27s  %27s\n%-22s %4s", "", "", "robot: longest gap [periods]", "bare loop", "",
              "ends");
  for (int i = 0; i < 2; ++i) std::printf("  %6s %6s %6s  %3s", "median", "p99", "most", ">2");
  std::printf("\n");
  {
    cca::deployed<apart<10>> d;
    orderly_ends("thinker, thread", d, ends);
  }
  {
    cca::deployed<apart<100>> d;
    d.get<"mind">().needs = 0;
    orderly_ends("seldom, thread", d, ends);
  }
  const std::string name = "/bench_ending_" + std::to_string(::getpid());
  in_processes<10>("thinker, shared memory", ends, [&] { return cca::shared_memory(name); });
  in_processes<100>("seldom, shared memory", ends, [&] { return cca::shared_memory(name + "_seldom"); });
#ifdef BENCH_CCA_DDS
  // A process that has used DDS can't be forked any more.
  alone([&] { in_processes<10>("thinker, DDS", ends, [&] { return cca::dds::domain(77); }); });
  alone([&] { in_processes<100>("seldom, DDS", ends, [&] { return cca::dds::domain(78); }); });
#endif
  farm_ends(ends);
  hang();
}
