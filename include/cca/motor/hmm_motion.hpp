// A motion model by a hidden Markov model: which part of the movement it is in, and so which way to go on,
// from the position.
//
//   cca::node<"motion", cca::hmm_motion<hand_in_trunk, 5>, cca::timed<10>>      5 hidden states
//   in  "position"    S, any space of one number an axis: the observed one
//   out "velocity"    velocity_of<S>: the wanted one
//   out "state"       hidden_state, a number from 0: the most likely state
//
//   h_k(t) = (sum_j h_j(t-1) a_jk) N(x; m_k^x, S_k^xx) / sum      forward variable; at first `priors` of the
//   mixture v(x)   = sum h_k (m_k^v + S_k^vx S_k^xx^-1 (x - m_k^x))       regression, so weighted
//
// The mixture is over (position, velocity); `transitions` has a row for each state that is left, and holds
// for the clock at which it was learned. The sequence of states tells apart parts of the movement that cross
// at one place, which a mixture by itself can't. A position that is not finite leaves the states as they are
// and gives velocity 0. Errors: none. Cost: K factorisations of D x D, K^2 products. Source: Calinon,
// D'halluin, Sauser, Caldwell, Billard, Learning and reproduction of gestures by imitation, IEEE Robotics and
// Automation Magazine 17, 2010 (HMM and GMR); the forward variable: Rabiner, A tutorial on hidden Markov
// models and selected applications in speech recognition, Proceedings of the IEEE 77, 1989 (the forward
// procedure). Checked against the recursion written out. Example: tests/runtime/motor/gmr.cpp.
#pragma once

#include <string_view>
#include <tuple>

#include <cca/component/parameters.hpp>
#include <cca/component/port.hpp>
#include <cca/motor/equations/gaussian_mixture.hpp>
#include <cca/motor/spaces.hpp>

namespace cca {

struct hidden_axis : dimension<"hidden"> {};
struct hidden_state : space<status, axes<hidden_axis>> {};

template <detail::LinearSpace S, int K>
struct hmm_motion {
  using model = gaussian_mixture<S::size, S::size, K>;
  using transition_matrix = Eigen::Matrix<double, K, K>;
  using vector = Eigen::Matrix<double, S::size, 1>;
  using weights = typename model::weights;

  struct parameters {
    BOOST_HANA_DEFINE_STRUCT(parameters, (model, mixture), (transition_matrix, transitions));
    std::string_view check() const {
      for (int k = 0; k < K; ++k)
        if (transitions.row(k).minCoeff() < 0 || transitions.row(k).sum() < 1 - 1e-6 ||
            transitions.row(k).sum() > 1 + 1e-6)
          return "a row of `transitions` is not a distribution: its sum is 1, none of it negative";
      return "";
    }
  };
  parameters p{{}, transition_matrix::Identity()};

  auto process(in<"position", S> position)
      -> std::tuple<out<"velocity", velocity_of<S>>, out<"state", hidden_state>> {
    vector velocity = vector::Zero();
    if (position.vector().allFinite()) {
      const weights predicted = begun ? weights(p.transitions.transpose() * now) : p.mixture.priors;
      const auto answer =
          regress<S::size, S::size, K>(p.mixture, predicted, position.vector(),
                                       [](const vector& x, const vector& mean) { return vector(x - mean); });
      now = answer.responsibilities;
      velocity = answer.mean;
      begun = true;
    }
    Eigen::Index likely = 0;
    now.maxCoeff(&likely);
    return {velocity, static_cast<double>(likely)};
  }

  // How likely each state is.
  const weights& states() const { return now; }

  // Begins anew.
  void on_start() {
    begun = false;
    now.setConstant(1.0 / K);
  }

private:
  weights now = weights::Constant(1.0 / K);
  bool begun = false;
};

}  // namespace cca
