// Adaptive components and their parts: differential equations and their solvers, learners, criteria, status,
// skills in sequence.
// Includes every public header of cca/adaptive/; to compile faster, include only those that you need.
#pragma once

#include <cca/base/compiler.hpp>

#include <cca/adaptive/adaptive_component.hpp>
#include <cca/adaptive/assembly/adaptive_options.hpp>
#include <cca/adaptive/module/adaptive_module.hpp>
#include <cca/adaptive/learning/batch_thread.hpp>
#include <cca/adaptive/learning/changes.hpp>
#include <cca/adaptive/component_status.hpp>
#include <cca/adaptive/numerics/covered_region.hpp>
#include <cca/adaptive/criterion.hpp>
#include <cca/adaptive/extreme_learning_machine.hpp>
#include <cca/adaptive/grasping.hpp>
#include <cca/adaptive/learned_file.hpp>
#include <cca/adaptive/learner.hpp>
#include <cca/adaptive/locally_weighted_regression.hpp>
#include <cca/adaptive/module_status.hpp>
#include <cca/adaptive/ode.hpp>
#include <cca/adaptive/numerics/ode_integrators.hpp>
#include <cca/adaptive/ode_odeint.hpp>
#include <cca/adaptive/ode_solver.hpp>
#include <cca/adaptive/ode_status.hpp>
#include <cca/adaptive/reaching_criterion.hpp>
#include <cca/adaptive/recursive_least_squares.hpp>
#include <cca/adaptive/sampling.hpp>
#include <cca/adaptive/sequence.hpp>
#include <cca/adaptive/sequencer.hpp>
#include <cca/adaptive/learning/timed_requests.hpp>
#include <cca/adaptive/tracking.hpp>
#include <cca/adaptive/training.hpp>
