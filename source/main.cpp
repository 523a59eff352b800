// What the target cca::main compiles once for a project: cca/base/separate/compiled.hpp.
#include <cca/main/command_line_functions.hpp>
#include <cca/main/descriptions_functions.hpp>
#include <cca/main/end_of_run_functions.hpp>
#include <cca/main/one_file_functions.hpp>
#include <cca/main/robot_run_functions.hpp>
#include <cca/main/run_commands_functions.hpp>
#include <cca/main/run_program_functions.hpp>
#include <cca/main/standard_options_functions.hpp>
