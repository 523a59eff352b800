// Mappings come with one header, which compiles alone.
#include <cca/mapping.hpp>

namespace all_of_mapping {

using cca::forward_kinematics;
using cca::inverse_kinematics;
using cca::mapping_chain;
using cca::pantograph_leg;
using cca::rigid_motion;

}  // namespace all_of_mapping
