// Pictures of graphs, compared exactly.
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <memory>

#include "../../laws/temporary_file.hpp"
#include "../picture.hpp"
#include "described.hpp"

using namespace core_test;

namespace {

constexpr std::string_view picture = R"(// [picture]
flowchart LR
  n0[("joint<br/><i>1000 Hz</i>")]
  n3["counter<br/><i>50 Hz</i>"]
  n4["display<br/><i>any_of&lt;moderate, timeout&lt;50&gt;&gt;</i>"]
  subgraph g1["smooth"]
    n1["first<br/><i>1000 Hz</i>"]
    n2["second<br/><i>1000 Hz</i>"]
  end
  n0 -- "angle → raw<br/>angle_of_joint, 1000 Hz" --> n1
  n1 -. "smooth → raw<br/>angle_of_joint, 1000 Hz<br/>delayed 2" .-> n2
  n2 -- "smooth → angle<br/>angle_of_joint, 1000 Hz" --> n4
  n3 -- "y → count<br/>reading, 50 Hz<br/>queue 4" --> n4
)";  // [picture end]

constexpr std::string_view drawing = R"(digraph "shown" {
  rankdir=LR;
  node [shape=box, style=rounded, fontname="sans-serif"];
  edge [fontname="sans-serif", fontsize=10];
  n0 [label="joint\n1000 Hz", shape=cylinder];
  n3 [label="counter\n50 Hz"];
  n4 [label="display\nany_of<moderate, timeout<50>>"];
  subgraph cluster_1 {
    label="smooth";
    n1 [label="first\n1000 Hz"];
    n2 [label="second\n1000 Hz"];
  }
  n0 -> n1 [label="angle → raw\nangle_of_joint, 1000 Hz"];
  n1 -> n2 [label="smooth → raw\nangle_of_joint, 1000 Hz\ndelayed 2", style=dashed];
  n2 -> n4 [label="smooth → angle\nangle_of_joint, 1000 Hz"];
  n3 -> n4 [label="y → count\nreading, 50 Hz\nqueue 4"];
}
)";

struct lonely : cca::graph<cca::node<"counter", counter>, cca::rate<0.5>> {};
struct broken : cca::graph<cca::rate<100>,
                           cca::node<"counter", counter>,
                           cca::node<"adder", adder>,
                           cca::wire<"counter.nothing", "adder.x">> {};

// A user's strategy without add_name.
struct nameless {
  template <class Inputs>
  static constexpr bool fires(cca::beat now, const Inputs&) {
    return now.index() % 7 == 3;
  }
};
struct own_strategies : cca::graph<cca::rate<100>,
                                   cca::node<"alone", counter, nameless>,
                                   cca::node<"within", counter, cca::any_of<nameless, cca::timeout<9>>>> {};

template <cca::fixed_string Name>
struct named : cca::space<cca::number, cca::axes<cca::x>> {};
struct quoting {
  auto process() -> cca::out<"y", named<"a\"b\\">> { return 0; }
};
struct listening {
  void process(cca::in<"x", named<"a\"b\\">>) {}
};
struct awkward : cca::graph<cca::rate<1>,
                            cca::node<"quoting", quoting>,
                            cca::node<"listening", listening>,
                            cca::wire<"quoting.y", "listening.x">> {};

// The output of `dot -Tsvg`, or its error.
struct drawn {
  int result;
  std::string svg;
};
drawn draw(const std::string& dot, const char* name) {
  const laws::temporary_file file(std::string(name) + ".dot", dot);
  drawn d{};
  const std::unique_ptr<FILE, int (*)(FILE*)> pipe(popen(("dot -Tsvg '" + file.path + "' 2>&1").c_str(), "r"),
                                                   [](FILE*) { return 0; });
  REQUIRE(pipe);
  std::array<char, 4096> part;
  while (const auto n = std::fread(part.data(), 1, part.size(), pipe.get())) d.svg.append(part.data(), n);
  d.result = pclose(pipe.get());
  return d;
}

}  // namespace

TEST_SUITE("describe") {
  TEST_CASE("mermaid") {
    test::check_picture<shown>(picture);
    CHECK_EQ(cca::describe<lonely>::mermaid(), "flowchart LR\n  n0[\"counter<br/><i>0.5 Hz</i>\"]\n");
  }

  TEST_CASE("a strategy without add_name has the name of its type") {
    CHECK_EQ(cca::describe<own_strategies>::mermaid(),
             "flowchart LR\n"
             "  n0[\"alone<br/><i>nameless</i>\"]\n"
             "  n1[\"within<br/><i>any_of&lt;nameless, timeout&lt;9&gt;&gt;</i>\"]\n");
    const std::string dot = cca::describe<own_strategies>::dot();
    CHECK_NE(dot.find("n1 [label=\"within\\nany_of<nameless, timeout<9>>\"]"), dot.npos);
  }

  TEST_CASE("dot, accepted by graphviz") {
    CHECK_EQ(cca::describe<shown>::dot(), drawing);
    const auto d = draw(cca::describe<shown>::dot(), "shown");
    CAPTURE(d.svg);
    REQUIRE_MESSAGE(d.result == 0, "`dot` of graphviz is needed here: ./bootstrap installs it");
    CHECK_NE(d.svg.find("<svg"), std::string::npos);
    CHECK_NE(d.svg.find("angle → raw"), std::string::npos);
    CHECK_EQ(d.svg.find("Warning"), std::string::npos);
  }

  TEST_CASE("a graph that breaks a rule has a picture too") {
    CHECK_EQ(cca::diagnosis<broken>.rule, "wire.unknown_port");
    CHECK_EQ(
        cca::describe<broken>::mermaid(),
        "flowchart LR\n  n0[\"counter<br/><i>timed&lt;1&gt;</i>\"]\n  n1[\"adder<br/><i>restless</i>\"]\n");
  }

  TEST_CASE("names with quotation marks") {
    const auto d = draw(cca::describe<awkward>::dot(), "awkward");
    CAPTURE(d.svg);
    CHECK_EQ(d.result, 0);
    const auto mermaid = cca::describe<awkward>::mermaid();
    CAPTURE(mermaid);
    CHECK_EQ(std::count(mermaid.begin(), mermaid.end(), '"'),
             2 + 2 + 2);  // around the two nodes and the wire
  }
}
