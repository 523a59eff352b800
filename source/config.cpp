// What the target cca::config compiles once for a project: cca/base/separate/compiled.hpp.
#include <cca/config.hpp>
