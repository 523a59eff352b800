# Makes a repository of the files that a user's project fetches, from the work tree: the headers and the CMake files.

file(REMOVE_RECURSE ${work})
set(snapshot ${work}/snapshot)
file(COPY ${source}/include ${source}/robots ${source}/sim ${source}/hardware ${source}/dds ${source}/record ${source}/door ${source}/mpi ${source}/python ${source}/source ${source}/cmake ${source}/CMakeLists.txt ${source}/LICENSE DESTINATION ${snapshot})
file(COPY ${source}/page/recording.html DESTINATION ${snapshot}/page)

foreach(command "init;--quiet;--initial-branch=main" "add;--all" "-c;user.name=cca;-c;user.email=cca@localhost;commit;--quiet;--message=snapshot")
  execute_process(COMMAND git ${command} WORKING_DIRECTORY ${snapshot} COMMAND_ERROR_IS_FATAL ANY)
endforeach()
