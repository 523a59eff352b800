// What the README shows of its example comes from here: the picture, and the message of a wire to a wrong
// space.
#include <algorithm>
#include <string>
#include <string_view>

#include <doctest/doctest.h>

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wreturn-type"  // its main() is renamed
#define main quickstart
#include "../../../examples/quickstart/quickstart.cpp"
#undef main
#pragma GCC diagnostic pop

#include "../picture.hpp"

namespace {

constexpr std::string_view picture = R"(// [picture]
flowchart LR
  n0["swing<br/><i>1000 Hz</i>"]
  n1["limits<br/><i>1000 Hz</i>"]
  n2[("leg<br/><i>1000 Hz</i>")]
  n0 -- "angles → command<br/>leg_angles, 1000 Hz" --> n1
  n1 -- "safe → command<br/>leg_angles, 1000 Hz" --> n2
)";  // [picture end]

// A leg that expects its angles in the order knee, hip.
struct foot_angles : cca::space<cca::joint_angles, cca::axes<knee, hip>, cca::rate<1000>> {};
struct other_leg {
  void act(cca::in<"command", foot_angles>) {}
};
struct wrong : cca::graph<cca::node<"swing", swing>,
                          cca::node<"limits", cca::limiter<leg_angles>>,
                          cca::node<"leg", other_leg>,
                          cca::wire<"swing.angles", "limits.command">,
                          cca::wire<"limits.safe", "leg.command">> {};

constexpr std::string_view message = R"(// [message]
space.mismatch: `limits.safe` publishes leg_angles (joint_angles over hip, knee at 1000 Hz) but `leg.command` expects
foot_angles (joint_angles over knee, hip at 1000 Hz): the axes are in another order; give both ends one space
)";  // [message end]

}  // namespace

TEST_CASE("the picture of the README's example") { test::check_picture<swinging>(picture); }

TEST_CASE("the README's message") {
  std::string expected = test::on_page(message);
  expected.pop_back();
  std::replace(expected.begin(), expected.end(), '\n', ' ');
  CHECK_EQ(std::string(cca::diagnosis<wrong>.message), expected);
}
