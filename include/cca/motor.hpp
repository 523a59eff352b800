// Movement generators and controllers: oscillators and gaits, movement primitives, VITE, motion models
// learned from examples, the reservoir pattern generator, PID. Includes every public header of cca/motor/; to
// compile faster, include only those that you need.
#pragma once

#include <cca/base/compiler.hpp>

#include <cca/motor/equations/attractor_ode.hpp>
#include <cca/motor/equations/dmp_basis.hpp>
#include <cca/motor/dmp_discrete.hpp>
#include <cca/motor/modules/dmp_discrete_module.hpp>
#include <cca/motor/equations/dmp_discrete_ode.hpp>
#include <cca/motor/dmp_pose.hpp>
#include <cca/motor/modules/dmp_pose_module.hpp>
#include <cca/motor/equations/dmp_pose_ode.hpp>
#include <cca/motor/dmp_rhythmic.hpp>
#include <cca/motor/dmp_rhythmic_module.hpp>
#include <cca/motor/equations/dmp_rhythmic_ode.hpp>
#include <cca/motor/dmp_shapes.hpp>
#include <cca/motor/gait.hpp>
#include <cca/motor/gait_network.hpp>
#include <cca/motor/equations/gaussian_mixture.hpp>
#include <cca/motor/gaussian_mixture_learning.hpp>
#include <cca/motor/generator.hpp>
#include <cca/motor/gmr.hpp>
#include <cca/motor/modules/gmr_module.hpp>
#include <cca/motor/hidden_markov_learning.hpp>
#include <cca/motor/hmm_motion.hpp>
#include <cca/motor/modules/hmm_module.hpp>
#include <cca/motor/hopf.hpp>
#include <cca/motor/equations/hopf_ode.hpp>
#include <cca/motor/equations/oscillator_network_ode.hpp>
#include <cca/motor/pid.hpp>
#include <cca/motor/rcpg.hpp>
#include <cca/motor/modules/rcpg_module.hpp>
#include <cca/motor/equations/reservoir.hpp>
#include <cca/motor/spaces.hpp>
#include <cca/motor/vite.hpp>
#include <cca/motor/equations/vite_ode.hpp>
