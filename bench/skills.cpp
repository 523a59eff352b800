// The controller of the Combination of Skills, in two forms: the graph, and the same arithmetic as one loop
// written by hand.
//
// The robot's joints reach their commands at once, with a little noise; after two seconds it sees a ball, so
// all skills run. `bench_skills check` compares the two bit for bit.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <cca/sim/oncilla/oncilla_model.hpp>

#include "../examples/combination_of_skills/architecture.hpp"
#include "program.hpp"

namespace bench {

using vector4 = Eigen::Matrix<double, 4, 1>;
using vector8 = Eigen::Matrix<double, 8, 1>;
using Eigen::Vector3d;

// The robot's sensor values, computed from its last commands.
struct echo {
  vector8 legs = vector8::Constant(1.0);
  vector4 abduction = vector4::Zero(), stiffness = vector4::Zero();
  vector8 sum = vector8::Zero();

  static double noise(std::int64_t k, int i) {
    return 1e-3 * static_cast<double>((k * 37 + i * 101) % 64 - 32) / 32;
  }
  vector8 angles(std::int64_t k) const {
    vector8 q = legs;
    for (int i = 0; i < 8; ++i) q[i] += noise(k, i);
    return q;
  }
  Eigen::Vector4d orientation(std::int64_t k) const { return {0, 0, noise(k, 3), 1}; }
  Vector3d rates(std::int64_t k) const { return {noise(k, 4), noise(k, 5), noise(k, 6)}; }
  vector4 contacts() const {  // a raised leg has its hip far forward
    vector4 touching;
    for (int i = 0; i < 4; ++i) touching[i] = legs[i] < 1.2 ? 1 : 0;
    return touching;
  }
  [[gnu::always_inline]] void take(const vector8& command, const vector4& sideways, const vector4& hips) {
    legs = command;
    abduction = sideways;
    stiffness = hips;
    sum += command;
    sum.head<4>() += sideways + hips;
  }
  static constexpr std::int64_t shown = 2000;
  static Vector3d ball() { return {0.2125, 0.085, -0.13}; }
};

struct robot {
  echo body;
  auto sense(cca::beat now) -> std::tuple<cca::out<"angles", cca::sim::leg_angles>,
                                          cca::out<"abducted", cca::sim::abduction_angles>,
                                          cca::out<"orientation", cca::sim::trunk_orientation>,
                                          cca::out<"angular_velocity", cca::sim::trunk_angular_velocity>,
                                          cca::out<"contacts", cca::sim::foot_contacts>> {
    return {body.angles(now.index()), body.abduction, body.orientation(now.index()), body.rates(now.index()),
            body.contacts()};
  }
  void act(cca::in<"command", cca::sim::leg_angles> wanted,
           cca::in<"abduction", cca::sim::abduction_angles> sideways,
           cca::in<"stiffness", cca::sim::hip_stiffnesses> hips) {
    body.take(wanted.vector(), sideways.vector(), hips.vector());
  }
};

struct eyes {
  auto sense(cca::beat now) -> cca::maybe<"ball", skills::point_in_trunk> {
    if (now.index() < echo::shown) return {};
    return echo::ball();
  }
};

using module = skills::shape_of_trot<1>;

// An arbitrary shape, so no file is needed.
module::learner::learned some_shape() {
  module::learner::learned known;
  for (int i = 0; i < 8; ++i)
    for (int j = 0; j < 40; ++j) known.function.weights(i, j) = 10 * std::sin(0.3 * i + 0.157 * j);
  known.seen.setConstant(100);
  known.evidence.setConstant(100);
  return known;
}

struct skills_graph : skills::architecture<robot, eyes> {};
struct look_at_robot {
  vector8 operator()(const auto& controller) const { return controller.template get<"robot">().body.sum; }
};
struct graph : as_graph<skills_graph, look_at_robot> {
  graph() { controller.get<"dmp.module">().learning.hand_over(some_shape()); }
};

// The same by hand: one function without samples, ports and origins. Equations, their solver, the check of
// inputs, kinematics and monitors are the library's functions. Like the components it holds a movement while
// an input is NaN.
struct by_hand {
  static constexpr const char* name = "by_hand";
  static constexpr double dt = 1'000'000 / 1e9, dt10 = 10'000'000 / 1e9, pi = std::numbers::pi;

  using vite_hips = cca::vite_ode<8>;
  using vite_knees = cca::vite_ode<4>;
  using shape = cca::dmp_rhythmic_ode<8, 40>;
  template <class Leg>
  using inverse = cca::detail::
      pantograph_solver<Leg, typename Leg::joints_of, skills::point_in_trunk, cca::damped_least_squares>;

  // Parameters, as in the components.
  skills::orders::parameters orders = skills::orders{}.p;
  double frequency = 4.0, convergence = 10.0, ember = 1e-3, stiffness_of_shape = 25.0;
  cca::ode_settling reaching_settles{0.05, 0.1}, cpg_settles{0.05, 0.1}, dmp_settles{1e-3, 1e-2};
  vite_hips::parameters vite_h{30.0, 0.4, 2};
  vite_knees::parameters vite_k{30.0, 0.4, 2};
  double vite_speed = 7.5;
  decltype(skills::tracking_criterion{}.p.limits) tracking = skills::tracking_criterion{}.p.limits;
  decltype(skills::reaching_criterion{}.p.limits) reaching = skills::reaching_criterion{}.p.limits;
  skills::stillness::parameters still = skills::stillness{}.p;
  skills::heading::parameters heading = skills::heading{}.p;
  skills::balance::parameters balance = skills::balance{}.p;
  skills::aim::parameters aiming = skills::aim{}.p;
  skills::steadying::parameters steady = skills::steadying{}.p;
  module::learner::learned known = some_shape();
  module::learner_settings settings{};

  // State.
  echo body;
  std::int64_t k = 0, step_began = -1, held_since = -1;
  int now_on = 0;
  bool right = false, settled = false, timed_out = false;
  double hip_stiffness = 30, smooth = 0, aside = 0, turn = 0, wanted = 0, share = 0;
  Vector3d correction{0, 0, 0}, swaying{0, 0, 0}, turning{0, 0, 0};
  vector4 carrying = vector4::Zero();
  std::array<Vector3d, 4> solution;
  vector8 hip_goal = vector8::Zero();
  vector4 knee_goal = vector4::Zero(), wanted_stiffness = vector4::Zero();
  cca::ode_solver<vite_hips> hips;
  cca::ode_solver<vite_knees> knees;
  cca::ode_solver<cca::hopf_ode> cpg;
  cca::ode_solver<shape> dmp;
  cca::ode_monitor hips_rest, knees_rest, cpg_rests, dmp_rests;
  cca::error_monitor follows, at_ball, stands_still;
  skills::ball_state ball_told = skills::ball_state::unseen;
  skills::paw_state paw_told = skills::paw_state::raised;
  cca::component_status dmp_told = cca::component_status::converging;
  bool walks = true, heads = true,
       touches = true;  // the parts that run: cpg and dmp; heading; aim and reaching
  double radius = 0, phase = 0;
  bool region_told = false, begun = false,
       dmp_begun = false;  // the module's status is published too: dmp.status.module
  vector8 last_legs;
  vector4 last_sideways;

  by_hand() {
    start_solution<skills::left_front>(0);
    start_solution<skills::right_front>(1);
    start_solution<skills::left_hind>(2);
    start_solution<skills::right_hind>(3);
  }
  template <class Leg>
  void start_solution(std::size_t leg) {
    using limits = cca::detail::chain_limits<Leg, typename Leg::joints_of>;
    solution[leg] = limits::clamped(typename limits::vector(limits::vector::Zero()));
  }

  static double at_least(double a, double b) { return b > a ? b : a; }
  static double at_most(double a, double b) { return b < a ? b : a; }

  // The plan: the condition for the next step.
  bool next_may_begin() const {
    const bool rest =
        hips_rest.get() == cca::ode_status::converged && knees_rest.get() == cca::ode_status::converged;
    const bool calm = stands_still.get() == cca::criterion_state::fulfilled,
               there = at_ball.get() == cca::criterion_state::fulfilled;
    const bool following = dmp_told == cca::component_status::reached;
    switch (now_on) {
      case 0:
        return ball_told == skills::ball_state::near;
      case 1:
        return cpg_rests.get() == cca::ode_status::converged && calm;
      case 2:
        return rest && calm && following;
      case 3:
        return rest && paw_told == skills::paw_state::raised;
      case 4:
        return there;
      case 5:
        return there;
      case 6:
        return rest;
      case 7:
        return rest && paw_told == skills::paw_state::grounded && calm;
      case 8:
        return rest && calm && following;
      default:
        return false;
    }
  }
  void go_on() {
    constexpr std::array<int, 10> otherwise{-1, 9, 8, 7, 6, 6, 7, 8, 9, -1};
    constexpr std::array<std::int64_t, 10> held{0, 0, 0, 0, 0, 1000, 0, 0, 0, 0};
    if (step_began < 0) step_began = k;
    if (now_on == 9) return;
    const auto i = static_cast<std::size_t>(now_on);
    if (!next_may_begin()) held_since = -1;
    else if (held_since < 0) held_since = k;
    if (held_since >= 0 && k - held_since >= held[i]) enter(now_on + 1, false);
    else if (otherwise[i] >= 0 && k - step_began >= 6000) enter(otherwise[i], true);
  }
  void enter(int step, bool by_timeout) {
    now_on = step;
    step_began = k;
    held_since = -1;
    timed_out = by_timeout;
  }

  void run_what_is_needed() {
    const bool stands = 3 <= now_on && now_on <= 7, reaches = 3 <= now_on && now_on <= 6;
    if (!walks && !stands) {
      cpg = {};
      dmp_begun = false;
      dmp_rests = {};
      follows = {};
    }
    if (!touches && reaches) at_ball = {};
    walks = !stands;
    heads = now_on <= 1 || now_on == 9;
    touches = reaches;
  }

  template <class Leg>
  void solve(std::size_t leg, const Vector3d& foot) {
    if (foot.allFinite()) solution[leg] = inverse<Leg>::solve(foot, solution[leg]).q;
  }

  template <class Leg>
  Vector3d rest_of_way(const Vector3d& joints, const Vector3d& point) const {
    const cca::chain_pose<Leg> leg(joints);
    const Eigen::Matrix3d jacobian = leg.jacobian().template bottomRows<3>();
    const Vector3d rest = (point - leg.tip().at).cwiseMax(-steady.most).cwiseMin(+steady.most);
    const Eigen::Matrix3d square =
        jacobian.transpose() * jacobian + steady.damping * steady.damping * Eigen::Matrix3d::Identity();
    return square.inverse() * (jacobian.transpose() * rest);
  }

  template <class Ode>
  static double rate_of(const typename Ode::state& x,
                        const typename Ode::input& u,
                        const typename Ode::parameters& p) {
    return cca::math::norm(Ode::derivative(x, u, p).template head<Ode::state::RowsAtCompileTime - 1>());
  }
  template <class Ode, class Goal>
  void reach(cca::ode_solver<Ode>& joints,
             cca::ode_monitor& rest,
             const typename Ode::parameters& p,
             const Goal& measured,
             const Goal& goal) {
    constexpr int D = Goal::RowsAtCompileTime;
    cca::detail::input_check inputs;
    typename Ode::input u;
    u.template head<D>() = inputs(goal);
    u[D] = vite_speed * 1.0;
    if (inputs.unreadable()) return;
    typename Ode::state x = joints.get();
    if (!begun) {
      x.setZero();
      x.template head<D>() = inputs(measured);
    }
    const bool rested = rest.get() == cca::ode_status::converged;
    if (rested && rest.update(rate_of<Ode>(x, u, p), reaching_settles) == cca::ode_status::transient)
      x[2 * D] = 0;
    joints.set(x);
    joints.advance(u, p, dt);
    rest.update(rate_of<Ode>(joints.get(), u, p), reaching_settles);
  }

  void step() {
    const vector8 angles = body.angles(k);
    const vector4 abducted = body.abduction, contacts = body.contacts();
    const Vector3d rates = body.rates(k);
    const bool seen = k >= echo::shown;
    const Vector3d ball = seen ? echo::ball() : Vector3d(0, 0, 0);
    const double way = ball[0] - skills::hip_in_trunk(0)[0] - skills::reach_ahead;
    if (k % 10 == 0) go_on();

    // Eyes.
    if (!settled && seen) {
      settled = true;
      right = ball[1] < 0;
    }
    const int side = right ? 1 : 0;
    const Vector3d paw_joints(abducted[side], angles[side], angles[4 + side]);
    const Vector3d paw = right ? cca::chain_pose<skills::right_front>(paw_joints).tip().at
                               : cca::chain_pose<skills::left_front>(paw_joints).tip().at;
    const Vector3d missing = ball - paw;
    if (touches) {
      if (missing.norm() < aiming.near)
        correction =
            (correction + aiming.gain * dt * missing).cwiseMax(-aiming.most).cwiseMin(+aiming.most).eval();
      else correction.setZero();
    }

    // Orders and inverse kinematics.
    if (k % 10 == 0) {
      const bool trots = now_on == 0 || now_on == 9, shifted = 2 <= now_on && now_on <= 7,
                 raised = 3 <= now_on && now_on <= 6;
      const std::size_t of_paw = right ? 1 : 0;
      std::array<Vector3d, 4> feet;
      for (std::size_t leg = 0; leg < 4; ++leg) {
        const auto& at = shifted ? orders.stand.feet : leg < 2 ? orders.trot.front : orders.trot.hind;
        const double towards = shifted ? cca::sim::side_of(of_paw) * orders.stand.aside : 0.0;
        feet[leg] = skills::hip_in_trunk(leg) + Vector3d(at.ahead, towards, -at.below);
      }
      if (raised) feet[of_paw][2] += orders.stand.lift;
      if (now_on == 4 || now_on == 5) feet[of_paw] = ball + correction;
      const auto& t = orders.trot;
      wanted = -1;
      if (trots && 1e-9 * static_cast<double>(k * 1'000'000) >= t.start) {
        wanted = t.intercept + t.slope * t.speed;
        if (now_on == 0 && seen)
          wanted = std::max<double>(t.least,
                                    t.intercept + t.slope * std::clamp<double>(t.slowing * way, 0, t.speed));
      }
      hip_stiffness += std::min(1.0, dt10 / orders.stand.stiffening) *
                       ((trots ? t.stiffness : orders.stand.stiffness) - hip_stiffness);
      wanted_stiffness.setConstant(hip_stiffness);
      carrying.setConstant(shifted || now_on == 8 ? 1.0 : 0.0);
      if (raised) carrying[side] = 0;
      solve<skills::left_front>(0, feet[0]);
      solve<skills::right_front>(1, feet[1]);
      solve<skills::left_hind>(2, feet[2]);
      solve<skills::right_hind>(3, feet[3]);
      for (int leg = 0; leg < 4; ++leg) {
        const Vector3d& q = solution[static_cast<std::size_t>(leg)];
        hip_goal[leg] = q[0];
        hip_goal[4 + leg] = q[1];
        knee_goal[leg] = q[2];
      }
    }

    // Reaching Controllers.
    vector8 measured_hips;
    measured_hips << abducted, angles.head<4>();
    reach(hips, hips_rest, vite_h, measured_hips, hip_goal);
    reach(knees, knees_rest, vite_k, vector4(angles.tail<4>()), knee_goal);
    vector8 goal;
    goal << hips.get().segment<4>(4), knees.get().head<4>();
    vector4 sideways = hips.get().head<4>();

    // The paw follows the ball.
    const bool at_ball_now = (now_on == 4 || now_on == 5) && missing.norm() < steady.near;
    share = std::clamp(share + (at_ball_now ? +1 : -1) * dt / steady.onset, 0.0, 1.0);
    if (share > 0) {
      const Vector3d asked(sideways[side], goal[side], goal[4 + side]), aimed = ball + correction;
      const Vector3d more = share * (right ? rest_of_way<skills::right_front>(asked, aimed)
                                           : rest_of_way<skills::left_front>(asked, aimed));
      sideways[side] += more[0];
      goal[side] += more[1];
      goal[4 + side] += more[2];
    }

    vector8 command = goal;  // while the gait rests
    if (walks) {
      // Hopf Oscillator.
      cca::detail::input_check drives;
      const cca::hopf_ode::input drive = drives(cca::hopf_ode::input(wanted, frequency));
      if (drives.unreadable()) {
        radius = std::max(ember, cca::math::norm(cpg.get()));
      } else {
        cpg.advance(drive, {convergence}, dt);
        cca::hopf_ode::state x = cpg.get();
        radius = std::sqrt(cca::math::dot(x, x));
        if (radius < ember) {
          x = radius > 0 ? cca::hopf_ode::state(ember / radius * x) : cca::hopf_ode::state(ember, 0);
          radius = ember;
          cpg.set(x);
        }
        cpg_rests.update(radius > ember ? cca::math::norm(cpg.rate(drive, {convergence})) : 0.0, cpg_settles);
      }
      phase = cca::math::atan2(cpg.get()[1], cpg.get()[0]);

      // DMP Transformation System.
      cca::detail::input_check read;
      const vector8 centre = read(goal);
      const double hertz = read.number(frequency, 0.01, cca::largest_input),
                   swing = std::max(0.0, read.number(radius)), at_phase = read.number(phase);
      const double tau = 1 / (2 * pi * hertz);
      const shape::parameters at{known.function.weights, stiffness_of_shape};
      shape::input u;
      u << centre, swing, tau;
      command = dmp.get().head<8>();
      if (!read.unreadable()) {
        shape::state x = dmp.get();
        if (!dmp_begun) {
          x.setZero();
          x.head<8>() = centre;
          dmp_begun = true;
        }
        x[16] = at_phase - dt / tau;
        dmp.set(x);
        dmp.advance(u, at, dt);
        dmp_rests.update(cca::math::norm(dmp.rate(u, at).head<16>()), dmp_settles);
        command = dmp.get().head<8>();
      }
      region_told = module::learner::inside(known, {at_phase, swing}, settings);
      const double error = cca::detail::furthest(vector8(command - angles));
      const auto tracked = follows.update(error, tracking, dt);
      dmp_told = cca::component_status_from(tracked, static_cast<cca::trained_region>(region_told), true);
    }

    // Trunk: heading, steering, balance.
    if (heads && k % 10 == 0) {
      const Vector3d hip = skills::hip_in_trunk(right ? 1 : 0);
      const double ahead = ball[0] - hip[0],
                   beside = ball[1] - hip[1] + cca::sim::side_of(right ? 1 : 0) * heading.inside;
      const double off = seen && ahead > heading.near ? -cca::math::atan2(beside, ahead)
                                                      : cca::rotation::yaw(body.orientation(k));
      if (radius > 0.1) {
        const double largest = heading.drift > 0 ? heading.most / heading.drift : 0.0;
        aside = std::clamp(aside + dt10 * off, -largest, largest);
      } else {
        aside = 0;
      }
      turn = std::clamp(-heading.gain * off - heading.drift * aside, -heading.most, +heading.most);
    }
    const vector8 around = command;
    for (int leg = 0; leg < 4; ++leg)
      command[leg] -= cca::sim::side_of(static_cast<std::size_t>(leg)) * turn * (around[leg] - goal[leg]);
    swaying += std::min(1.0, dt / balance.smoothing) *
               ((rates.allFinite() ? rates : Vector3d(Vector3d::Zero())) - swaying);
    for (int leg = 0; leg < 4; ++leg) {
      const Vector3d hip = skills::hip_in_trunk(static_cast<std::size_t>(leg));
      const double rising = swaying[0] * hip[1] - swaying[1] * hip[0];
      command[4 + leg] +=
          carrying[leg] * std::clamp(balance.time / balance.lever * rising, -balance.most, +balance.most);
    }

    // Status.
    if (touches && seen) at_ball.update(std::sqrt(cca::math::dot(missing, missing)), reaching, dt);
    ball_told = !seen     ? skills::ball_state::unseen
                : way < 0 ? skills::ball_state::near
                          : skills::ball_state::ahead;
    paw_told = contacts[side] != 0 ? skills::paw_state::grounded : skills::paw_state::raised;
    turning += std::min(1.0, dt / still.each) * (rates - turning);
    smooth += std::min(1.0, dt / still.smoothing) * (turning.norm() - smooth);
    stands_still.update(smooth, still.limits, dt);

    // Limits.
    constexpr const auto& m = cca::sim::oncilla_defaults;
    if (!begun) {
      for (int i = 0; i < 8; ++i)
        last_legs[i] = at_most(i < 4 ? m.hip_range.high : m.knee_range.high,
                               at_least(i < 4 ? m.hip_range.low : m.knee_range.low, angles[i]));
      for (int i = 0; i < 4; ++i)
        last_sideways[i] = at_most(m.abduction_range.high, at_least(m.abduction_range.low, abducted[i]));
    }
    vector8 safe;
    vector4 safe_sideways, safe_stiffness;
    for (int i = 0; i < 8; ++i) {
      const auto range = i < 4 ? m.hip_range : m.knee_range;
      const double rate = i < 4 ? m.hip_motor.no_load_speed : m.knee_motor.no_load_speed;
      safe[i] = at_most(at_most(range.high, last_legs[i] + rate * dt),
                        at_least(at_least(range.low, last_legs[i] + -rate * dt), command[i]));
    }
    for (int i = 0; i < 4; ++i) {
      const double rate = m.abduction_motor.no_load_speed;
      safe_sideways[i] =
          at_most(at_most(m.abduction_range.high, last_sideways[i] + rate * dt),
                  at_least(at_least(m.abduction_range.low, last_sideways[i] + -rate * dt), sideways[i]));
      safe_stiffness[i] = at_most(m.stiffest_hip, at_least(0.0, wanted_stiffness[i]));
    }
    last_legs = safe;
    last_sideways = safe_sideways;
    body.take(safe, safe_sideways, safe_stiffness);
    if (k % 10 == 0) run_what_is_needed();  // from the next beat on
    begun = true;
    ++k;
  }
  vector8 result() const { return body.sum; }
};

}  // namespace bench

int main(int argc, char** argv) { return bench::program<bench::graph, bench::by_hand>(argc, argv); }
