// A recording, played into the same controller, gives the same samples; of another one it says where the
// first difference is.
#include <doctest/doctest.h>

#include <filesystem>
#include <sstream>
#include <string>

#include "graphs.hpp"

using namespace record_test;

namespace laws {
std::size_t allocations();
}

namespace {

struct graph : walking<> {};
using controller = cca::controller<graph>;

struct eye {
  auto sense() -> cca::out<"angles", leg_angles> { return Eigen::Vector2d(0.1, -0.9); }
};
struct reader {
  void process(cca::in<"x", leg_angles>) {}
};

// Until its fault: three steps take about 4.2 s.
void record(const std::string& file, cca::recording::settings s = {.waits = true}) {
  controller c;
  cca::recording::recorder recording(c, file, s);
  c.load();
  c.start();
  c.run(cca::for_beats<1000>{});
  c.set<"filter">({0.3, "slow"});
  c.run(cca::for_beats<9000>{});
  REQUIRE(c.state() == cca::state::faulted);
  recording.close();
  CHECK(recording.problem() == "");
  CHECK(recording.lost_beats() == 0);
}

}  // namespace

TEST_CASE("a replay gives every sample and the fault bit for bit") {
  const temporary_file file("replay");
  record(file.path);
  const auto result = cca::recording::replay<graph>(file.path);
  INFO(result);
  CHECK(result);
  CHECK(result.beats > 3000);
  CHECK(result.fault == "`counter`: too many steps");
  CHECK(result.samples > 2 * result.beats);  // filter and leg seldom or fed; swing and limits in each beat
}

TEST_CASE("a replay says where the first difference is") {
  const temporary_file file("difference");
  record(file.path);
  const auto result =
      cca::recording::replay<graph>(file.path, [](auto& c) { c.template get<"filter">().s[0] = 1e-9; });
  CHECK_FALSE(result);
  CHECK(result.component == "filter");
  CHECK(result.port == "y");
  CHECK(result.beat == 0);
  CHECK(result.difference.find("`filter.y`, beat 0: recorded [") == 0);
}

TEST_CASE("a recording that was cut off is replayed as far as it goes") {
  const temporary_file file("cut");
  record(file.path, {.waits = true, .chunk_bytes = 1 << 14});
  std::filesystem::resize_file(file.path, std::filesystem::file_size(file.path) / 2);
  const auto result = cca::recording::replay<graph>(file.path);
  CHECK(result.difference == "");
  CHECK(result.beats > 1000);
  CHECK(result.ended_early.find("the recording is cut off") == 0);
}

TEST_CASE("a replay that compares nothing is no success") {
  const temporary_file file("sensed");
  const auto recorded_only = [&](const std::string& scope, int beats) {
    controller c;
    cca::recording::recorder recording(c, file.path, {.scopes = {scope}, .waits = true});
    c.load();
    c.start();
    for (int k = 0; k < beats && c.state() == cca::state::started; ++k) c.step();
  };
  recorded_only("leg", 100);
  const auto nothing = cca::recording::replay<graph>(file.path);
  CHECK_FALSE(nothing);
  CHECK(nothing.difference == "");
  CHECK(nothing.ended_early == "");
  CHECK(nothing.beats == 100);
  std::ostringstream text;
  text << nothing;
  CHECK(text.str() ==
        "nothing is compared in 100 beats: the recording lacks all that components compute: `filter.y`, "
        "`swing.angles`, `counter.steps`, `limits.safe`");
  recorded_only("leg", 10'000);
  const auto fault = cca::recording::replay<graph>(file.path);  // it comes in the recorded beat
  CHECK(fault);
  CHECK(fault.samples == 0);
  CHECK(fault.fault == "`counter`: too many steps");
}

TEST_CASE("of a graph that computes nothing, what was sensed is all there is") {
  struct only_sensed : cca::graph<cca::rate<1000>, cca::node<"reader", reader>, cca::node<"eye", eye>,
                                  cca::wire<"eye.angles", "reader.x">>,
                       cca::recordable {};
  const temporary_file file("only_sensed");
  {
    cca::controller<only_sensed> c;
    cca::recording::recorder recording(c, file.path, {.waits = true});
    c.load();
    c.start();
    c.run(cca::for_beats<50>{});
  }
  const auto result = cca::recording::replay<only_sensed>(file.path);
  CHECK(result);
  CHECK(result.beats == 50);
}

TEST_CASE("what can't be replayed is refused") {
  const temporary_file file("refused");
  record(file.path, {.scopes = {"limits"}, .waits = true});
  CHECK_THROWS_WITH_AS(cca::recording::replay<graph>(file.path),
                       doctest::Contains("what `leg.angles` sensed was not recorded"), cca::refused);
  {
    controller c;
    c.load();
    c.start();
    c.run(cca::for_beats<5>{});
    cca::recording::recorder late(c, file.path);
    c.run(cca::for_beats<5>{});
  }
  CHECK_THROWS_WITH_AS(cca::recording::replay<graph>(file.path),
                       doctest::Contains("does not begin before the first beat"), cca::refused);
  controller c;
  CHECK_THROWS_WITH_AS(cca::recording::recorder(c, file.path, {.scopes = {"lims"}}),
                       doctest::Contains("no port under `lims`"), cca::refused);
}

TEST_CASE("a recorded beat allocates nothing") {
  // The thread of a recorder allocates, so here nobody writes: the ring is full after two beats.
  struct silent final : cca::detail::beat_tap<graph> {
    silent() : beat_tap(2) {}
    void parameters_changed(const cca::detail::controller_state<graph>&, std::int64_t) noexcept override {}
    void moved(cca::state, std::int64_t) noexcept override {}
    void failed(int, const char*, std::int64_t) noexcept override {}
    void controller_is_gone() noexcept override {}
  } tap;
  controller c;
  c.record_into(&tap);
  c.load();
  c.start();
  const auto before = laws::allocations();
  c.run(cca::for_beats<1000>{});
  CHECK(laws::allocations() == before);
  CHECK(c.beat_index() == 1000);
  c.record_into(nullptr);
}

TEST_CASE("a copy of a controller is not recorded") {
  const temporary_file file("copy");
  controller c;
  cca::recording::recorder recording(c, file.path);
  CHECK(c.recorded_into() != nullptr);
  const controller copy = c;
  CHECK(copy.recorded_into() == nullptr);
}

TEST_CASE("the recording of a controller ends when another one is assigned to it") {
  const temporary_file file("assigned");
  controller c;
  cca::recording::recorder recording(c, file.path);
  c.load();
  c.start();
  c.run(cca::for_beats<10>{});
  controller& itself = c;
  c = itself;
  CHECK(c.recorded_into() != nullptr);
  c = controller();
  CHECK(c.recorded_into() == nullptr);
  c.load();
  c.start();
  c.run(cca::for_beats<5>{});
  recording.close();
  CHECK(recording.problem() == "");
  const auto result = cca::recording::replay<graph>(file.path);
  INFO(result);
  CHECK(result);
  CHECK(result.beats == 10);
}

TEST_CASE("beats that do not fit are counted and marked") {
  const temporary_file file("lost");
  std::int64_t lost = 0;
  {
    controller c;
    cca::recording::recorder recording(c, file.path, {.buffered_seconds = 0});
    c.load();
    c.start();
    // Much faster than any file, but for a loop that a sanitizer slows.
    for (int i = 0; i < 300 || (recording.lost_beats() == 0 && i < 100'000); ++i)
      if (c.run(cca::for_beats<100'000>{}) == cca::state::faulted) c.resume();
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
