// Adaptive components come with one header, which compiles alone.
#include <cca/adaptive.hpp>

namespace all_of_adaptive {

using cca::adaptive_component;
using cca::extreme_learning_machine;
using cca::ode_solver;
using cca::sequencer;
using cca::tracker;

}  // namespace all_of_adaptive
