// A body as URDF, which RViz and Foxglove draw: links with inertia and simple shapes, joints with limits.
//
// A joint is named like the axis that moves it, and turns as the axis says, so that messages of joint states
// fit. Further joints of an axis mimic it. Each link is drawn as cylinders to what hangs on it, and a sphere
// in its joint. Source of the format: wiki.ros.org/urdf/XML.
#pragma once

#include <string>
#include <string_view>

#include <cca/base/separate/compiled.hpp>
#include <cca/record/messages/body_description.hpp>

namespace cca::recording::detail {

std::string urdf_of(const body_description& d, std::string_view robot);

}  // namespace cca::recording::detail

#if !CCA_HAS_COMPILED_RECORD
#include <cca/record/messages/urdf_functions.hpp>
#endif
