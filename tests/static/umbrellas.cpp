// Every umbrella header, with warnings that users may have switched on (CMakeLists.txt).
#include <cca/adaptive.hpp>
#include <cca/cca.hpp>
#include <cca/config.hpp>
#include <cca/deployment.hpp>
#include <cca/modes.hpp>
#include <cca/mapping.hpp>
#include <cca/motor.hpp>
#include <cca/robot.hpp>
#include <cca/trace.hpp>
