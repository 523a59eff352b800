// Parameters by a path that is known only at run time, and saving while a controller is started.
#include <doctest/doctest.h>

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include <Eigen/Core>

#include <cca/cca.hpp>
#include <cca/config.hpp>

#include "../../laws/temporary_file.hpp"

namespace {

enum class terrain { flat, slope };
struct range {
  BOOST_HANA_DEFINE_STRUCT(range, (double, low), (double, high));
  const char* check() const { return low < high ? "" : "low must be below high"; }
};
using three = std::array<double, 3>;

struct reading : cca::space<cca::number, cca::axes<cca::x>> {};
struct oscillator {
  struct parameters {
    BOOST_HANA_DEFINE_STRUCT(parameters,
                             (cca::bounded<double, 0.1, 5>, frequency),
                             (cca::quantity<cca::angle, -0.9, 0.9>, offset),
                             (terrain, ground),
                             (bool, reversed),
                             (std::uint8_t, legs),
                             (three, gains),
                             (cca::text<8>, name),
                             (range, swing),
                             (Eigen::Matrix2d, mixing));
  };
  parameters p{
      1.5, 0.0, terrain::flat, false, 4, {1, 2, 3}, "trot", {-0.2, 0.2}, Eigen::Matrix2d::Identity()};
  auto process() -> cca::out<"y", reading> { return static_cast<double>(p.frequency); }
  void on_save() { ++saves; }
  int saves = 0;
};
struct inner : cca::graph<cca::node<"ode", oscillator>, cca::expose<"ode.y", "y">> {};
struct both : cca::graph<cca::rate<1000>,
                         cca::node<"cpg", oscillator>,
                         cca::node<"dmp", inner>,
                         cca::observe<"cpg.y">,
                         cca::observe<"dmp.ode.y">> {};

template <class F>
std::string words_of(F f) {
  try {
    f();
  } catch (const cca::refused& refusal) { return refusal.what(); }
  return {};
}

}  // namespace

TEST_SUITE("parameters by path") {
  TEST_CASE("each kind can be set and read") {
    cca::controller<both> c;
    auto& p = c.get<"cpg">().p;
    const std::string path = "cpg.frequency";
    c.set(path, 2.5);
    CHECK_EQ(p.frequency, 2.5);
    CHECK_EQ(c.parameter(path), "2.5");
    CHECK_EQ(c.parameter<double>(path), 2.5);
    c.set(path, 2);
    CHECK_EQ(p.frequency, 2.0);
    c.set("cpg.offset", "30 deg");
    CHECK_EQ(c.parameter<double>("cpg.offset"), doctest::Approx(cca::pi / 6));
    c.set("cpg.ground", "slope");
    CHECK_EQ(c.parameter("cpg.ground"), "\"slope\"");
    c.set("cpg.reversed", true);
    CHECK(c.parameter<bool>("cpg.reversed"));
    c.set("cpg.legs", 6);
    CHECK_EQ(c.parameter<int>("cpg.legs"), 6);
    CHECK_EQ(c.parameter<double>("cpg.legs"), 6);
    c.set("cpg.gains", std::vector{4.0, 5.0, 6.0});
    c.set("cpg.gains[1]", 7.5);
    CHECK_EQ(p.gains, three{4, 7.5, 6});
    CHECK_EQ(c.parameter("cpg.gains"), "[4.0, 7.5, 6.0]");
    c.set("cpg.mixing", std::array{std::array{1.0, 2.0}, std::array{3.0, 4.0}});
    CHECK_EQ(c.parameter("cpg.mixing"), "[[1.0, 2.0], [3.0, 4.0]]");
    c.set("cpg.name", std::string("walk"));
    CHECK_EQ(p.name.view(), "walk");
    c.set("dmp.ode.swing.high", 0.7);
    CHECK_EQ(c.parameter<double>("dmp.ode.swing.high"), 0.7);
    CHECK_EQ(p.swing.high, 0.2);
    CHECK_EQ(c.parameter_paths().size(), 20);
    CHECK_EQ(c.parameter_paths()[17], "dmp.ode.swing.low");
  }

  TEST_CASE("what can't be set is refused in words, and nothing changes") {
    cca::controller<both> c;
    const auto refusal = [&](const char* path, const auto& value) {
      return words_of([&] { c.set(path, value); });
    };
    CHECK_EQ(refusal("cpg.frequncy", 2.0),
             "cca::controller: set: cpg.frequncy: unknown parameter, did you mean `cpg.frequency`?");
    CHECK_EQ(refusal("cgp.frequency", 2.0),
             "cca::controller: set: cgp.frequency: unknown parameter, did you mean `cpg.frequency`?");
    CHECK_EQ(refusal("cpg.frequency", 9.0),
             "cca::controller: set: cpg.frequency: 9 is out of range, expected 0.1 to 5");
    CHECK_EQ(
        refusal("cpg.frequency", "fast"),
        "cca::controller: set: cpg.frequency: expected a number, got a string \"fast\"; for example `1.5`");
    CHECK_EQ(
        refusal("cpg.offset", "60 deg"),
        "cca::controller: set: cpg.offset: 60 deg (1.0471975511965976 rad) is out of range, expected -0.9 to "
        "0.9 rad");
    CHECK_EQ(refusal("cpg.ground", "mud"),
             "cca::controller: set: cpg.ground: unknown name \"mud\", expected flat or slope");
    CHECK_EQ(refusal("cpg.swing.low", 0.3), "cca::controller: set: cpg.swing: low must be below high");
    for (const char* path : {"", "cpg", "cpg.", "cpg.gains[3]", "cpg.gains[]", "cpg.gains[x]", "cpg.gains[1",
                             "cpg.frequency.x", "cpg.frequency[0]", "cpgfrequency", "cpg.swing.lo"})
      CHECK_NE(refusal(path, 1.0).find("unknown parameter"), std::string::npos);
    CHECK_EQ(words_of([&] { c.parameter<bool>("cpg.frequency"); }),
             "cca::controller: parameter: cpg.frequency: is 1.5, not true or false");
    CHECK_EQ(words_of([&] { c.parameter<double>("cpg.name"); }),
             "cca::controller: parameter: cpg.name: is \"trot\", not a number");
    CHECK_EQ(c.parameter<double>("cpg.frequency"), 1.5);
    CHECK_EQ(c.parameter<double>("cpg.swing.low"), -0.2);
  }

  TEST_CASE("tuned parameters can be saved while the controller is started, and in a run") {
    const laws::temporary_file file("by_path.toml");
    cca::controller<both> c;
    CHECK_EQ(words_of([&] { c.save(file.path); }),
             "cca::controller: save(file) is refused in the state `created`: load() it first");
    c.load();
    c.start();
    c.set("cpg.frequency", 2.0);
    c.save(file.path);
    CHECK_EQ(c.state(), cca::state::started);
    CHECK_EQ(c.get<"cpg">().saves, 0);
    CHECK_NE(file.text().find("[cpg]\nfrequency = 2.0"), std::string::npos);
    c.run(cca::for_beats<3>{}, {}, [&](auto& running) {
      running.set("cpg.frequency", 3.0);
      running.save(file.path);
      CHECK_EQ(running.state(), cca::state::running);
    });
    CHECK_NE(file.text().find("[cpg]\nfrequency = 3.0"), std::string::npos);
    c.stop();
    c.save(file.path);
    CHECK_EQ(c.state(), cca::state::created);
    CHECK_EQ(c.get<"cpg">().saves, 1);
    cca::controller<both> next;
    next.load(file.path);
    CHECK_EQ(next.parameter<double>("cpg.frequency"), 3.0);
  }
}
