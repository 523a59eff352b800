// Movement generators and controllers come with one header, which compiles alone.
#include <cca/motor.hpp>

namespace all_of_motor {

using cca::dmp_discrete;
using cca::gait_network;
using cca::generator;
using cca::gmr;
using cca::hmm_module;
using cca::hmm_motion;
using cca::hopf;
using cca::pid;
using cca::rcpg;
using cca::vite;

}  // namespace all_of_motor
