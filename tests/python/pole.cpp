// The module of the tests.
#include <cca/python/module.hpp>

#include "pole.hpp"

PYBIND11_MODULE(cca_test_pole, m) {
  cca::python::add_environment<python_test::balancing>(m, "pole");
  m.def("may_begin", [] { python_test::may_begin = true; });
}
