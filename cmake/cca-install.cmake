# Installs the headers and the files that find_package(cca COMPONENTS ...) reads.

include(CMakePackageConfigHelpers)

set(package_dir ${CMAKE_INSTALL_DATADIR}/cmake/cca)  # headers only: the same on every architecture
foreach(target IN LISTS CCA_TARGETS)
  install(EXPORT cca-${target} FILE cca-${target}-targets.cmake NAMESPACE cca:: DESTINATION ${package_dir})
endforeach()

configure_package_config_file(cmake/cca-config.cmake.in ${PROJECT_BINARY_DIR}/cca-config.cmake INSTALL_DESTINATION ${package_dir}
                              NO_SET_AND_CHECK_MACRO)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/cca-config-version.cmake COMPATIBILITY SameMinorVersion ARCH_INDEPENDENT)
install(FILES ${PROJECT_BINARY_DIR}/cca-config.cmake ${PROJECT_BINARY_DIR}/cca-config-version.cmake cmake/FindODE.cmake cmake/FindZSTD.cmake
        cmake/cca-compiled.cmake cmake/cca-same-bits.cmake cmake/cca-python.cmake DESTINATION ${package_dir})
install(DIRECTORY source/ DESTINATION ${CMAKE_INSTALL_DATADIR}/cca/source)  # cca-compiled.cmake
if("record" IN_LIST CCA_COMPONENTS)
  install(FILES page/recording.html DESTINATION ${CMAKE_INSTALL_DATADIR}/cca)
endif()
install(FILES LICENSE DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/cca)
