// Pictures of sets of modes, and of deployments of them, compared exactly.
#include <doctest/doctest.h>

#include <string_view>

#include <cca/deployment.hpp>
#include <cca/modes.hpp>

#include "../picture.hpp"
#include "described.hpp"

using namespace core_test;

namespace {

struct rough : cca::graph<cca::node<"joint", joint>,
                          cca::node<"filter", filter>,
                          cca::wire<"joint.angle", "filter.raw", cca::delayed<1>>> {};
struct smooth : cca::graph<cca::node<"joint", joint>,
                           cca::node<"both", smoothing>,
                           cca::wire<"joint.angle", "both.angle">> {};

// [describe]
struct ways : cca::modes<cca::mode<"rough", rough>, cca::mode<"smooth", smooth>> {};

struct spread : cca::deployment<ways,
                                cca::environment<"robot", cca::nodes<"joint", "both">>,
                                cca::environment<"mind", cca::other_nodes>> {};
// [describe end]

constexpr std::string_view of_modes = R"(flowchart LR
  subgraph m0["<b>rough</b>"]
    m0_n0[("joint<br/><i>1000 Hz</i>")]
    m0_n1["filter<br/><i>1000 Hz</i>"]
    m0_n0 -. "angle → raw<br/>angle_of_joint, 1000 Hz<br/>delayed 1" .-> m0_n1
  end
  subgraph m1["<b>smooth</b>"]
    m1_n0[("joint<br/><i>1000 Hz</i>")]
    subgraph m1_g1["both"]
      m1_n1["first<br/><i>1000 Hz</i>"]
      m1_n2["second<br/><i>1000 Hz</i>"]
    end
    m1_n0 -- "angle → raw<br/>angle_of_joint, 1000 Hz" --> m1_n1
    m1_n1 -. "smooth → raw<br/>angle_of_joint, 1000 Hz<br/>delayed 2" .-> m1_n2
  end
)";

constexpr std::string_view picture = R"(// [picture]
flowchart LR
  subgraph m0["<b>rough</b>"]
    subgraph m0_e0["<b>robot</b>"]
      m0_n0[("joint<br/><i>1000 Hz</i>")]
    end
    subgraph m0_e1["<b>mind</b>"]
      m0_n1["filter<br/><i>1000 Hz</i>"]
    end
    m0_n0 -. "angle → raw<br/>angle_of_joint, 1000 Hz<br/>memory, delayed 1" .-> m0_n1
  end
  subgraph m1["<b>smooth</b>"]
    subgraph m1_e0["<b>robot</b>"]
      m1_n0[("joint<br/><i>1000 Hz</i>")]
      subgraph m1_g1["both"]
        m1_n1["first<br/><i>1000 Hz</i>"]
        m1_n2["second<br/><i>1000 Hz</i>"]
      end
    end
    m1_n0 -- "angle → raw<br/>angle_of_joint, 1000 Hz" --> m1_n1
    m1_n1 -. "smooth → raw<br/>angle_of_joint, 1000 Hz<br/>delayed 2" .-> m1_n2
  end
)";  // [picture end]

constexpr std::string_view drawing = R"(digraph "spread" {
  rankdir=LR;
  node [shape=box, style=rounded, fontname="sans-serif"];
  edge [fontname="sans-serif", fontsize=10];
  subgraph cluster_m0 {
    label="rough";
    style=bold;
    subgraph cluster_m0_e0 {
      label="robot";
      style=bold;
      m0_n0 [label="joint\n1000 Hz", shape=cylinder];
    }
    subgraph cluster_m0_e1 {
      label="mind";
      style=bold;
      m0_n1 [label="filter\n1000 Hz"];
    }
    m0_n0 -> m0_n1 [label="angle → raw\nangle_of_joint, 1000 Hz\nmemory, delayed 1", style=dashed];
  }
)";

}  // namespace

TEST_SUITE("describe a set of modes") {
  TEST_CASE("each mode is a box") { CHECK_EQ(cca::describe<ways>::mermaid(), of_modes); }
  TEST_CASE("in it the environments of a deployment are boxes, too") {
    static_assert(cca::well_formed<spread>);
    test::check_picture<spread>(picture);
    CHECK(cca::describe<spread>::mermaid("DDS").find("DDS, delayed 1") != std::string::npos);
    CHECK_EQ(cca::describe<spread>::dot().substr(0, drawing.size()), drawing);
  }
}
