// What the target cca::door compiles once for a project: cca/base/separate/compiled.hpp.
#include <cca/door/parameter_list_functions.hpp>
#include <cca/door/server_functions.hpp>
