# What `cmake --install` puts where: emulsion_install(core film ...) names the rooms that make up the library.
#
#   lib/libemulsion_<room>.a, lib/cmake/emulsion (find_package), lib/pkgconfig/emulsion.pc
#   include/emulsion/<room>/*.h, include/emulsion.h (the C interface)
#   bin/emulsion, if it was built

include(CMakePackageConfigHelpers)
include(GNUInstallDirs)

# One library. The headers name each other "core/color.h", and renderers name them <emulsion/core/color.h>.
function(emulsion_install_library target export_name)
  set_target_properties(${target} PROPERTIES EXPORT_NAME ${export_name})
  target_include_directories(${target} INTERFACE
    $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}> $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}/emulsion>)
  # Renderers' plug-ins are shared objects. None of these functions is there to be replaced by a program's own.
  set_target_properties(${target} PROPERTIES POSITION_INDEPENDENT_CODE ON)
  target_compile_options(${target} PRIVATE -fno-semantic-interposition)
  install(TARGETS ${target} EXPORT emulsion ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
endfunction()

# The pkg-config file finds its prefix from where it lies, as the prefix may be chosen as late as at the installation.
function(emulsion_install_pkg_config libraries)
  list(TRANSFORM libraries PREPEND "-l")
  list(JOIN libraries " " libs)
  set(folder ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
  file(RELATIVE_PATH prefix_from_pc ${CMAKE_INSTALL_FULL_LIBDIR}/pkgconfig ${CMAKE_INSTALL_PREFIX})
  set(libdir "\${prefix}")
  cmake_path(APPEND libdir ${CMAKE_INSTALL_LIBDIR})
  set(includedir "\${prefix}")
  cmake_path(APPEND includedir ${CMAKE_INSTALL_INCLUDEDIR})
  configure_file(${PROJECT_SOURCE_DIR}/cmake/emulsion.pc.in ${PROJECT_BINARY_DIR}/generated/emulsion.pc @ONLY)
  install(FILES ${PROJECT_BINARY_DIR}/generated/emulsion.pc DESTINATION ${folder})
endfunction()

function(emulsion_install)
  set(package ${CMAKE_INSTALL_LIBDIR}/cmake/emulsion)

  # Libraries, in an order in which a linker that looks at each once finds everything
  set(libraries emulsion_sigmoid_tables)
  emulsion_install_library(emulsion_sigmoid_tables sigmoid_tables)
  foreach(room IN LISTS ARGN)
    list(PREPEND libraries emulsion_${room})
    if(room STREQUAL capi)
      emulsion_install_library(emulsion_capi c)
    else()
      emulsion_install_library(emulsion_${room} ${room})
      install(DIRECTORY ${PROJECT_SOURCE_DIR}/src/${room} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/emulsion
        FILES_MATCHING PATTERN "*.h" PATTERN generate EXCLUDE)
    endif()
  endforeach()
  add_library(emulsion::c ALIAS emulsion_capi)
  install(FILES ${PROJECT_SOURCE_DIR}/src/capi/emulsion.h DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})

  # Package files
  install(EXPORT emulsion NAMESPACE emulsion:: FILE emulsion-targets.cmake DESTINATION ${package})
  configure_package_config_file(${PROJECT_SOURCE_DIR}/cmake/emulsion-config.cmake.in
    ${PROJECT_BINARY_DIR}/generated/emulsion-config.cmake INSTALL_DESTINATION ${package})
  write_basic_package_version_file(${PROJECT_BINARY_DIR}/generated/emulsion-config-version.cmake
    COMPATIBILITY SameMinorVersion)
  install(FILES ${PROJECT_BINARY_DIR}/generated/emulsion-config.cmake
    ${PROJECT_BINARY_DIR}/generated/emulsion-config-version.cmake ${PROJECT_SOURCE_DIR}/cmake/FindHighway.cmake
    ${PROJECT_SOURCE_DIR}/cmake/FindLcms2.cmake
    DESTINATION ${package})
  emulsion_install_pkg_config("${libraries}")

  if(TARGET emulsion)
    install(TARGETS emulsion RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
  endif()
endfunction()
