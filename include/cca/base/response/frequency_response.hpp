// Gain and phase of a system from records of a test: what went in, and what came out.
//
//   const auto bode = cca::chirp_response(excitation, angle, 1000, cca::frequencies(1, 100, 40));
//   bode[0].frequency, bode[0].gain, bode[0].phase, bode[0].coherence
//
//   excitation, output   samples at one rate, in Hz, from the begin of the test on; equally many, finite
//   frequency            Hz
//   gain                 unit of the output per unit of the excitation
//   phase                rad, below 0 where the output comes later; along a list without jumps of a turn
//   coherence            0 to 1: the share of the output that the excitation explains
//
// Works outside of the loop, and allocates. NaN in a record, too few samples and a frequency that is not
// between 0 and half the rate are refused (cca::refused).
//
// A sine: the amplitudes of sin and cos at its frequency and a constant are fitted to the whole periods of
// the last half of the record, so what was there before has died away. Source: IEEE Std 1057-2017, section
// 4.6.
// A chirp: within a narrow band around each frequency the spectra obey Y(k) = G(k) U(k) + T(k), where G is
// the response and T what the ends of the record leave; both are polynomials of degree 2 there, and a least
// squares fit gives them. With degree 0 and T = 0 it is the estimate H1 = S_uy / S_uu. Source: Pintelon and
// Schoukens, System Identification, 2012, sections 7.2 and 2.6; Bendat and Piersol, Random Data, 2010,
// section 6.1.
// In a closed loop the response from one signal to another is the quotient of both responses to the
// excitation: noise that goes around the loop makes no error of the mean. Pintelon and Schoukens, section
// 2.6.4. `ratio_of` is this quotient.
//
// Tests: tests/runtime/base/response.cpp; docs/tuning.md.
#pragma once

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <numbers>
#include <span>
#include <string>
#include <vector>

#include <cca/base/eigen.hpp>
#include <cca/base/math.hpp>
#include <cca/base/refused.hpp>
#include <cca/base/response/spectrum.hpp>

#include <Eigen/Cholesky>
#include <Eigen/QR>

namespace cca {

struct response_point {
  double frequency = 0, gain = 0, phase = 0, coherence = 0;
};

// `count` of them, each higher than the last by the same factor.
inline std::vector<double> frequencies(double from, double to, int count) {
  if (!(from > 0 && to > from && to < 1e12) || count < 2 || count > 100000)
    throw refused("cca::frequencies: expected 0 < from < to, and at least 2 of them");
  std::vector<double> all;
  for (int i = 0; i < count; ++i) all.push_back(from * math::exp(math::log(to / from) * i / (count - 1)));
  return all;
}

namespace detail {

inline void check_records(std::span<const double> u, std::span<const double> y, double rate) {
  if (!(rate > 0 && rate < 1e12)) throw refused("response: expected the rate of the samples in Hz, above 0");
  if (u.size() != y.size() || u.size() < 16)
    throw refused("response: expected two records of the same length, at least 16 samples; they have " +
                  std::to_string(u.size()) + " and " + std::to_string(y.size()));
  const auto is_number = [](double one) { return one > -1e150 && one < 1e150; };
  if (!std::all_of(u.begin(), u.end(), is_number) || !std::all_of(y.begin(), y.end(), is_number))
    throw refused("response: a record has a sample that is no finite number");
}
inline void check_frequency(double f, double rate) {
  if (!(f > 0 && 2 * f < rate))
    throw refused("response: " + std::to_string(f) +
                  " Hz: expected a frequency above 0 and below half the rate, " + std::to_string(0.5 * rate) +
                  " Hz");
}

inline response_point point_of(double frequency, std::complex<double> response, double coherence) {
  return {frequency, math::hypot(response.real(), response.imag()),
          math::atan2(response.imag(), response.real()), std::clamp(coherence, 0.0, 1.0)};
}

struct fitted_sine {
  std::complex<double> amplitude;  // of e^(i w t)
  double explained = 0;            // of the squares around the mean
};
inline fitted_sine fit_sine(std::span<const double> y, double turns_a_sample) {
  Eigen::Matrix3d squares = Eigen::Matrix3d::Zero();
  Eigen::Vector3d products = Eigen::Vector3d::Zero();
  const auto row = [&](std::size_t n) {
    const double turns = turns_a_sample * static_cast<double>(n);
    const double angle = 2 * std::numbers::pi * (turns - math::floor(turns));
    return Eigen::Vector3d(math::cos(angle), math::sin(angle), 1);
  };
  for (std::size_t n = 0; n < y.size(); ++n) {
    const Eigen::Vector3d one = row(n);
    squares += one * one.transpose();
    products += y[n] * one;
  }
  const Eigen::Vector3d x = squares.ldlt().solve(products);
  double left = 0, all = 0, mean = 0;
  for (const double one : y) mean += one / static_cast<double>(y.size());
  for (std::size_t n = 0; n < y.size(); ++n) {
    const double error = y[n] - x.dot(row(n));
    left += error * error, all += (y[n] - mean) * (y[n] - mean);
  }
  return {{x[0], -x[1]}, all > 0 ? 1 - left / all : 0};
}

// G at `bin`, and the share of Y that G U explains.
inline response_point fit_band(const std::vector<std::complex<double>>& u,
                               const std::vector<std::complex<double>>& y,
                               double frequency,
                               double bin,
                               double bins_a_period_of_record) {
  using complex = std::complex<double>;
  const double wide = std::clamp(0.06 * bin, 7 * bins_a_period_of_record, 96 * bins_a_period_of_record);
  const std::size_t half = u.size() / 2;
  const double last = static_cast<double>(half) - 1;
  const auto from = static_cast<std::size_t>(math::floor(std::max(1.0, bin - wide)));
  const auto to = static_cast<std::size_t>(math::ceil(std::min(last, bin + wide)));
  const auto rows = static_cast<Eigen::Index>(to - from + 1);
  Eigen::Matrix<complex, Eigen::Dynamic, 6> terms(rows, 6);
  Eigen::VectorXcd wanted(rows);
  double most = 0;
  for (std::size_t k = from; k <= to; ++k) most = std::max(most, std::abs(u[k]));
  if (!(most > 0)) return {frequency, 0, 0, 0};
  for (Eigen::Index r = 0; r < rows; ++r) {
    const std::size_t k = from + static_cast<std::size_t>(r);
    const double x = (static_cast<double>(k) - bin) / wide;
    const complex one = u[k] / most;
    terms.row(r) << one, x * one, x * x * one, complex(1), complex(x), complex(x * x);
    wanted[r] = y[k];
  }
  // An excitation that passes a band in a moment has a smooth spectrum there, as the ends of the record have:
  // then nothing tells one from the other, and T is left out.
  const Eigen::VectorXcd excitation = terms.col(0);
  const Eigen::Matrix<complex, Eigen::Dynamic, 3> ends = terms.rightCols<3>();
  const Eigen::VectorXcd rough = excitation - ends * ends.householderQr().solve(excitation);
  const bool has_ends = rough.squaredNorm() > 0.9 * excitation.squaredNorm();
  Eigen::Matrix<complex, 6, 1> found = Eigen::Matrix<complex, 6, 1>::Zero();
  if (has_ends) found = terms.householderQr().solve(wanted);
  else found.head<3>() = terms.leftCols<3>().householderQr().solve(wanted);
  const Eigen::VectorXcd by_excitation = terms.leftCols<3>() * found.head<3>();
  const double explained = by_excitation.squaredNorm();
  const double left = (wanted - terms * found).squaredNorm() * static_cast<double>(rows) /
                      static_cast<double>(std::max<Eigen::Index>(rows - 6, 1));
  return point_of(frequency, found[0] / most, explained > 0 ? explained / (explained + left) : 0);
}

// The phases of a list, without jumps of a turn.
inline void join_phases(std::vector<response_point>& all) {
  for (std::size_t i = 1; i < all.size(); ++i) {
    const double turns = (all[i].phase - all[i - 1].phase) / (2 * std::numbers::pi);
    all[i].phase -= 2 * std::numbers::pi * math::floor(turns + 0.5);
  }
}

}  // namespace detail

// Of a test by a sine of this frequency.
inline response_point sine_response(std::span<const double> excitation,
                                    std::span<const double> output,
                                    double rate,
                                    double frequency) {
  detail::check_records(excitation, output, rate);
  detail::check_frequency(frequency, rate);
  const double half = 0.5 * static_cast<double>(output.size());
  const double periods = math::floor(half * frequency / rate);
  if (periods < 1)
    throw refused("response: the last half of the record has no whole period of " +
                  std::to_string(frequency) + " Hz: make the test longer");
  const auto used = static_cast<std::size_t>(math::floor(periods * rate / frequency + 0.5));
  const auto in = detail::fit_sine(excitation.last(used), frequency / rate);
  const auto out = detail::fit_sine(output.last(used), frequency / rate);
  if (!(std::abs(in.amplitude) > 0)) throw refused("response: the excitation has no sine of this frequency");
  return detail::point_of(frequency, out.amplitude / in.amplitude, out.explained);
}

// Of a test by a chirp, at each of these frequencies; those that the chirp does not have get a low coherence.
// The output begins at rest. The record may go on after the end of the chirp, and should until it rests
// again.
inline std::vector<response_point> chirp_response(std::span<const double> excitation,
                                                  std::span<const double> output,
                                                  double rate,
                                                  std::span<const double> at) {
  detail::check_records(excitation, output, rate);
  for (const double f : at) detail::check_frequency(f, rate);
  // Where the output rests.
  const std::size_t tail = std::max<std::size_t>(output.size() / 50, 1);
  double base = 0;
  for (const double one : output.last(tail)) base += one / static_cast<double>(tail);
  std::vector<double> changes(output.begin(), output.end());
  for (double& one : changes) one -= base;
  const auto u = detail::spectrum_of(excitation), y = detail::spectrum_of(changes);
  const auto size = static_cast<double>(u.size());
  std::vector<response_point> all;
  for (const double f : at)
    all.push_back(detail::fit_band(u, y, f, f * size / rate, size / static_cast<double>(excitation.size())));
  detail::join_phases(all);
  return all;
}

// From one output to another, each as the response to the same excitation at the same frequencies.
inline std::vector<response_point> ratio_of(std::span<const response_point> to,
                                            std::span<const response_point> from) {
  std::vector<response_point> all;
  for (std::size_t i = 0; i < to.size() && i < from.size(); ++i)
    all.push_back({to[i].frequency, from[i].gain > 0 ? to[i].gain / from[i].gain : 0,
                   to[i].phase - from[i].phase, std::min(to[i].coherence, from[i].coherence)});
  return all;
}

}  // namespace cca
