# cca_find_interpreter(): the Python that runs, not a script in front of it: the shims of pyenv take 0.3 s, and there are
# hundreds of calls.
function(cca_find_interpreter)
  if(NOT Python3_EXECUTABLE)
    find_package(Python3 3.9 REQUIRED COMPONENTS Interpreter)
    execute_process(COMMAND ${Python3_EXECUTABLE} -c "import sys; print(sys.executable)" OUTPUT_VARIABLE interpreter
                    OUTPUT_STRIP_TRAILING_WHITESPACE COMMAND_ERROR_IS_FATAL ANY)
    set(Python3_EXECUTABLE ${interpreter} CACHE FILEPATH "the interpreter of the checks")
  endif()
endfunction()

# cca_find_numpy(): CCA_PYTHON_WITH_NUMPY, which may be another interpreter than that of the other tests (Debian: python3-numpy),
# but is of the version for which modules are built.
function(cca_find_numpy)
  if(CCA_PYTHON_WITH_NUMPY)
    return()
  endif()
  find_package(Python3 3.9 REQUIRED COMPONENTS Interpreter)
  foreach(candidate ${Python3_EXECUTABLE} /usr/bin/python3)
    execute_process(COMMAND ${candidate} -c "import numpy, sys; print('%d.%d' % sys.version_info[:2])" OUTPUT_VARIABLE found RESULT_VARIABLE failed
                    OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
    if(NOT failed AND found STREQUAL "${Python3_VERSION_MAJOR}.${Python3_VERSION_MINOR}")
      set(CCA_PYTHON_WITH_NUMPY ${candidate} CACHE INTERNAL "an interpreter with NumPy")
      return()
    endif()
  endforeach()
  message(FATAL_ERROR "the tests need NumPy for Python ${Python3_VERSION_MAJOR}.${Python3_VERSION_MINOR}: ./bootstrap installs it")
endfunction()

# cca_test_descriptions(<kind> <program>...): what --write-parameters writes, --config reads unchanged; all outputs are listed.
function(cca_test_descriptions kind)
  foreach(program IN LISTS ARGN)
    set(file ${CMAKE_CURRENT_BINARY_DIR}/written_${program})
    add_test(NAME "${kind}: ${program} --write-parameters" COMMAND ${program} --write-parameters ${file}.toml)
    add_test(NAME "${kind}: ${program} --config" COMMAND ${program} --config ${file}.toml --write-parameters ${file}_again.toml)
    add_test(NAME "${kind}: ${program} --config, unchanged" COMMAND ${CMAKE_COMMAND} -E compare_files ${file}.toml ${file}_again.toml)
    set_tests_properties("${kind}: ${program} --write-parameters" PROPERTIES FIXTURES_SETUP written_${program})
    set_tests_properties("${kind}: ${program} --config" PROPERTIES FIXTURES_REQUIRED written_${program} FIXTURES_SETUP read_${program})
    set_tests_properties("${kind}: ${program} --config, unchanged" PROPERTIES FIXTURES_REQUIRED read_${program})
  endforeach()
  cca_test_lists(${kind} ${ARGN})
endfunction()
function(cca_test_lists kind)  # of programs without --config
  foreach(program IN LISTS ARGN)
    add_test(NAME "${kind}: ${program} --list" COMMAND ${program} --list)
    set_tests_properties("${kind}: ${program} --list" PROPERTIES PASS_REGULAR_EXPRESSION "^output +space +unit +rate +numbers\n.+\n$")
  endforeach()
endfunction()

# cca_label_long(<regex>): the tests of this folder whose name matches take long, or run a program that takes long to compile.
function(cca_label_long regex)
  get_property(tests DIRECTORY PROPERTY TESTS)
  foreach(test IN LISTS tests)
    if(test MATCHES "${regex}")
      set_property(TEST ${test} APPEND PROPERTY LABELS long)
    endif()
  endforeach()
endfunction()

# cca_label_programs(): the tests of this folder that are not checks of the sources run whole programs. Call it last.
function(cca_label_programs)
  get_property(tests DIRECTORY PROPERTY TESTS)
  foreach(test IN LISTS tests)
    get_property(labels TEST ${test} PROPERTY LABELS)
    if(NOT "repository" IN_LIST labels)
      set_property(TEST ${test} APPEND PROPERTY LABELS program)
    endif()
  endforeach()
endfunction()
