# What `cmake --install` leaves, so that find_package(inkcell) finds it.
include(CMakePackageConfigHelpers)
include(GNUInstallDirs)

set(package ${CMAKE_INSTALL_LIBDIR}/cmake/inkcell)
install(TARGETS inkcell_core inkcell_kinetic inkcell_port_pixel inkcell_port_display
  EXPORT inkcell)
install(EXPORT inkcell NAMESPACE inkcell:: FILE inkcellTargets.cmake
  DESTINATION ${package})
foreach(folder core core/kinetic port/pixel port/display)
  install(DIRECTORY ${PROJECT_SOURCE_DIR}/${folder}/include/
    DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}
    FILES_MATCHING PATTERN "*.hpp")
endforeach()

configure_package_config_file(
  ${CMAKE_CURRENT_LIST_DIR}/inkcellConfig.cmake.in
  ${PROJECT_BINARY_DIR}/inkcellConfig.cmake
  INSTALL_DESTINATION ${package}
  PATH_VARS CMAKE_INSTALL_BINDIR)
write_basic_package_version_file(
  ${PROJECT_BINARY_DIR}/inkcellConfigVersion.cmake
  COMPATIBILITY SameMinorVersion)
install(FILES
  ${PROJECT_BINARY_DIR}/inkcellConfig.cmake
  ${PROJECT_BINARY_DIR}/inkcellConfigVersion.cmake
  ${PROJECT_SOURCE_DIR}/fonts_gen/cmake/InkcellFonts.cmake
  DESTINATION ${package})
