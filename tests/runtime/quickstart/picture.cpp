// The picture of the README's example, out of its program.
#include <string_view>

#include <doctest/doctest.h>

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wreturn-type"  // only of main
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

}  // namespace

TEST_CASE("the picture of the README's example") { test::check_picture<swinging>(picture); }
