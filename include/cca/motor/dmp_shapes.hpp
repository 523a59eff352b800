// The shapes of movement primitives as models for a learner: the weights of their forcing terms.
//
//   rhythmic_shape<S, N>   input: phase (rad), amplitude    output: forcing term f = r W Psi(phi)
//   discrete_shape<S, N>   input: canonical variable x      output: f = x W Psi(x); if scaled: f / (g - y0)
//   pose_shape<S, N>       the same for a pose
//
// W has one row per axis of S; for a pose three for the position, then three for the rotation. Psi are the
// normalised activations of equations/dmp_basis.hpp. `wanted_forcing` of the primitives' equations gives the
// forcing term that a demonstration needs (2.12). Source: Ijspeert et al., Neural Computation 25, 2013,
// equations 2.3 and 2.7.
#pragma once

#include <string>

#include <cca/space/messages/space_in_words.hpp>
#include <cca/base/messages/holds_or_tells.hpp>
#include <cca/base/reflect.hpp>
#include <cca/motor/equations/dmp_basis.hpp>
#include <cca/motor/spaces.hpp>
#include <cca/space/info.hpp>

namespace cca {
namespace detail {

// "rhythmic_shape over hip, knee with 25 functions"
inline std::string title_over(std::string_view model, const space_info& space, std::string_view rest) {
  std::string text(model);
  for (int i = 0; i < space.axis_count; ++i) text.append(i ? ", " : " over ").append(space.axes[i]);
  return text.append(" ").append(rest);
}

template <class S, int N, int Rows = S::size>
struct dmp_shape {
  using output = Eigen::Matrix<double, Rows, 1>;
  using weight_matrix = Eigen::Matrix<double, Rows, N>;
  struct parameters {
    BOOST_HANA_DEFINE_STRUCT(parameters, (weight_matrix, weights));
    parameters() : weights(weight_matrix::Zero()) {}
  };
};

}  // namespace detail

template <detail::LinearSpace S, int N>
struct rhythmic_shape : detail::dmp_shape<S, N> {
  using typename detail::dmp_shape<S, N>::output;
  using typename detail::dmp_shape<S, N>::parameters;
  using input = Eigen::Matrix<double, 2, 1>;

  // always_inline: a call in the beat otherwise (docs/compilers.md).
  [[gnu::always_inline]] static cca::activations<N> activations(const input& x) {
    return rhythmic_activations<N>(x[0]);
  }
  static double scale(const input& x) { return x[1]; }
  static cca::activations<N> regressors(const input& x) { return scale(x) * activations(x); }
  static output answer(const parameters& p, const input& x) { return p.weights * regressors(x); }
  static std::string title() {
    return detail::title_over("rhythmic_shape", detail::space_of<S>,
                              "with " + std::to_string(N) + " functions");
  }
};

namespace detail {

template <class S, int N, int Decay, int Rows>
struct discrete_function : dmp_shape<S, N, Rows> {
  using typename dmp_shape<S, N, Rows>::output;
  using typename dmp_shape<S, N, Rows>::parameters;
  using input = Eigen::Matrix<double, 1, 1>;

  static cca::activations<N> activations(const input& x) {
    return discrete_activations<N>(x[0], 1e-3 * Decay);
  }
  static double scale(const input& x) { return x[0]; }
  static cca::activations<N> regressors(const input& x) { return scale(x) * activations(x); }
  static output answer(const parameters& p, const input& x) { return p.weights * regressors(x); }
  static std::string functions() {
    return "with " + std::to_string(N) + " functions, decay " + std::to_string(Decay) + "e-3";
  }
};

}  // namespace detail

// Decay: a of the canonical system times 1000. It is part of the type because it places the functions.
template <detail::LinearSpace S, int N, int Decay = 5000>
struct discrete_shape : detail::discrete_function<S, N, Decay, S::size> {
  static std::string title() {
    return detail::title_over("discrete_shape", detail::space_of<S>, discrete_shape::functions());
  }
};

namespace detail {

template <class S>
struct no_pose_space {
  static constexpr void tell(text& m) {
    m << "space.mismatch: a cca::pose_shape is over a space of poses, and " << space_in_words<S>()
      << " is none: name a space of cca::pose<frame>, or use cca::discrete_shape";
  }
};

}  // namespace detail

// S is a space of a pose; its domain in the title names the frame.
template <Space S, int N, int Decay = 5000>
struct pose_shape : detail::discrete_function<S, N, Decay, 6> {
  static_assert(detail::holds_or_tells<(S::size == 7), detail::no_pose_space<S>>::value);
  static std::string title() {
    return "pose_shape of " + std::string(detail::space_of<S>.domain) + " " + pose_shape::functions();
  }
};

}  // namespace cca
