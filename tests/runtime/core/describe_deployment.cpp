// Pictures of deployments, compared exactly.
#include <doctest/doctest.h>

#include <cca/deployment.hpp>

#include "../picture.hpp"
#include "described.hpp"

using namespace core_test;

namespace {

// [describe]
struct watched : cca::graph<cca::node<"joint", joint>,
                            cca::node<"near", smoothing>,
                            cca::node<"far", smoothing>,
                            cca::wire<"joint.angle", "near.angle">,
                            cca::wire<"joint.angle", "far.angle", cca::delayed<5>>> {};

struct spread : cca::deployment<watched,
                                cca::environment<"robot", cca::nodes<"joint", "near.first">>,
                                cca::environment<"watch", cca::other_nodes>> {};
// [describe end]

constexpr std::string_view picture = R"(// [picture]
flowchart LR
  subgraph e0["<b>robot</b>"]
    n0[("joint<br/><i>1000 Hz</i>")]
    n1["near.first<br/><i>1000 Hz</i>"]
  end
  subgraph e1["<b>watch</b>"]
    n2["near.second<br/><i>1000 Hz</i>"]
    subgraph g2["far"]
      n3["first<br/><i>1000 Hz</i>"]
      n4["second<br/><i>1000 Hz</i>"]
    end
  end
  n0 -- "angle → raw<br/>angle_of_joint, 1000 Hz" --> n1
  n1 -. "smooth → raw<br/>angle_of_joint, 1000 Hz<br/>memory, delayed 2" .-> n2
  n0 -. "angle → raw<br/>angle_of_joint, 1000 Hz<br/>memory, delayed 5" .-> n3
  n3 -. "smooth → raw<br/>angle_of_joint, 1000 Hz<br/>delayed 2" .-> n4
)";  // [picture end]

constexpr std::string_view drawing = R"(digraph "spread" {
  rankdir=LR;
  node [shape=box, style=rounded, fontname="sans-serif"];
  edge [fontname="sans-serif", fontsize=10];
  subgraph cluster_e0 {
    label="robot";
    style=bold;
    n0 [label="joint\n1000 Hz", shape=cylinder];
    n1 [label="near.first\n1000 Hz"];
  }
  subgraph cluster_e1 {
    label="watch";
    style=bold;
    n2 [label="near.second\n1000 Hz"];
    subgraph cluster_2 {
      label="far";
      n3 [label="first\n1000 Hz"];
      n4 [label="second\n1000 Hz"];
    }
  }
  n0 -> n1 [label="angle → raw\nangle_of_joint, 1000 Hz"];
  n1 -> n2 [label="smooth → raw\nangle_of_joint, 1000 Hz\nmemory, delayed 2", style=dashed];
  n0 -> n3 [label="angle → raw\nangle_of_joint, 1000 Hz\nmemory, delayed 5", style=dashed];
  n3 -> n4 [label="smooth → raw\nangle_of_joint, 1000 Hz\ndelayed 2", style=dashed];
}
)";

constexpr std::string_view boxes_of_cut_deep = R"(flowchart LR
  subgraph e0["<b>here</b>"]
    n0[("joint<br/><i>1000 Hz</i>")]
    n1["outer.one.first<br/><i>1000 Hz</i>"]
  end
  subgraph e1["<b>there</b>"]
    n2["outer.one.second<br/><i>1000 Hz</i>"]
    subgraph g3["outer.two"]
      n3["first<br/><i>1000 Hz</i>"]
      n4["second<br/><i>1000 Hz</i>"]
    end
  end
)";

constexpr std::string_view picture_of_unplaced = R"(flowchart LR
  n1[("loose<br/><i>1000 Hz</i>")]
  subgraph e0["<b>robot</b>"]
    n0[("joint<br/><i>1000 Hz</i>")]
  end
)";

// An inner graph of an inner graph that is cut.
struct pair_of_smoothing : cca::graph<cca::node<"one", smoothing>,
                                      cca::node<"two", smoothing>,
                                      cca::wire<"one.angle_out", "two.angle", cca::delayed<1>>,
                                      cca::expose<"one.angle", "angle">> {};
struct deep : cca::graph<cca::node<"joint", joint>,
                         cca::node<"outer", pair_of_smoothing>,
                         cca::wire<"joint.angle", "outer.angle">> {};
struct cut_deep : cca::deployment<deep,
                                  cca::environment<"here", cca::other_nodes>,
                                  cca::environment<"there", cca::nodes<"outer.one.second", "outer.two">>> {};

struct lonely : cca::graph<cca::node<"joint", joint>, cca::node<"loose", joint>> {};
struct unplaced : cca::deployment<lonely, cca::environment<"robot", cca::nodes<"joint">>> {};

}  // namespace

TEST_SUITE("describe a deployment") {
  TEST_CASE("mermaid: environments are boxes, wires between them have a transport") {
    static_assert(cca::well_formed<spread>);
    test::check_picture<spread>(picture);
  }

  TEST_CASE("dot") { CHECK_EQ(cca::describe<spread>::dot(), drawing); }

  TEST_CASE("shows the transport that it is given") {
    const auto mermaid = cca::describe<spread>::mermaid("DDS <7>");
    CHECK(mermaid.find("DDS &lt;7&gt;, delayed 2") != std::string::npos);
    CHECK(mermaid.find("memory") == std::string::npos);
    CHECK(cca::describe<spread>::dot("\"DDS\"").find("\\\"DDS\\\", delayed 5") != std::string::npos);
  }

  TEST_CASE("an inner graph is a box where all its nodes run in one environment") {
    static_assert(cca::well_formed<cut_deep>);
    const auto boxes = cca::describe<cut_deep>::mermaid();
    CHECK_EQ(boxes.substr(0, boxes.find("  n0 --")), boxes_of_cut_deep);
  }

  TEST_CASE("a node without an environment stands outside of the boxes") {
    CHECK_EQ(cca::diagnosis<unplaced>.rule, "deployment.unplaced");
    CHECK_EQ(cca::describe<unplaced>::mermaid(), picture_of_unplaced);
  }

  TEST_CASE("a deployment of one environment has the wires of its architecture") {
    struct whole : cca::deployment<watched, cca::environment<"all", cca::other_nodes>> {};
    const auto wires = [](std::string all) { return all.substr(all.find("  n0 --")); };
    CHECK_EQ(wires(cca::describe<whole>::mermaid()), wires(cca::describe<watched>::mermaid()));
  }
}
