# The targets: cca::cca (the core), cca::config, cca::main, cca::robots, cca::sim, cca::hardware, cca::dds and cca::record. All of them are headers only.

include(GNUInstallDirs)

# cca_add_headers(<name> <root>: the folder that users include from; FILES...)
# Makes the target cca::<name>. Its headers are installed; the target all_verify_interface_header_sets compiles each alone.
function(cca_add_headers name root)
  set(target cca)
  if(NOT name STREQUAL "cca")
    set(target cca_${name})
  endif()
  add_library(${target} INTERFACE)
  add_library(cca::${name} ALIAS ${target})
  set_target_properties(${target} PROPERTIES EXPORT_NAME ${name} VERIFY_INTERFACE_HEADER_SETS ${PROJECT_IS_TOP_LEVEL})
  if(NOT PROJECT_IS_TOP_LEVEL)
    set_target_properties(${target} PROPERTIES SYSTEM ON)  # the user's warnings are for the user's code, as with an installed cca
  endif()
  target_compile_features(${target} INTERFACE cxx_std_20)
  target_sources(${target} INTERFACE FILE_SET HEADERS BASE_DIRS ${root} FILES ${ARGN})
  install(TARGETS ${target} EXPORT cca-${name} FILE_SET HEADERS DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
endfunction()

foreach(component IN LISTS CCA_COMPONENTS)
  if(NOT component MATCHES "^(config|main|sim|hardware|dds|record)$")
    message(FATAL_ERROR "CCA_COMPONENTS: there is no component '${component}', only config, main, sim, hardware, dds and record")
  endif()
endforeach()
if("main" IN_LIST CCA_COMPONENTS AND NOT "config" IN_LIST CCA_COMPONENTS)
  message(FATAL_ERROR "CCA_COMPONENTS: the component 'main' needs 'config'")
endif()

if(NOT PROJECT_IS_TOP_LEVEL)  # who links one of these reads of a target that was not found, and why above
  set(left_out config main sim hardware dds record)
  list(REMOVE_ITEM left_out none ${CCA_COMPONENTS})
  if(left_out)
    list(JOIN left_out ", cca::" names)
    message(STATUS "cca: there is no cca::${names}: to link one, name it in CCA_COMPONENTS before cca is added")
  endif()
endif()

# What is built and installed: the core, the components, and the robots if a component needs them.
set(CCA_TARGETS cca ${CCA_COMPONENTS})
if("sim" IN_LIST CCA_COMPONENTS OR "hardware" IN_LIST CCA_COMPONENTS)
  list(APPEND CCA_TARGETS robots)
endif()

set(include ${PROJECT_SOURCE_DIR}/include)
file(GLOB_RECURSE headers CONFIGURE_DEPENDS ${include}/cca/*.hpp)
set(config_headers ${headers})
set(main_headers ${headers})
list(FILTER headers EXCLUDE REGEX "/cca/(config|main)(/|\\.hpp$)")
list(FILTER config_headers INCLUDE REGEX "/cca/config(/|\\.hpp$)")
list(FILTER main_headers INCLUDE REGEX "/cca/main(/|\\.hpp$)")

find_package(Eigen3 3.4 REQUIRED CONFIG)
find_package(Boost 1.74 REQUIRED CONFIG)
cca_add_headers(cca ${include} ${headers})
target_link_libraries(cca INTERFACE Eigen3::Eigen Boost::headers)

if("config" IN_LIST CCA_COMPONENTS)
  find_package(tomlplusplus REQUIRED CONFIG)
  cca_add_headers(config ${include} ${config_headers})
  target_link_libraries(cca_config INTERFACE cca tomlplusplus::tomlplusplus)
endif()

if("main" IN_LIST CCA_COMPONENTS)
  find_package(CLI11 REQUIRED CONFIG)
  find_package(Threads REQUIRED)
  cca_add_headers(main ${include} ${main_headers})
  target_link_libraries(cca_main INTERFACE cca cca_config CLI11::CLI11 Threads::Threads)
endif()

if("robots" IN_LIST CCA_TARGETS)
  set(include ${PROJECT_SOURCE_DIR}/robots/include)
  file(GLOB_RECURSE headers CONFIGURE_DEPENDS ${include}/cca/*.hpp)
  cca_add_headers(robots ${include} ${headers})
  target_link_libraries(cca_robots INTERFACE cca)
endif()

if("sim" IN_LIST CCA_COMPONENTS)
  list(APPEND CMAKE_MODULE_PATH ${CMAKE_CURRENT_LIST_DIR})
  find_package(ODE REQUIRED)
  set(include ${PROJECT_SOURCE_DIR}/sim/include)
  file(GLOB_RECURSE headers CONFIGURE_DEPENDS ${include}/cca/*.hpp)
  cca_add_headers(sim ${include} ${headers})
  target_link_libraries(cca_sim INTERFACE cca cca_robots ODE::ODE)
endif()

if("hardware" IN_LIST CCA_COMPONENTS)
  set(include ${PROJECT_SOURCE_DIR}/hardware/include)
  file(GLOB_RECURSE headers CONFIGURE_DEPENDS ${include}/cca/*.hpp)
  cca_add_headers(hardware ${include} ${headers})
  target_link_libraries(cca_hardware INTERFACE cca cca_robots)
  # g++ 12 drops the bytes written into a frame that is a temporary argument of a call. No report of this fault is
  # known; docs/decisions/0014-modref.md has the reduced case and says which versions were looked at.
  set(needs_option $<AND:$<CXX_COMPILER_ID:GNU>,$<VERSION_GREATER_EQUAL:$<CXX_COMPILER_VERSION>,12>,$<VERSION_LESS:$<CXX_COMPILER_VERSION>,13>>)
  target_compile_options(cca_hardware INTERFACE $<${needs_option}:-fno-ipa-modref>)
endif()

if("dds" IN_LIST CCA_COMPONENTS)
  find_package(CycloneDDS 0.10 REQUIRED CONFIG)
  find_package(Threads REQUIRED)
  set(include ${PROJECT_SOURCE_DIR}/dds/include)
  file(GLOB_RECURSE headers CONFIGURE_DEPENDS ${include}/cca/*.hpp)
  cca_add_headers(dds ${include} ${headers})
  target_link_libraries(cca_dds INTERFACE cca CycloneDDS::ddsc Threads::Threads)
endif()

if("record" IN_LIST CCA_COMPONENTS)
  list(APPEND CMAKE_MODULE_PATH ${CMAKE_CURRENT_LIST_DIR})
  find_package(ZSTD REQUIRED)
  find_package(Threads REQUIRED)
  set(include ${PROJECT_SOURCE_DIR}/record/include)
  file(GLOB_RECURSE headers CONFIGURE_DEPENDS ${include}/cca/*.hpp)
  cca_add_headers(record ${include} ${headers})
  target_link_libraries(cca_record INTERFACE cca ZSTD::ZSTD Threads::Threads)
  # The page without a recording, for the option --page.
  target_compile_definitions(cca_record INTERFACE
    "$<BUILD_INTERFACE:CCA_RECORDING_PAGE=\"${PROJECT_SOURCE_DIR}/page/recording.html\">"
    "$<INSTALL_INTERFACE:CCA_RECORDING_PAGE=\"$<INSTALL_PREFIX>/${CMAKE_INSTALL_DATADIR}/cca/recording.html\">")
endif()
