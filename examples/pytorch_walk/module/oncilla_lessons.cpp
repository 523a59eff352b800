// The Oncilla with a teacher as a module of Python: docs/tutorial/10_policy.md.
#include <cca/python/module.hpp>

#include "../lessons.hpp"

PYBIND11_MODULE(oncilla_lessons, m) {
  cca::python::add_environment<pytorch_walk::lessons>(m, "lessons",
                                                      "an Oncilla, and what the trot would do in its place");
}
