// Publishers and subscribers of spaces as nodes of a graph.
#include <doctest/doctest.h>

#include <cstddef>
#include <string>

#include <cca/robot/limiter.hpp>
#include <cca/robot/watchdog.hpp>

#include "spaces.hpp"

using namespace talk;

namespace twins {
struct leg : cca::space<cca::number, cca::axes<cca::x>> {};
struct Leg : cca::space<cca::number, cca::axes<cca::x>> {};
namespace a_b {
struct c : cca::space<cca::number, cca::axes<cca::x>> {};
}  // namespace a_b
namespace a {
struct b_c : cca::space<cca::number, cca::axes<cca::x>> {};
}  // namespace a
}  // namespace twins

namespace laws {
std::size_t allocations_of_this_thread();
}

namespace talk {

namespace left {
struct leg {};
}  // namespace left
namespace right {
struct leg {};
}  // namespace right
template <class Leg, int Direction>
struct turned : cca::space<cca::number, cca::axes<cca::x>> {};
template <cca::fixed_string Name>
struct named : cca::space<cca::number, cca::axes<cca::x>> {};
template <class Leg>
struct of_leg {
  struct angles : cca::space<cca::number, cca::axes<cca::x>> {};
};

}  // namespace talk

namespace {

struct swing {
  auto process(cca::beat now) -> cca::maybe<"angles", leg_angles> {
    if (now.index() < 3) return {};
    return Eigen::Vector2d(0.5, -1.0 - 1e-4 * static_cast<double>(now.index() % 100));
  }
};
struct leg_on_bus {
  auto sense() -> cca::out<"angles", leg_angles> { return Eigen::Vector2d(0.5, -1); }
};

// A command goes out and comes back, each time through a limiter.
struct both : cca::graph<cca::rate<1000>,
                         cca::node<"swing", swing>,
                         cca::node<"limits", cca::limiter<leg_angles>>,
                         cca::node<"leg", cca::dds::command_publisher<leg_angles>>,
                         cca::node<"heard", cca::dds::subscriber<leg_angles>>,
                         cca::node<"here", recorder<leg_angles>>,
                         cca::wire<"swing.angles", "limits.command">,
                         cca::wire<"limits.safe", "leg.sample">,
                         cca::wire<"heard.sample", "here.value">> {};

// A measured angle is no command, so others may watch it.
// [watched]
struct watched : cca::graph<cca::rate<1000>,
                            cca::node<"leg", leg_on_bus>,
                            cca::node<"tell", cca::dds::publisher<leg_angles>>,
                            cca::wire<"leg.angles", "tell.sample">> {};
// [watched end]
struct unlimited : cca::graph<cca::rate<1000>,
                              cca::node<"swing", swing>,
                              cca::node<"leg", cca::dds::command_publisher<leg_angles>>,
                              cca::wire<"swing.angles", "leg.sample">> {};
// What comes from outside is no more than a wish.
struct obeyed : cca::graph<cca::rate<1000>,
                           cca::node<"wish", cca::dds::subscriber<leg_angles>>,
                           cca::node<"leg", cca::dds::command_publisher<leg_angles, "other">>,
                           cca::wire<"wish.sample", "leg.sample">> {};
static_assert(cca::well_formed<watched>);
static_assert(cca::diagnosis<unlimited>.rule == "robot.unlimited_command");
static_assert(cca::diagnosis<obeyed>.rule == "robot.unlimited_command");
static_assert(cca::ResourceNode<cca::dds::publisher<leg_angles>>);
static_assert(cca::ResourceNode<cca::dds::command_publisher<leg_angles>>);
static_assert(cca::ResourceNode<cca::dds::subscriber<leg_angles>>);

// [guarded]
struct guarded : cca::graph<cca::rate<1000>,
                            cca::node<"wish", cca::dds::subscriber<leg_angles, "cca/said">>,
                            cca::node<"watchdog", cca::watchdog<leg_angles, 200>>,  // 0.2 s
                            cca::node<"limits", cca::limiter<leg_angles>>,
                            cca::node<"leg", cca::dds::command_publisher<leg_angles, "cca/safe">>,
                            cca::wire<"wish.sample", "watchdog.command">,
                            cca::wire<"watchdog.fresh", "limits.command">,
                            cca::wire<"limits.safe", "leg.sample">> {};
// [guarded end]

template <class C>
void use_own_domain(C& c) {
  c.template get<"leg">().p.domain = c.template get<"heard">().p.domain = domain();
}

}  // namespace

TEST_SUITE("spaces as nodes") {
  TEST_CASE("a beat allocates nothing, and nothing is sent before there is a sample") {
    cca::controller<both> c;
    use_own_domain(c);
    c.load();
    c.start();
    const auto before = laws::allocations_of_this_thread();
    for (int i = 0; i < 3; ++i) c.step();
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    CHECK_EQ(c.get<"leg">().sent(), 0);
    CHECK(within_seconds(20, [&] {
      c.step();
      return c.get<"here">().count > 100;
    }));
    CHECK_EQ(laws::allocations_of_this_thread(), before);
    CHECK_EQ(c.get<"heard">().refused(), 0);
    CHECK_GE(c.get<"leg">().sent(), c.get<"heard">().received());
    CHECK_EQ(c.get<"here">().age, 0);  // it originated in the beat in which it was sent
  }

  TEST_CASE("a copy of a controller neither sends nor receives") {
    cca::controller<both> c;
    use_own_domain(c);
    c.load();
    c.start();
    cca::controller<both> copy = c;
    for (int i = 0; i < 100; ++i) copy.step();
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
    CHECK_EQ(copy.get<"leg">().sent(), 0);
    CHECK_EQ(copy.get<"heard">().received(), 0);
    CHECK_EQ(c.get<"leg">().sent(), 0);
  }

  TEST_CASE("data that was old when it was sent is stale, however often it comes") {
    const auto other = peer("tell", "leg_angles");  // 0.25 s old, fifty times a second
    cca::controller<guarded> c;
    c.get<"wish">().p.domain = c.get<"leg">().p.domain = domain();
    c.load();
    c.start();
    REQUIRE(within_seconds(20, [&] { return c.get<"wish">().received() > 2; }));
    int beats = 0;
    while (c.step() && beats < 100) ++beats;  // the first of them takes a sample
    CHECK_EQ(std::string(c.fault().reason()), "stale command");
    CHECK_LT(beats, 2);
  }
}

TEST_SUITE("idl") {
  TEST_CASE("names, units, limits and the number of a space") {
    const std::string text = cca::idl<leg_angles>();
    CAPTURE(text);
    CHECK(text.find("// leg_angles: joint_angles, 1000 Hz; topic \"talk/leg_angles\", if the node names no "
                    "other\n") != text.npos);
    CHECK(text.find("  @final struct talk_leg_angles_sample {\n") != text.npos);
    CHECK(text.find("    double hip_;  // rad, -1 to 1\n    double knee_;  // rad, -2 to 0\n") != text.npos);
    CHECK(text.find("const long long talk_leg_angles_space = " +
                    std::to_string(cca::schema_of<leg_angles>.hash() >> 1)) != text.npos);
  }
  // Samples of two spaces must not meet on one topic: a command of the left leg is none of the right one.
  TEST_CASE("spaces of templates have the names of their arguments, with namespaces and signs") {
    using namespace cca::dds::detail;
    CHECK_EQ(topic_of_space<turned<left::leg, 1>>(), "talk/turned_talk_left_leg_1");
    CHECK_EQ(topic_of_space<turned<right::leg, 1>>(), "talk/turned_talk_right_leg_1");
    CHECK_EQ(topic_of_space<turned<right::leg, -1>>(), "talk/turned_talk_right_leg_minus_1");
    CHECK_EQ(topic_of_space<named<"left">>(), "talk/named_left");
    CHECK_EQ(topic_of_space<of_leg<left::leg>::angles>(), "talk/of_leg_talk_left_leg/angles");
    CHECK_EQ(type_in_dds<of_leg<left::leg>::angles>(), "cca::talk_of_leg_talk_left_leg_angles_sample");
  }
  TEST_CASE("words of IDL, digits, names that differ only in case, and many numbers") {
    CHECK(cca::idl<any>().find("    double in_;\n    double octet_;\n    double c3rd_;\n") !=
          std::string::npos);
    CHECK(cca::idl<pads>().find("    // 0: pad\n    // 1: PAD\n    double values[2];\n") !=
          std::string::npos);
    CHECK(cca::idl<paws>().find("    double values[14];\n") != std::string::npos);
    CHECK(cca::idl<picture>().find("    double values[9216];\n") != std::string::npos);
  }
  TEST_CASE("a space stands there once, and two of one name are refused") {
    CHECK_EQ(cca::idl<leg_angles, any, leg_angles>(), cca::idl<leg_angles, any>());
    const auto refusal = [](auto write) -> std::string {
      try {
        write();
      } catch (const cca::refused& e) { return e.what(); }
      return "";
    };
    CHECK_EQ(
        refusal([] { (void)cca::idl<twins::leg, twins::Leg>(); }),
        "cca::idl: `twins::leg` and `twins::Leg` have one name in IDL, `twins_Leg_sample`: write them into "
        "two files, or rename one");
    CHECK_NE(refusal([] { (void)cca::idl<twins::a_b::c, twins::a::b_c>(); }), "");
  }
}
