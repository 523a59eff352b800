// The torque loop of the arm of examples/touch, in three forms: the graph, the same arithmetic as one loop
// written by hand, and a loop by hand that computes the kinematics and the mass matrix once a beat.
//
// The parts are those of the example: what the flange does and feels, momentum observer, watch, leader,
// Cartesian impedance, gravity compensation, passivity guard and limiter. The robot plays back a motion with
// its torques and the load on the flange; what the plan and the movement primitives ask for is played back
// too: a way, a repeated movement, wiping, yielding, guiding. `bench_arm_controller check` compares the three
// bit for bit.
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <type_traits>

#include <Eigen/Geometry>

#include "../examples/touch/architecture.hpp"
#include "program.hpp"

namespace bench {

namespace arm = touch::arm;
using vector7 = arm::torques::vector_type;
using vector6 = Eigen::Matrix<double, 6, 1>;
using hand = touch::hand::vector_type;
using Eigen::Vector3d, Eigen::Vector4d, Eigen::Vector2d;
using pose_of_arm = cca::body_pose<arm::body>;

// One beat of what is played back.
struct moment {
  vector7 angles, velocities, torques;
  vector6 load;  // along the axes of the flange
  int step;
  bool pressed;
  hand way, repeated, centre;
  vector6 way_twist, repeated_twist;
  Vector2d place, place_velocity;
};

// A motion of three seconds, over and over.
struct playback {
  static constexpr int part = 512, length = 6 * part;
  static constexpr std::array<int, 6> steps{touch::plan::at<"go back">, touch::plan::at<"repeat">,
                                            touch::plan::at<"wipe">,    touch::plan::at<"yield">,
                                            touch::plan::at<"wipe on">, touch::plan::at<"guided">};
  std::array<moment, length> stored;

  playback() {
    for (int i = 0; i < length; ++i) stored[static_cast<std::size_t>(i)] = made(i);
  }
  const moment& operator()(std::int64_t k) const { return stored[static_cast<std::size_t>(k % length)]; }

private:
  static moment made(int i) {
    constexpr double w = 2 * std::numbers::pi / (1e-3 * length);
    const double t = 1e-3 * i;
    moment now;
    now.step = steps[static_cast<std::size_t>(i / part)];
    now.pressed = i % part > part - 32 && i / part == 5;
    vector7 accelerations;
    for (int a = 0; a < 7; ++a) {
      const double turn = 0.1 + 0.01 * a, at = w * t + a;
      now.angles[a] = arm::description::start[static_cast<std::size_t>(a)] + turn * std::sin(at);
      now.velocities[a] = w * turn * std::cos(at);
      accelerations[a] = -w * w * turn * std::sin(at);
    }
    const pose_of_arm at(now.angles);
    const cca::rigid end = at.tip<"arm">();
    now.load.setZero();
    if (touch::presses(now.step)) {
      const Vector3d force(0.5 * std::sin(7 * t), 0.5 * std::cos(5 * t), -10 - std::sin(20 * t));
      now.load << Vector3d(0, 0, 2 * arm::description::tool_radius).cross(force), force;
    }
    vector6 in_base;
    in_base << cca::math::product(end.turn, now.load.head<3>()),
        cca::math::product(end.turn, now.load.tail<3>());
    now.torques = cca::inverse_dynamics(at, now.velocities, accelerations).torques -
                  cca::math::product(at.jacobian<"arm">().transpose(), in_base);
    if (now.step == touch::plan::at<"yield">) now.torques[1] += 8;  // somebody pushes

    const auto aside = [&](double far, double phase) {
      hand wanted;
      wanted << end.at + far * Vector3d(std::sin(3 * t + phase), std::cos(2 * t), std::sin(t)),
          cca::rotation::product(cca::rotation::about(Vector3d(0, 0, 1), 0.1 * std::sin(2 * t + phase)),
                                 cca::detail::quaternion_of(end.turn));
      return wanted;
    };
    now.way = aside(0.02, 0);
    now.repeated = aside(0.03, 1);
    now.centre = aside(0.01, 2);
    for (int c = 0; c < 6; ++c) {
      now.way_twist[c] = 0.05 * std::sin(3 * t + c);
      now.repeated_twist[c] = 0.05 * std::cos(2 * t + c);
    }
    now.place = {0.06 * std::cos(3 * t), 0.04 * std::sin(3 * t)};
    now.place_velocity = {-0.18 * std::sin(3 * t), 0.12 * std::cos(3 * t)};
    return now;
  }
};
const playback played;

struct robot {
  vector7 sum = vector7::Zero();
  auto sense(cca::beat now) -> std::tuple<cca::out<"angles", arm::angles>,
                                          cca::out<"velocities", arm::velocities>,
                                          cca::out<"torques", arm::torques>,
                                          cca::out<"flange_load", touch::load_in_flange>> {
    const moment& m = played(now.index());
    return {m.angles, m.velocities, m.torques, m.load};
  }
  void act(cca::in<"torque", arm::torques> command) { sum += command.vector(); }
};

// In the place of the plan, the path and the movement primitives.
struct skills {
  double pushes = 0;
  auto sense(cca::beat now)
      -> std::tuple<cca::out<"step", cca::step_port>,
                    cca::out<"stop", touch::button_port>,
                    cca::out<"way", touch::hand>,
                    cca::out<"way_twist", touch::hand_motion>,
                    cca::out<"repeated", touch::hand>,
                    cca::out<"repeated_twist", cca::twist_of<touch::hand, touch::flange>>,
                    cca::out<"centre", touch::hand>,
                    cca::out<"place", touch::place_on_table>,
                    cca::out<"place_velocity", cca::velocity_of<touch::place_on_table>>> {
    const moment& m = played(now.index());
    return {m.step,          cca::status_of(m.pressed ? touch::button::pressed : touch::button::released),
            m.way,           m.way_twist,
            m.repeated,      m.repeated_twist,
            m.centre,        m.place,
            m.place_velocity};
  }
  void act(cca::in<"pushed", cca::contact_port> pushed) {
    pushes += pushed.is<cca::contact>(cca::contact::reacting) ? 1 : 0;
  }
};

struct arm_graph
    : cca::graph<cca::rate<1000>,
                 cca::node<"robot", robot>,
                 cca::node<"skills", skills>,
                 cca::node<"flange", cca::part_kinematics<arm::body, "arm", arm::angles, touch::hand>>,
                 cca::node<"motion", touch::flange_motion>,
                 cca::wire<"robot.angles", "flange.angles">,
                 cca::wire<"robot.angles", "motion.angles">,
                 cca::wire<"robot.velocities", "motion.velocities">,
                 cca::wire<"robot.flange_load", "motion.load">,
                 cca::node<"feel", touch::feel>,
                 cca::wire<"motion.load", "feel.load">,
                 cca::wire<"flange.pose", "feel.pose">,
                 cca::node<"observer", touch::observer, cca::timed<1>>,
                 cca::wire<"robot.angles", "observer.angles">,
                 cca::wire<"robot.velocities", "observer.velocities">,
                 cca::wire<"robot.torques", "observer.torques">,
                 cca::node<"watch", touch::watch, cca::timed<1>>,
                 cca::wire<"observer.external", "watch.external">,
                 cca::wire<"robot.angles", "watch.angles">,
                 cca::wire<"motion.load", "watch.load">,
                 cca::wire<"watch.status", "skills.pushed">,
                 cca::node<"leader", touch::leader, cca::timed<1>>,
                 cca::wire<"skills.step", "leader.step">,
                 cca::wire<"skills.stop", "leader.stop">,
                 cca::wire<"skills.way", "leader.way">,
                 cca::wire<"skills.way_twist", "leader.way_twist">,
                 cca::wire<"skills.repeated", "leader.repeated">,
                 cca::wire<"skills.repeated_twist", "leader.repeated_twist">,
                 cca::wire<"skills.centre", "leader.centre">,
                 cca::wire<"skills.place", "leader.place">,
                 cca::wire<"skills.place_velocity", "leader.place_velocity">,
                 cca::wire<"feel.normal", "leader.normal">,
                 cca::wire<"feel.force", "leader.force">,
                 cca::wire<"feel.status", "leader.feeling">,
                 cca::node<"impedance", touch::impedance, cca::timed<1>>,
                 cca::wire<"leader.reference", "impedance.reference">,
                 cca::wire<"leader.twist", "impedance.reference_twist">,
                 cca::wire<"leader.stiffness", "impedance.stiffness">,
                 cca::wire<"leader.damping", "impedance.damping">,
                 cca::wire<"leader.feedforward", "impedance.feedforward">,
                 cca::wire<"robot.angles", "impedance.angles">,
                 cca::wire<"robot.velocities", "impedance.velocities">,
                 cca::node<"posture", touch::posture, cca::timed<1>>,
                 cca::wire<"posture.angles", "impedance.posture">,
                 cca::node<"gravity", touch::gravity, cca::timed<1>>,
                 cca::wire<"robot.angles", "gravity.angles">,
                 cca::node<"guard", touch::guard, cca::timed<1>>,
                 cca::wire<"impedance.torques", "guard.torques">,
                 cca::wire<"robot.angles", "guard.angles">,
                 cca::wire<"robot.velocities", "guard.velocities">,
                 cca::wire<"gravity.torques", "guard.gravity">,
                 cca::node<"limits", cca::limiter<arm::torques>>,
                 cca::wire<"guard.torques", "limits.command">,
                 cca::wire<"limits.safe", "robot.torque">,
                 cca::observe<"feel.*">,
                 cca::observe<"guard.*">> {};

using results = Eigen::Matrix<double, 8, 1>;
struct look_at_robot {
  results operator()(const auto& controller) const {
    results r;
    r << controller.template get<"robot">().sum, controller.template get<"skills">().pushes;
    return r;
  }
};
using graph = as_graph<arm_graph, look_at_robot>;

// The same by hand: one function without samples, ports and origins. Dynamics, kinematics, springs, tanks and
// the check of inputs are the library's functions. With `Once`, kinematics, mass matrix and gravity torques
// are computed once in each beat; else where they are used, as in the components.
template <bool Once>
struct loop {
  static constexpr const char* name = Once ? "shared" : "by_hand";
  static constexpr double dt = 1'000'000 / 1e9, pi = std::numbers::pi;
  using end_of_arm = cca::detail::tip_dynamics_at<arm::body, "arm">;
  using matrix7 = end_of_arm::matrix;
  using solver7 = cca::detail::positive_matrix<7>;
  using limits = cca::detail::limits_of<arm::torques>;

  // Parameters, as in the components.
  touch::feel::parameters feel = touch::feel{}.p;
  touch::watch::parameters watch = touch::watch{}.p;
  touch::leader::parameters lead = touch::leader{}.p;
  touch::impedance::parameters soft = touch::impedance{}.p;
  touch::guard::parameters guard = touch::guard{}.p;
  touch::observer::parameters observer = touch::observer{}.p;
  double gravity = 9.81;

  // State.
  std::int64_t k = 0;
  bool observer_begun = false, tanks_begun = false, impedance_gap = false, guard_gap = false;
  vector7 external = vector7::Zero(), momentum = vector7::Zero(), load_before = vector7::Zero();
  vector7 felt = vector7::Zero();
  double push_lasts = 0, gone_for = 0, integrated = 0;
  bool pushed = false, on_table = false;
  Vector3d normal = Vector3d::UnitZ(), against_normal = Vector3d::UnitZ();
  cca::detail::energy_tank<7> posture_tank, tank;
  double energy = 0, force_told = 0;  // published: guard.energy, feel.force
  bool limiting = false;
  cca::input_status guard_told = cca::input_status::usable;
  vector7 guarded_told = vector7::Zero(), last = vector7::Zero();
  std::int64_t interventions = 0, first_intervention = -1;
  vector7 sum = vector7::Zero();
  double pushes = 0;

  static double at_least(double a, double b) { return b > a ? b : a; }
  static double at_most(double a, double b) { return b < a ? b : a; }

  struct nothing {
    explicit nothing(const vector7&) {}
  };
  using known = std::conditional_t<Once, end_of_arm, nothing>;
  static decltype(auto) pose(const known& all, const vector7& q) {
    if constexpr (Once) return (all.now);
    else return pose_of_arm(q);
  }
  static decltype(auto) end(const known& all, const vector7& q) {
    if constexpr (Once) return (all.end);
    else return pose_of_arm(q).tip<"arm">();
  }
  static decltype(auto) dynamics(const known& all, const vector7& q) {
    if constexpr (Once) return (all);
    else return end_of_arm(q);
  }
  static decltype(auto) mass_of(const known& all, const vector7& q) {
    if constexpr (Once) return (all.mass);
    else return matrix7(cca::mass_matrix(pose_of_arm(q)));
  }
  static decltype(auto) solver_of(const known& all, const matrix7& mass) {
    if constexpr (Once) return (all.solver);
    else return solver7(mass);
  }

  // Where the table touches the tool.
  void touch_table(const vector6& load, const Vector4d& turn) {
    const Vector3d torque = load.head<3>(), force = load.tail<3>();
    const double size = force.norm();
    const bool presses = size > feel.least && std::isfinite(size) && torque.allFinite();
    if (presses) {
      constexpr double r = arm::description::tool_radius;
      const Vector3d centre = cca::rotation::rotate(turn, Vector3d(0, 0, r));
      const double square = force.squaredNorm();
      const Vector3d on_line = cca::rotation::cross<double>(force, torque) / square, off = on_line - centre;
      const double along = off.dot(force), root = along * along - square * (off.squaredNorm() - r * r);
      const double step = (-along - std::sqrt(std::max(root, 0.0))) / square;
      const Vector3d found = -(off + step * force).normalized();
      if (found.allFinite()) {
        const double share = on_table ? std::min(1.0, dt / (feel.smoothing + dt)) : 1.0;
        normal = (normal + share * (found - normal)).normalized();
      }
    }
    gone_for = presses ? 0 : gone_for + dt;
    if (presses && size > feel.touches) on_table = true;
    else if (gone_for > feel.release) on_table = false;
    force_told = presses ? force.dot(normal) : 0.0;
  }

  // Who pushes: the momentum observer, and what the load does not explain.
  void observe(const known& all, const moment& m, const vector7* held) {
    cca::detail::input_check inputs;
    const vector7 q = inputs(m.angles), dq = inputs(m.velocities), drive = inputs(m.torques);
    if (inputs.unreadable()) {
      observer_begun = false;
      return;
    }
    const auto& at = pose(all, q);
    const auto found = cca::joint_momentum(at, dq);
    const vector7 load =
        found.change - (held ? *held : cca::gravity_torques(at, Vector3d(0, 0, -observer.gravity)));
    if (observer_begun) {
      const double gain = 2 * pi * observer.bandwidth;
      const vector7 gained = found.momentum - momentum - dt * (drive + 0.5 * (load + load_before));
      external = (external + gain * gained) / (1 + gain * dt);
    }
    momentum = found.momentum;
    load_before = load;
    observer_begun = true;
  }
  void notice(const known& all, const vector7& q, const vector6& load) {
    const auto& at = pose(all, q);
    const double w = 2 * pi * watch.bandwidth * dt;
    const vector7 due = jacobian(all, at).transpose() * load;
    if (due.allFinite()) felt += w / (1 + w) * (due - felt);
    const vector7 left = (external - felt).cwiseAbs();
    const bool pushing = left.maxCoeff() > watch.threshold, rests = left.maxCoeff() < 0.5 * watch.threshold;
    push_lasts = (pushed ? rests : pushing) ? push_lasts + dt : 0;
    if (push_lasts > (pushed ? watch.release : watch.confirm)) {
      pushed = !pushed;
      push_lasts = 0;
    }
  }
  static decltype(auto) jacobian(const known& all, const pose_of_arm& at) {
    if constexpr (Once) return (all.jacobian);
    else return at.jacobian<"arm">();
  }

  // What the hand should do.
  struct order {
    hand reference;
    vector6 twist, stiffness, damping = vector6::Zero(), force = vector6::Zero();
  };
  static Vector4d against(const Vector3d& to) {
    const Vector3d axis = cca::rotation::cross<double>({0, 0, 1}, to);
    const double sine = axis.norm();
    if (sine < 1e-9) return {1, 0, 0, 0};
    return cca::rotation::product(cca::rotation::about(axis, cca::math::atan2(sine, to[2])),
                                  Vector4d(1, 0, 0, 0));
  }
  double pressure() {
    if (!on_table) {
      integrated = 0;
      return 0.3 * lead.press;
    }
    const double e = lead.press - force_told, wanted = lead.press + lead.proportional * e + integrated;
    const double u = std::clamp(wanted, 0.0, lead.most.value());
    if (u == wanted) integrated += lead.integral * e * dt;
    return u;
  }
  order decide(const moment& m) {
    using touch::plan;
    const bool presses = touch::presses(m.step);
    if (presses)
      against_normal =
          (against_normal + std::min(1.0, dt / lead.aligning) * (normal - against_normal)).normalized();
    else against_normal = Vector3d::UnitZ();
    order o{m.way, m.way_twist, lead.stiff};
    if (m.pressed) {
      o.stiffness.setZero(), o.damping = lead.stopping, o.twist.setZero();
    } else if (m.step == plan::at<"guided"> || m.step == plan::at<"learn">) {
      o.stiffness.setZero(), o.damping = lead.guiding, o.twist.setZero();
    } else if (touch::repeats(m.step)) {
      o.reference = m.repeated, o.twist = m.repeated_twist;
    } else if (presses) {
      const Vector4d turn = against(against_normal);
      const Eigen::Matrix3d axes = cca::rotation::matrix(turn);
      if (m.step != plan::at<"return">) {
        o.reference = m.centre;
        o.reference.template head<3>() += axes.leftCols<2>() * m.place;
        o.twist << 0, 0, 0, axes.leftCols<2>() * m.place_velocity;
      }
      o.reference.template tail<4>() = turn;
      if (m.step == plan::at<"yield">) o.stiffness = lead.soft;
      o.stiffness[5] = 0;
      o.damping[5] = lead.along_normal;
      o.force.template tail<3>() = -pressure() * against_normal;
    }
    if (!presses) integrated = 0;
    return o;
  }

  using matrix6 = Eigen::Matrix<double, 6, 6>;
  static matrix6 square_of(const matrix6& root) { return cca::math::product(root, root.transpose()); }

  // The hand as a spring, the elbow in its posture.
  vector7 impedance(const known& all, const moment& m, const order& o) {
    namespace detail = cca::detail;
    detail::input_check motion, wish;
    const vector7 q = motion(m.angles), dq = motion(m.velocities);
    hand goal = wish(o.reference);
    goal.tail<4>() = cca::rotation::normalised(Vector4d(goal.tail<4>()));
    vector6 twist = wish(o.twist), k6 = detail::at_least_zero(wish, o.stiffness),
            d6 = detail::at_least_zero(wish, o.damping), added = wish(o.force);
    const vector7 rest = wish(vector7(vector7::Map(arm::description::start.data())));
    vector7 torques = vector7::Zero();
    if (motion.unreadable()) {
      impedance_gap = true;
    } else {
      const bool pulls = !wish.unreadable();
      if (!pulls) {
        k6 = soft.stiffness, d6 = soft.damping, twist.setZero(), added.setZero();
        goal << 0, 0, 0, 0, 0, 0, 1;
      }
      const auto& at = dynamics(all, q);
      const Eigen::Matrix3d frame = cca::rotation::matrix(Vector4d(goal.tail<4>()));
      const vector6 away = twist - cca::math::product(at.jacobian, dq);
      matrix6 resists =
          square_of(detail::root_along(frame, d6)) +
          detail::damping_for<6>(at.mobility, detail::root_along(frame, k6), soft.damping_ratio);
      // What acts once a beat must be slow enough for the inertia that it moves.
      const matrix7 damping =
          cca::math::product(cca::math::product(at.jacobian.transpose(), resists), at.jacobian);
      matrix7 stiffness = cca::math::product(
          cca::math::product(at.jacobian.transpose(), square_of(detail::root_along(frame, k6))), at.jacobian);
      vector7 posture_k = soft.posture_stiffness;
      stiffness += posture_k.asDiagonal();
      const double share = detail::stable_share<7, false>(at.mass, damping, stiffness, dt);
      if (share < 1) [[unlikely]] {
        resists *= share;
        k6 *= share * share, posture_k *= share * share;
      }
      vector6 wrench = added + cca::math::product(resists, away);
      if (pulls) wrench += detail::cartesian_spring(at.end, goal, frame, k6, soft.largest).wrench;
      vector7 spring = vector7::Zero();
      if (pulls) spring = at.free_torques(vector7(posture_k.cwiseProduct(rest - q)));
      const vector7 damper = -soft.posture_damping * at.free_momentum(dq);
      if (!tanks_begun) posture_tank.start(soft.posture_energy);
      if (impedance_gap) posture_tank.draw_after_gap(q, soft.posture_energy);
      else posture_tank.draw(q, soft.posture_energy);
      impedance_gap = false;
      const vector7 free = damper + posture_tank.share(spring, damper, dq, at.solver, dt) * spring;
      posture_tank.hold(free, q);
      torques = cca::math::product(at.jacobian.transpose(), wrench) + free;
    }
    return in_limits(torques);
  }

  static vector7 in_limits(const vector7& wanted) {
    vector7 v;
    for (int i = 0; i < 7; ++i) v[i] = limits::in_range(i, wanted[i]);
    return v;
  }

  // The energy that the torques may deliver.
  vector7 guarded(const known& all, const moment& m, const vector7& torques, const vector7& weight) {
    cca::detail::input_check motion, command, weights;
    if (!tanks_begun) tank.start(guard.energy);
    const vector7 q = motion(m.angles), dq = motion(m.velocities), wanted = command(torques);
    vector7 held = weights(weight);
    if (weights.unreadable()) held.setZero();
    guard_told = cca::detail::worse(motion.get(), cca::detail::worse(command.get(), weights.get()));
    double share = 0;
    vector7 passed = vector7::Zero();
    if (motion.unreadable()) {
      guard_gap = true;
    } else {
      if (guard_gap) tank.draw_after_gap(q, guard.most);
      else tank.draw(q, guard.most);
      guard_gap = false;
      const auto& mass = mass_of(all, q);
      const auto& solver = solver_of(all, mass);
      const vector7 brake = -guard.braking * cca::math::product(mass, dq);
      if (!command.unreadable()) share = tank.share(wanted, vector7(vector7::Zero()), dq, solver, dt);
      if (share < 1 && !command.unreadable())
        share = tank.share(vector7(wanted - brake), brake, dq, solver, dt);
      passed = command.unreadable() ? brake : vector7(share * wanted + (1 - share) * brake);
    }
    const vector7 all_torques = passed + held, within = in_limits(all_torques);
    const bool cut = (within.array() != all_torques.array()).any();
    if (!motion.unreadable()) tank.hold(cut ? vector7(within - held) : passed, q);
    energy = tank.joule();
    limiting = share < 1 && !motion.unreadable();
    guarded_told = within;
    return within;
  }

  [[gnu::noinline, gnu::cold]] vector7 corrected(const vector7& command) {
    vector7 value;
    for (int i = 0; i < 7; ++i) {
      const double goal = std::isfinite(command[i]) ? command[i] : 0;
      value[i] = at_most(
          at_most(limits::range[std::size_t(i)].upper, last[i] + limits::rate[std::size_t(i)].upper * dt),
          at_least(at_least(limits::range[std::size_t(i)].lower,
                            last[i] + limits::rate[std::size_t(i)].lower * dt),
                   goal));
      if (value[i] != command[i]) {
        ++interventions;
        if (first_intervention < 0) first_intervention = k;
      }
    }
    return value;
  }
  vector7 limited(const vector7& command) {
    if (!tanks_begun) [[unlikely]]
      for (int i = 0; i < 7; ++i) last[i] = limits::in_range(i, std::isfinite(command[i]) ? command[i] : 0);
    vector7 value;
    bool changed = false;
    for (std::size_t i = 0; i < 7; ++i) {
      const int a = static_cast<int>(i);
      value[a] = at_most(
          at_most(limits::range[i].upper, last[a] + limits::rate[i].upper * dt),
          at_least(at_least(limits::range[i].lower, last[a] + limits::rate[i].lower * dt), command[a]));
      changed |= value[a] != command[a];
    }
    if (changed) [[unlikely]]
      value = corrected(command);
    last = value;
    return value;
  }

  void step() {
    const moment& m = played(k);
    const vector7 q = m.angles;
    const known all(q);

    // The flange.
    const Vector4d turned = cca::detail::tip_in<touch::hand>(end(all, q)).template tail<4>();
    vector6 load;
    const Eigen::Matrix3d turn = end(all, q).turn;
    load << turn * m.load.head<3>(), turn * m.load.tail<3>();
    touch_table(load, turned);
    const vector7 weight = cca::gravity_torques(pose(all, q), Vector3d(0, 0, -gravity));
    observe(all, m, Once ? &weight : nullptr);
    notice(all, q, load);
    pushes += pushed ? 1 : 0;

    const order o = decide(m);
    const vector7 torques = impedance(all, m, o);
    const vector7 safe = limited(guarded(all, m, torques, weight));
    tanks_begun = true;
    sum += safe;
    ++k;
  }
  results result() const {
    results r;
    r << sum, pushes;
    return r;
  }
};
using by_hand = loop<false>;
using shared = loop<true>;

}  // namespace bench

int main(int argc, char** argv) {
  return bench::program<bench::graph, bench::by_hand, bench::shared>(argc, argv);
}
