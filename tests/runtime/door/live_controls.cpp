// What a door asks is done on a controller that runs, or refused with the reason: without a network.
#include <doctest/doctest.h>

#include <signal.h>
#include <sys/resource.h>

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

#include <cca/door/live_controls.hpp>
#include <cca/modes.hpp>

#include "../core/live_rig.hpp"
#include "../record/graphs.hpp"

using namespace live_test;
using cca::detail::door_outcome;
using cca::detail::door_parameter;
using cca::detail::door_request;
using cca::detail::door_value;
using how = door_outcome::how;
using what = door_request::what;

namespace {

enum class terrain { flat, slope };
using three = std::array<double, 3>;
struct leg_of {
  BOOST_HANA_DEFINE_STRUCT(leg_of, (double, damping));
};
struct tuned {
  struct parameters {
    BOOST_HANA_DEFINE_STRUCT(parameters,
                             (cca::quantity<cca::angle, -0.9, 0.9>, offset),
                             (terrain, ground),
                             (bool, on),
                             (std::uint8_t, legs),
                             (three, gains),
                             (cca::text<8>, name),
                             (leg_of, leg),
                             (Eigen::Matrix2d, mixing));
  };
  parameters p{0.1, terrain::slope, true, 4, {1, 2, 3}, "left", {0.5}, Eigen::Matrix2d::Identity()};
  void process(cca::in<"x", pair>) {}
};
struct graph : cca::graph<cca::rate<1000>,
                          cca::node<"source", source, cca::stoppable<cca::timed<1>>>,
                          cca::node<"tuned", tuned>,
                          cca::wire<"source.y", "tuned.x", cca::latest>>,
               cca::recordable {};
using controller = cca::controller<graph>;

// Messages of a recording, as a door gets them.
struct heard : cca::recording::message_sink {
  void channel(const cca::recording::channel_info& one) override { topics[one.id] = one.topic; }
  void message(std::uint16_t id, std::uint64_t, std::uint64_t, cca::recording::detail::byte_view) override {
    ++count[topics.at(id)];
  }
  void metadata(const std::string& name, const cca::recording::detail::text_map& entries) override {
    notes.emplace_back(name, entries);
  }
  std::map<std::uint16_t, std::string> topics;
  std::map<std::string, int> count;
  std::vector<std::pair<std::string, cca::recording::detail::text_map>> notes;
};

// A run in a thread of its own, and its controls.
template <class Controller>
struct rig {
  explicit rig(double speed = 1, std::vector<cca::run_command<Controller>> offers = {})
      : live(c),
        recorder(c, cca::recording::settings{}),
        controls(live, live.control(), recorder, std::move(offers), "test", speed, {}) {}

  template <class F>
  void beside(F f) {
    std::thread window([&] {
      f();
      CHECK(controls.begin({.about = what::end_run}).is == how::done);
    });
    const auto between = [this](Controller& running) {
      if (!controls.is_wanted(controls.the_run)) return true;
      controls.obey(running);
      return live(running);
    };
    looked<decltype(between)> look{between, live};
    c.run(cca::without_end{}, cca::at_speed(4), look);
    controls.end(c);
    window.join();
  }
  template <class Between>
  struct looked {
    const Between& between;
    cca::live_access<Controller>& live;
    bool operator()(Controller& running) { return between(running); }
    cca::detail::run_control& control() { return live.control(); }
    bool while_paused(Controller& running) { return between(running); }
  };

  // Until it has been taken.
  door_outcome ask(const door_request& request) {
    door_outcome said = controls.begin(request);
    wait_until([&] {
      if (said.is == how::busy) said = controls.begin(request);
      if (said.is == how::begun) said = controls.outcome();
      return said.is == how::done || said.is == how::refused;
    });
    return said;
  }
  door_outcome set(std::vector<std::pair<std::string, door_value>> values) {
    return ask({.about = what::set, .values = std::move(values)});
  }
  door_parameter parameter(std::string_view path) {
    const auto all = controls.parameters();
    REQUIRE(all);
    for (const door_parameter& one : *all)
      if (one.path == path) return one;
    FAIL("there is no such parameter");
    return {};
  }

  Controller c = started<Controller>();
  cca::live_access<Controller> live;
  cca::recording::recorder<Controller> recorder;
  cca::detail::live_controls<Controller> controls;
};

// A disk that is full after the head of a recording.
struct small_files {
  small_files() {
    ::getrlimit(RLIMIT_FSIZE, &before);
    const rlimit small{1000, before.rlim_max};
    ::setrlimit(RLIMIT_FSIZE, &small);
  }
  ~small_files() {
    ::setrlimit(RLIMIT_FSIZE, &before);
    ::signal(SIGXFSZ, handler);
  }
  void (*handler)(int) = ::signal(SIGXFSZ, SIG_IGN);
  rlimit before{};
};

door_value number(double value) { return {.number = value}; }
door_value whole(std::int64_t value) { return {.what = door_value::kind::integer, .integer = value}; }
door_value text(std::string value) { return {.what = door_value::kind::text, .text = std::move(value)}; }

}  // namespace

TEST_CASE("door: parameters have their value, unit, range or choices") {
  rig<controller> r;
  const door_parameter offset = r.parameter("tuned.offset");
  CHECK(offset.value == number(0.1));
  CHECK(offset.unit == "rad");
  CHECK(offset.lower == -0.9);
  CHECK(offset.upper == 0.9);
  const door_parameter ground = r.parameter("tuned.ground");
  CHECK(ground.value == text("slope"));
  REQUIRE(ground.choices.size() == 2);
  CHECK(ground.choices[0] == "flat");
  CHECK(r.parameter("tuned.on").value == door_value{.what = door_value::kind::boolean, .integer = 1});
  CHECK(r.parameter("tuned.legs").value == whole(4));
  CHECK_FALSE(r.parameter("tuned.leg.damping").lower);
  CHECK(r.parameter("tuned.gains").value.numbers == std::vector<double>{1, 2, 3});
  CHECK(r.parameter("tuned.mixing[1]").value.numbers == std::vector<double>{0, 1});
  CHECK(r.parameter("tuned.name").value == text("left"));
}

TEST_CASE("door: all parameters of a request change in one beat, or none") {
  rig<controller> r;
  r.beside([&] {
    for (int i = 1; i <= 40; ++i)
      CHECK(r.set({{"source.slope", number(i)}, {"source.same", number(i)}}).is == how::done);
    const door_outcome refused = r.set({{"source.slope", number(7)}, {"source.same", number(101)}});
    CHECK(refused.is == how::refused);
    CHECK(refused.why.find("source.same") != std::string::npos);
    CHECK(refused.why.find("100") != std::string::npos);
    CHECK(r.parameter("source.slope").value == number(40));
    CHECK(r.set({{"source.slopes", number(1)}}).why.find("did you mean `source.slope`") != std::string::npos);
    CHECK(r.set({{"tuned.legs", number(2.5)}}).is == how::refused);
    CHECK(r.set({{"tuned.ground", text("hill")}}).why.find("flat") != std::string::npos);
    CHECK(r.set({{"tuned.offset", text("30 deg")}, {"tuned.legs", whole(6)}}).is == how::done);
    CHECK(r.set({{"tuned.gains", {.what = door_value::kind::numbers, .numbers = {4, 5, 6}}}}).is ==
          how::done);
    CHECK(r.set({{"tuned.gains", {.what = door_value::kind::numbers, .numbers = {4, 5}}}}).is ==
          how::refused);
  });
  const source& seen = r.c.get<"source">();
  CHECK(seen.broken == 0);
  CHECK(double{seen.p.slope} == 40);
  CHECK(r.c.get<"tuned">().p.legs == 6);
  CHECK(double{r.c.get<"tuned">().p.offset} == doctest::Approx(0.5236).epsilon(1e-4));
  CHECK(r.c.get<"tuned">().p.gains == three{4, 5, 6});
}

TEST_CASE("door: a component refuses for now, and is named") {
  rig<controller> r;
  r.beside([&] {
    CHECK(r.set({{"source.locked", {.what = door_value::kind::boolean, .integer = 1}}}).is == how::done);
    const door_outcome refused = r.set({{"source.slope", number(3)}});
    CHECK(refused.is == how::refused);
    CHECK(refused.why == "`source` refuses it for now");
    CHECK(r.parameter("source.slope").value == number(1));
  });
}

TEST_CASE("door: pause, single beats, speed, parts, and the end of the run") {
  rig<controller> r;
  r.beside([&] {
    CHECK(r.ask({.about = what::step, .number = 1}).why.find("not paused") != std::string::npos);
    CHECK(r.ask({.about = what::pause}).is == how::done);
    wait_until([&] { return r.controls.status().is_paused; });
    const std::int64_t k = r.controls.status().beat;
    CHECK(r.ask({.about = what::step, .number = 3}).is == how::done);
    wait_until([&] { return r.controls.status().beat == k + 3; });
    CHECK(r.ask({.about = what::step, .number = 0}).is == how::refused);
    CHECK(r.set({{"source.slope", number(2)}}).is == how::done);  // in a pause, too
    CHECK(r.ask({.about = what::speed, .number = 0}).is == how::refused);
    CHECK(r.ask({.about = what::speed, .number = 2}).is == how::done);
    CHECK(r.controls.status().speed == 2);
    CHECK(r.ask({.about = what::stop_part, .text = "source"}).is == how::done);
    CHECK(r.ask({.about = what::start_part, .text = "source"}).is == how::done);
    CHECK(r.ask({.about = what::stop_part, .text = "tuned"}).is == how::refused);
    CHECK(r.ask({.about = what::switch_mode, .text = "walk"}).why.find("no modes") != std::string::npos);
    CHECK(r.ask({.about = what::go_on}).is == how::done);
    wait_until([&] { return r.controls.status().beat > k + 10; });
    CHECK(r.controls.status().state == "running");
    CHECK(r.ask({.about = what::end_run}).is == how::done);
  });
  CHECK(r.c.get<"source">().stops == 1);
  CHECK(r.c.state() == cca::state::started);
}

TEST_CASE("door: a pause, and its end, end the single beats that were to come") {
  rig<controller> r;
  r.beside([&] {
    const auto beat_now = [&] {
      (void)r.controls.status();  // asks for a look
      std::this_thread::sleep_for(std::chrono::milliseconds(20));
      return r.controls.status().beat;
    };
    const auto rests = [&] {
      wait_until([&] { return r.controls.status().is_paused; });
      const std::int64_t k = beat_now();
      CHECK(beat_now() == k);
    };
    CHECK(r.ask({.about = what::pause}).is == how::done);
    rests();
    CHECK(r.ask({.about = what::step, .number = 1e6}).is == how::done);
    CHECK_FALSE(r.controls.status().is_paused);
    CHECK(r.ask({.about = what::pause}).is == how::done);
    rests();
    CHECK(r.ask({.about = what::step, .number = 1e6}).is == how::done);
    CHECK(r.ask({.about = what::go_on}).is == how::done);
    CHECK(r.ask({.about = what::pause}).is == how::done);
    rests();
    CHECK(r.ask({.about = what::step, .number = 1e6}).is == how::done);
    CHECK(r.ask({.about = what::end_steps}).is == how::done);
    rests();
  });
}

TEST_CASE("door: a fast run has no speed") {
  rig<controller> r(0);
  CHECK(r.ask({.about = what::speed, .number = 2}).why.find("fast run") != std::string::npos);
}

TEST_CASE("door: a file begins and ends while the controller runs") {
  const record_test::temporary_file first("a"), second("b");
  rig<controller> r;
  heard door;
  r.beside([&] {
    CHECK(r.ask({.about = what::end_recording}).why.find("nothing is being recorded") != std::string::npos);
    wait_until([&] { return r.controls.status().beat > 20; });
    r.recorder.add(door);
    CHECK(r.set({{"source.slope", number(9)}}).is == how::done);
    CHECK(r.ask({.about = what::record, .text = first.path}).is == how::done);
    CHECK(r.controls.status().recording == first.path);
    CHECK(r.ask({.about = what::record, .text = second.path}).why.find(first.path) != std::string::npos);
    const std::int64_t k = r.controls.status().beat;
    wait_until([&] { return r.controls.status().beat > k + 50; });
    r.controls.note("127.0.0.1:1", "set source.slope to 9");
    CHECK(r.ask({.about = what::end_recording}).is == how::done);
    CHECK(r.controls.status().recording.empty());
    CHECK(r.ask({.about = what::record, .text = "/nowhere/a.mcap"}).is == how::refused);
    CHECK(r.ask({.about = what::record, .text = second.path}).is == how::done);
  });
  r.recorder.remove(door);
  r.recorder.close();
  CHECK(r.recorder.problem().empty());
  CHECK(door.count["/source/y"] > 50);
  CHECK(door.count["/cca/state"] >= 1);  // it came late, and is told where things stand
  for (const auto* file : {&first, &second}) {
    cca::recording::mcap_reader read(file->path);
    std::map<std::string, int> count;
    for (cca::recording::mcap_message m; read.next(m);) ++count[read.channels().at(m.channel).topic];
    CHECK(read.damage().empty());
    CHECK(count["/cca/parameters/source"] >= 1);
    CHECK(count["/cca/state"] >= 1);
    if (file == &first) CHECK(count["/source/y"] >= 40);
    bool has_end = false;
    for (const auto& [name, entries] : read.metadata()) has_end = has_end || name == "cca.end";
    CHECK(has_end);
  }
}

TEST_CASE("door: a file that can't be written any more is told, also at its end, and the next one is whole") {
  const record_test::temporary_file full("full"), next("next");
  rig<controller> r;
  r.beside([&] {
    std::optional<small_files> disk(std::in_place);
    CHECK(r.ask({.about = what::record, .text = full.path}).is == how::done);
    wait_until([&] { return !r.controls.recording_problem().empty(); });
    const std::string problem = r.controls.recording_problem();
    CHECK(problem ==
          full.path + " can't be written: File too large; up to there it is in " + full.path + ".part");
    CHECK(r.controls.status().recording == full.path);
    CHECK(r.controls.status().recording_problem == problem);
    const door_outcome ended = r.ask({.about = what::end_recording});
    CHECK(ended.is == how::refused);
    CHECK(ended.why == "the recording has ended, and is incomplete: " + problem);
    disk.reset();
    CHECK(r.controls.status().recording == "");
    CHECK(r.controls.status().recording_problem == "");
    CHECK(r.ask({.about = what::record, .text = next.path}).is == how::done);
    const std::int64_t k = r.controls.status().beat;
    wait_until([&] { return r.controls.status().beat > k + 50; });
    CHECK(r.controls.status().recording_problem == "");
    CHECK(r.ask({.about = what::end_recording}).is == how::done);
  });
  r.recorder.close();
  CHECK(r.recorder.problem().find(full.path) == 0);  // the program's exit code knows of the first
}

TEST_CASE("door: a program's own commands, held and released") {
  std::vector<double> pushed;
  int released = 0, lifted = 0;
  // One by one: g++ 12 stops with an internal error at a list of them.
  std::vector<cca::run_command<controller>> offers;
  offers.push_back(
      {.name = "push",
       .help = "pushes the trunk",
       .arguments = {{"forward", 20, -60, 60, "N"}, {"up", 0, -5, 5, "N"}},
       .begin = [&](controller&, auto newtons) { pushed.assign(newtons.begin(), newtons.end()); },
       .end = [&](controller&) { ++released; }});
  offers.push_back({.name = "tap", .begin = [&](controller&, auto) { pushed.clear(); }});
  offers.push_back({.name = "drop",
                    .begin = [](controller&, auto) { throw cca::refused("the hand is empty"); },
                    .end = [](controller&) { throw cca::refused("it was empty"); }});
  offers.push_back({.name = "lift", .begin = [&](controller&, auto) { ++lifted; }, .only_at_rest = true});
  rig<controller> r(1, std::move(offers));
  const auto& told = r.controls.description().commands;
  REQUIRE(told.size() == 4);
  CHECK(told[0].is_held);
  CHECK(told[0].arguments[0].upper == 60);
  CHECK_FALSE(told[1].is_held);
  const auto call = [&](std::string name, std::vector<std::pair<std::string, door_value>> values) {
    return r.ask({.about = what::call, .values = std::move(values), .text = std::move(name)});
  };
  r.beside([&] {
    CHECK(call("push", {{"forward", number(61)}}).why == "push: forward: expected a number from -60 to 60 N");
    CHECK(call("push", {{"side", number(1)}}).why == "push: there is no argument `side`");
    CHECK(call("shove", {}).why == "there is no command `shove`: it has push, tap, drop, lift");
    CHECK(r.ask({.about = what::release, .text = "tap"}).why.find("over at once") != std::string::npos);
    CHECK(pushed.empty());
    CHECK(call("push", {{"forward", whole(-30)}}).is == how::done);
    CHECK(pushed == std::vector<double>{-30, 0});
    CHECK(r.ask({.about = what::release, .text = "push"}).is == how::done);
    CHECK(released == 1);
    CHECK(call("push", {}).is == how::done);
    CHECK(pushed == std::vector<double>{20, 0});
    CHECK(call("drop", {}).why == "drop: the hand is empty");
    CHECK(call("tap", {}).is == how::done);
    CHECK(call("lift", {}).why == "pause it first: `lift` is refused while it runs");
    CHECK(r.ask({.about = what::pause}).is == how::done);
    CHECK(call("lift", {}).is == how::done);
    CHECK(lifted == 1);
    CHECK(r.ask({.about = what::step, .number = 1e6}).is == how::done);
    CHECK(call("lift", {}).is == how::refused);
    CHECK(lifted == 1);
    CHECK(r.ask({.about = what::go_on}).is == how::done);
    wait_until([&] { return !r.live.is_paused(); });
    CHECK(call("lift", {}).is == how::refused);
    CHECK(lifted == 1);
  });
  CHECK(released == 2);  // the run is over
  CHECK_THROWS_AS((cca::detail::offered_commands<controller>({{.name = "none"}})), cca::refused);
}

namespace {

struct resting : cca::graph<cca::rate<1000>,
                            cca::node<"leg", record_test::leg>,
                            cca::node<"limits", cca::limiter<record_test::leg_angles>>,
                            cca::wire<"leg.angles", "limits.command">,
                            cca::wire<"limits.safe", "leg.command">> {};
struct swinging : cca::graph<cca::rate<1000>,
                             cca::node<"leg", record_test::leg>,
                             cca::node<"swing", record_test::swing, cca::timed<1>>,
                             cca::node<"filter", record_test::filter, cca::timed<10>>,
                             cca::node<"limits", cca::limiter<record_test::leg_angles>>,
                             cca::wire<"leg.angles", "filter.x", cca::latest>,
                             cca::wire<"filter.y", "swing.slow", cca::latest>,
                             cca::wire<"swing.angles", "limits.command">,
                             cca::wire<"limits.safe", "leg.command">> {};
struct both : cca::modes<cca::mode<"rest", resting>, cca::mode<"swing", swinging>>, cca::recordable {};

}  // namespace

TEST_CASE("door: modes are listed, told and switched") {
  rig<cca::controller<both>> r;
  CHECK(r.controls.description().modes == std::vector<std::string>{"rest", "swing"});
  r.beside([&] {
    CHECK(r.controls.status().mode == "rest");
    CHECK(r.ask({.about = what::switch_mode, .text = "swing"}).is == how::done);
    wait_until([&] { return r.controls.status().mode == "swing"; });
    CHECK(r.ask({.about = what::switch_mode, .text = "fly"}).is == how::refused);
    CHECK(r.set({{"filter.gain", number(0.2)}}).is == how::done);
  });
}
