# The installed package: targets inkcell::core, its libraries (inkcell::cache,
# inkcell::figures, inkcell::layers, inkcell::layout, inkcell::motion, inkcell::simulation,
# inkcell::stored, inkcell::strike),
# inkcell::port_* and inkcell::c, which the project that asks compiles itself,
# and the function inkcell_add_font().
cmake_policy(VERSION 3.25)

if(NOT TARGET inkcell_core)
  foreach(folder core port)
    add_subdirectory(${CMAKE_CURRENT_LIST_DIR}/../../inkcell/${folder}
      ${CMAKE_BINARY_DIR}/inkcell/${folder} EXCLUDE_FROM_ALL)
  endforeach()
endif()
include(${CMAKE_CURRENT_LIST_DIR}/InkcellFonts.cmake)
