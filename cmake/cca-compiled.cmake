# What depends on no type of a program is compiled once for a project, with the project's own flags, instead of in each of
# its files (cca/base/separate/compiled.hpp, docs/compile_time.md). cca is no binary: an installed cca brings the sources of this,
# too. With CCA_COMPILED off all is in the headers.

option(CCA_COMPILED "compile once for a project what depends on no type of a program: the simulator, the command line, parameter files, recordings, doors" ON)

# cca_compile_once(<component> <its target> <folder of the sources>)
function(cca_compile_once component target folder)
  get_property(languages GLOBAL PROPERTY ENABLED_LANGUAGES)
  if(NOT CCA_COMPILED OR NOT "CXX" IN_LIST languages)
    return()
  endif()
  set(library cca_compiled_${component})
  string(TOUPPER CCA_COMPILED_${component} macro)
  if(NOT TARGET ${library})
    get_target_property(folders ${target} INTERFACE_INCLUDE_DIRECTORIES)
    get_target_property(needs ${target} INTERFACE_LINK_LIBRARIES)
    get_target_property(definitions ${target} INTERFACE_COMPILE_DEFINITIONS)
    if(NOT definitions)
      set(definitions "")
    endif()
    add_library(${library} STATIC EXCLUDE_FROM_ALL ${folder}/${component}.cpp)
    set_target_properties(${library} PROPERTIES POSITION_INDEPENDENT_CODE ON)
    set(system SYSTEM)
    if(PROJECT_IS_TOP_LEVEL AND PROJECT_NAME STREQUAL "cca")
      set(system "")  # our own warnings
    endif()
    target_include_directories(${library} ${system} PRIVATE ${folders})
    target_link_libraries(${library} PRIVATE ${needs})
    target_compile_definitions(${library} PRIVATE ${macro} ${definitions})
  endif()
  target_compile_definitions(${target} INTERFACE $<BUILD_INTERFACE:${macro}>)
  target_link_libraries(${target} INTERFACE $<BUILD_INTERFACE:${library}>)
endfunction()

# For work on a program: it compiles faster and runs slower, with the same results. The preset `edit` switches it on. g++
# collects its garbage later, and beats are not inlined into one function; clang parses the headers once for a target.
option(CCA_EDIT "compile programs faster; they run slower" OFF)

# cca_for_edits(<component> <its target>)
function(cca_for_edits component target)
  if(NOT CCA_EDIT)
    return()
  endif()
  if(component STREQUAL "cca")
    target_compile_definitions(${target} INTERFACE $<BUILD_INTERFACE:CCA_EDIT>)
    target_compile_options(${target} INTERFACE $<BUILD_INTERFACE:$<$<CXX_COMPILER_ID:GNU>:--param=ggc-min-heapsize=1048576>>)
  endif()
  set(header_of_sim cca/sim/robot.hpp)
  set(header cca/${component}.hpp)
  if(DEFINED header_of_${component})
    set(header ${header_of_${component}})
  endif()
  set_property(TARGET ${target} APPEND PROPERTY INTERFACE_PRECOMPILE_HEADERS
               "$<BUILD_INTERFACE:$<$<CXX_COMPILER_ID:Clang>:<${header}$<ANGLE-R>>>")
endfunction()
