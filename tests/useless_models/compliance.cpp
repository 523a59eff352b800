// Compliant components: an arm that a useless servo drives.
#include <limits>

#include "../runtime/compliance/rig.hpp"
#include "trials.hpp"

using namespace useless;
using namespace compliance_test;

namespace {

enum class kind { nothing, refusing, repeating };

template <kind What>
struct servo {
  mutable vector last = vector::Zero();
  vector stiffness{80, 60, 50, 40, 20, 10, 5}, reference = bent;

  vector operator()(const vector& q, const vector& dq) const {
    const vector before = last;
    last = stiffness.cwiseProduct(reference - q) - dq;
    if (What == kind::nothing) return vector::Zero();
    if (What == kind::refusing) return vector::Constant(no_number);
    return before;
  }
  double stored(const vector& q) const {
    return 0.5 * (reference - q).dot(stiffness.cwiseProduct(reference - q));
  }
};

template <kind What>
void compliant() {
  servo<What> of;
  const simulated arm{bent, vector::Zero()};
  laws::law("is as stiff as commanded",
            [&] { laws::is_as_stiff(arm, of, of.stiffness, vector{4, -3, 2, 2, -1, 0.5, 0.2}); });
  laws::law("has the damping ratio", [&] { laws::has_damping_ratio(arm, of, 0.5, 14); });
  laws::law("creates no energy", [&] {
    simulated moving = arm;
    moving.dq.setConstant(0.3);
    CHECK(laws::energy_created(moving, of, 0.5, 5e-4) < 1e-5);
  });
}

}  // namespace

TEST_CASE("compliance") {
  try_model("compliance", does_nothing, 3, compliant<kind::nothing>);
  try_model("compliance", refuses, 3, compliant<kind::refusing>);
  try_model("compliance", repeats, 3, compliant<kind::repeating>);
}
