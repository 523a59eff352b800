#pragma once
// Inverse Kinematics (the source document, section 6.3): the joint angles that bring the four feet to four
// points.
//
//   in  "left_front" ... "right_hind"   point_in_trunk
//   out "hips"                          hip_angles: abduction and swing
//   out "knees"                         knee_angles
//
// One component for each leg, each with its own chain. A point out of reach is replaced by the nearest point
// in reach.
#include <tuple>

#include <cca/cca.hpp>
#include <cca/mapping/inverse_kinematics.hpp>

#include "legs.hpp"

namespace skills {

template <class Leg>
struct inverse_leg : cca::inverse_kinematics<Leg, typename Leg::joints_of, point_in_trunk> {};

// Sorts the joints by kind: hips and knees.
struct by_kind {
  auto process(cca::in<"left_front", left_front::joints_of> lf,
               cca::in<"right_front", right_front::joints_of> rf,
               cca::in<"left_hind", left_hind::joints_of> lh,
               cca::in<"right_hind", right_hind::joints_of> rh)
      -> std::tuple<cca::out<"hips", hip_angles>, cca::out<"knees", knee_angles>> {
    hip_angles::vector_type hips;
    hips << lf.vector()[0], rf.vector()[0], lh.vector()[0], rh.vector()[0], lf.vector()[1], rf.vector()[1],
        lh.vector()[1], rh.vector()[1];
    return {hips, knee_angles::vector_type{lf.vector()[2], rf.vector()[2], lh.vector()[2], rh.vector()[2]}};
  }
};

struct inverse_kinematics : cca::graph<cca::node<"left_front", inverse_leg<left_front>>,
                                       cca::node<"right_front", inverse_leg<right_front>>,
                                       cca::node<"left_hind", inverse_leg<left_hind>>,
                                       cca::node<"right_hind", inverse_leg<right_hind>>,
                                       cca::node<"by_kind", by_kind>,

                                       cca::wire<"left_front.angles", "by_kind.left_front">,
                                       cca::wire<"right_front.angles", "by_kind.right_front">,
                                       cca::wire<"left_hind.angles", "by_kind.left_hind">,
                                       cca::wire<"right_hind.angles", "by_kind.right_hind">,

                                       cca::expose<"left_front.position", "left_front">,
                                       cca::expose<"right_front.position", "right_front">,
                                       cca::expose<"left_hind.position", "left_hind">,
                                       cca::expose<"right_hind.position", "right_hind">,
                                       cca::expose<"by_kind.hips", "hips">,
                                       cca::expose<"by_kind.knees", "knees">> {};

}  // namespace skills
