// Mappings from space to space: forward and inverse kinematics, rigid motions, chains of mappings, learned
// mappings.
// Includes every public header of cca/mapping/; to compile faster, include only those that you need.
#pragma once

#include <cca/base/compiler.hpp>

#include <cca/mapping/adaptive_mapping.hpp>
#include <cca/mapping/damped_least_squares.hpp>
#include <cca/mapping/forward_kinematics.hpp>
#include <cca/mapping/inverse_kinematics.hpp>
#include <cca/mapping/kinematics.hpp>
#include <cca/mapping/many_starts.hpp>
#include <cca/mapping/mapping.hpp>
#include <cca/mapping/mapping_chain.hpp>
#include <cca/mapping/network/feed_forward.hpp>
#include <cca/mapping/pantograph.hpp>
#include <cca/mapping/placement.hpp>
#include <cca/mapping/policy.hpp>
#include <cca/mapping/reaching.hpp>
#include <cca/mapping/rigid_motion.hpp>
#include <cca/mapping/serial_chain.hpp>
#include <cca/mapping/tip_task.hpp>
