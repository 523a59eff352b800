# Modules of Python: docs/python.md.

# pybind11, with the Python that find_package(Python3) finds: a macro, so that what it finds is known where it is called.
macro(cca_find_pybind11)
  find_package(Python3 3.9 REQUIRED COMPONENTS Interpreter Development.Module)
  find_package(pybind11 2.10 REQUIRED CONFIG)
  find_package(Threads REQUIRED)
endmacro()

# cca_python_module(<name> SOURCES...): the module <name>, `import <name>`, from sources with PYBIND11_MODULE(<name>, ...).
function(cca_python_module name)
  pybind11_add_module(${name} MODULE NO_EXTRAS ${ARGN})
  target_link_libraries(${name} PRIVATE cca::python)
  set_target_properties(${name} PROPERTIES CXX_VISIBILITY_PRESET hidden VISIBILITY_INLINES_HIDDEN ON)
endfunction()
