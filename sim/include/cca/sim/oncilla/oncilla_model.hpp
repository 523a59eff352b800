// The numbers of an Oncilla under the names that version 0.1.0 had (cca/robots/oncilla/body.hpp).
//
// To simulate another robot, change a copy of `cca::sim::model_of<cca::robots::oncilla::as_built>()`.
#pragma once

#include <cca/robots/oncilla/body.hpp>
#include <cca/robots/oncilla/former_names.hpp>

namespace cca::sim {

using oncilla_model = robots::oncilla::body_numbers;
inline constexpr const oncilla_model& oncilla_defaults = robots::oncilla::body;

}  // namespace cca::sim
