# Programs that run the examples of port/display/examples against models of their
# displays: example_<name>, on the host and on a board.
# <name>_c is <name>.c, which must show what <name>.cpp shows.
set(INKCELL_EXAMPLES st7789 ssd1306 ssd1681 clock gauge battery
  st7789_c ssd1306_c ssd1681_c clock_c)
set(INKCELL_EXAMPLE_TESTS ${CMAKE_CURRENT_LIST_DIR})

function(inkcell_example_test name)
  get_filename_component(root ${INKCELL_EXAMPLE_TESTS}/../../.. ABSOLUTE)
  set(unit ${root}/tests/unit)
  string(REGEX REPLACE "_c$" "" shown ${name})
  string(REGEX REPLACE "_c$" ".c" file ${name})
  if(file STREQUAL name)
    set(file ${name}.cpp)
  endif()
  add_library(example_${name}_main OBJECT
    ${root}/port/display/examples/${file})
  target_compile_definitions(example_${name}_main PRIVATE main=example_main)
  set(sources ${INKCELL_EXAMPLE_TESTS}/test_${shown}.cpp ${unit}/check.cpp
    ${unit}/check_main.cpp $<TARGET_OBJECTS:example_${name}_main>)
  # The fonts of a program of C are sources.
  get_target_property(fonts ${name} SOURCES)
  list(FILTER fonts INCLUDE REGEX "/fonts/.*\\.c$")
  set_source_files_properties(${fonts} PROPERTIES GENERATED TRUE)
  list(APPEND sources ${fonts})
  get_target_property(libraries ${name} LINK_LIBRARIES)
  list(APPEND libraries inkcell::port_display)
  if(INKCELL_BOARD)
    inkcell_add_firmware(example_${name} SOURCES ${sources}
      LIBRARIES ${libraries})
  else()
    add_executable(example_${name} ${sources})
    target_link_libraries(example_${name} PRIVATE ${libraries})
  endif()
  # The example itself makes the font.
  add_dependencies(example_${name}_main ${name})
  add_dependencies(example_${name} ${name})
  target_link_libraries(example_${name}_main PRIVATE ${libraries})
  target_include_directories(example_${name}_main PRIVATE
    $<TARGET_PROPERTY:${name},INCLUDE_DIRECTORIES>)
  target_include_directories(example_${name} PRIVATE
    ${unit} ${root}/port/display/examples)
  foreach(target example_${name} example_${name}_main)
    target_compile_definitions(${target} PRIVATE
      INKCELL_BOARD_FIRMWARE=$<BOOL:${INKCELL_BOARD}>
      EXAMPLE_IS_C=$<NOT:$<STREQUAL:${name},${shown}>>)
    target_compile_options(${target} PRIVATE -Wall -Wextra -Wpedantic
      -Wconversion -Wsign-conversion -Wshadow
      $<$<COMPILE_LANGUAGE:CXX>:-Wold-style-cast> -Wundef -Werror)
  endforeach()
endfunction()

foreach(name ${INKCELL_EXAMPLES})
  inkcell_example_test(${name})
endforeach()
