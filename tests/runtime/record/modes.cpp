// The recording of a set of modes has the active mode and each switch, and can be replayed.
#include <doctest/doctest.h>

#include <vector>

#include <cca/modes.hpp>
#include <cca/trace.hpp>

#include "two_modes.hpp"

using namespace record_test;

namespace {

struct legs : cca::modes<cca::mode<"walk", walk>, cca::mode<"stand", stand>>, cca::recordable {};
struct plain_legs : cca::modes<cca::mode<"walk", walk>, cca::mode<"stand", stand>> {};
struct traced_legs : cca::modes<cca::mode<"walk", walk>, cca::mode<"stand", stand>>,
                     cca::recordable,
                     cca::traceable {};

// Components switch in the beats 200 and 300, the program before beat 500. Returns where the leg was.
template <class Controller>
std::vector<double> drive(Controller& c) {
  std::vector<double> at;
  const auto note = [&](Controller& running) { at.push_back(running.template get<"leg">().at[0]); };
  c.load();
  c.start();
  c.run(cca::for_beats<250>{}, {}, note);
  c.template set<"gait">({0.4});
  c.run(cca::for_beats<250>{}, {}, note);
  c.template switch_to<"stand">();
  c.run(cca::for_beats<100>{}, {}, note);
  c.stop();
  return at;
}

}  // namespace

TEST_CASE("the recording of a set of modes has the active mode, its switches, and what each mode publishes") {
  const temporary_file file("modes");
  {
    cca::controller<legs> c;
    cca::recording::recorder recording(c, file.path, {.waits = true});
    cca::controller<plain_legs> plain;
    CHECK(drive(c) == drive(plain));  // the same bits with and without a recording
    recording.close();
    CHECK(recording.problem() == "");
    CHECK(recording.lost_beats() == 0);
  }
  auto [modes, count] = modes_recorded_in(file.path);
  CHECK(modes == std::vector<switched>{
                     {0, "walk", false}, {201, "stand", true}, {301, "walk", true}, {500, "stand", false}});
  CHECK(count["/gait/angles"] == 201 + 199);
  CHECK(count["/stance/height"] == 100 + 100);
  CHECK(count["/stance/angles"] == 200);
  CHECK(count["/leg/angles"] == 600);
  CHECK(count["/limits/safe"] == 600);
  CHECK(count["/cca/parameters/gait"] == 2);
  CHECK(count["/cca/lost"] == 0);
}

TEST_CASE("the recording of a set of modes is replayed bit for bit, or the first difference is named") {
  const temporary_file file("replayed_modes");
  {
    cca::controller<legs> c;
    cca::recording::recorder recording(c, file.path, {.waits = true});
    drive(c);
  }
  const auto result = cca::recording::replay<legs>(file.path);
  INFO(result);
  CHECK(result);
  CHECK(result.beats == 600);
  CHECK(result.samples == 600 + 400 + 2 * 200);

  const auto other =
      cca::recording::replay<legs>(file.path, [](auto& c) { c.template get<"stance">().sum = 1e-3; });
  CHECK(other.component == "stance");
  CHECK(other.port == "height");
  CHECK(other.beat == 201);

  const auto longer =
      cca::recording::replay<legs>(file.path, [](auto& c) { c.template get<"stance">().stands_until = 310; });
  CHECK(longer.difference == "beat 301: recorded the mode `walk`, replayed `stand`");
  CHECK(longer.beat == 301);
}

TEST_CASE("the recording of another set of modes is refused") {
  struct other_legs : cca::modes<cca::mode<"stand", stand>, cca::mode<"walk", walk>>, cca::recordable {};
  const temporary_file file("other_modes");
  {
    cca::controller<other_legs> c;
    cca::recording::recorder recording(c, file.path);
  }
  CHECK_THROWS_WITH_AS(cca::recording::replay<legs>(file.path), doctest::Contains("another architecture"),
                       cca::refused);
}

TEST_CASE("a set of modes is recorded and traced at once, or one after the other") {
  const temporary_file file("both"), trace("both_trace");
  cca::controller<traced_legs> c;
  cca::controller<plain_legs> plain;
  cca::tracer tracer(c, trace.path);
  {
    cca::recording::recorder recording(c, file.path, {.waits = true});
    CHECK(drive(c) == drive(plain));
  }
  tracer.close();
  CHECK(tracer.summary().environments.at(0).beats.all.count() == 600);
  CHECK(cca::recording::replay<traced_legs>(file.path));
}
