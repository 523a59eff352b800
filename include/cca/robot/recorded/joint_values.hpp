// The sines and cosines of a body's angles, each once: several at a time, in the lanes of a vector.
//
// `numbers`: a cosine for each joint value of the reduced body, then the sines; of a prismatic joint the
// first is its way, and there is no second. Cost: about 75 instructions an angle, 50 with AVX2.
#pragma once

#include <cstring>

#include <cca/base/compiler.hpp>
#include <cca/base/math/angles.hpp>
#include <cca/base/unrolled.hpp>
#include <cca/mapping/kinematics.hpp>
#include <cca/robot/recorded/reduced_body.hpp>

namespace cca::detail {

template <class Body>
class joint_values {
  static constexpr const auto& body = reduced_body_of<Body>;
  static constexpr const auto& links = body_tree_of<Body>.links;
  static constexpr int count = body.value_count;

  // The joint of a link beside its joint value: which way it turns, and the cosine and sine of its rest.
  struct from_value {
    int index = 0;
    double sign = 1, cosine = 1, sine = 0;
  };
  static constexpr auto joints = [] {
    std::array<from_value, links.size()> all{};
    for (std::size_t i = 0; i < links.size(); ++i) {
      const auto& v = body.values[static_cast<std::size_t>(body.links[i].value)];
      all[i] = {body.links[i].value, links[i].ratio == v.ratio ? 1.0 : -1.0, 1, 0};
      if (links[i].rest == 0) continue;
      all[i].cosine = constant_cosine(links[i].rest);
      all[i].sine = constant_sine(links[i].rest);
    }
    return all;
  }();

  template <class T>
  CCA_INLINE void store(int first, T x) {
    const auto both = math::sine_and_cosine(x);
    std::memcpy(numbers + first, &both.cosine, sizeof(T));
    std::memcpy(numbers + count + first, &both.sine, sizeof(T));
  }

public:
  double numbers[std::size_t{2 * count + (count == 0)}];

  // Why it is not inlined: docs/compilers.md.
  template <class Vector>
  [[gnu::noinline]] void take(const Vector& q) {
    double x[std::size_t{count + 1}];
    unrolled<count>([&](auto k) {
      constexpr joint_value v = body.values[static_cast<std::size_t>(k())];
      if constexpr (v.ratio == 1) x[k()] = q[v.coordinate];
      else x[k()] = v.ratio * q[v.coordinate];
    });
    constexpr int together = count - count % lane_count;
    for (int k = 0; k < together; k += lane_count) {
      lanes some;
      std::memcpy(&some, x + k, sizeof some);
      store(k, some);
    }
    for (int k = together; k < count; ++k) store(k, x[k]);
    unrolled<count>([&](auto k) {
      constexpr bool slides = !body.values[static_cast<std::size_t>(k())].revolute;
      if constexpr (slides) numbers[k()] = x[k()], numbers[count + k()] = 0;
    });
  }

  joint_turn turn_of(std::size_t i) const {
    const from_value& j = joints[i];
    const double c = numbers[j.index];
    if (links[i].kind == joint_kind::prismatic) return {j.sign * c + links[i].rest, 0};
    const double s = j.sign * numbers[count + j.index];
    if (links[i].rest == 0) return {c, s};
    return {c * j.cosine - s * j.sine, s * j.cosine + c * j.sine};
  }
};

}  // namespace cca::detail
