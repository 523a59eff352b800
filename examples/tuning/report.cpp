// The tuning of docs/tuning.md without a door: tests in a fast run, what they tell, and the gains made of it.
//
//   tuning_report [FILE.csv]    the curves, for the picture
#include <cstdio>
#include <string>
#include <vector>

#include <cca/base/response/frequency_response.hpp>
#include <cca/base/response/step_response.hpp>

#include "axis.hpp"

namespace {

using controller = cca::controller<tuning::axis>;

// [record]
struct records {
  std::vector<double> excitation, torque, angle;
};

// One test from the start on, and half a second more.
records test(
    controller& c, cca::test_signal signal, double amplitude, double from, double to, double seconds) {
  auto p = c.get<"test_servo_reference">().p;
  p.signal = signal, p.amplitude = amplitude, p.frequency = from, p.to = to, p.duration = seconds;
  p.run = p.run + 1;  // begins with the next sample
  c.set<"test_servo_reference">(p);
  records all;
  const auto& motor = c.get<"drive">().motor.now;
  for (int k = 0; k < 1000 * (seconds + 0.5); ++k) {
    all.angle.push_back(motor.position);  // what the servo sees in this beat
    c.step();
    all.torque.push_back(motor.torque);
    all.excitation.push_back(
        k < 1000 * seconds ? amplitude * cca::test_value(signal, 1e-3 * k, from, to, seconds) : 0);
  }
  return all;
}
// [record end]

void tell(const char* gains, const cca::step_figures& step) {
  std::printf("%s: rise %.3f s, overshoot %.1f %%, settled after %.3f s\n", gains, step.rise_time,
              100 * step.overshoot, step.settling_time);
}

}  // namespace

int main(int count, char** words) {
  controller c;
  auto soft = c.get<"servo">().p;
  soft.proportional[0] = 1, soft.derivative[0] = 0.05, soft.filter = 0.001;
  c.load();
  c.set<"servo">(soft);
  c.start();
  for (int k = 0; k < 3000; ++k) c.step();  // to where it rests

  const auto before = test(c, cca::test_signal::step, 0.1, 1, 1, 2);
  const auto step_before = cca::step_response(std::span(before.angle).first(2000), 1000, 0.1);
  for (int k = 0; k < 3000; ++k) c.step();
  const auto chirp = test(c, cca::test_signal::chirp, 0.05, 0.5, 50, 20);

  // [bode]
  const auto at = cca::frequencies(0.7, 40, 40);
  const auto angle = cca::chirp_response(chirp.excitation, chirp.angle, 1000, at);
  const auto torque = cca::chirp_response(chirp.excitation, chirp.torque, 1000, at);
  const auto plant = cca::ratio_of(angle, torque);  // rad per N m
  // [bode end]

  // [gains]
  // Where the open loop is to cross 1, and how far from -180 degrees its phase is to be there.
  const double crossing = 8, margin = 60 * cca::pi / 180;
  std::size_t n = 0;
  while (n + 1 < plant.size() && plant[n].frequency < crossing) ++n;
  const double w = 2 * cca::pi * plant[n].frequency;
  const double lead = margin - cca::pi - plant[n].phase;  // of the controller, kp + kd s
  const double kp = cca::math::cos(lead) / plant[n].gain, kd = cca::math::sin(lead) / plant[n].gain / w;
  // [gains end]
  std::printf("plant at %.2f Hz: %.4f rad/(N m), %.1f deg, coherence %.4f\n", plant[n].frequency,
              plant[n].gain, plant[n].phase * 180 / cca::pi, plant[n].coherence);
  std::printf("gains: proportional %.3f N m/rad, derivative %.4f N m s/rad\n", kp, kd);

  auto stiff = soft;
  stiff.proportional[0] = kp, stiff.derivative[0] = kd;
  c.set<"servo">(stiff);
  for (int k = 0; k < 3000; ++k) c.step();
  const auto after = test(c, cca::test_signal::step, 0.1, 1, 1, 2);
  const auto step_after = cca::step_response(std::span(after.angle).first(2000), 1000, 0.1);
  tell("before", step_before);
  tell("after ", step_after);

  if (count < 2) return 0;
  std::FILE* const file = std::fopen(words[1], "w");
  if (!file) return std::perror(words[1]), 1;
  for (std::size_t i = 0; i < plant.size(); ++i)
    std::fprintf(file, "bode,%g,%g,%g,%g,%g,%g\n", plant[i].frequency, plant[i].gain,
                 plant[i].phase * 180 / cca::pi, plant[i].coherence, angle[i].gain,
                 angle[i].phase * 180 / cca::pi);
  for (std::size_t i = 0; i < 1500; ++i)
    std::fprintf(file, "step,%g,%g,%g\n", 1e-3 * static_cast<double>(i), before.angle[i], after.angle[i]);
  return std::fclose(file);
}
