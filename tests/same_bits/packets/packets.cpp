// What the library adds, as hashes: a line for each part. packets.py compiles this with Eigen's packets and
// without, and compares. The last line is by Eigen's own reductions, and must differ.
#include <cstdint>
#include <cstdio>
#include <cstring>

#include <cca/base/math/random_numbers.hpp>
#include <cca/base/math/reductions.hpp>
#include <cca/mapping/damped_least_squares.hpp>
#include <cca/mapping/serial_chain.hpp>
#include <cca/mapping/tip_task.hpp>
#include <cca/motor/equations/dmp_discrete_ode.hpp>
#include <cca/motor/equations/dmp_pose_ode.hpp>
#include <cca/motor/equations/gaussian_mixture.hpp>
#include <cca/motor/equations/hopf_ode.hpp>
#include <cca/robot/body.hpp>
#include <cca/robot/compliance/cartesian_spring.hpp>
#include <cca/robot/compliance/damping_design.hpp>
#include <cca/robot/dynamics/coriolis_matrix.hpp>
#include <cca/robot/dynamics/derivatives.hpp>
#include <cca/robot/dynamics/forward_dynamics.hpp>
#include <cca/robot/dynamics/mass_matrix.hpp>
#include <cca/robot/dynamics/momentum.hpp>
#include <cca/robot/dynamics/operational_space.hpp>

namespace {

struct bench : cca::frame<"bench"> {};
struct hand : cca::frame<"hand"> {};
template <cca::fixed_string Name>
struct joint : cca::dimension<Name> {};
struct chain
    : cca::serial_chain<
          bench,
          hand,
          cca::axes<joint<"1">, joint<"2">, joint<"3">, joint<"4">, joint<"5">, joint<"6">, joint<"7">>> {
  static constexpr std::array joints{
      cca::revolute({0.6, 0, 0.8}, cca::at(0.1, 0, 0.11)), cca::revolute(cca::along_y, cca::at(0, 0.1, 0.2)),
      cca::revolute(cca::along_z, cca::at(0, 0, 0.2)),     cca::revolute({0, 0.6, 0.8}, cca::at(0, 0, 0.2)),
      cca::revolute(cca::along_z, cca::at(0, 0.3, 0.2)),   cca::revolute(cca::along_y, cca::at(0, 0, 0.19)),
      cca::revolute(cca::along_x, cca::at(0, 0, 0.08))};
  static constexpr auto tip = cca::at(0, 0.02, 0.05);
  static constexpr std::array links{
      cca::link_inertia{2.7, {0.01, -0.03, 0.12}, {0.016, 0.015, 0.006, 1e-4, 2e-4, 1e-3}},
      cca::link_inertia{2.7, {0, 0.05, 0.07}, {0.016, 0.007, 0.014, 1e-4, 0, 1e-3}},
      cca::link_inertia{2.7, {0.02, 0.03, 0.12}, {0.016, 0.015, 0.006, 0, 0, -1e-3}},
      cca::link_inertia{2.7, {0, -0.05, 0.07}, {0.016, 0.007, 0.014, 0, 0, -1e-3}},
      cca::link_inertia{1.7, {0.03, -0.02, 0.1}, {0.01, 0.009, 0.003, 0, 0, 1e-3}},
      cca::link_inertia{1.6, {0, 0.01, 0.01}, {0.003, 0.003, 0.003, 0, 0, 0}},
      cca::link_inertia{0.3, {0, 0.01, 0.02}, {1e-3, 1e-3, 1e-3, 0, 0, 0}}};
};
struct arm : cca::body<bench, cca::part<"arm", chain>> {};
constexpr int joints = 7;
using vector = Eigen::Matrix<double, joints, 1>;

// The same numbers by every compiler: uniform in [-1, 1).
struct numbers {
  cca::random_numbers random{1};
  double next() { return random.between(-1, 1); }
  template <class M>
  M of() {
    M m;
    for (Eigen::Index i = 0; i < m.size(); ++i) m.data()[i] = static_cast<typename M::Scalar>(next());
    return m;
  }
};

struct hash {
  std::uint64_t of = 0xcbf29ce484222325U;
  template <class T>
  void bytes(const T* from, std::size_t count) {
    unsigned char all[sizeof(T)];
    for (std::size_t i = 0; i < count; ++i) {
      std::memcpy(all, from + i, sizeof(T));
      for (const unsigned char one : all) of = (of ^ one) * 0x100000001b3U;
    }
  }
  void add(double x) { bytes(&x, 1); }
  void add(float x) { bytes(&x, 1); }
  template <class M>
  void add(const Eigen::PlainObjectBase<M>& m) {
    bytes(m.data(), static_cast<std::size_t>(m.size()));
  }
};

template <class F>
void line(const char* name, F f) {
  numbers random;
  hash h;
  for (int round = 0; round < 20; ++round) f(random, h);
  std::printf("%s %016llx\n", name, static_cast<unsigned long long>(h.of));
}

template <class Scalar, int Size>
void sums(numbers& random, hash& h) {
  using cca::math::dot, cca::math::norm, cca::math::sum;
  const auto a = random.of<Eigen::Matrix<Scalar, Size, 1>>(), b = random.of<Eigen::Matrix<Scalar, Size, 1>>();
  const Eigen::Matrix<Scalar, Eigen::Dynamic, 1> more = a;
  h.add(sum(a)), h.add(dot(a, b)), h.add(cca::math::squared_norm(a)), h.add(norm(a - b));
  h.add(cca::math::mean(a)), h.add(dot(a.transpose(), b)), h.add(sum(more)), h.add(dot(more, b));
}
template <int Rows, int Depth>
void products(numbers& random, hash& h) {
  const auto a = random.of<Eigen::Matrix<double, Rows, Depth>>();
  const auto b = random.of<Eigen::Matrix<double, Depth, 3>>();
  h.add(cca::math::product(a, b));
  h.add(cca::math::product(a, b.col(1)));
  h.add(cca::math::product(a.row(0), b));
  h.add(cca::math::trace(cca::math::product(a, a.transpose())));
}
constexpr const auto& links = cca::detail::weighed_links_of<arm>;
std::array<cca::detail::placed_link, links.size()> placed_at(const vector& q) {
  std::array<cca::detail::placed_link, links.size()> placed;
  cca::detail::place_links<links.size()>(links, q, placed);
  return placed;
}

}  // namespace

int main() {
  using namespace cca;
  line("reductions", [](numbers& r, hash& h) {
    sums<double, 2>(r, h), sums<double, 3>(r, h), sums<double, 4>(r, h), sums<double, 6>(r, h),
        sums<double, 7>(r, h);
    sums<double, 28>(r, h), sums<float, 3>(r, h), sums<float, 8>(r, h);
    products<3, 3>(r, h), products<4, 6>(r, h), products<6, 7>(r, h), products<8, 8>(r, h);
  });
  line("kinematics", [](numbers& r, hash& h) {
    for (const auto& one : placed_at(r.of<vector>()))
      h.add(one.frame.turn), h.add(one.frame.at), h.add(one.axis);
  });
  line("rotations", [](numbers& r, hash& h) {
    const auto a = rotation::normalised<double>(r.of<Eigen::Vector4d>()),
               b = rotation::normalised<double>(r.of<Eigen::Vector4d>());
    h.add(rotation::slerp<double>(a, b, 0.3)), h.add(rotation::log<double>(a)),
        h.add(rotation::angle<double>(b));
    h.add(rotation::exp<double>(r.of<Eigen::Vector3d>()));
  });
  // Drawn before each call: compilers evaluate arguments in different orders.
  line("inverse dynamics", [](numbers& r, hash& h) {
    const auto placed = placed_at(r.of<vector>());
    const vector dq = r.of<vector>(), ddq = r.of<vector>();
    h.add(detail::newton_euler<links.size(), joints>(links, placed, detail::base_inertia_of<arm>(), dq, ddq,
                                                     base_motion{})
              .torques);
  });
  line("mass", [](numbers& r, hash& h) {
    const auto placed = placed_at(r.of<vector>());
    h.add(detail::joint_space_inertia<joints>(links,
                                              detail::composite_bodies<links.size()>(links, placed, {})));
  });
  line("Coriolis", [](numbers& r, hash& h) {
    const auto placed = placed_at(r.of<vector>());
    h.add(detail::coriolis_of<joints>(links, placed, r.of<vector>()));
  });
  line("forward dynamics", [](numbers& r, hash& h) {
    const auto placed = placed_at(r.of<vector>());
    const vector dq = r.of<vector>(), torques = r.of<vector>();
    h.add(detail::articulated_body<false, joints>(links, placed, detail::base_inertia_of<arm>(), dq, torques,
                                                  base_motion{}, detail::vector6(detail::vector6::Zero()))
              .accelerations);
  });
  line("operational space", [](numbers& r, hash& h) {
    const auto placed = placed_at(r.of<vector>());
    const auto mass =
        detail::joint_space_inertia<joints>(links, detail::composite_bodies<links.size()>(links, placed, {}));
    Eigen::Matrix<double, 6, 6> inertia;
    Eigen::Matrix<double, joints, 6> inverse;
    detail::operational_space_by_loops<6, joints>(mass, r.of<Eigen::Matrix<double, 6, joints>>(), inertia,
                                                  inverse);
    h.add(inertia), h.add(inverse);
    h.add(detail::damping_for<joints>(mass, mass, 0.7));
  });
  line("movement primitives", [](numbers& r, hash& h) {
    using pose = dmp_pose_ode<60>;
    auto s = r.of<pose::state>();
    const pose::parameters p{r.of<Eigen::Matrix<double, 6, 60>>(), 20, 4, 3, true};
    auto u = r.of<pose::input>();
    u[14] = s[20] = 1;
    h.add(pose::derivative(s, u, p));
    using discrete = dmp_discrete_ode<8, 40>;
    const discrete::parameters d{r.of<Eigen::Matrix<double, 8, 40>>(), 20, 4, 3, true};
    auto x = r.of<discrete::state>();
    auto to = r.of<discrete::input>();
    x[24] = to[16] = 1;
    h.add(discrete::derivative(x, to, d));
    const auto state = r.of<hopf_ode::state>(), input = r.of<hopf_ode::input>();
    h.add(hopf_ode::flow(state, input, {3}, 0.01));
  });
  line("Gaussian mixtures", [](numbers& r, hash& h) {
    using mixture = gaussian_mixture<6, 6, 3>;
    mixture m;
    m.means = r.of<mixture::mean_matrix>();
    for (auto& one : m.covariances) {
      const auto a = r.of<Eigen::Matrix<double, 12, 12>>();
      one = detail::above_floor<12>(math::product(a, a.transpose()), 1e-3);
      h.add(one);
    }
    const auto x = r.of<mixture::input>();
    const auto found =
        regress(m, m.priors, x, [](const auto& to, const auto& from) { return mixture::input(to - from); });
    h.add(found.mean), h.add(found.covariance), h.add(found.responsibilities);
    h.add(detail::log_likelihood(m, m.priors, x));
  });
  line("momentum", [](numbers& r, hash& h) {
    const auto placed = placed_at(r.of<vector>());
    const auto of = detail::momentum_of_joints<joints>(links, placed, r.of<vector>());
    h.add(of.momentum), h.add(of.change);
    h.add(detail::torques_at_rest<joints>(links, placed, r.of<Eigen::Vector3d>()));
  });
  line("Eigen", [](numbers& r, hash& h) {
    const auto a = r.of<Eigen::Vector4d>();
    h.add(a.squaredNorm());
  });
}
