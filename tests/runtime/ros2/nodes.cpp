// Publishers and subscribers as nodes of a graph.
#include <doctest/doctest.h>

#include <cstddef>
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

  TEST_CASE("a domain that is no number is refused") {
    ::setenv("ROS_DOMAIN_ID", "seven", 1);
    cca::controller<watched> c;
    CHECK_THROWS_WITH_AS(c.load(), "cca::ros2: ROS_DOMAIN_ID is `seven`: it must be a number, 0 to 230",
                         cca::refused);
  }
}
