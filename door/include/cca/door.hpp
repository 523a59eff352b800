// A door into a controller that runs, for viewers, for a browser, for terminals and scripts; and the option
// `--door` of a program. Needs the target cca::door. docs/door.md.
#pragma once

#include <cca/door/open_door.hpp>
#include <cca/door/program_door.hpp>
#include <cca/record.hpp>
