// What recorded dynamics and loops over the links cost where they run: once in a beat, between other code
// that takes their place in the caches.
//
//   cold_dynamics check              compares the results of both ways
//   cold_dynamics BEATS              a line for each quantity: name, body, operations of its recording, and the
//                                    recording's name in the program's symbols; then nanoseconds, recorded and
//                                    by loops: one call after another, once a beat after 256 KB of other code,
//                                    and after 8 MB of data and that code. Separated by tabs.
//
// Each call begins with the sines of the angles. Times are medians of so many beats, less those of a call
// that does nothing. A recording may be larger than the library makes one: these are what the limit was found
// with.
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <string_view>
#include <type_traits>
#include <vector>

#include <cca/robot/dynamics/derivatives.hpp>

#include "arm.hpp"
#include "other_code.hpp"
#include "quadruped.hpp"
#include "two_ways.hpp"
#include "words.hpp"

namespace bench {

namespace cd = cca::detail;

// Recorded whatever its size.
template <class Quantity>
struct unlimited : Quantity {
  static constexpr int most_kept = 4096;
};

template <class Body>
inline constexpr const char* name_of = std::is_same_v<Body, arm> ? "arm" : "quadruped";

template <class Body>
struct state {
  static constexpr int n = cca::axes_of<Body>::count;
  using vector = Eigen::Matrix<double, n, 1>;
  vector q, dq, input;  // the input: accelerations or torques
  cca::base_motion base;
  Eigen::Matrix<double, 6, 1> wrench;

  static state next(int round) {
    state s;
    spread(s, round);
    s.base = {{0.3, -0.5, -9.7}, {0.4, s.q[0], 0.3}, {1, 2, s.q[1]}, {0.5, 0.1, -2}};
    s.wrench << 1, s.q[0], 2, 3, s.q[1], 4;
    return s;
  }
  cca::body_pose<Body> pose() const { return cca::body_pose<Body>(q); }
  auto placed() const {
    std::array<cd::placed_link, cd::weighed_links_of<Body>.size()> all;
    cd::place_links(cd::weighed_links_of<Body>, q, all);
    return all;
  }
};

template <class Body>
struct of_body {
  using body = Body;
  using state_type = state<Body>;
};

// Of a base that stands.
template <class Body>
struct gravity : of_body<Body> {
  static constexpr const char *name = "gravity", *recording = "recorded_gravity_torques";
  using quantity = unlimited<cd::recorded_gravity_torques<Body, false>>;
  using typename of_body<Body>::state_type;
  static auto recorded(const state_type& s) {
    return cd::recorded_result<quantity, typename state_type::vector>(s.pose().joint_values());
  }
  static auto loops(const state_type& s) {
    return cd::torques_at_rest<state_type::n>(cd::weighed_links_of<Body>, s.placed(),
                                              cca::base_motion{}.gravity);
  }
};
template <class Body>
struct inverse : of_body<Body> {
  static constexpr const char *name = "inverse dynamics", *recording = "recorded_inverse_dynamics";
  using quantity = unlimited<cd::recorded_inverse_dynamics<Body, false>>;
  using typename of_body<Body>::state_type;
  static auto recorded(const state_type& s) {
    cca::dynamics_result<state_type::n> r;
    const auto now = s.pose();
    cd::straight_line<quantity>::evaluate({r.torques.data(), r.wrench.data(), r.wrench.data() + 3},
                                          now.joint_values(), s.dq.data(), s.input.data());
    return r.torques;
  }
  static auto loops(const state_type& s) {
    constexpr const auto& links = cd::weighed_links_of<Body>;
    return cd::newton_euler<links.size(), state_type::n>(links, s.placed(), cd::base_inertia_of<Body>(), s.dq,
                                                         s.input, {})
        .torques;
  }
};
template <class Body>
struct mass : of_body<Body> {
  static constexpr const char *name = "mass matrix", *recording = "recorded_mass_matrix";
  using quantity = unlimited<cd::recorded_mass_matrix<Body, false>>;
  using typename of_body<Body>::state_type;
  static auto recorded(const state_type& s) {
    return cd::recorded_result<quantity, Eigen::Matrix<double, state_type::n, state_type::n>>(
        s.pose().joint_values());
  }
  static auto loops(const state_type& s) {
    constexpr const auto& links = cd::weighed_links_of<Body>;
    return cd::joint_space_inertia<state_type::n>(links,
                                                  cd::composite_bodies<links.size()>(links, s.placed(), {}));
  }
};
template <class Body>
struct forward : of_body<Body> {
  static constexpr const char *name = "forward dynamics", *recording = "recorded_forward_dynamics";
  using quantity = unlimited<cd::recorded_forward_dynamics<Body, false>>;
  using typename of_body<Body>::state_type;
  static auto recorded(const state_type& s) {
    return cd::recorded_result<quantity, typename state_type::vector>(s.pose().joint_values(), s.dq.data(),
                                                                      s.input.data());
  }
  static auto loops(const state_type& s) {
    return cd::articulated_body<false>(cd::weighed_links_of<Body>, s.placed(), {}, s.dq, s.input,
                                       cca::base_motion{}, cd::vector6(cd::vector6::Zero()))
        .accelerations;
  }
};
template <class Body>
struct coriolis : of_body<Body> {
  static constexpr const char *name = "Coriolis matrix", *recording = "recorded_coriolis_matrix";
  using quantity = unlimited<cd::recorded_coriolis_matrix<Body>>;
  using typename of_body<Body>::state_type;
  static auto recorded(const state_type& s) {
    return cd::recorded_result<quantity, Eigen::Matrix<double, state_type::n, state_type::n>>(
        s.pose().joint_values(), s.dq.data());
  }
  static auto loops(const state_type& s) {
    return cd::coriolis_of<state_type::n>(cd::weighed_links_of<Body>, s.placed(), s.dq);
  }
};
template <class Body>
struct derivatives : of_body<Body> {
  static constexpr const char *name = "derivatives of inverse dynamics",
                              *recording = "recorded_torque_derivatives";
  using quantity = unlimited<cd::recorded_torque_derivatives<Body, false>>;
  using typename of_body<Body>::state_type;
  static auto joined(const cca::inverse_dynamics_derivatives_result<state_type::n>& d) {
    Eigen::Matrix<double, state_type::n, 3 * state_type::n + 1> all;
    all << d.torques, d.by_angles, d.by_velocities, d.by_accelerations;
    return all;
  }
  static auto recorded(const state_type& s) {
    cca::inverse_dynamics_derivatives_result<state_type::n> d;
    const auto now = s.pose();
    cd::straight_line<quantity>::evaluate(
        {d.torques.data(), d.by_angles.data(), d.by_velocities.data(), d.by_accelerations.data()},
        now.joint_values(), s.dq.data(), s.input.data());
    return joined(d);
  }
  static auto loops(const state_type& s) {
    constexpr const auto& links = cd::weighed_links_of<Body>;
    return joined(
        cd::derivatives_of_torques<state_type::n, links.size()>(links, s.placed(), s.dq, s.input, {}));
  }
};

// Of a base that is free, or moves.
template <class Body>
struct free_inverse : of_body<Body> {
  static constexpr const char *name = "inverse dynamics, moving base",
                              *recording = "recorded_inverse_dynamics";
  using quantity = unlimited<cd::recorded_inverse_dynamics<Body, true>>;
  using typename of_body<Body>::state_type;
  static auto joined(const cca::dynamics_result<state_type::n>& r) {
    Eigen::Matrix<double, 6 + state_type::n, 1> all;
    all << r.wrench, r.torques;
    return all;
  }
  static auto recorded(const state_type& s) {
    cca::dynamics_result<state_type::n> r;
    const auto now = s.pose();
    cd::straight_line<quantity>::evaluate({r.torques.data(), r.wrench.data(), r.wrench.data() + 3},
                                          now.joint_values(), s.dq.data(), s.input.data(),
                                          s.base.gravity.data(), s.base.angular_velocity.data(),
                                          s.base.angular_acceleration.data(), s.base.acceleration.data());
    return joined(r);
  }
  static auto loops(const state_type& s) {
    constexpr const auto& links = cd::weighed_links_of<Body>;
    return joined(cd::newton_euler<links.size(), state_type::n>(
        links, s.placed(), cd::base_inertia_of<Body>(), s.dq, s.input, s.base));
  }
};
template <class Body>
struct free_mass : of_body<Body> {
  static constexpr const char *name = "mass matrix, free base", *recording = "recorded_mass_matrix";
  using quantity = unlimited<cd::recorded_mass_matrix<Body, true>>;
  using typename of_body<Body>::state_type;
  static auto recorded(const state_type& s) {
    return cd::recorded_result<quantity, Eigen::Matrix<double, 6 + state_type::n, 6 + state_type::n>>(
        s.pose().joint_values());
  }
  static auto loops(const state_type& s) {
    constexpr const auto& links = cd::weighed_links_of<Body>;
    return cd::whole_inertia<state_type::n>(
        links, cd::composite_bodies<links.size()>(links, s.placed(), cd::base_inertia_of<Body>()));
  }
};
template <class Body>
struct free_forward : of_body<Body> {
  static constexpr const char *name = "forward dynamics, free base",
                              *recording = "recorded_floating_forward_dynamics";
  using quantity = unlimited<cd::recorded_floating_forward_dynamics<Body>>;
  using typename of_body<Body>::state_type;
  static auto recorded(const state_type& s) {
    Eigen::Matrix<double, 6 + state_type::n, 1> all;
    const auto now = s.pose();
    cd::straight_line<quantity>::evaluate({all.data() + 6, all.data(), all.data() + 3}, now.joint_values(),
                                          s.dq.data(), s.input.data(), s.base.angular_velocity.data(),
                                          s.wrench.data(), s.wrench.data() + 3);
    all.template segment<3>(3) += s.base.gravity;
    return all;
  }
  static auto loops(const state_type& s) {
    const auto r = cd::articulated_body<true>(cd::weighed_links_of<Body>, s.placed(),
                                              cd::base_inertia_of<Body>(), s.dq, s.input, s.base, s.wrench);
    Eigen::Matrix<double, 6 + state_type::n, 1> all;
    all << r.base.angular_acceleration, r.base.acceleration, r.accelerations;
    return all;
  }
};

// A call each, as in a beat of a controller.
template <class Quantity>
[[gnu::noinline]] auto once_recorded(const typename Quantity::state_type& s) {
  return Quantity::recorded(s);
}
template <class Quantity>
[[gnu::noinline]] auto once_loops(const typename Quantity::state_type& s) {
  return Quantity::loops(s);
}
template <class State>
[[gnu::noinline]] Eigen::Matrix<double, 1, 1> once_nothing(const State& s) {
  return Eigen::Matrix<double, 1, 1>::Constant(s.q[0]);
}

template <class Quantity>
bool check() {
  using state_type = typename Quantity::state_type;
  for (int i = 0; i < 100; ++i) {
    const auto s = state_type::next(i);
    const auto a = once_recorded<Quantity>(s), b = once_loops<Quantity>(s);
    if ((a - b).cwiseAbs().maxCoeff() <= 1e-10 * b.cwiseAbs().maxCoeff()) continue;
    std::fprintf(stderr, "%s differs from the loops by %g\n", Quantity::name, (a - b).norm());
    return false;
  }
  return true;
}

// Nanoseconds of a call: the median of so many beats, each after `between()`.
template <class State, class Call, class Between>
double median(int beats, double& sum, Call call, Between between) {
  std::vector<double> all;
  for (int i = 0; i < beats; ++i) {
    const State s = State::next(i % 50);
    between();
    const auto before = std::chrono::steady_clock::now();
    const auto result = call(s);
    const auto after = std::chrono::steady_clock::now();
    sum += result.sum();
    all.push_back(std::chrono::duration<double, std::nano>(after - before).count());
  }
  std::nth_element(all.begin(), all.begin() + beats / 2, all.end());
  return all[static_cast<std::size_t>(beats / 2)];
}

template <class Quantity>
double measure(int beats) {
  using state_type = typename Quantity::state_type;
  double sum = 0;
  other_code work;
  std::printf("%s\t%s\t%d\t%s", Quantity::name, name_of<typename Quantity::body>,
              cd::tape_of<typename Quantity::quantity>.operations, Quantity::recording);
  const auto time = [&](auto between) {
    const auto of = [&](auto call) { return median<state_type>(beats, sum, call, between); };
    const double nothing = of([](const state_type& s) { return once_nothing(s); }),
                 recorded = of([](const state_type& s) { return once_recorded<Quantity>(s); }),
                 loops = of([](const state_type& s) { return once_loops<Quantity>(s); });
    std::printf("\t%.1f\t%.1f", recorded - nothing, loops - nothing);
  };
  time([] {});
  time([&] { work.run(); });
  time([&] { work.run_on_data(); });
  std::puts("");
  return sum + static_cast<double>(work.result() & 1);
}

template <class... Quantities>
int run(std::string_view what) {
  if (what == "check") return (check<Quantities>() && ...) ? 0 : 1;
  const int beats = beats_in(what);
  return std::isfinite((measure<Quantities>(beats) + ...)) ? 0 : 1;
}

}  // namespace bench

int main(int argc, char** argv) {
  using namespace bench;
  const std::string_view what = argc > 1 ? argv[1] : "";
  return run<gravity<arm>, mass<arm>, inverse<arm>, forward<arm>, forward<quadruped>, coriolis<arm>,
             free_mass<quadruped>, free_inverse<quadruped>, free_forward<arm>, derivatives<arm>,
             derivatives<quadruped>, free_forward<quadruped>>(what);
}
