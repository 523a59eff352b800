// What the target cca::main compiles once for a project: cca/base/separate/compiled.hpp.
#include <cca/main/command_line_functions.hpp>
