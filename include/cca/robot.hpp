// What protects and describes a robot: the limiter, the watchdog, faults, bodies and their dynamics.
// Includes every public header of cca/robot/; to compile faster, include only those that you need.
#pragma once

#include <cca/base/compiler.hpp>

#include <cca/robot/body.hpp>
#include <cca/robot/body_components.hpp>
#include <cca/robot/body_dynamics.hpp>
#include <cca/robot/body_pose.hpp>
#include <cca/robot/compliance/admittance.hpp>
#include <cca/robot/compliance/cartesian_impedance.hpp>
#include <cca/robot/compliance/contact_reaction.hpp>
#include <cca/robot/compliance/hybrid_control.hpp>
#include <cca/robot/compliance/joint_impedance.hpp>
#include <cca/robot/compliance/passivity_guard.hpp>
#include <cca/robot/dynamics/coriolis_matrix.hpp>
#include <cca/robot/dynamics/forward_dynamics.hpp>
#include <cca/robot/dynamics/derived_mass.hpp>
#include <cca/robot/dynamics/mass_matrix.hpp>
#include <cca/robot/dynamics/momentum.hpp>
#include <cca/robot/dynamics/momentum_observer.hpp>
#include <cca/robot/dynamics/operational_space.hpp>
#include <cca/robot/limiter.hpp>
#include <cca/robot/unreadable_fault.hpp>
#include <cca/robot/watchdog.hpp>
