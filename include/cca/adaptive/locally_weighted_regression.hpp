// Locally weighted regression: fits each weight of a local model separately, to the examples near it.
//
//   w_i = sum_t psi_i(x_t) s_t y_t / sum_t psi_i(x_t) s_t^2                    batch
//   A_i += psi_i s^2 - (1 - l) psi_i A_i,  w_i += psi_i s (y - s w_i) / A_i    online, the same sums with
//                                                                              forgetting l
//
// psi_i are the normalised activations of the model, s its scale. With l = 1 both give the same weights. The
// weights are local averages of y / s, so the width of a function smooths the shape. Least squares
// (recursive_least_squares.hpp) does not smooth, but lets distant examples act. Forgetting is weighted by the
// activation, so regions that are not visited are not forgotten. Trained region: the functions that are
// active at x have seen examples.
//
// Examples and inputs that are NaN or infinite don't come here (learner.hpp), so the weights stay finite.
//
// Cost: a step takes N (2 D + 6) products and the activations; a batch that per example.
// Source: Ijspeert, Nakanishi, Hoffmann, Pastor, Schaal, Neural Computation 25, 2013, equation 2.14 (batch);
// Schaal and Atkeson, Constructive incremental learning from only local information, Neural Computation 10,
// 1998 (online). Checked against the first formula written out. Example: tests/runtime/adaptive/learners.cpp.
#pragma once

#include <cca/base/math/reductions.hpp>
#include <cca/adaptive/learner.hpp>
#include <cca/component/field_types.hpp>

namespace cca {

template <LocalModel Model>
struct locally_weighted_regression {
  using model = Model;
  using input = typename model::input;
  using output = typename model::output;
  using local = decltype(model::activations(std::declval<const input&>()));
  using parameters = typename model::parameters;
  static constexpr std::string_view name = "locally_weighted_regression";

  struct settings {
    BOOST_HANA_DEFINE_STRUCT(settings,
                             (bounded<double, 0, 1>, memory),              // l: 1 forgets nothing
                             (bounded<double, 0, infinity>, least_seen));  // examples near x, else outside
    constexpr settings(double keep = 1.0, double least = 1.0) : memory(keep), least_seen(least) {}
  };

  struct learned {
    BOOST_HANA_DEFINE_STRUCT(learned, (parameters, function), (local, evidence), (local, seen));
    learned() : function(), evidence(local::Zero()), seen(local::Zero()) {}
  };

  // always_inline: a call in the beat otherwise (docs/compilers.md).
  [[gnu::always_inline]] static bool inside(const learned& known, const input& x, const settings& s) {
    return math::dot(model::activations(x), known.seen) >= s.least_seen;
  }

  static void step(learned& known, const input& x, const output& y, const settings& s) {
    const local near = model::activations(x);
    const double scale = model::scale(x);
    for (int i = 0; i < near.size(); ++i) {
      const double forget = (1 - s.memory) * near[i];
      known.evidence[i] += near[i] * scale * scale - forget * known.evidence[i];
      known.seen[i] += near[i] - forget * known.seen[i];
      if (known.evidence[i] > negligible)
        known.function.weights.col(i) +=
            near[i] * scale / known.evidence[i] * (y - scale * known.function.weights.col(i));
    }
  }

  static learned batch(std::span<const example<model>> examples, const settings& s) {
    learned known;
    for (const auto& one : examples) step(known, one.x, one.y, settings(1.0, s.least_seen));
    return known;
  }

private:
  static constexpr double negligible = 1e-200;
};

}  // namespace cca
