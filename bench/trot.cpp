// The trot's controller with a robot that plays angles back, in three forms.
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <cca/sim/oncilla/oncilla_model.hpp>

#include "../examples/trot/architecture.hpp"
#include "classical.hpp"
#include "program.hpp"

namespace bench {

using angles = cca::sim::leg_angles;
using vector8 = angles::vector_type;

// Plays 64 beats of joint angles and orientations over and over, and adds up its commands.
struct playback {
  static constexpr int length = 64;
  std::array<vector8, length> stored;
  std::array<Eigen::Vector4d, length> orientations;
  playback() {
    for (int i = 0; i < length; ++i) {
      for (int a = 0; a < 8; ++a)
        stored[static_cast<std::size_t>(i)][a] = 0.8 + 0.2 * (a / 4) + 0.1 * std::sin(0.1 * i + a);
      const double yaw = 0.1 * std::sin(0.1 * i);
      orientations[static_cast<std::size_t>(i)] = {0, 0, std::sin(yaw / 2), std::cos(yaw / 2)};
    }
  }
};
const playback played;

struct robot {
  vector8 sum = vector8::Zero();
  std::tuple<cca::out<"angles", angles>, cca::out<"orientation", cca::sim::trunk_orientation>> sense(
      cca::beat now) {
    const auto i = static_cast<std::size_t>(now.index() % playback::length);
    return {played.stored[i], played.orientations[i]};
  }
  void act(cca::in<"command", angles> command) { sum += command.vector(); }
};

struct trot_graph : trot::architecture<robot> {};
struct look_at_robot {
  vector8 operator()(const auto& controller) const { return controller.template get<"robot">().sum; }
};
using graph = as_graph<trot_graph, look_at_robot>;

// The same by hand: one function without samples, ports and origins.
struct by_hand {
  static constexpr const char* name = "by_hand";
  static constexpr double pi = std::numbers::pi, whole = 2 * pi;
  static constexpr double dt = 1'000'000 / 1e9, dt10 = 10'000'000 / 1e9;

  // Parameters, as in the components.
  double speed = 0.75, start = 0.2, intercept = 0.165, slope = 0.95;
  double heading = 1.29, drift = 0.5, most = 0.5, upright = 0.78, average = 1, level = 0.79, damp = 0.017,
         most_lean = 0.5;
  double frequency = 4.0, convergence = 10.0;
  struct leg {
    double hip, knee, swing, lift;
  };
  leg front{trot::degrees(47), trot::degrees(96.6), trot::degrees(18.3), trot::degrees(51.6)};
  leg hind{trot::degrees(36.1), trot::degrees(91.8), trot::degrees(19.3), trot::degrees(58.4)};
  double duty = 0.536, even = 0.925, give = trot::degrees(0.4), lead = -0.035, squat = 0.8;
  std::array<double, 4> offsets{0.0, 0.5, 0.379, -0.121};

  // State.
  long k = 0;
  double wanted = 0, turn = 0, hips = 0, knees = 0, aside = 0, incline = 0, last_roll = 0;
  Eigen::Vector2d oscillator{0.01, 0};
  vector8 last = vector8::Zero(), sum = vector8::Zero();
  bool limiter_begun = false;
  long interventions = 0, first_intervention = -1;

  static double at_least(double a, double b) { return b > a ? b : a; }
  static double at_most(double a, double b) { return b < a ? b : a; }

  double sweep(double phase) const {
    const double landing = whole * duty;
    const bool in_stance = phase < landing;
    const double part = in_stance ? phase / landing : (phase - landing) / (whole - landing);
    const double cosine = cca::math::cos(pi * (in_stance ? part : 1 + part));
    const double swing = -2 * (1 - duty) / duty;
    const double straight =
        in_stance ? 1 - 2 * part : -1 + part * (swing + part * (3 * (2 - swing) + part * 2 * (swing - 2)));
    return cosine + even * (straight - cosine);
  }
  double flexion(double phase, double lift) const {
    const double landing = whole * duty;
    const bool in_stance = phase <= landing;
    const double part = in_stance ? phase / landing : (phase - landing) / (whole - landing);
    const double height = in_stance ? give : lift;
    const double sine = cca::math::sin(pi * part);
    return height * sine * sine;
  }

  // First the hips, then the knees.
  static constexpr double low(int i) {
    return i < 4 ? cca::sim::oncilla_defaults.hip_range.low : cca::sim::oncilla_defaults.knee_range.low;
  }
  static constexpr double high(int i) {
    return i < 4 ? cca::sim::oncilla_defaults.hip_range.high : cca::sim::oncilla_defaults.knee_range.high;
  }
  static constexpr double rate(int i) {
    return i < 4 ? cca::sim::oncilla_defaults.hip_motor.no_load_speed
                 : cca::sim::oncilla_defaults.knee_motor.no_load_speed;
  }

  [[gnu::noinline, gnu::cold]] vector8 corrected(const vector8& command) {
    vector8 value;
    for (int i = 0; i < 8; ++i) {
      const double goal = std::isfinite(command[i]) ? command[i] : last[i];
      value[i] = at_most(at_most(high(i), last[i] + rate(i) * dt),
                         at_least(at_least(low(i), last[i] + -rate(i) * dt), goal));
      if (value[i] != command[i]) {
        ++interventions;
        if (first_intervention < 0) first_intervention = k;
      }
    }
    return value;
  }

  void step() {
    const auto beat = static_cast<std::size_t>(k % playback::length);
    const vector8& measured = played.stored[beat];
    if (k % 10 == 0) {
      const double time = static_cast<double>(k * 1'000'000) * 1e-9;
      wanted = speed > 0 && time >= start ? intercept + slope * speed : -1.0;
      const Eigen::Vector4d& q = played.orientations[beat];
      const double yaw =
          cca::math::atan2(2 * (q[3] * q[2] + q[0] * q[1]), 1 - 2 * (q[1] * q[1] + q[2] * q[2]));
      const double pitch = cca::math::asin(std::clamp(2 * (q[3] * q[1] - q[2] * q[0]), -1.0, 1.0));
      const double roll =
          cca::math::atan2(2 * (q[3] * q[0] + q[1] * q[2]), 1 - 2 * (q[0] * q[0] + q[1] * q[1]));
      if (std::isfinite(yaw + pitch + roll)) {
        const double largest = drift > 0 ? most / drift : 0.0;
        aside = std::clamp(aside + dt10 * yaw, -largest, largest);
        turn = std::clamp(-heading * yaw - drift * aside, -most, +most);
        incline += std::min(1.0, dt10 / average) * (pitch - incline);
        const double rolling = (roll - last_roll) / dt10;
        last_roll = roll;
        hips = std::clamp(upright * incline, -most_lean, +most_lean);
        knees = std::clamp(level * roll + damp * rolling, -most_lean, +most_lean);
      }
    }

    const double square = oscillator.squaredNorm();
    double growth = wanted > 0 ? std::max(-1.0, 1 - square / (wanted * wanted)) : -1.0;
    if (wanted <= 0 && square < 0.01 * 0.01) growth = 0;
    const double along = convergence * growth, around = 2 * pi * frequency;
    oscillator += dt * Eigen::Vector2d(along * oscillator.x() - around * oscillator.y(),
                                       along * oscillator.y() + around * oscillator.x());
    const double phase = cca::math::atan2(oscillator.y(), oscillator.x()),
                 amplitude = std::sqrt(oscillator.squaredNorm());

    vector8 command;
    const double squatting = squat * std::max(0.0, -hips);
    for (int l = 0; l < 4; ++l) {
      const leg& shape = l < 2 ? front : hind;
      const double side = l % 2 == 0 ? 1.0 : -1.0;
      const double own = phase + whole * offsets[static_cast<std::size_t>(l)];
      command[l] =
          shape.hip + hips + amplitude * (1 - side * turn - hips) * shape.swing * sweep(cca::wrap_turn(own));
      command[4 + l] = shape.knee + side * knees + (l < 2 ? -squatting : squatting) +
                       amplitude * flexion(cca::wrap_turn(own + whole * lead), shape.lift);
    }

    if (!limiter_begun) {
      for (int i = 0; i < 8; ++i) last[i] = at_most(high(i), at_least(low(i), measured[i]));
      limiter_begun = true;
    }
    vector8 safe;
    bool changed = false;
    for (int i = 0; i < 8; ++i) {
      safe[i] = at_most(at_most(high(i), last[i] + rate(i) * dt),
                        at_least(at_least(low(i), last[i] + -rate(i) * dt), command[i]));
      changed |= safe[i] != command[i];
    }
    if (changed) safe = corrected(command);
    last = safe;
    sum += safe;
    ++k;
  }
  vector8 result() const { return sum; }
};

struct in_classical_way {
  static constexpr const char* name = "classical";
  trot::throttle throttle;
  trot::posture posture;
  trot::stride_oscillator cpg;
  trot::gait gait;
  cca::limiter<angles> limits;
  robot body;
  classical::architecture loop{1'000'000};

  in_classical_way() {
    using namespace classical;
    loop.add<&robot::sense>("sense", body, std::make_unique<every>(1));
    loop.add<&trot::throttle::process>("throttle", throttle, std::make_unique<every>(10), 10);
    loop.add<&trot::posture::process>("posture", posture, std::make_unique<every>(10), 10);
    loop.add<&trot::stride_oscillator::process>("cpg", cpg, std::make_unique<every>(1));
    loop.add<&trot::gait::process>("gait", gait, std::make_unique<when_first_is_fresh>());
    loop.add<&cca::limiter<angles>::process>("limits", limits, std::make_unique<when_fresh>());
    loop.add<&robot::act>("act", body, std::make_unique<every>(1));
    loop.connect("sense.orientation", "posture.orientation");
    loop.connect("throttle.amplitude", "cpg.amplitude");
    loop.connect("posture.turn", "gait.turn");
    loop.connect("posture.lean", "gait.lean");
    loop.connect("cpg.phase", "gait.phase");
    loop.connect("cpg.amplitude", "gait.amplitude");
    loop.connect("gait.angles", "limits.command");
    loop.connect("sense.angles", "limits.measured");
    loop.connect("limits.safe", "act.command");
  }
  in_classical_way(const in_classical_way&) = delete;
  void step() { loop.step(); }
  vector8 result() const { return body.sum; }
};

}  // namespace bench

int main(int argc, char** argv) {
  return bench::program<bench::graph, bench::by_hand, bench::in_classical_way>(argc, argv);
}
