// The region in which a learner was trained: a few of its inputs (centres) and a radius, such that each
// example lies within the radius of a centre.
//
// The centres are chosen one by one: each is the example farthest from those chosen before. No choice of as
// many centres has less than half of this radius. Distances are in units of `width`, the standard deviation
// of the examples along each axis. Cost: M distances per query; M N to make it from N examples.
// Source: Gonzalez, Clustering to minimize the maximum intercluster distance, Theoretical Computer Science
// 38, 1985.
#pragma once

#include <algorithm>
#include <limits>
#include <vector>

#include <cca/base/math/reductions.hpp>
#include <cca/base/math/roots.hpp>
#include <cca/base/reflect.hpp>
#include <cca/base/eigen.hpp>

namespace cca {

template <int I, int M>
struct covered_region {
  using input = Eigen::Matrix<double, I, 1>;
  using centre_matrix = Eigen::Matrix<double, I, M>;
  BOOST_HANA_DEFINE_STRUCT(covered_region, (centre_matrix, centres), (input, width), (double, radius));

  // Empty: the radius is negative.
  covered_region() : centres(centre_matrix::Zero()), width(input::Ones()), radius(-1) {}

  bool contains(const input& x, double margin) const {
    double nearest = std::numeric_limits<double>::infinity();
    for (int j = 0; j < M; ++j)
      nearest = std::min(nearest, math::squared_norm((x - centres.col(j)).cwiseQuotient(width)));
    const double reach = (1 + margin) * radius;
    return radius >= 0 && nearest <= reach * reach * (1 + 1e-12) + 1e-18;
  }

  // Precondition: at least one input.
  template <class Inputs>
  static covered_region over(const Inputs& inputs) {
    covered_region region;
    input mean = input::Zero(), square = input::Zero();
    for (const input& x : inputs) mean += x;
    mean /= static_cast<double>(inputs.size());
    for (const input& x : inputs) square += (x - mean).cwiseAbs2();
    for (int i = 0; i < I; ++i) {
      const double deviation = math::sqrt(square[i] / static_cast<double>(inputs.size()));
      region.width[i] = deviation > 0 ? deviation : 1.0;
    }
    std::vector<double> nearest(inputs.size(), std::numeric_limits<double>::infinity());
    std::size_t chosen = 0;
    for (int j = 0; j < M; ++j) {
      region.centres.col(j) = inputs[chosen];
      for (std::size_t k = 0; k < inputs.size(); ++k)
        nearest[k] = std::min(nearest[k],
                              math::squared_norm((inputs[k] - inputs[chosen]).cwiseQuotient(region.width)));
      chosen = static_cast<std::size_t>(std::max_element(nearest.begin(), nearest.end()) - nearest.begin());
    }
    region.radius = math::sqrt(nearest[chosen]);
    return region;
  }
};

}  // namespace cca
