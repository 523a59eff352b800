// The recording of a deployment: one file with all environments of a process, in the order of the beats. As
// one loop it is replayed bit for bit.
#include <doctest/doctest.h>

#include <atomic>
#include <chrono>
#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <thread>
#include <vector>

#include <cca/deployment.hpp>
#include <cca/trace.hpp>

#include "graphs.hpp"
#include "rewriting.hpp"

using namespace record_test;

namespace laws {
std::size_t allocations();
}

namespace {

struct thinker {
  struct parameters {
    BOOST_HANA_DEFINE_STRUCT(parameters, (double, gain), (int, microseconds));
  };
  parameters p{0.1, 0};
  Eigen::Vector2d s{0, 0};
  auto process(cca::in<"x", leg_angles> x) -> cca::out<"y", slow_angles> {
    if (p.microseconds > 0) std::this_thread::sleep_for(std::chrono::microseconds(p.microseconds));
    s += p.gain * (x.vector() - s);
    return s;
  }
};

struct walking_apart : cca::graph<cca::rate<1000>,
                                  cca::node<"thinker", thinker, cca::timed<10>>,
                                  cca::node<"swing", swing, cca::timed<1>>,
                                  cca::node<"counter", counter>,
                                  cca::node<"limits", cca::limiter<leg_angles>>,
                                  cca::node<"leg", leg>,
                                  cca::wire<"leg.angles", "thinker.x", cca::delayed<1>>,
                                  cca::wire<"thinker.y", "swing.slow", cca::delayed<9>>,
                                  cca::wire<"swing.angles", "limits.command">,
                                  cca::wire<"leg.angles", "counter.x", cca::delayed<2>>,
                                  cca::wire<"limits.safe", "leg.command">> {};

using robot = cca::environment<"robot", cca::nodes<"leg", "limits", "swing">>;
using mind = cca::environment<"mind", cca::nodes<"thinker">>;
using watch = cca::environment<"watch", cca::other_nodes>;

struct plain : cca::deployment<walking_apart, robot, mind, watch, cca::tolerate<1000>> {};
struct passive_leg {
  auto sense() -> cca::out<"angles", leg_angles> {
    ++beats;
    return Eigen::Vector2d(1e-3 * static_cast<double>(beats % 77), -0.3);
  }
  std::int64_t beats = 0;
};
struct split : cca::deployment<walking_apart, robot, mind, watch, cca::tolerate<1000>>, cca::recordable {};
struct traced : cca::deployment<walking_apart, robot, mind, watch, cca::tolerate<1000>>,
                cca::recordable,
                cca::traceable {};

struct alone : cca::deployment<walking_apart, cca::environment<"all", cca::other_nodes>>, cca::recordable {};

// Needs its parameter when it is loaded, as a policy needs the name of its file.
struct informed {
  struct parameters {
    BOOST_HANA_DEFINE_STRUCT(parameters, (cca::text<8>, file), (double, gain));
  };
  parameters p{"", 0.5};
  std::size_t weights = 0;
  void on_load() {
    if (p.file.view().empty()) throw cca::refused("informed: it has no file");
    weights = p.file.view().size();
  }
  auto process(cca::in<"x", leg_angles> x) -> cca::out<"y", slow_angles> {
    return p.gain * static_cast<double>(weights) * x.vector();
  }
};
struct two_robots : cca::graph<cca::rate<1000>,
                               cca::node<"policy", informed, cca::timed<10>>,
                               cca::node<"other", informed, cca::timed<10>>,
                               cca::node<"swing", swing, cca::timed<1>>,
                               cca::node<"limits", cca::limiter<leg_angles>>,
                               cca::node<"leg", leg>,
                               cca::node<"passive", passive_leg>,
                               cca::wire<"leg.angles", "policy.x", cca::delayed<1>>,
                               cca::wire<"passive.angles", "other.x", cca::delayed<2>>,
                               cca::wire<"policy.y", "swing.slow", cca::delayed<9>>,
                               cca::wire<"swing.angles", "limits.command", cca::delayed<1>>,
                               cca::wire<"limits.safe", "leg.command">,
                               cca::observe<"other.y">> {};

// The components that read files and the robots in any environment.
template <class... Environments>
struct placed : cca::deployment<two_robots, Environments..., cca::tolerate<1000>>, cca::recordable {};
template <cca::fixed_string Name, cca::fixed_string... Paths>
using on = cca::environment<Name, cca::nodes<Paths...>>;
using rest = cca::environment<"rest", cca::other_nodes>;

struct recorded_message {
  std::string topic;
  std::int64_t beat;
};
std::vector<recorded_message> messages_in(const std::string& file) {
  std::vector<recorded_message> all;
  cca::recording::mcap_reader from(file);
  for (cca::recording::mcap_message m; from.next(m);) {
    const std::string& topic = from.channels().at(m.channel).topic;
    if (!topic.starts_with("/ros2"))
      all.push_back({topic, cca::recording::detail::cdr_reader(m.data).number<std::int64_t>()});
  }
  CHECK(from.damage() == "");
  return all;
}
std::map<std::string, int> count_of(const std::vector<recorded_message>& all) {
  std::map<std::string, int> count;
  for (const auto& m : all) ++count[m.topic];
  return count;
}

// Until the fault of `counter`, after about 4.2 s.
template <class D>
std::vector<double> run_until_fault(cca::deployed<D>& d) {
  std::vector<double> at;
  d.load();
  d.start();
  d.run(cca::for_beats<1000>{});
  d.template set<"thinker">({0.3, 0});
  d.run(cca::for_beats<9000>{}, {}, [&](auto& running) {
    at.push_back(running.template get<"leg">().at[0]);
    return true;
  });
  return at;
}

}  // namespace

TEST_CASE("a deployment is recorded into one file, in the order of the beats, and replayed as one loop") {
  const temporary_file file("deployment");
  {
    cca::deployed<split> d;
    cca::deployed<plain> other;
    cca::recording::recorder recording(d, file.path, {.waits = true});
    CHECK(run_until_fault(d) == run_until_fault(other));  // the same bits with and without a recording
    REQUIRE(d.state() == cca::state::faulted);
    recording.close();
    CHECK(recording.problem() == "");
    CHECK(recording.lost_beats() == 0);
  }
  const auto all = messages_in(file.path);
  std::int64_t beat = 0;
  for (const auto& m : all)
    if (m.topic != "/cca/fault") {
      CHECK(m.beat >= beat);
      beat = m.beat;
    }
  auto count = count_of(all);
  CHECK(count["/leg/angles"] > 3000);
  CHECK(count["/limits/safe"] == count["/leg/angles"] - 1);  // the fault comes before
  CHECK(count["/thinker/y"] == (count["/leg/angles"] + 9) / 10);
  CHECK(count["/counter/steps"] > 4);
  CHECK(count["/cca/parameters/thinker"] == 2);
  CHECK(count["/cca/fault"] == 1);
  CHECK(count["/cca/lost"] == 0);
  CHECK(count["/cca/skipped"] == 0);
  CHECK(count["/cca/late"] == 0);

  const auto result = cca::recording::replay<split>(file.path);
  INFO(result);
  CHECK(result);
  CHECK(result.beats == count["/leg/angles"]);
  CHECK(result.fault == "`counter`: too many steps");

  const auto other =
      cca::recording::replay<split>(file.path, [](auto& c) { c.template get<"thinker">().s[0] = 1e-9; });
  CHECK(other.difference.find("`thinker.y`, beat 0: recorded [") == 0);
}

TEST_CASE("a file that ends while the loops run ends after a whole beat of all, and is replayed") {
  for (int n = 0; n < 4; ++n) {
    const temporary_file file("ends");
    {
      cca::deployed<split> d;
      // At last the file ends before the thread that writes has looked at anything.
      const std::chrono::milliseconds looks_every(n < 3 ? 2 : 400);
      cca::recording::recorder recording(d, file.path, {.waits = true, .looks_every = looks_every});
      std::atomic<bool> is_time = false;
      std::thread other([&] {
        is_time.wait(false);
        recording.end_file();
      });
      d.load();
      d.start();
      d.run(cca::for_beats<700>{}, {}, [&](auto& running) {
        if (running.beat_index() == 200 + 37 * n) is_time = true, is_time.notify_one();
        return true;
      });
      other.join();
      CHECK(recording.recorded_into() == "");
    }
    const auto result = cca::recording::replay<split>(file.path);
    INFO(result);
    CHECK(result);
    CHECK(result.beats >= 200);
  }
}

TEST_CASE("a file that ends where no beat comes ends at once") {
  const temporary_file file("rests");
  cca::deployed<split> d;
  cca::recording::recorder recording(d, file.path, {.waits = true});
  d.load();
  d.start();
  d.run(cca::for_beats<300>{});
  std::this_thread::sleep_for(std::chrono::milliseconds(100));  // all is written
  const auto began = std::chrono::steady_clock::now();
  recording.end_file();
  CHECK(std::chrono::steady_clock::now() - began < std::chrono::milliseconds(900));
  CHECK(cca::recording::replay<split>(file.path).beats == 300);
}

TEST_CASE("the file says which environments are in it") {
  const temporary_file file("environments");
  {
    cca::deployed<split> d;
    cca::recording::recorder recording(d, file.path);
  }
  cca::recording::mcap_reader from(file.path);
  for (cca::recording::mcap_message m; from.next(m);) {}
  bool is_told = false;
  for (const auto& [name, entries] : from.metadata())
    if (name == "cca.environments") {
      is_told = true;
      CHECK(entries.at("all") == "robot mind watch");
      CHECK(entries.at("here") == "robot mind watch");
    }
  CHECK(is_told);
}

TEST_CASE("in a wall-clock run, late samples and beats that were left out are in the file") {
  const temporary_file file("late");
  std::int64_t late = 0, lost = 0;
  {
    cca::deployed<split> d;
    cca::recording::recorder recording(d, file.path);
    d.load();
    auto slow = d.get<"thinker">().p;
    slow.microseconds = 25'000;  // its samples should come within 9 ms
    d.set<"thinker">(slow);
    d.start();
    d.run(cca::for_beats<300>{}, cca::at_wall_clock());
    d.stop();
    late = d.late();
    lost = d.lost_periods();
    recording.close();
    CHECK(recording.lost_beats() == 0);
  }
  REQUIRE(late > 0);
  auto count = count_of(messages_in(file.path));
  CHECK(count["/cca/late"] == late);
  CHECK(count["/cca/skipped"] > 0);
  CHECK(lost > 0);
  const auto result = cca::recording::replay<split>(file.path);
  INFO(result);
  CHECK_FALSE(result);
  CHECK(result.difference == "");
  CHECK(result.ended_early.find("it can't be replayed from beat ") == 0);
  CHECK(result.beats > 5);
}

TEST_CASE("the recording of a process that runs some environments is not replayed") {
  const temporary_file file("some"), other_file("others");
  const std::string name = "/cca_record_" + std::to_string(::getpid());
  std::thread elsewhere([&] {
    cca::deployed<split> d(cca::only{"mind", "watch"}, cca::shared_memory(name));
    cca::recording::recorder recording(d, other_file.path, {.waits = true});
    d.load();
    d.start();
    d.run(cca::for_beats<500>{});
    d.stop();
  });
  {
    cca::deployed<split> d(cca::only{"robot"}, cca::shared_memory(name));
    cca::recording::recorder recording(d, file.path, {.waits = true});
    d.load();
    d.start();
    d.run(cca::for_beats<500>{});
    d.stop();
  }
  elsewhere.join();
  auto here = count_of(messages_in(file.path)), there = count_of(messages_in(other_file.path));
  CHECK(here["/leg/angles"] == 500);
  CHECK(here["/thinker/y"] == 0);
  CHECK(here["/cca/parameters/thinker"] == 0);
  CHECK(there["/leg/angles"] == 0);
  CHECK(there["/thinker/y"] == 50);
  CHECK(there["/cca/parameters/thinker"] == 1);
  CHECK_THROWS_WITH_AS(cca::recording::replay<split>(other_file.path),
                       doctest::Contains("with all environments in one process"), cca::refused);
}

TEST_CASE("a recorded environment allocates nothing, and does not wait for a full ring") {
  // The thread of a recorder allocates, so here nobody writes: the rings are full after two beats.
  using loop = cca::detail::part<alone, 0>;
  struct silent final : cca::detail::beat_tap<loop> {
    silent() : beat_tap(2) {}
    void parameters_changed(const cca::detail::controller_state<loop>&, std::int64_t) noexcept override {}
    void moved(cca::state, std::int64_t) noexcept override {}
    void failed(int, const char*, std::int64_t) noexcept override {}
    void controller_is_gone() noexcept override {}
  } tap;
  cca::deployed<alone> d;
  d.for_each_tap([&]<int E>(auto& pointer) { pointer.set(&tap); });
  d.load();
  d.start();
  d.run(cca::for_beats<10>{});
  std::size_t before = 0, after = 0;
  d.run(cca::for_beats<1000>{}, {}, [&](auto& running) {
    if (running.beat_index() == 20) before = laws::allocations();
    if (running.beat_index() == 1000) after = laws::allocations();
    return true;
  });
  CHECK(after == before);
  CHECK(before > 0);
  CHECK(d.beat_index() == 1010);
  d.for_each_tap([&]<int E>(auto& pointer) { pointer.set(nullptr); });
}

TEST_CASE("a deployment is recorded and traced at once") {
  const temporary_file file("both_deployed"), trace("both_deployed_trace");
  cca::deployed<traced> d;
  cca::tracer tracer(d, trace.path, {.waits = true});
  {
    cca::recording::recorder recording(d, file.path, {.waits = true});
    d.load();
    d.start();
    d.run(cca::for_beats<1000>{});
    d.stop();
  }
  d.start();
  d.run(cca::for_beats<500>{});  // only traced
  tracer.close();
  const auto summary = tracer.summary();
  REQUIRE(summary.environments.size() == 3);
  CHECK(summary.environments[0].beats.all.count() == 1500);
  const auto result = cca::recording::replay<traced>(file.path);
  INFO(result);
  CHECK(result);
  CHECK(result.beats == 1000);
}

TEST_CASE("beats of an environment that do not fit are counted and marked") {
  const temporary_file file("lost_deployed");
  std::int64_t lost = 0;
  {
    cca::deployed<alone> d;
    cca::recording::recorder recording(d, file.path, {.buffered_seconds = 0});
    d.get<"counter">().count = -1'000'000'000;  // no fault: after one, each run is over in a few beats
    d.load();
    d.start();
    for (int i = 0; i < 10'000 && recording.lost_beats() == 0; ++i)  // at times faster than any file
      REQUIRE(d.run(cca::for_beats<100'000>{}) != cca::state::faulted);
    d.stop();
    recording.close();
    lost = recording.lost_beats();
  }
  std::int64_t marked = 0, recorded = 0;
  cca::recording::mcap_reader reader(file.path);
  for (cca::recording::mcap_message m; reader.next(m);) {
    const std::string& topic = reader.channels().at(m.channel).topic;
    cca::recording::detail::cdr_reader from(m.data);
    from.number<std::int64_t>();
    if (topic == "/cca/lost") marked += from.number<std::int64_t>();
    recorded += topic == "/leg/angles";
  }
  CHECK(reader.damage() == "");
  CHECK(lost > 0);
  CHECK(marked == lost);
  CHECK(recorded > 0);
}

TEST_CASE_TEMPLATE("a deployment is replayed wherever its parts are placed",
                   D,
                   placed<on<"robot", "leg", "limits">, on<"mind", "policy">, rest>,
                   placed<on<"mind", "policy", "swing">, on<"body", "passive", "other">, rest>,
                   placed<rest, on<"watch", "other", "passive">>) {
  const temporary_file file("placed");
  for (int i = 0; i < 5; ++i) {  // which of two threads is first differs
    {
      cca::deployed<D> d;
      cca::recording::recorder recording(d, file.path, {.waits = true});
      d.template get<"policy">().p.file = "first";
      d.template get<"other">().p.file = "second";
      d.load();
      d.template set<"other">({"later", 0.25});  // too late for load(), which has read the other name
      d.start();
      d.run(cca::for_beats<300>{});
      d.template set<"policy">({"x", 0.125});
      d.run(cca::for_beats<300>{});
      d.stop();
    }
    const auto result = cca::recording::replay<D>(file.path);
    INFO(result);
    REQUIRE(result);
    REQUIRE(result.beats == 600);
  }
  // Of another process, whose parameters are not in this file, the reason is not only the hook's.
  const temporary_file other("without");
  rewrite(file.path, other.path, {.keeps = [](const std::string& topic) {
            return topic != "/cca/parameters/policy" && topic != "/policy/y";
          }});
  CHECK_THROWS_WITH_AS(
      cca::recording::replay<D>(other.path),
      doctest::Contains("the state `loaded` is refused: informed: it has no file (no parameters "
                        "are recorded of `policy`)"),
      cca::refused);
}
