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
