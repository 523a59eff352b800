# What the first page of the tutorial asks the reader to do; prints only what the program prints.
file(REMOVE_RECURSE ${work})
file(COPY ${source}/examples/tutorial/own_project/CMakeLists.txt ${source}/examples/tutorial/first_loop.cpp DESTINATION ${work}/my_robot)
file(CREATE_LINK ${source} ${work}/cca SYMBOLIC)
execute_process(COMMAND ${CMAKE_COMMAND} -G ${generator} -B build -D CMAKE_BUILD_TYPE=Release -D CMAKE_CXX_COMPILER=${compiler}
                WORKING_DIRECTORY ${work}/my_robot OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${CMAKE_COMMAND} --build build WORKING_DIRECTORY ${work}/my_robot OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND build/first_loop WORKING_DIRECTORY ${work}/my_robot COMMAND_ERROR_IS_FATAL ANY)
