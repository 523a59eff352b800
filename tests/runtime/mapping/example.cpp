// The example of docs/mappings.md.
#include <string_view>

#include <doctest/doctest.h>

#include "../picture.hpp"

// [mappings]
#include <cca/cca.hpp>
#include <cca/mapping/mapping.hpp>
#include <cca/mapping/mapping_chain.hpp>
#include <cca/mapping/rigid_motion.hpp>

namespace paw {

struct hip : cca::frame<"hip"> {};
struct trunk : cca::frame<"trunk"> {};
using xyz = cca::axes<cca::x, cca::y, cca::z>;
struct in_hip : cca::space<cca::cartesian_position<hip>, xyz> {};
struct in_trunk : cca::space<cca::cartesian_position<trunk>, xyz> {};
struct height : cca::space<cca::number, cca::axes<cca::z>> {};

// A placement: the frame of the hip in that of the trunk.
struct hip_in_trunk : cca::placed<hip, trunk> {
  static constexpr auto where = cca::at(0.12, 0.07, 0) * cca::turned_about(cca::along_z, cca::pi / 2);
};

// Function objects.
struct mirrored {  // swaps left and right
  Eigen::Vector3d operator()(const Eigen::Vector3d& v) const { return {v[0], -v[1], v[2]}; }
};
struct above_trunk {
  double operator()(const cca::sample<in_trunk>& p) const { return p[cca::z{}]; }
};

// A chain is one component. Without the first mapping it would not compile: mapping.chain.
struct height_of : cca::mapping_chain<cca::frame_change<hip_in_trunk, in_hip, in_trunk>,  //
                                      cca::transformation<in_trunk, mirrored>,            //
                                      cca::mapping<in_trunk, height, above_trunk>> {};

}  // namespace paw
// [mappings end]

namespace paw {

struct sweep {
  auto process(cca::beat now) -> cca::out<"paw", in_hip> {
    return Eigen::Vector3d(0, 0, 0.1 * static_cast<double>(now.index()));
  }
};
struct reader {
  double last = -1;
  void process(cca::in<"height", height> h) { last = h.vector()[0]; }
};
struct walk : cca::graph<cca::rate<1000>,
                         cca::node<"sweep", sweep>,
                         cca::node<"height", height_of>,
                         cca::node<"reader", reader>,
                         cca::wire<"sweep.paw", "height.input">,
                         cca::wire<"height.output", "reader.height">> {};

}  // namespace paw

TEST_SUITE("mappings, example") {
  TEST_CASE("a chain in a graph") {
    cca::controller<paw::walk> c;
    c.load();
    c.start();
    for (int i = 0; i < 4; ++i) CHECK(c.step());
    CHECK(c.get<"reader">().last == doctest::Approx(0.3));
  }
}

namespace {

constexpr std::string_view picture = R"(// [picture]
flowchart LR
  n0["sweep<br/><i>1000 Hz</i>"]
  n1["height<br/><i>1000 Hz</i>"]
  n2["reader<br/><i>1000 Hz</i>"]
  n0 -- "paw → input<br/>in_hip, 1000 Hz" --> n1
  n1 -- "output → height<br/>height, 1000 Hz" --> n2
)";  // [picture end]

}  // namespace

TEST_CASE("the picture of a mapping between two components is the one on its page") {
  test::check_picture<paw::walk>(picture);
}
