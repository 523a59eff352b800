// Publishers and subscribers as nodes of a graph.
#include <doctest/doctest.h>

#include <cstddef>
#include <cstdint>
#include <tuple>
#include <string>

#include "spaces.hpp"

using namespace ros2_test;

namespace laws {
std::size_t allocations_of_this_thread();
}

namespace {

using only_angles = cca::ros2::joint_state<leg_angles>;

struct swing {
  auto process(cca::beat now) -> cca::maybe<"angles", leg_angles> {
    if (now.index() < 3) return {};
    return Eigen::Vector2d(0.5, -1.0 - 1e-4 * static_cast<double>(now.index() % 100));
  }
};
struct ear {
  int count = 0;
  void process(const cca::in<"angles", leg_angles>&) { ++count; }
};

// What a robot over ROS 2 is commanded, and hears.
struct both : cca::graph<cca::rate<1000>,
                         cca::node<"swing", swing>,
                         cca::node<"limits", cca::limiter<leg_angles>>,
                         cca::node<"leg", cca::ros2::command_publisher<"cca/command", only_angles>>,
                         cca::node<"heard", cca::ros2::subscriber<"cca/command", only_angles>>,
                         cca::node<"ear", ear>,
                         cca::wire<"swing.angles", "limits.command">,
                         cca::wire<"limits.safe", "leg.position">,
                         cca::wire<"heard.position", "ear.angles">> {};

struct unlimited : cca::graph<cca::rate<1000>,
                              cca::node<"swing", swing>,
                              cca::node<"leg", cca::ros2::command_publisher<"cca/command", only_angles>>,
                              cca::wire<"swing.angles", "leg.position">> {};
struct watched : cca::graph<cca::rate<1000>,
                            cca::node<"swing", swing>,
                            cca::node<"states", cca::ros2::publisher<"cca/states", only_angles>>,
                            cca::wire<"swing.angles", "states.position">> {};
// Two tell of frames on one topic, as on "tf": the other one in each beat, ours if it is told to.
struct two_places {
  bool trunk = false;
  auto process() -> std::tuple<cca::maybe<"trunk", place>, cca::out<"other", place>> {
    numbers_of<places> at;
    at << 1, 2, 3, 0, 0, 0, 1;
    if (trunk) return {at, at};
    return {cca::maybe<"trunk", place>(), at};
  }
};
struct crowded
    : cca::graph<cca::rate<1000>,
                 cca::node<"where", two_places>,
                 cca::node<"ours", cca::ros2::publisher<"cca/crowd", tree>>,
                 cca::node<"others", cca::ros2::publisher<"cca/crowd", cca::ros2::tf<place, "other">>>,
                 cca::node<"heard", cca::ros2::subscriber<"cca/crowd", tree>>,
                 cca::wire<"where.trunk", "ours.transform">,
                 cca::wire<"where.other", "others.transform">> {};

struct place_ear {
  int count = 0;
  void process(const cca::in<"place", place>&) { ++count; }
};
struct told_once {
  auto process(cca::beat now) -> cca::maybe<"place", place> {
    if (now.index() != 3) return {};
    numbers_of<places> at;
    at << 1, 2, 3, 0, 0, 0, 1;
    return at;
  }
};
struct tells_once
    : cca::graph<cca::rate<1000>,
                 cca::node<"where", told_once>,
                 cca::node<"tell", cca::ros2::publisher<"/cca/static", tree, cca::ros2::transient_local>>,
                 cca::wire<"where.place", "tell.transform">> {};
struct hears_late
    : cca::graph<cca::rate<1000>,
                 cca::node<"heard", cca::ros2::subscriber<"cca/static", tree, cca::ros2::transient_local>>,
                 cca::node<"ear", place_ear>,
                 cca::wire<"heard.transform", "ear.place">> {};

using cca::ros2::detail::names_a_topic;
static_assert(names_a_topic("joint_states") && names_a_topic("/joint_states") && names_a_topic("a/_b2/c"));
static_assert(!names_a_topic("") && !names_a_topic("/") && !names_a_topic("a/") && !names_a_topic("a//b"));
static_assert(!names_a_topic("2a") && !names_a_topic("a/2b") && !names_a_topic("a.b") &&
              !names_a_topic("~/a"));

static_assert(cca::diagnosis<unlimited>.rule == "robot.unlimited_command");
static_assert(cca::well_formed<watched>);

}  // namespace

TEST_SUITE("ros 2 nodes") {
  TEST_CASE("a beat allocates nothing, and nothing is sent before there is a sample") {
    use_own_domain();
    cca::controller<both> c;
    c.load();
    c.start();
    const auto before = laws::allocations_of_this_thread();
    for (int i = 0; i < 3; ++i) c.step();
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    CHECK_EQ(c.get<"leg">().sent(), 0);
    CHECK(within_seconds(20, [&] {
      c.step();
      return c.get<"ear">().count > 100;
    }));
    CHECK_EQ(laws::allocations_of_this_thread(), before);
    CHECK_EQ(c.get<"heard">().refused(), 0);
    CHECK_GE(c.get<"leg">().sent(), c.get<"heard">().received());
  }

  TEST_CASE("a copy of a controller neither sends nor receives") {
    use_own_domain();
    cca::controller<both> c;
    c.load();
    c.start();
    cca::controller<both> copy = c;
    for (int i = 0; i < 100; ++i) copy.step();
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
    CHECK_EQ(c.get<"leg">().sent(), 0);
    CHECK_EQ(copy.get<"leg">().sent(), 0);
    CHECK_EQ(copy.get<"heard">().received(), 0);
    c = copy;  // goes on where the copy is, with its own connection
    CHECK(within_seconds(20, [&] {
      c.step();
      return c.get<"ear">().count > 0;
    }));
  }

  TEST_CASE("messages that nobody sends in time are dropped and counted") {
    use_own_domain();
    cca::controller<both> c;
    c.load();
    c.start();
    for (int i = 0; i < 200'000; ++i) c.step();  // much faster than a thread can send
    CHECK(within_seconds(20, [&] { return c.get<"leg">().sent() + c.get<"leg">().dropped() == 199'997; }));
    CHECK_GT(c.get<"leg">().dropped(), 0);
  }

  // Whoever publishes on "tf" uses the same instance of the topic, so a burst of others must not displace
  // ours.
  TEST_CASE("on a topic of many a message is not displaced by those of others") {
    use_own_domain();
    cca::controller<crowded> c;
    c.load();
    c.start();
    c.get<"where">().trunk = true;
    CHECK(within_seconds(20, [&] {
      c.step();
      return c.get<"heard">().received() > 0;
    }));
    const std::int64_t before = c.get<"heard">().received();
    for (int i = 0; i < 60; ++i) {
      c.get<"where">().trunk = i == 0;
      c.step();
    }
    CHECK(within_seconds(20, [&] { return c.get<"others">().sent() >= 60; }));
    CHECK(within_seconds(5, [&] { return c.get<"heard">().received() > before; }));
    CHECK_EQ(c.get<"others">().dropped(), 0);
  }

  TEST_CASE("what was told once is heard by who comes later, and does not age") {
    use_own_domain();
    cca::controller<tells_once> c;
    c.load();
    c.start();
    for (int i = 0; i < 10; ++i) c.step();
    cca::controller<hears_late> late;
    late.load();
    CHECK(within_seconds(20, [&] { return late.get<"heard">().received() == 1; }));
    std::this_thread::sleep_for(std::chrono::milliseconds(150));  // an other message would be dropped
    late.start();
    late.step();
    CHECK_EQ(late.get<"ear">().count, 1);
    CHECK_EQ(late.get<"heard">().too_late(), 0);
  }

  TEST_CASE("a domain that is no number is refused") {
    ::setenv("ROS_DOMAIN_ID", "seven", 1);
    cca::controller<watched> c;
    CHECK_THROWS_WITH_AS(c.load(), "cca::ros2: ROS_DOMAIN_ID is `seven`: it must be a number, 0 to 230",
                         cca::refused);
  }
}
