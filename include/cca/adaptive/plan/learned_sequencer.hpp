// Moved: adaptive/choice/learned_sequencer.hpp.
#pragma once

#include <cca/adaptive/choice/learned_sequencer.hpp>
