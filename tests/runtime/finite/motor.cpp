// The components of motor/ under the laws of finite numbers. Each test is named after its header; the script
// tests/scripts/finite.py notices a header without a test.
#include <cca/motor.hpp>

#include "../../laws/finite_laws.hpp"

namespace {

struct stride : cca::dimension<"stride"> {};
struct hip : cca::dimension<"hip"> {};
struct knee : cca::dimension<"knee"> {};
struct lf : cca::dimension<"left_front"> {};
struct rf : cca::dimension<"right_front"> {};
struct lh : cca::dimension<"left_hind"> {};
struct rh : cca::dimension<"right_hind"> {};
struct trunk : cca::frame<"trunk"> {};
struct hand : cca::frame<"hand"> {};
struct leg : cca::space<cca::joint_angles, cca::axes<hip, knee>> {};
struct torques : cca::space<cca::joint_torques, cca::axes<hip, knee>> {};
struct hand_in_trunk : cca::space<cca::pose<trunk>, cca::axes<cca::x, cca::y, cca::z>> {};

// It keeps what it learned.
template <class Type>
struct learns : laws::finite_case<Type> {
  static constexpr bool forgets = false;
};
// Without a state.
struct shift : laws::finite_case<cca::phase_shift<stride>> {
  static constexpr bool says_unreadable = false, passes_nan = true;
};

// The Gaussians of a new one all lie at the origin, where every input has the same answer.
template <class Type>
struct with_a_movement : laws::finite_case<Type> {
  static auto made() {
    auto c = std::make_unique<Type>();
    auto& mixture = c->p.mixture;
    for (int k = 0; k < mixture.means.cols(); ++k)
      for (int i = 0; i < mixture.means.rows(); ++i) mixture.means(i, k) = std::sin(2.0 * k + i);
    for (auto& covariance : mixture.covariances) {
      covariance.setConstant(0.3);
      covariance.diagonal().setConstant(0.5);
    }
    return c;
  }
};

}  // namespace

TEST_CASE("motor/hopf.hpp") { laws::finite<laws::finite_case<cca::hopf<stride>>>(); }
TEST_CASE("motor/gait_network.hpp") { laws::finite<laws::finite_case<cca::gait_network<lf, rf, lh, rh>>>(); }
TEST_CASE("motor/vite.hpp") { laws::finite<laws::finite_case<cca::vite<leg>>>(); }
TEST_CASE("motor/dmp_discrete.hpp") { laws::finite<laws::finite_case<cca::dmp_discrete<leg, 5>>>(); }
TEST_CASE("motor/dmp_pose.hpp") { laws::finite<laws::finite_case<cca::dmp_pose<hand_in_trunk, hand, 3>>>(); }
TEST_CASE("motor/dmp_rhythmic.hpp") { laws::finite<laws::finite_case<cca::dmp_rhythmic<leg, stride, 5>>>(); }
TEST_CASE("motor/dmp_rhythmic_module.hpp") {
  laws::finite<learns<cca::dmp_rhythmic_module<leg, stride, 5>>>();
}
TEST_CASE("motor/generator.hpp") { laws::finite<shift>(); }
TEST_CASE("motor/pid.hpp") { laws::finite<laws::finite_case<cca::pid<leg, torques>>>(); }
TEST_CASE("motor/rcpg.hpp") {
  using pattern = cca::rcpg<leg, 12, 4>;
  laws::stays_finite<laws::finite_case<pattern>>();
  // A teacher that is not finite counts as none.
  using teacher = cca::optional_in<"teacher", leg>;
  pattern taught;
  taught.p.readout.setConstant(0.3);
  pattern twin = taught;
  for (int k = 0; k < 100; ++k) {
    teacher broken(Eigen::Vector2d(0, std::nan("")), k, true);
    broken.set_wired();
    const auto [y, status] = taught.process(broken);
    CHECK(y.vector() == std::get<0>(twin.process(teacher{})).vector());
    CHECK(status.vector()[0] == cca::status_of(cca::input_status::unreadable));
  }
}
TEST_CASE("motor/gmr.hpp") {
  laws::finite<with_a_movement<cca::gmr<cca::over<cca::number, stride>, leg, 3>>>();
  laws::finite<with_a_movement<cca::gmr<cca::over<cca::phase, stride>, leg, 3>>>();
}
TEST_CASE("motor/hmm_motion.hpp") { laws::finite<with_a_movement<cca::hmm_motion<leg, 3>>>(); }
