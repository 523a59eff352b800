// A motion model by a hidden Markov model: from the position it tells which part of the movement is running
// and with which velocity to go on.
//
//   cca::node<"motion", cca::hmm_motion<hand_in_trunk, 5>, cca::timed<10>>      5 hidden states
//
//   in  "position"  S               any space with one number per axis: the observed position
//   out "velocity"  velocity_of<S>  the wanted velocity
//   out "state"     hidden_state    the most likely state, counted from 0
//   out "status"    input_status_port
//
//   h_k(t) = (sum_j h_j(t-1) a_jk) N(x; m_k^x, S_k^xx) / sum    forward variable; `priors` at first
//   v(x)   = sum h_k (m_k^v + S_k^vx S_k^xx^-1 (x - m_k^x))     regression with these weights
//
// The mixture is over (position, velocity). Row j of `transitions` holds the probabilities of leaving state
// j; they belong to the clock at which they were learned. The sequence of states distinguishes parts of the
// movement that cross at one place; a mixture alone cannot. hidden_markov_learning.hpp learns both parameters
// from demonstrations; modules/hmm_module.hpp is a whole adaptive module.
//
// Inputs (input_status.hpp): while the position is NaN or infinite, the states stay and the velocity is 0,
// with the status `unreadable`; beyond 1e12 it is cut, with the status `clamped`. So is a position at which
// no state can be told from the others because numbers overflow: the states stay.
//
// Errors: none. Cost: K factorisations of D x D, K^2 products. Source: Calinon, D'halluin, Sauser, Caldwell,
// Billard, Learning and reproduction of gestures by imitation, IEEE Robotics and Automation Magazine 17, 2010
// (HMM and GMR); forward variable: Rabiner, A tutorial on hidden Markov models and selected applications in
// speech recognition, Proceedings of the IEEE 77, 1989. Checked against the recursion written out. Example:
// tests/runtime/motor/gmr.cpp.
#pragma once

#include <string_view>
#include <tuple>

#include <cca/base/math/reductions.hpp>
#include <cca/component/input_status.hpp>
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
    parameters(const model& states = {}, const transition_matrix& chances = transition_matrix::Identity())
        : mixture(states), transitions(chances) {}
    std::string_view check() const {
      for (int k = 0; k < K; ++k)
        if (transitions.row(k).minCoeff() < 0 || math::sum(transitions.row(k)) < 1 - 1e-6 ||
            math::sum(transitions.row(k)) > 1 + 1e-6)
          return "a row of `transitions` is not a probability distribution: no entry may be negative, the "
                 "sum must be 1";
      return "";
    }
  };
  parameters p{};

  auto process(in<"position", S> position) -> std::
      tuple<out<"velocity", velocity_of<S>>, out<"state", hidden_state>, out<"status", input_status_port>> {
    vector velocity = vector::Zero();
    detail::input_check inputs;
    const vector at = inputs(position.vector());
    if (!inputs.unreadable()) {
      const weights predicted =
          begun ? weights(math::product(p.transitions.transpose(), now)) : p.mixture.priors;
      const auto answer = regress<S::size, S::size, K>(
          p.mixture, predicted, at, [](const vector& x, const vector& mean) { return vector(x - mean); });
      if (detail::all_finite(answer.responsibilities) && detail::all_finite(answer.mean)) {
        now = answer.responsibilities;
        velocity = answer.mean;
        begun = true;
      } else {
        inputs.note_clamped();
      }
    }
    Eigen::Index likely = 0;
    now.maxCoeff(&likely);
    return {velocity, static_cast<double>(likely), status_of(inputs.get())};
  }

  // The probability of each state.
  const weights& states() const { return now; }

  // Begins again from `priors`.
  void on_start() {
    begun = false;
    now.setConstant(1.0 / K);
  }

private:
  weights now = weights::Constant(1.0 / K);
  bool begun = false;
};

}  // namespace cca
