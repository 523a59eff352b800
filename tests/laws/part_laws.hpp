// What each transport between processes must do with parts that are stopped and started from outside: a part
// may have components in another process, or be there as a whole. `Meeting`: as in transport_laws.hpp.
#pragma once

#include <doctest/doctest.h>

#include <sstream>
#include <string>

#include "../runtime/deployment/asking.hpp"
#include "../runtime/deployment/parts_rig.hpp"
#include "process.hpp"

namespace part_laws {

using namespace parts_test;
using deployment_test::which;

// `mind.reach` is spread over both; `mind` is, too. Of `whole` both parts are in one environment.
struct spread : cca::deployment<skilled<-1>,
                                cca::environment<"robot", cca::nodes<"source", "orders", "mind.reach.aim">>,
                                cca::environment<"mind", cca::other_nodes>> {};
using whole = in_two<>;

template <class Played, class F>
void for_each_noting(Played& c, F f) {
  const auto of = [&](auto get) {
    try {
      f(get());
    } catch (const cca::refused&) {}  // another process has it
  };
  of([&]() -> auto& { return c.template get<"mind.first">(); });
  of([&]() -> auto& { return c.template get<"mind.reach.aim">(); });
  of([&]() -> auto& { return c.template get<"mind.reach.move">(); });
  of([&]() -> auto& { return c.template get<"last">(); });
}
template <class Played>
std::string told(Played& c) {
  std::ostringstream text;
  text << std::hexfloat << c.beat_index() << '\n';
  for_each_noting(c, [&](const auto& one) {
    text << one.all.size() << ' ' << one.starts << ' ' << one.stops;
    for (const auto& s : one.all)
      text << ' ' << s.beat << ' ' << s.x << ' ' << s.dt << ' ' << s.origin << ' ' << s.fresh;
    text << '\n';
  });
  return text.str();
}
// Of one loop what the process of an environment tells.
template <class D>
std::string told_of(cca::controller<skilled<-1>>& c, const std::string& environment) {
  std::ostringstream text;
  std::istringstream lines(told(c));
  std::string line;
  std::getline(lines, line);
  text << line << '\n';
  for (const std::string_view path : {"mind.first", "mind.reach.aim", "mind.reach.move", "last"}) {
    std::getline(lines, line);
    const int node = cca::detail::node_at<D>(path);
    const int of = cca::detail::plan_of<D>.nodes[static_cast<std::size_t>(node)].place;
    if (cca::detail::name_of_environment<D>(static_cast<std::size_t>(of)) == environment)
      text << line << '\n';
  }
  return text.str();
}

// Long texts.
inline void check_same(const std::string& here, const std::string& there) {
  std::size_t at = 0;
  while (at < here.size() && at < there.size() && here[at] == there[at]) ++at;
  CHECK_EQ(here.substr(at, 60), there.substr(at, 60));
}

inline constexpr const char* parts[] = {"mind", "mind.reach"};
inline void ask(auto& of, int what) {
  if (what >= 0) what < 2 ? of.stop(parts[what]) : of.start(parts[what - 2]);
}

// In the thread of environment `Own`, before it takes what is asked for.
template <class D, int Own>
struct asking_in {
  cca::live_access<cca::deployed<D>>& live;
  int* asked;

  template <int Environment>
  void after_beat(cca::deployed<D>& d) {
    const int what = which(d.beat_index() + Own, 4);
    if (Environment == Own && what >= 0) {
      CHECK(live.is_taken());
      ask(live, what);
      ++*asked;
    }
    live.template after_beat<Environment>(d);
  }
  bool goes_on(cca::deployed<D>& d) { return live.goes_on(d); }
  bool is_over() const { return false; }
};

template <class Meeting, class D>
cca::deployed<D> opened(const char* environment, const std::string& name) {
  cca::deployed<D> d(cca::only{environment}, Meeting::transport(name));
  d.load();
  d.start();
  return d;
}

// Both processes ask for parts that they run, and for parts that the other one runs. The bits are those of
// one loop that was told in these beats.
template <class Meeting, class D>
void stops_in_the_same_beat() {
  const std::string name = Meeting::other_name();
  const auto story = [&]<int Own>(const char* environment) {
    auto d = opened<Meeting, D>(environment, name);
    cca::live_access live(d);
    int asked = 0;
    asking_in<D, Own> outside{live, &asked};
    d.run(cca::for_beats<400>{}, cca::as_fast_as_possible(), outside);
    if (asked < 20 || live.refused_by() != "") return "asked " + std::to_string(asked) + live.refused_by();
    return told(d);
  };
  process mind([&] { return story.template operator()<1>("mind"); });
  process robot([&] { return story.template operator()<0>("robot"); });
  auto loop = running<cca::controller<skilled<-1>>>();
  loop.run(cca::for_beats<400>{}, cca::as_fast_as_possible(), [&](auto& now) {
    ask(now, which(now.beat_index(), 4));
    ask(now, which(now.beat_index() + 1, 4));
    return true;
  });
  check_same(robot.said(), told_of<D>(loop, "robot"));
  check_same(mind.said(), told_of<D>(loop, "mind"));
}

// `between` asks as well; and between two runs a process may stop what another one runs: it has effect when
// the next run begins.
template <class Meeting, class D>
void stops_what_another_process_runs() {
  const std::string name = Meeting::other_name();
  const auto between = [](auto& now) {
    if (now.beat_index() == 8) now.template stop<"mind">();
    if (now.beat_index() == 20) now.start("mind");
    return true;
  };
  process mind([&] {
    auto d = opened<Meeting, D>("mind", name);
    for (int i = 0; i < 3; ++i) d.run(cca::for_beats<40>{});
    return told(d);
  });
  process robot([&] {
    auto d = opened<Meeting, D>("robot", name);
    d.template stop<"mind.reach">();
    cca::live_access live(d);
    d.run(cca::for_beats<40>{}, cca::as_fast_as_possible(), between);
    CHECK(live.stop("mind"));
    live.run_ended(d);
    live.template after_beat<0>(d);
    CHECK_EQ(live.refused_by(), "");
    CHECK(live.is_taken());
    d.run(cca::for_beats<40>{});
    d.stop("mind.reach");
    d.start("mind.reach");
    d.run(cca::for_beats<40>{});
    return told(d);
  });
  auto loop = running<cca::controller<skilled<-1>>>();
  loop.template stop<"mind.reach">();
  loop.run(cca::for_beats<40>{}, cca::as_fast_as_possible(), between);
  loop.stop("mind");
  loop.run(cca::for_beats<40>{});
  loop.stop("mind.reach");
  loop.start("mind.reach");
  loop.run(cca::for_beats<40>{});
  check_same(robot.said(), told_of<D>(loop, "robot"));
  check_same(mind.said(), told_of<D>(loop, "mind"));
}

// In a wall-clock run an order comes into all environments in the same beat, as long as nothing is late.
template <class Meeting, class D>
void stops_in_the_same_beat_of_a_wall_clock_run() {
  constexpr std::int64_t beats = 80;
  auto loop = running<cca::controller<skilled<-1>>>();
  loop.run(cca::for_some_beats{1 + cca::detail::beat_of_order<D>(0, false)});
  loop.stop("mind.reach");
  loop.run(cca::for_some_beats{beats - loop.beat_index()});
  for (const double speed : {0.1, 0.05, 0.02}) {
    const std::string name = Meeting::other_name();
    const auto run = [&](const char* environment, bool asks) {
      auto d = opened<Meeting, D>(environment, name);
      cca::live_access live(d);
      if (asks) CHECK(live.stop("mind.reach"));  // taken after the first beat
      d.run(cca::for_beats<beats>{}, cca::at_speed(speed), live);
      return d.late() > 0 || d.figures()[1].lost_periods > 0 || d.fault() ? std::string("late") : told(d);
    };
    process mind([&] { return run("mind", false); });
    process robot([&] { return run("robot", true); });
    const std::string of_robot = robot.said(), of_mind = mind.said();
    if (of_robot == "late" || of_mind == "late") continue;
    check_same(of_robot, told_of<D>(loop, "robot"));
    check_same(of_mind, told_of<D>(loop, "mind"));
    return;
  }
  MESSAGE("something was late each time: nothing to compare");
}

}  // namespace part_laws
