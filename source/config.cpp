// What the target cca::config compiles once for a project: cca/base/separate/compiled.hpp.
#include <cca/config/by_path_functions.hpp>
#include <cca/config/files_functions.hpp>
