// What a program says before a run and after it: its parameters, its outputs, what stopped it, what was
// limited.
#include <doctest/doctest.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include <unistd.h>

#include <cca/cca.hpp>
#include <cca/main.hpp>

#include "../deployment/robot_and_mind.hpp"
#include "../../laws/temporary_file.hpp"
#include "child.hpp"

using namespace deployment_test;
using programs_test::child;

namespace {

using file = laws::temporary_file;

// ---- a graph with all kinds of parameters, which its program changes before files are read ----

struct hip : cca::dimension<"hip"> {
  static constexpr auto limits = cca::limits{cca::angle{-0.5, 0.5}, cca::velocity{-2, 2}};
};
struct knee : cca::dimension<"knee"> {
  static constexpr auto limits = cca::limits{cca::angle{-1.8, 0.0}, cca::velocity{-2, 2}};
};
struct leg_angles : cca::space<cca::joint_angles, cca::axes<hip, knee>, cca::rate<1000>> {};

enum class ground { flat, slope };
struct wave {
  struct inner {
    BOOST_HANA_DEFINE_STRUCT(inner, (bool, is_on), (cca::text<12>, name));
  };
  struct parameters {
    BOOST_HANA_DEFINE_STRUCT(parameters,
                             (double, height),
                             (cca::bounded<double, 0.1, 5>, frequency),
                             (cca::quantity<cca::angle, -0.9, 0.9>, offset),
                             (ground, below),
                             (Eigen::Vector2d, weights),
                             (std::array<int, 3>, steps),
                             (inner, more));
  };
  parameters p{1.0 / 3, 0.7, 0.1, ground::slope, {0.1, 2.0 / 3}, {1, -2, 3}, {true, "a \"b\""}};
  auto process(cca::beat now) -> cca::out<"angles", leg_angles> {
    return Eigen::Vector2d(now.index() < 5 ? 0.1 : p.height, -0.5);
  }
};
// Hears nothing from beat 20 on, and says so.
struct deaf_leg {
  std::int64_t silent_since = -1, last_beat = 0;
  auto sense(cca::beat now) -> cca::maybe<"angles", leg_angles> {
    if (now.index() < 20) return Eigen::Vector2d(0, -0.5);
    if (silent_since < 0) silent_since = now.index();
    return {};
  }
  void act(cca::in<"command", leg_angles>) {}
  cca::cause cause() const {
    if (silent_since < 0) return {};
    return {"the drive of `knee` is silent", silent_since};
  }
};
struct follows {
  auto process(cca::in<"measured", leg_angles>, cca::in<"wanted", leg_angles> wanted)
      -> cca::out<"angles", leg_angles> {
    return wanted;
  }
};
struct leg : cca::graph<cca::rate<1000>,
                        cca::node<"wave", wave>,
                        cca::node<"follows", follows>,
                        cca::node<"watchdog", cca::watchdog<leg_angles, 5>>,
                        cca::node<"limits", cca::limiter<leg_angles>>,
                        cca::node<"robot", deaf_leg>,
                        cca::wire<"robot.angles", "follows.measured">,
                        cca::wire<"wave.angles", "follows.wanted">,
                        cca::wire<"follows.angles", "watchdog.command">,
                        cca::wire<"watchdog.fresh", "limits.command">,
                        cca::wire<"limits.safe", "robot.command">> {};

struct walking : cca::robot_program<leg> {
  walking() { settings.speed.reset(), settings.seconds = 0.1; }
  void prepare(controller_type& c) override { c.get<"wave">().p.frequency = 0.9; }
  void loaded(controller_type&) override { std::printf("loaded;"); }
};

// ---- outputs of many numbers, with and without names ----

struct legs : cca::array_of<leg_angles, 9> {};  // 18 axes
struct ground_frame : cca::frame<"ground"> {};
struct hand : cca::space<cca::pose<ground_frame>, cca::axes<cca::x, cca::y, cca::z>> {};
struct covariance_of {  // a domain type that names no number
  using quantity = cca::angle;
  static constexpr bool actuated = false;
  static constexpr int width(int axes) { return axes * axes; }
  static constexpr double zero(int, int) { return 0; }
  template <class Self>
  struct methods {};
};
struct covariance : cca::space<covariance_of, cca::axes<hip, knee>> {};
template <class Space>
struct shows {
  auto process(cca::beat) -> cca::out<"all", Space> {
    return typename Space::vector_type(Space::vector_type::Zero());
  }
};
struct wide : cca::graph<cca::rate<1000>,
                         cca::node<"legs", shows<legs>>,
                         cca::node<"hand", shows<hand>>,
                         cca::node<"errors", shows<covariance>>> {};

// A busy machine is no lost contact here.
struct patient : cca::deployment<architecture,
                                 cca::environment<"robot", cca::nodes<"device", "filter", "guard">>,
                                 cca::environment<"mind", cca::other_nodes>,
                                 cca::tolerate<100'000>> {};

}  // namespace

TEST_CASE("written parameters are those of a run, and load again unchanged") {
  const file written("a.toml"), again("b.toml"), own("own.toml", "[wave]\nheight = 0.125\n");
  child first(cca::robot_main<walking>, {"--config", own.path, "--write-parameters", written.path});
  CHECK(first.code() == 0);
  CHECK(first.out == "");
  CHECK(first.err == "");
  const std::string text = written.text();
  CHECK(text.find("height = 0.125\n") != text.npos);             // of the file
  CHECK(text.find("frequency = 0.9  # 0.1 to 5") != text.npos);  // of `prepare`
  CHECK(text.find("offset = \"0.1 rad\"  # -0.9 to 0.9 rad") != text.npos);
  CHECK(text.find("below = \"slope\"  # flat or slope") != text.npos);
  child second(cca::robot_main<walking>, {"--config", written.path, "--write-parameters", again.path});
  CHECK(second.code() == 0);
  CHECK(again.text() == text);

  child two(cca::robot_main<patient>, {"--write-parameters", written.path});  // a deployment
  CHECK(two.code() == 0);
  CHECK(written.text().find("[filter]\ngain = 0.1") != text.npos);
  child read(cca::robot_main<patient>, {"--config", written.path, "--seconds", "0.01", "--pace", "fast"});
  CHECK(read.code() == 0);
}

TEST_CASE("what can't be written or read leaves the file as it was") {
  const file written("c.toml", "old"), wrong("wrong.toml", "[wave]\nheigt = 1\n");
  child bad(cca::robot_main<walking>, {"--config", wrong.path, "--write-parameters", written.path});
  CHECK(bad.code() == 2);
  CHECK(bad.err.find("did you mean `height`?") != std::string::npos);
  CHECK(written.text() == "old");
  child none(cca::robot_main<walking>, {"--write-parameters", "/none/a.toml"});
  CHECK(none.code() == 2);
  child both(cca::robot_main<walking>, {"--list", "--write-parameters", written.path});
  CHECK(both.code() == 2);
  CHECK(both.err.find("take one of them") != std::string::npos);
}

TEST_CASE("all outputs are listed, with space, unit and rate") {
  child one(cca::robot_main<walking>, {"--list"});
  CHECK(one.code() == 0);
  std::istringstream lines(one.out);
  std::string line, name, space, unit, rate, hz, axes;
  int count = 0;
  while (std::getline(lines, line)) ++count;
  CHECK(count == 6);  // the heading, and five outputs
  lines = std::istringstream(one.out.substr(one.out.find("limits.safe")));
  lines >> name >> space >> unit >> rate >> hz >> axes;
  CHECK(name == "limits.safe");
  CHECK(space.find("leg_angles") != space.npos);
  CHECK(unit + " " + rate + " " + hz + " " + axes == "rad 1000 Hz hip");
  CHECK(child(cca::robot_main<two>, {"--list"}).code() == 0);
}

TEST_CASE("of many numbers the first are named and the others counted - those without names are counted") {
  child one(
      [](int count, char** words) {
        cca::command_line line("shows");
        cca::offer_descriptions<cca::controller<wide>>(line);
        return cca::run_program(count, words, line, [] { return 0; });
      },
      {"--list"});
  CHECK(one.code() == 0);
  const auto row = [&](const std::string& output) {
    const std::size_t from = one.out.find("\n" + output) + 1;
    return one.out.substr(from, one.out.find('\n', from) - from);
  };
  CHECK(row("legs.all")
            .ends_with("  hip0 knee0 hip1 knee1 hip2 knee2 hip3 knee3 hip4 knee4 hip5 knee5 hip6 knee6 "
                       "hip7 knee7 and 2 more"));
  CHECK(row("hand.all").ends_with("  x y z qx qy qz qw"));
  CHECK(row("hand.all").find("  m m m 1 1 1 1  ") != std::string::npos);
  CHECK(row("errors.all").ends_with("  4 numbers"));
}

TEST_CASE("the first cause is told first, and what was limited") {
  child one(cca::robot_main<walking>, {});
  CHECK(one.code() == 1);
  const std::string first = "walk: `robot`, after 0.020 s: the drive of `knee` is silent\n";
  CHECK(one.err.starts_with(first));
  CHECK(one.err.substr(first.size())
            .starts_with("walk: fault in `watchdog.watch`, after 0.026 s: stale command: the oldest data of "
                         "the command is 0.006 s old, 0.005 s are allowed: "));
  CHECK_EQ(one.out, "loaded;`limits`: 20 numbers limited; the first: `hip` in beat 5: its rate\n");
  child quiet(cca::robot_main<walking>, {"--quiet"});
  CHECK(quiet.code() == 1);
  CHECK(quiet.err == one.err);
  CHECK(quiet.out == "loaded;");
}

TEST_CASE("what did not happen is not told") {
  struct short_walk : walking {
    short_walk() { settings.seconds = 0.004; }
  };
  child one(cca::robot_main<short_walk>, {});
  CHECK(one.code() == 0);
  CHECK(one.err == "");
  CHECK(one.out == "loaded;");
}
