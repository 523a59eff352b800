// The parameters of an adaptive module whose command follows an attractor on springs
// (equations/attractor_ode.hpp): gmr_module, hmm_module.
#pragma once

#include <string>
#include <vector>

#include <cca/adaptive/learned_file.hpp>
#include <cca/adaptive/numerics/rate_bound.hpp>
#include <cca/adaptive/ode_status.hpp>
#include <cca/adaptive/training.hpp>
#include <cca/base/reflect.hpp>
#include <cca/component/parameters.hpp>

namespace cca::detail {

template <class Settings>  // of the learner
struct attractor_parameters {
  BOOST_HANA_DEFINE_STRUCT(attractor_parameters,
                           (bounded<double, 0.1, 1000>, stiffness),
                           (ode_settling, settling),
                           (Settings, settings),
                           (learned_files, files));
  attractor_parameters(double stiff = 25,
                       const ode_settling& settles = {1e-3, 1e-2},
                       const Settings& of_learner = {},
                       const learned_files& names = {})
      : stiffness(stiff), settling(settles), settings(of_learner), files(names) {}
  std::string check_at(double step) const {
    return above_rate_bound("stiffness", stiffness, 2 * rate_bound(step), step);
  }
};

// What a learned file must agree with.
template <class Settings>
std::vector<learned_header::constant> constants_of(const attractor_parameters<Settings>& p) {
  return {{"stiffness", p.stiffness}};
}

}  // namespace cca::detail
