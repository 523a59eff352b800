// What is wrong with the readings of a sensor, as parameters, and what it does to them.
//
//   noise        standard deviation of each reading
//   bias         standard deviation of an offset that is drawn once
//   scale        standard deviation of a factor about 1 that is drawn once
//   resolution   readings are whole multiples of it
//   delay        s, to whole beats
//   loss         probability that a reading is lost: the last one is read again
//
// In this order, but that a delayed reading is the first: what was true then is scaled, offset, noisy,
// rounded, lost. All are 0 unless they are set; then the reading is untouched, bit for bit. A number that is
// drawn once is that number of standard deviations, at most 3, times what the parameter says now.
//
//   uncertain_reading<Quantity>   numbers of one quantity
//   uncertain_wrench              three torques, three forces
//   uncertain_orientation         a unit quaternion: noise and bias turn it about each of the world's axes
//   uncertain_contact             yes or no: delay and loss only
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include <cca/base/eigen.hpp>
#include <cca/base/math/random_numbers.hpp>
#include <cca/base/math/roots.hpp>
#include <cca/component/parameters.hpp>
#include <cca/space/methods/rotation.hpp>

namespace cca::sim {

inline constexpr double most_delay = 0.25;  // s

using delay_parameter = quantity<duration, 0, 0.25>;
using share_parameter = bounded<double, 0, 1>;

template <class Quantity>
using spread_of = quantity<Quantity, 0, 1e6>;

template <class Quantity>
struct uncertain_reading {
  BOOST_HANA_DEFINE_STRUCT(uncertain_reading,
                           (spread_of<Quantity>, noise),
                           (spread_of<Quantity>, bias),
                           (share_parameter, scale),
                           (spread_of<Quantity>, resolution),
                           (delay_parameter, delay),
                           (share_parameter, loss));
};

struct uncertain_wrench {
  BOOST_HANA_DEFINE_STRUCT(uncertain_wrench,
                           (spread_of<force>, noise),
                           (spread_of<torque>, torque_noise),
                           (spread_of<force>, bias),
                           (spread_of<torque>, torque_bias),
                           (share_parameter, scale),
                           (delay_parameter, delay),
                           (share_parameter, loss));
};

struct uncertain_orientation {
  BOOST_HANA_DEFINE_STRUCT(uncertain_orientation,
                           (quantity<angle, 0, 3>, noise),
                           (quantity<angle, 0, 3>, bias),
                           (delay_parameter, delay),
                           (share_parameter, loss));
};

struct uncertain_contact {
  BOOST_HANA_DEFINE_STRUCT(uncertain_contact, (delay_parameter, delay), (share_parameter, loss));
};

namespace detail {

// A number of standard deviations.
inline double drawn_deviation(random_numbers& random) { return std::clamp(random.normal(), -3.0, 3.0); }

struct number_error {
  double noise = 0, bias = 0, scale = 0, resolution = 0;
};

// A sample of N numbers that come, and are lost, together.
template <std::size_t N>
class uncertain_channel {
public:
  using numbers = std::array<double, N>;

  void draw(random_numbers& random) {
    for (double& x : bias_) x = drawn_deviation(random);
    for (double& x : scale_) x = drawn_deviation(random);
    has_last_ = false;
  }

  template <class Quantity>
  void change(numbers& now, const uncertain_reading<Quantity>& p, random_numbers& random) {
    const number_error e{p.noise, p.bias, p.scale, p.resolution};
    for (std::size_t k = 0; k < N; ++k) change(now[k], k, e, random);
    lose(now, p.loss, random);
  }
  void change(numbers& now, const uncertain_wrench& p, random_numbers& random) {
    for (std::size_t k = 0; k < N; ++k)
      change(now[k], k,
             k < 3 ? number_error{p.torque_noise, p.torque_bias, p.scale, 0}
                   : number_error{p.noise, p.bias, p.scale, 0},
             random);
    lose(now, p.loss, random);
  }
  void change(numbers& now, const uncertain_orientation& p, random_numbers& random) {
    if constexpr (N == 4) {
      if (p.noise > 0 || p.bias > 0) {
        Eigen::Vector3d turn;
        for (std::size_t k = 0; k < 3; ++k)
          turn[static_cast<Eigen::Index>(k)] =
              p.bias * bias_[k] + p.noise * (p.noise > 0 ? random.normal() : 0);
        const Eigen::Vector4d q =
            rotation::product(rotation::exp<double>(turn), Eigen::Vector4d(Eigen::Vector4d::Map(now.data())));
        Eigen::Vector4d::Map(now.data()) = q;
      }
    }
    lose(now, p.loss, random);
  }
  void change(numbers& now, const uncertain_contact& p, random_numbers& random) { lose(now, p.loss, random); }

private:
  void change(double& x, std::size_t k, const number_error& e, random_numbers& random) const {
    if (e.scale > 0) x *= 1 + e.scale * scale_[k];
    if (e.bias > 0) x += e.bias * bias_[k];
    if (e.noise > 0) x += e.noise * random.normal();
    if (e.resolution > 0) x = e.resolution * math::round(x / e.resolution);
  }
  void lose(numbers& now, double chance, random_numbers& random) {
    if (chance > 0 && has_last_ && random.happens(chance)) now = last_;
    last_ = now, has_last_ = true;
  }

  numbers bias_{}, scale_{}, last_{};
  bool has_last_ = false;
};

// What was so many beats ago, or since the first: a ring.
template <class Value, std::size_t Capacity>
class delay_line {
public:
  void clear() { count_ = 0; }
  Value& add() {
    newest_ = (newest_ + 1) % Capacity;
    count_ = std::min(count_ + 1, Capacity);
    return kept_[newest_];
  }
  // After the first `add`.
  const Value& before(double seconds, double beat) const {
    const auto beats = static_cast<std::size_t>(std::max(0.0, math::round(seconds / beat)));
    return kept_[(newest_ + Capacity - std::min(beats, count_ - 1)) % Capacity];
  }

private:
  std::array<Value, Capacity> kept_{};
  std::size_t newest_ = 0, count_ = 0;
};

}  // namespace detail
}  // namespace cca::sim
