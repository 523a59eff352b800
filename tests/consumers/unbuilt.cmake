# The headers are installed from a folder in which nothing was ever built, and a program without CMake includes them by -I,
# with every warning on that a user may have made an error.

file(REMOVE_RECURSE ${work})
set(options -G ${generator} -D CMAKE_CXX_COMPILER=${compiler} -D CCA_TESTS=OFF -D CCA_EXAMPLES=OFF)
execute_process(COMMAND ${CMAKE_COMMAND} -S ${source} -B ${work}/build ${options} OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${CMAKE_COMMAND} --install ${work}/build --prefix ${work}/prefix OUTPUT_VARIABLE said COMMAND_ERROR_IS_FATAL ANY)
if(NOT said MATCHES "Not installed, because it is not built: cca-can [(]cmake --build '[^']*' --target cca-can[)]")
  message(FATAL_ERROR "the installation does not say that cca-can is left out:\n${said}")
endif()
if(EXISTS ${work}/prefix/bin/cca-can)
  message(FATAL_ERROR "cca-can was built after all")
endif()

file(WRITE ${work}/all.cpp "#include <cca/cca.hpp>
#include <cca/adaptive.hpp>
#include <cca/mapping.hpp>
#include <cca/motor.hpp>
#include <cca/robot.hpp>
#include <cca/hardware/oncilla.hpp>
#include <cca/hardware/virtual_robot.hpp>
")
set(warnings -Wall -Wextra -Wpedantic -Wconversion -Wsign-conversion -Wshadow -Wold-style-cast -Wdouble-promotion -Werror)
foreach(program ${work}/all.cpp ${CMAKE_CURRENT_LIST_DIR}/core.cpp)
  execute_process(COMMAND ${compiler} -std=c++20 -fsyntax-only ${warnings} -I ${work}/prefix/include -isystem ${eigen} ${program}
                  COMMAND_ERROR_IS_FATAL ANY)
endforeach()
