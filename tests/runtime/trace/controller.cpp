// The trace of one loop: each firing once, by its path, in its beat, in the order of the schedule; marks; and
// the same results as without a trace.
#include <fcntl.h>

#include <sstream>
#include <system_error>

#include <cca/record.hpp>

#include "traced_file.hpp"

using namespace trace_test;

namespace laws {
std::size_t allocations();
}

namespace {

struct traced : loop, cca::traceable {};
struct traced_and_recorded : loop, cca::traceable, cca::recordable {};
struct recorded : loop, cca::recordable {};

template <class Controller>
std::map<std::string, std::int64_t> counted_in(const Controller& c) {
  return {{"plant (sense)", c.template get<"plant">().senses},
          {"plant (act)", c.template get<"plant">().acts},
          {"mean", c.template get<"mean">().fired},
          {"seldom", c.template get<"seldom">().fired},
          {"log", c.template get<"log">().fired},
          {"pair.first", c.template get<"pair.first">().fired},
          {"pair.second", c.template get<"pair.second">().fired}};
}

template <class Controller>
void begin(Controller& c) {
  c.load();
  c.start();
}

// A clock on which a beat takes as long as a test says.
struct slow_clock {
  std::int64_t* time;
  std::int64_t now() const { return *time; }
  void sleep_until(std::int64_t t) const { *time = std::max(*time, t); }
};

}  // namespace

TEST_CASE_TEMPLATE("each firing is there once, by its path, in its beat",
                   Graph,
                   traced,
                   traced_and_recorded) {
  const temporary_file file;
  cca::controller<Graph> c;
  cca::tracer trace(c, file.path, {.waits = true});
  begin(c);
  c.run(cca::for_beats<500>{});
  c.step();
  trace.close();
  CHECK(trace.problem() == "");
  CHECK(trace.lost_beats() == 0);

  const auto all = events_of(file.path);
  const auto beats = beats_of(all, 1);
  REQUIRE(beats.size() == 501);
  for (std::size_t k = 0; k < beats.size(); ++k) {
    CHECK(beats[k].number == static_cast<std::int64_t>(k));
    std::vector<std::string> wanted{"plant (sense)"};
    if (k % 10 == 0) wanted.push_back("mean");
    wanted.push_back("seldom");
    if (k % 7 == 0) wanted.push_back("log");
    for (const char* one : {"pair.first", "pair.second", "plant (act)"}) wanted.push_back(one);
    CHECK(beats[k].fired == wanted);
  }
  CHECK(firings_in(beats) == counted_in(c));
}

TEST_CASE("a summary counts what the controller counts") {
  const temporary_file file;
  cca::controller<traced> c;
  cca::tracer trace(c, file.path, {.name = "walk", .waits = true});
  begin(c);
  c.run(cca::for_beats<300>{});
  trace.close();
  const cca::trace_summary summary = trace.summary();
  REQUIRE(summary.environments.size() == 1);
  const auto& one = summary.environments[0];
  CHECK(one.name == "walk");
  CHECK(one.beats.all.count() == 300);
  std::map<std::string, std::int64_t> fired;
  double shares = 0;
  for (const auto& row : one.components) {
    fired[row.phase == "process" ? row.path : row.path + " (" + std::string(row.phase) + ")"] =
        row.firings.all.count();
    shares += one.share(row);
  }
  auto wanted = counted_in(c);
  CHECK(fired == wanted);
  CHECK(shares > 0.3);
  CHECK(shares <= 1);
  std::ostringstream text;
  text << summary;
  CHECK(text.str().find("walk") != std::string::npos);
  CHECK(text.str().find("  pair.second") != std::string::npos);
  CHECK(text.str().find("  plant (act)") != std::string::npos);
}

TEST_CASE_TEMPLATE("a traced controller computes the same numbers", Graph, traced, traced_and_recorded) {
  const temporary_file file;
  cca::controller<Graph> c;
  cca::controller<loop> plain;
  begin(c);
  begin(plain);
  c.run(cca::for_beats<50>{});  // not yet
  {
    cca::tracer trace(c, file.path, {.waits = true});
    c.run(cca::for_beats<150>{});
  }
  c.run(cca::for_beats<100>{});  // no more
  plain.run(cca::for_beats<300>{});
  CHECK(c.template get<"plant">().at == plain.get<"plant">().at);
  CHECK(c.template get<"mean">().sum == plain.get<"mean">().sum);
  CHECK(counted_in(c) == counted_in(plain));
  const auto beats = beats_of(events_of(file.path), 1);
  REQUIRE(beats.size() == 150);
  CHECK(beats.front().number == 50);
}

TEST_CASE("recorded and traced, each begins and ends on its own") {
  const temporary_file file, recording_file, other_file;
  {
    cca::controller<traced_and_recorded> c;
    cca::recording::recorder recording(c, recording_file.path, {.waits = true});
    begin(c);
    c.run(cca::for_beats<100>{});
    {
      cca::tracer trace(c, file.path, {.waits = true});
      c.run(cca::for_beats<100>{});
      recording.close();
      c.run(cca::for_beats<100>{});
    }
    c.run(cca::for_beats<100>{});
    CHECK(c.traced_into() == nullptr);
  }
  const auto result = cca::recording::replay<traced_and_recorded>(recording_file.path);
  INFO(result);
  CHECK(result);
  CHECK(result.beats == 200);
  const auto beats = beats_of(events_of(file.path), 1);
  REQUIRE(beats.size() == 200);
  CHECK(beats.front().number == 100);
}

TEST_CASE("the life-cycle and a fault are marks") {
  const temporary_file file;
  cca::controller<traced> c;
  cca::tracer trace(c, file.path, {.waits = true});
  begin(c);
  c.get<"seldom">().fault_at = 20;
  CHECK(c.run(cca::for_beats<100>{}) == cca::state::faulted);
  c.resume();
  c.stop();
  trace.close();
  const auto all = events_of(file.path);
  std::vector<std::string> marks;
  for (const event& e : all)
    if (e.phase == 'i') marks.push_back(e.name);
  CHECK(marks == std::vector<std::string>{"created", "loaded", "started", "running", "fault", "faulted",
                                          "started", "loaded"});
  for (const event& e : all)
    if (e.name == "fault") {
      CHECK(e.arguments.at("component") == "seldom");
      CHECK(e.arguments.at("reason") == "a \"bad\" beat");
    }
  const auto beats = beats_of(all, 1);
  REQUIRE(beats.size() == 21);
  CHECK(beats.back().fired.back() == "seldom");  // the fault cuts the beat
}

TEST_CASE("an overrun is a mark after its beat") {
  const temporary_file file;
  std::int64_t time = 0;
  cca::controller<traced> c;
  cca::tracer trace(c, file.path, {.waits = true});
  begin(c);
  c.run(cca::for_beats<10>{}, cca::clocked_pace<slow_clock>(1, {&time}), [&](auto& running) {
    if (running.beat_index() == 4) time += 3'500'000;  // beat 3 took so long
    if (running.beat_index() == 8) time += 1'200'000;
  });
  CHECK(c.overruns() == 2);
  CHECK(c.lost_periods() == 4);
  trace.close();
  CHECK(trace.summary().environments[0].overruns == 2);
  const auto all = events_of(file.path);
  CHECK(count_of(all, "overrun") == 2);
  const auto beats = beats_of(all, 1);
  std::vector<std::int64_t> periods, behind;
  for (const event& e : all)
    if (e.name == "overrun") {
      periods.push_back(e.arguments.at("periods without a beat"));
      for (const beat& one : beats)
        if (one.end == e.begin) behind.push_back(one.number);
    }
  CHECK(periods == std::vector<std::int64_t>{3, 1});
  CHECK(behind == std::vector<std::int64_t>{3, 7});
}

TEST_CASE("beats that do not fit are counted and marked, and the others are whole") {
  const temporary_file file;
  cca::controller<traced> c;
  cca::tracer trace(c, file.path, {.buffered_events = 1});
  begin(c);
  for (int i = 0; i < 20; ++i) c.run(cca::for_beats<20'000>{});  // much faster than any file
  trace.close();
  CHECK(trace.problem() == "");
  const auto all = events_of(file.path);
  const auto beats = beats_of(all, 1);
  std::int64_t marked = 0;
  for (const event& e : all)
    if (e.name == "lost beats") marked += e.arguments.at("beats").get<std::int64_t>();
  CHECK(trace.lost_beats() > 0);
  CHECK(marked == trace.lost_beats());
  CHECK(static_cast<std::int64_t>(beats.size()) + marked == 400'000);
  REQUIRE(!beats.empty());
  for (const beat& one : beats) CHECK(one.fired.size() >= 5);
  CHECK(trace.summary().environments[0].lost_beats == marked);
}

TEST_CASE("a traced beat allocates nothing, nor does a mark") {
  cca::detail::trace_track track({.events = 64, .in_beat = 20});  // nobody reads: it is full soon
  cca::controller<traced> c;
  begin(c);
  c.for_each_trace([&](int, cca::detail::trace_pointer& from) { from.set(&track); });
  const auto before = laws::allocations();
  c.run(cca::for_beats<1000>{});
  CHECK(laws::allocations() == before);
  CHECK(track.lost_beats() > 900);
  CHECK(track.lost_beats() < 1000);
}

TEST_CASE("a copy is not traced, a controller is traced once, and may end first") {
  const temporary_file file, other;
  auto c = std::make_unique<cca::controller<traced>>();
  cca::tracer trace(*c, file.path, {.waits = true});
  CHECK_THROWS_WITH_AS(cca::tracer(*c, other.path), doctest::Contains("is being traced already"),
                       cca::refused);
  cca::controller<traced> copy = *c;
  CHECK(copy.traced_into() == nullptr);
  begin(*c);
  begin(copy);
  copy.run(cca::for_beats<7>{});
  c->run(cca::for_beats<5>{});
  *c = copy;  // goes on being traced
  c->run(cca::for_beats<3>{});
  c.reset();
  trace.close();
  const auto beats = beats_of(events_of(file.path), 1);
  REQUIRE(beats.size() == 8);
  CHECK(beats[5].number == 7);
}

TEST_CASE("where nothing can be written the loop goes on") {
  CHECK_THROWS_AS(
      [] {
        cca::controller<traced> c;
        cca::tracer trace(c, "/no/such/folder/trace.json");
      }(),
      std::system_error);
  cca::controller<traced> c;
  cca::tracer trace(c, "/dev/full", {.buffered_events = 1, .waits = true});
  begin(c);
  c.run(cca::for_beats<100'000>{});
  trace.close();
  CHECK(c.beat_index() == 100'000);
  CHECK(trace.problem().find("/dev/full can't be written") != std::string::npos);
}
