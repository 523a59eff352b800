// What each transport between processes must do. `Meeting` has `static auto transport(const std::string&)`,
// which opens the one of this name, and `static std::string other_name()`, a name that no other test has.
//
// Each part of a law runs in a process of its own, so this process never opens the transport.
#pragma once

#include <doctest/doctest.h>

#include <poll.h>
#include <unistd.h>

#include <chrono>
#include <fstream>
#include <sstream>
#include <string>
#include <thread>

#include <cca/base/compiler.hpp>

#include "../runtime/deployment/alarmed.hpp"
#include "../runtime/deployment/robot_and_mind.hpp"
#include "process.hpp"

namespace transport_laws {

using namespace deployment_test;
using namespace std::chrono_literals;

// The same, but its readers wait longer than any test lasts.
struct patient : cca::deployment<architecture,
                                 cca::environment<"robot", cca::nodes<"device", "filter", "guard">>,
                                 cca::environment<"mind", cca::other_nodes>,
                                 cca::tolerate<1000000>> {};

template <class Played>
std::string state_of(const Played& c) {
  std::ostringstream text;
  text << c.beat_index() << ' ' << cca::to_string(c.state()) << ' ' << c.fault().reason() << ' '
       << std::hexfloat;
  return text.str();
}
template <class Played>
std::string robot_of(const Played& c) {
  std::ostringstream text;
  text << state_of(c) << std::hexfloat << c.template get<"filter">().kept << ' '
       << c.template get<"device">().command << ' ' << c.template get<"device">().faults << '\n';
  return text.str();
}
template <class Played>
std::string mind_of(const Played& c) {
  std::ostringstream text;
  text << state_of(c) << std::hexfloat << c.template get<"thinker">().sum << '\n';
  return text.str();
}

// Runs of several lengths, and one that ends with a fault, which comes after about 280 beats.
template <class Played, class F>
std::string story(Played& c, F tell, double most = 8) {
  std::string all;
  c.load();
  try {
    c.template set<"guard">({most});
  } catch (const cca::refused&) {}  // another process has it
  c.start();
  for (const int beats : {1, 7, 100, 33, 1000}) {
    c.run(cca::for_some_beats{beats});
    all += tell(c);
  }
  return all;
}

constexpr auto tell_robot = [](const auto& c) { return robot_of(c); };
constexpr auto tell_mind = [](const auto& c) { return mind_of(c); };

template <class Meeting, class D = two>
cca::deployed<D> opened(const char* environment, const std::string& name) {
  static_assert(cca::Transport<decltype(Meeting::transport(name)), D>);
  return cca::deployed<D>(cca::only{environment}, Meeting::transport(name));
}

// Where a component runs does not change what it computes.
template <class Meeting>
void has_the_bits_of_one_loop() {
  const std::string name = Meeting::other_name();
  process mind([&] {
    auto d = opened<Meeting>("mind", name);
    return story(d, tell_mind);
  });
  process robot([&] {
    auto d = opened<Meeting>("robot", name);
    return story(d, tell_robot);
  });
  cca::controller<architecture> one, other;
  const std::string of_robot = story(one, tell_robot);
  CHECK(of_robot.find("faulted too much") != std::string::npos);
  CHECK_EQ(robot.said(), of_robot);
  CHECK_EQ(mind.said(), story(other, tell_mind));
}

// Also in a wall-clock run, as long as nothing is late. On a busy machine it tries again, and slower.
template <class Meeting>
void has_the_same_bits_at_wall_clock_speed() {
  cca::controller<architecture> c;
  c.load();
  c.start();
  c.run(cca::for_beats<80>{});
  for (const double speed : {0.1, 0.05, 0.02}) {
    const std::string name = Meeting::other_name();
    const auto run = [&](const char* environment, auto tell) {
      auto d = opened<Meeting, patient>(environment, name);
      d.load();
      d.start();
      d.run(cca::for_beats<80>{}, cca::at_speed(speed));
      return d.late() > 0 || d.figures()[1].lost_periods > 0 ? std::string("late") : tell(d);
    };
    process mind([&] { return run("mind", tell_mind); });
    process robot([&] { return run("robot", tell_robot); });
    const std::string of_robot = robot.said(), of_mind = mind.said();
    if (of_robot == "late" || of_mind == "late") continue;
    CHECK_EQ(of_robot, robot_of(c));
    CHECK_EQ(of_mind, mind_of(c));
    return;
  }
  MESSAGE("something was late each time: nothing to compare");
}

// Processes that have come so far, and who waits for them.
class milestone {
public:
  milestone() { REQUIRE_EQ(::pipe(ends), 0); }
  milestone(const milestone&) = delete;
  milestone& operator=(const milestone&) = delete;
  ~milestone() {
    ::close(ends[0]);
    ::close(ends[1]);
  }
  void reached() const { REQUIRE_EQ(::write(ends[1], "", 1), 1); }
  bool is_reached() const {
    pollfd one{ends[0], POLLIN, 0};
    return ::poll(&one, 1, 0) == 1;
  }
  void wait_for(int processes) const {
    for (int i = 0; i < processes; ++i) {
      pollfd one{ends[0], POLLIN, 0};
      char byte = 0;
      REQUIRE_MESSAGE(::poll(&one, 1, 60'000) == 1, "a process did not get so far in a minute");
      REQUIRE_EQ(::read(ends[0], &byte, 1), 1);
    }
  }

private:
  int ends[2]{};
};

// What the one says that is left when SIGKILL ends the other, once both run. `pace`: nothing, or
// `cca::at_speed(...)`.
template <class Meeting, class... Pace>
std::string said_by_the_one_left(bool kills_mind, Pace... pace) {
  const std::string name = Meeting::other_name();
  const milestone both_run;
  const auto run = [&](const char* environment, auto tell) {
    auto d = opened<Meeting>(environment, name);
    d.load();
    d.start();
    d.run(cca::for_beats<5>{}, pace...);
    both_run.reached();
    if (d.state() == cca::state::started) d.run(cca::without_end{}, pace...);
    return tell(d);
  };
  process mind([&] { return run("mind", tell_mind); });
  process robot([&] { return run("robot", tell_robot); });
  both_run.wait_for(2);
  std::this_thread::sleep_for(200ms);
  (kills_mind ? mind : robot).kill();
  return (kills_mind ? robot : mind).said();
}

// SIGKILL of one is lost contact for the other, at any pace, whichever it is. On a busy machine the one left
// may have been late itself before, and lost by the other: then it tries again, and slower.
template <class Meeting>
void loses_contact_with_the_killed() {
  for (const bool kills_mind : {true, false}) {
    const std::string lost = "faulted lost contact with ";
    const std::string killed = kills_mind ? "`mind`" : "`robot`", left = kills_mind ? "`robot`" : "`mind`";
    const auto tells_of_it = [&](const std::string& said) {
      CAPTURE(said);
      CHECK(said.find(lost + killed) != std::string::npos);
      if (kills_mind) CHECK(said.ends_with(" 1\n"));  // on_fault
    };
    tells_of_it(said_by_the_one_left<Meeting>(kills_mind));
    std::string said;
    for (const double speed : {0.1, 0.05, 0.02}) {
      said = said_by_the_one_left<Meeting>(kills_mind, cca::at_speed(speed));
      if (said.find(lost + left) == std::string::npos) break;
    }
    tells_of_it(said);
  }
}

// In a wall-clock run a fault in a follower stops every resource node, in whichever process, within two
// beats.
template <class Meeting>
void stops_all_within_two_beats_of_a_fault() {
  const std::string name = Meeting::other_name();
  const auto run = [&](const char* environment, auto tell) {
    auto d = opened<Meeting, alarmed>(environment, name);
    d.load();
    d.start();
    d.run(cca::without_end{}, cca::at_speed(alarmed_speed));
    return std::string(d.fault().reason()) + ' ' + std::to_string(tell(d));
  };
  process mind([&] { return run("mind", [](auto& d) { return d.template get<"alarm">().raised_at; }); });
  process hand([&] { return run("hand", [](auto& d) { return d.template get<"hand">().stopped_at; }); });
  process arm([&] { return run("arm", [](auto& d) { return d.template get<"arm">().stopped_at; }); });
  const auto time_in = [](const std::string& said) {
    CAPTURE(said);
    REQUIRE(said.starts_with("alarm "));
    return std::stoll(said.substr(6));
  };
  const auto raised_at = time_in(mind.said());
  for (process* const each : {&arm, &hand}) {
    const auto stopped_at = time_in(each->said());
    CHECK_GE(stopped_at, raised_at);
    CHECK_LE(stopped_at, raised_at + 2 * alarmed_beat);
  }
}

// Who comes late is waited for. Who comes again goes on with the beat of the others.
template <class Meeting>
void waits_for_who_comes_late_or_again() {
  const std::string name = Meeting::other_name();
  process robot([&] {
    auto d = opened<Meeting>("robot", name);
    d.load();
    d.start();
    d.run(cca::for_beats<50>{});
    std::string all = state_of(d);
    d.run(cca::without_end{});
    all += cca::to_string(d.state());
    const auto beat = d.beat_index();
    d.resume();
    d.run(cca::for_beats<20>{});
    return all + (d.beat_index() == beat + 20 ? ", went on " : ", lost its beat ") +
           std::string(cca::to_string(d.state()));
  });
  std::this_thread::sleep_for(400ms);
  process first([&] {
    auto d = opened<Meeting>("mind", name);
    d.load();
    d.start();
    d.run(cca::without_end{});
    d.run(cca::without_end{});
    return std::string();
  });
  std::this_thread::sleep_for(900ms);
  first.kill();
  process second([&] {
    auto d = opened<Meeting>("mind", name);
    d.load();
    d.start();
    d.run(cca::without_end{});
    return d.beat_index() > 70 ? std::string("went on") : "began anew at " + std::to_string(d.beat_index());
  });
  CHECK_EQ(robot.said(), "50 started  faulted, went on started");
  CHECK_EQ(second.said(), "went on");
}

// stop() in one process is stop() in the other, which waits in run.
template <class Meeting>
void stops_with_the_others() {
  const std::string name = Meeting::other_name();
  process mind([&] {
    auto d = opened<Meeting>("mind", name);
    d.load();
    d.start();
    int runs = 0;
    while (d.state() == cca::state::started) {
      d.run(cca::for_some_beats{50});
      ++runs;
    }
    return std::to_string(runs) + std::string(cca::to_string(d.state()));
  });
  process robot([&] {
    auto d = opened<Meeting>("robot", name);
    d.load();
    d.start();
    d.run(cca::for_some_beats{50});
    d.run(cca::for_some_beats{50});
    d.stop();
    std::this_thread::sleep_for(1s);
    return std::string();
  });
  CHECK_EQ(mind.said(), "3loaded");
  CHECK_EQ(robot.said(), "");
}

// What this process has written into memory of its own. Not code: pages of it count as resident from their
// first use on, and when that is depends on what else the machine does.
inline long own_kilobytes() {
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);)
    if (line.starts_with("RssAnon:")) return std::stol(line.substr(8));
  return 0;
}

template <class Deployed>
std::string state_and_fault(const Deployed& d) {
  if (d.state() != cca::state::faulted) return std::string(cca::to_string(d.state()));
  return "faulted: " + d.fault_path() + ": " + std::string(d.fault().reason());
}

template <class Meeting>
std::string runs_on_as_mind(const std::string& name) {
  auto d = opened<Meeting, patient>("mind", name);
  d.load();
  d.start();
  d.run(cca::without_end{}, cca::at_wall_clock());
  return state_and_fault(d);
}

// A reader that stops costs the writer neither beats nor memory: while it stands still, the writer goes on
// through 1000 beats. In the first 300 its buffers become full. After that a message that is kept in each
// beat would be seen: of one topic that is at least 140 kB. A sanitizer keeps what was freed for a while.
inline constexpr std::int64_t beats_to_fill = 300, beats_alone = 1000;
inline constexpr long most_growth = CCA_SANITIZED ? 65536 : 64;

template <class Meeting>
void is_not_held_up_by_a_stopped_reader() {
  const std::string name = Meeting::other_name();
  const milestone both_run, stands, measured;
  process mind([&] { return runs_on_as_mind<Meeting>(name); });
  process robot([&] {
    auto d = opened<Meeting, patient>("robot", name);
    d.load();
    d.start();
    long before = 0, after = 0;
    std::int64_t since = -1, late = 0;
    d.run(cca::without_end{}, cca::at_wall_clock(), [&](auto& running) {
      const std::int64_t k = running.beat_index();
      if (k == 20) both_run.reached();
      if (since < 0 && stands.is_reached()) since = k;
      if (since < 0) return true;
      if (k == since + beats_to_fill) before = own_kilobytes(), late = running.late();
      if (k < since + beats_alone) return true;
      after = own_kilobytes();
      late = running.late() - late;
      measured.reached();
      return false;
    });
    std::ostringstream text;
    text << state_and_fault(d) << ' ' << (late > (beats_alone - beats_to_fill) / 2 ? "alone" : "never alone")
         << ' '
         << (after - before < most_growth ? "small" : "grew by " + std::to_string(after - before) + " kB");
    return text.str();
  });
  both_run.wait_for(1);
  mind.stop();
  stands.reached();
  measured.wait_for(1);
  mind.go_on();
  CHECK_EQ(robot.said(), "started alone small");
  CHECK_EQ(mind.said(), "started");
}

// Who stood still for longer than another may be silent (2 s over DDS) does not take the others for lost when
// it goes on: what they have said meanwhile is still to be read.
template <class Meeting>
void goes_on_after_a_standstill() {
  const std::string name = Meeting::other_name();
  const milestone both_run, is_over;
  process mind([&] { return runs_on_as_mind<Meeting>(name); });
  process robot([&] {
    auto d = opened<Meeting, patient>("robot", name);
    d.load();
    d.start();
    d.run(cca::without_end{}, cca::at_wall_clock(), [&](auto& running) {
      if (running.beat_index() == 20) both_run.reached();
      return !is_over.is_reached();
    });
    return state_and_fault(d);
  });
  both_run.wait_for(1);
  mind.stop();
  std::this_thread::sleep_for(3s);
  mind.go_on();
  std::this_thread::sleep_for(300ms);
  is_over.reached();
  CHECK_EQ(robot.said(), "started");
  CHECK_EQ(mind.said(), "started");
}

struct tolerant : cca::deployment<architecture,
                                  cca::environment<"robot", cca::nodes<"device", "filter", "guard">>,
                                  cca::environment<"mind", cca::other_nodes>,
                                  cca::tolerate<100>> {};

// While another process stands still, the robot's side idles once a period: after lost contact, and where the
// run is to end. 900 periods pass meanwhile; the machine may give it a few of them only.
template <class Meeting, class D>
std::string said_while_the_mind_stands(std::int64_t ends_after_late) {
  const std::string name = Meeting::other_name();
  const milestone runs;
  process mind([&] {
    auto d = opened<Meeting, D>("mind", name);
    d.load();
    d.start();
    d.run(cca::without_end{}, cca::at_wall_clock());
    return std::string(cca::to_string(d.state()));
  });
  process robot([&] {
    auto d = opened<Meeting, D>("robot", name);
    d.load();
    d.start();
    int before = -1;
    std::int64_t late = 0;
    d.run(cca::without_end{}, cca::at_wall_clock(), [&](auto& running) {
      if (running.beat_index() == 20) runs.reached();
      if (running.beat_index() <= 20) before = running.template get<"device">().idles, late = running.late();
      return running.late() < late + ends_after_late;
    });
    const auto& device = d.template get<"device">();
    std::ostringstream text;
    text << cca::to_string(d.state()) << ' ' << device.faults << ' ';
    if (const int idles = device.idles - before; idles < 30) text << idles;
    else text << "idled";
    return text.str();
  });
  runs.wait_for(1);
  mind.stop();
  std::this_thread::sleep_for(900ms);
  mind.go_on();
  mind.said();
  return robot.said();
}
template <class Meeting>
void idles_while_another_stands() {
  CHECK_EQ(said_while_the_mind_stands<Meeting, tolerant>(1'000'000), "faulted 1 idled");
  CHECK_EQ(said_while_the_mind_stands<Meeting, patient>(50), "started 0 idled");
}

// A second process, a process of another deployment.
template <class Meeting>
void refuses_whom_it_must() {
  const std::string name = Meeting::other_name();
  process all([&] {
    auto d = opened<Meeting>("robot", name);
    const auto refusal = [](auto f) {
      try {
        f();
      } catch (const cca::refused& e) { return std::string(e.what()) + '\n'; }
      return std::string("nothing\n");
    };
    return refusal([&] { opened<Meeting>("robot", name); }) +
           refusal([&] { opened<Meeting, patient>("mind", name); });
  });
  const std::string said = all.said();
  CAPTURE(said);
  CHECK(said.find("another process runs environment `robot` already") != std::string::npos);
  CHECK(said.find("runs another deployment; here `deployment") != std::string::npos);
  CHECK(said.find("1000000 late beats tolerated") != std::string::npos);
  CHECK(said.find("nothing") == std::string::npos);
}

}  // namespace transport_laws
