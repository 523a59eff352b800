// The walking Oncilla as a module of Python: docs/python.md.
#include <cca/python/module.hpp>

#include "../task.hpp"

// [module]
PYBIND11_MODULE(oncilla_walk, m) {
  cca::python::add_environment<training::walk>(m, "walk", "an Oncilla learns to walk as fast as commanded");
}
// [module end]
