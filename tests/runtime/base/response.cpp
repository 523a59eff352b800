// Gain and phase from records, judged by systems whose response is known in closed form: of discrete time,
// so that nothing is left to an approximation.
#include <doctest/doctest.h>

#include <complex>
#include <functional>
#include <limits>
#include <random>
#include <vector>

#include <cca/base/response/frequency_response.hpp>
#include <cca/base/response/step_response.hpp>
#include <cca/component/testing/test_signal.hpp>

namespace {

using complex = std::complex<double>;
using record = std::vector<double>;
using transfer = std::function<complex(complex)>;  // of z
constexpr double pi = std::numbers::pi, rate = 1000;

record excitation(cca::test_signal signal, double f, double g, double seconds, double rest = 0) {
  record u;
  for (int n = 0; n < static_cast<int>(rate * (seconds + rest)); ++n)
    u.push_back(n < rate * seconds ? 0.3 * cca::test_value(signal, n / rate, f, g, seconds) : 0);
  return u;
}

// y(n) = sum b(i) u(n - i) - sum a(i) y(n - i)
struct filter {
  std::vector<double> b, a;
  record operator()(const record& u) const {
    record y(u.size());
    for (std::size_t n = 0; n < u.size(); ++n) {
      for (std::size_t i = 0; i < b.size() && i <= n; ++i) y[n] += b[i] * u[n - i];
      for (std::size_t i = 0; i < a.size() && i < n; ++i) y[n] -= a[i] * y[n - 1 - i];
    }
    return y;
  }
  complex at(double f) const {
    const complex z = std::polar(1.0, -2 * pi * f / rate);
    complex above = 0, below = 1, power = 1;
    for (const double one : b) above += one * power, power *= z;
    power = z;
    for (const double one : a) below += one * power, power *= z;
    return above / below;
  }
};

filter first_order(double time) {
  const double a = std::exp(-1 / (rate * time));
  return {{0, 1 - a}, {-a}};
}
// Poles of w0 and damping d.
filter second_order(double w0, double d) {
  const double r = std::exp(-d * w0 / rate), angle = w0 / rate * std::sqrt(1 - d * d);
  const double a1 = -2 * r * std::cos(angle), a2 = r * r;
  return {{0, 1 + a1 + a2}, {a1, a2}};
}
filter delayed(filter of, int samples) {
  of.b.insert(of.b.begin(), static_cast<std::size_t>(samples), 0.0);
  return of;
}

void compare(const cca::response_point& found, complex truth, double gain = 0.01, double degrees = 1) {
  INFO("frequency " << found.frequency << " gain " << found.gain << " instead of " << std::abs(truth));
  CHECK(std::abs(found.gain / std::abs(truth) - 1) < gain);
  const double turns = (found.phase - std::arg(truth)) / (2 * pi);
  CHECK(std::abs(turns - std::round(turns)) * 360 < degrees);
}

struct drawn {
  std::mt19937_64 random{20};
  double operator()(double from, double to) {
    return std::uniform_real_distribution<double>(from, to)(random);
  }
};

record noisy(record y, double deviation, drawn& draw) {
  std::normal_distribution<double> one(0, deviation);
  for (double& each : y) each += one(draw.random);
  return y;
}

}  // namespace

TEST_CASE("sine: gain and phase of systems of first and second order with delay, drawn at random") {
  drawn draw;
  for (int i = 0; i < 40; ++i) {
    const filter plant =
        delayed(i % 2 ? first_order(draw(0.005, 0.1)) : second_order(draw(20, 200), draw(0.1, 1)),
                static_cast<int>(draw(0, 9)));
    const double f = draw(1, 90);
    const auto u = excitation(cca::test_signal::sine, f, f, 6);
    compare(cca::sine_response(u, plant(u), rate, f), plant.at(f), 1e-3, 0.1);
    const auto noise = noisy(plant(u), 0.02 * std::abs(plant.at(f)), draw);
    const auto found = cca::sine_response(u, noise, rate, f);
    compare(found, plant.at(f));
    CHECK(found.coherence > 0.98);
  }
}

TEST_CASE("chirp: gain and phase of systems of first and second order with delay, drawn at random") {
  drawn draw;
  const auto at = cca::frequencies(1, 100, 25);
  for (int i = 0; i < 12; ++i) {
    const filter plant =
        delayed(i % 2 ? first_order(draw(0.005, 0.1)) : second_order(draw(20, 200), draw(0.15, 1)),
                static_cast<int>(draw(0, 9)));
    // It rests for a moment after each second one: the others end while the output moves.
    const auto signal = i % 3 ? cca::test_signal::chirp : cca::test_signal::linear_chirp;
    const auto u = excitation(signal, 0.5, 150, 20, i % 2 ? 1 : 0);
    auto y = plant(u);
    for (double& each : y) each += 2;  // where the axis stands
    for (const auto& one : cca::chirp_response(u, y, rate, at)) {
      compare(one, plant.at(one.frequency));
      CHECK(one.coherence > 0.999);
    }
  }
}

TEST_CASE("chirp: the same with noise, and the coherence tells of it") {
  drawn draw;
  const auto at = cca::frequencies(2, 30, 12);
  for (int i = 0; i < 6; ++i) {
    const filter plant = delayed(second_order(draw(80, 200), draw(0.3, 1)), static_cast<int>(draw(0, 9)));
    const auto u = excitation(cca::test_signal::chirp, 1, 60, 40, 1);
    for (const auto& one : cca::chirp_response(u, noisy(plant(u), 0.003, draw), rate, at)) {
      compare(one, plant.at(one.frequency));
      CHECK(one.coherence > 0.9);
    }
    const auto lost = cca::chirp_response(u, noisy(record(u.size()), 1, draw), rate, at);
    double mean = 0;
    for (const auto& one : lost) mean += one.coherence / static_cast<double>(lost.size());
    CHECK(mean < 0.4);
  }
}

TEST_CASE("a closed loop: of it and, as a quotient, of the plant in it, with noise that goes around") {
  drawn draw;
  const auto at = cca::frequencies(2, 40, 12);
  for (int i = 0; i < 4; ++i) {
    const double time = draw(0.02, 0.08), kp = draw(1, 3), ki = draw(5, 20);
    const filter plant = delayed(first_order(time), 2);
    std::normal_distribution<double> noise(0, 1e-3);
    const auto r = excitation(cca::test_signal::chirp, 1, 80, 30, 1);
    record y(r.size()), command(r.size());
    double state = 0, integral = 0;
    const double a = -plant.a[0];
    for (std::size_t n = 0; n < r.size(); ++n) {
      state = a * state + (1 - a) * (n >= 3 ? command[n - 3] : 0);
      y[n] = state + noise(draw.random);
      const double error = r[n] - y[n];
      command[n] = kp * error + integral;
      integral += ki / rate * error;
    }
    const auto pid = [&](double f) { return kp + ki / rate / (std::polar(1.0, 2 * pi * f / rate) - 1.0); };
    const auto to = cca::chirp_response(r, y, rate, at), from = cca::chirp_response(r, command, rate, at);
    const auto inside = cca::ratio_of(to, from);
    for (std::size_t n = 0; n < at.size(); ++n) {
      const complex open = pid(at[n]) * plant.at(at[n]);
      compare(to[n], open / (1.0 + open));
      compare(inside[n], plant.at(at[n]));
    }
  }
}

TEST_CASE("the phase of a delay goes on beyond half a turn") {
  const filter plant = delayed({{1}, {}}, 20);  // 20 ms: at 100 Hz two turns
  const auto u = excitation(cca::test_signal::chirp, 1, 120, 20, 1);
  const auto found = cca::chirp_response(u, plant(u), rate, cca::frequencies(2, 100, 60));
  CHECK(found.back().phase == doctest::Approx(-4 * pi).epsilon(1e-3));
  CHECK(found.back().gain == doctest::Approx(1).epsilon(1e-3));
}

TEST_CASE("step: the figures of first and second order in closed form") {
  drawn draw;
  for (int i = 0; i < 20; ++i) {
    const double time = draw(0.02, 0.2), height = i % 2 ? 0.5 : -0.25;
    const record u(4000, height);
    const auto one = cca::step_response(first_order(time)(u), rate, height);
    CHECK(one.gain == doctest::Approx(1).epsilon(1e-6));
    CHECK(one.rise_time == doctest::Approx(time * std::log(9)).epsilon(1e-3));
    CHECK(one.settling_time == doctest::Approx(time * std::log(50)).epsilon(0.02));
    CHECK(one.overshoot < 1e-6);
    const double d = draw(0.2, 0.8), w0 = draw(20, 100);
    const auto two = cca::step_response(second_order(w0, d)(u), rate, height);
    CHECK(two.overshoot == doctest::Approx(std::exp(-pi * d / std::sqrt(1 - d * d))).epsilon(0.02));
    CHECK(two.gain == doctest::Approx(1).epsilon(1e-6));
  }
}

TEST_CASE("records that are none are refused") {
  const auto u = excitation(cca::test_signal::sine, 5, 5, 2);
  auto bad = u;
  bad[100] = std::numeric_limits<double>::quiet_NaN();
  const record none(u.size()), few(8);
  const std::vector<double> above{600}, right{5}, nan{bad[100]};
  CHECK_THROWS_WITH_AS(cca::sine_response(u, bad, rate, 5), doctest::Contains("no finite number"),
                       cca::refused);
  CHECK_THROWS_WITH_AS(cca::sine_response(few, few, rate, 5), doctest::Contains("at least 16"), cca::refused);
  CHECK_THROWS_WITH_AS(cca::sine_response(u, few, rate, 5), doctest::Contains("same length"), cca::refused);
  CHECK_THROWS_WITH_AS(cca::sine_response(u, u, rate, 0.1), doctest::Contains("longer"), cca::refused);
  CHECK_THROWS_WITH_AS(cca::sine_response(none, u, rate, 5), doctest::Contains("no sine"), cca::refused);
  CHECK_THROWS_WITH_AS(cca::sine_response(u, u, 0, 5), doctest::Contains("rate"), cca::refused);
  CHECK_THROWS_WITH_AS(cca::chirp_response(u, u, rate, above), doctest::Contains("below half the rate"),
                       cca::refused);
  CHECK_THROWS_AS(cca::chirp_response(u, u, rate, nan), cca::refused);
  CHECK_THROWS_AS(cca::chirp_response(bad, u, rate, right), cca::refused);
  CHECK(cca::chirp_response(none, u, rate, right)[0].coherence == 0);
  CHECK_THROWS_AS(cca::frequencies(0, 1, 3), cca::refused);
  CHECK_THROWS_AS(cca::step_response(none, rate, 1), cca::refused);
  CHECK_THROWS_AS(cca::step_response(few, rate, 1), cca::refused);
  CHECK_THROWS_AS(cca::step_response(bad, rate, 1), cca::refused);
  CHECK_THROWS_AS(cca::step_response(u, rate, 0), cca::refused);
}
