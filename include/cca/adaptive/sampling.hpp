// A learner that makes its own examples: it asks for the output at points spread evenly over a box (the
// source document, chapter 3, *Learner*: it possibly generates its training data by sampling).
//
//   m.learning.collect();
//   cca::sample_examples(m.learning, lowest, highest, 2000, m.p.settings, [&](const Eigen::Vector2d& q) {
//     return cca::example<model>{paw_of(q), q};         a posture and its paw position: inverse kinematics
//   });
//   m.learning.hand_over(m.learning.begin_batch(m.p.settings)());
//
// Call it between two beats. The points are the Halton sequence, the same in each run: any number of them
// covers the box evenly, unlike random points. The function may ask a model, a measurement or another
// component. An example that is not finite is ignored.
// Errors: `cca::refused` if the training is neither collecting nor learning online.
// Source: Halton, On the efficiency of certain quasi-random sequences of points, Numerische Mathematik 2,
// 1960.
// Example: tests/runtime/adaptive/mapping.cpp.
#pragma once

#include <array>
#include <cstdint>

#include <cca/base/messages/holds_or_tells.hpp>
#include <cca/adaptive/training.hpp>

namespace cca {
namespace detail {

inline constexpr std::array halton_bases{2, 3, 5, 7, 11, 13, 17, 19, 23, 29, 31, 37};

// The digits of `index` in a base, mirrored at the radix point: in [0, 1).
constexpr double mirrored(std::int64_t index, int base) {
  double sum = 0, place = 1;
  for (; index > 0; index /= base) sum += static_cast<double>(index % base) * (place /= base);
  return sum;
}

template <int Count>
struct too_many_dimensions {
  static constexpr void tell(text& m) {
    m << "cca::spread_point: points of " << Count
      << " dimensions are wanted, and a Halton sequence covers at most 12 evenly: spread fewer at once";
  }
};

}  // namespace detail

// The point number `index` (from 0) of the sequence between `low` and `high`.
template <detail::FixedVector Point>
Point spread_point(const Point& low, const Point& high, std::int64_t index) {
  static_assert(
      detail::holds_or_tells<(Point::SizeAtCompileTime <= static_cast<int>(detail::halton_bases.size())),
                             detail::too_many_dimensions<Point::SizeAtCompileTime>>::value);
  Point point;
  for (int i = 0; i < point.size(); ++i)
    point[i] = low[i] + (high[i] - low[i]) *
                            detail::mirrored(index + 1, detail::halton_bases[static_cast<std::size_t>(i)]);
  return point;
}

template <Learner Rule, int Capacity, detail::FixedVector Point, class Ask>
void sample_examples(training<Rule, Capacity>& learning,
                     const Point& low,
                     const Point& high,
                     std::int64_t count,
                     const typename Rule::settings& settings,
                     Ask ask) {
  if (learning.state() != cca::learning::collecting && learning.state() != cca::learning::online)
    throw refused("cca::sample_examples: refused while it is `" + std::string(to_string(learning.state())) +
                  "`: collect() or learn() first");
  for (std::int64_t i = 0; i < count; ++i) {
    const example<typename Rule::model> one = ask(spread_point(low, high, i));
    learning.teach(one.x, one.y, settings);
  }
}

}  // namespace cca
