# What `cmake --install` leaves: sources of what runs on the device, programs for
# this machine, the licence. find_package(Inkcell) compiles the sources as part of
# the project that asks, with its compiler and flags: one installation serves this
# machine and every cross compiler.
include(CMakePackageConfigHelpers)
include(GNUInstallDirs)

set(package ${CMAKE_INSTALL_DATADIR}/cmake/inkcell)
set(sources ${CMAKE_INSTALL_DATADIR}/inkcell)
foreach(folder core port/pixel port/display port/c/examples port/harfbuzz port/lvgl
    port/make)
  install(DIRECTORY ${PROJECT_SOURCE_DIR}/${folder}/
    DESTINATION ${sources}/${folder}
    FILES_MATCHING
      PATTERN "*.hpp" PATTERN "*.cpp" PATTERN "*.h" PATTERN "*.c"
      PATTERN "CMakeLists.txt" PATTERN "*.cmake" PATTERN "*.mk" PATTERN "Makefile")
endforeach()
install(FILES ${PROJECT_SOURCE_DIR}/port/CMakeLists.txt
  DESTINATION ${sources}/port)
# The interface for C as it was made: its users need no Python.
get_target_property(include inkcell_port_c INTERFACE_INCLUDE_DIRECTORIES)
install(DIRECTORY ${include} ${include}/../src DESTINATION ${sources}/port/c)
install(FILES ${PROJECT_SOURCE_DIR}/port/c/CMakeLists.txt
  DESTINATION ${sources}/port/c)
install(FILES ${PROJECT_SOURCE_DIR}/LICENSE DESTINATION ${sources})

write_basic_package_version_file(
  ${PROJECT_BINARY_DIR}/inkcell-config-version.cmake
  COMPATIBILITY SameMinorVersion ARCH_INDEPENDENT)
install(FILES
  ${PROJECT_BINARY_DIR}/inkcell-config-version.cmake
  ${CMAKE_CURRENT_LIST_DIR}/inkcell-config.cmake
  ${PROJECT_SOURCE_DIR}/fonts_gen/cmake/InkcellFonts.cmake
  DESTINATION ${package})

if(INKCELL_HOST)
  install(TARGETS
    inkcell-render inkcell-inspect inkcell-accuracy inkcell-specimen
    RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT tools)
  include(${CMAKE_CURRENT_LIST_DIR}/deb/package.cmake)
endif()
