# The libraries of the demo, for a firmware and for the host that compares.
include(${CMAKE_CURRENT_LIST_DIR}/../../../fonts_gen/cmake/InkcellFonts.cmake)

set(INKCELL_DEMO_FONT /usr/share/fonts/truetype/dejavu/DejaVuSans.ttf CACHE
  FILEPATH "TTF or OTF that the demo's font is made from")
set(INKCELL_DEMO_DIR ${CMAKE_CURRENT_LIST_DIR})

# inkcell_add_demo_font(<board>)
#
# <board>_demo_font: one font for the clock and the text, printable ASCII for 8 to
# 64 px, or as large as the clock is; of outlines, unless the board's
# INKCELL_DEMO_CODING is another.
function(inkcell_add_demo_font board)
  if(TARGET ${board}_demo_font)
    return()
  endif()
  if(NOT EXISTS ${INKCELL_DEMO_FONT})
    message(FATAL_ERROR
      "inkcell: the demo needs the font ${INKCELL_DEMO_FONT}; on Debian and "
      "Ubuntu: apt-get install fonts-dejavu-core, or set INKCELL_DEMO_FONT")
  endif()
  set(INKCELL_DEMO_CODING outline)
  include(${INKCELL_DEMO_DIR}/../../${board}/board.cmake)
  set(max_px 64)
  if(INKCELL_DEMO_CLOCK_PX GREATER max_px)
    set(max_px ${INKCELL_DEMO_CLOCK_PX})
  endif()
  add_library(${board}_demo_font INTERFACE)
  inkcell_add_font(${board}_demo_font NAME demo FONT ${INKCELL_DEMO_FONT}
    MIN_PX 8 MAX_PX ${max_px} CODING ${INKCELL_DEMO_CODING})
endfunction()

# inkcell_add_demo(<name> <board> <format> [<rows>])
#
# <name>_pattern: the test picture. <name>_scene: the scene with its font. Both
# for the display of a board, in one of its formats, drawn in strips of so many
# rows; by default as the board draws them.
function(inkcell_add_demo name board format)
  include(${INKCELL_DEMO_DIR}/../../${board}/board.cmake)
  set(rows ${INKCELL_DEMO_ROWS})
  if(ARGC GREATER 3)
    set(rows ${ARGV3})
  endif()

  add_library(${name}_pattern STATIC
    ${INKCELL_DEMO_DIR}/pattern.cpp
    ${INKCELL_DEMO_DIR}/show.cpp)
  target_compile_definitions(${name}_pattern PUBLIC
    INKCELL_DISPLAY_WIDTH=${INKCELL_DISPLAY_WIDTH}
    INKCELL_DISPLAY_HEIGHT=${INKCELL_DISPLAY_HEIGHT}
    INKCELL_DEMO_FORMAT=${format}
    INKCELL_DEMO_ROWS=${rows})
  target_include_directories(${name}_pattern PUBLIC
    ${INKCELL_DEMO_DIR} ${INKCELL_DEMO_DIR}/..)
  target_link_libraries(${name}_pattern PUBLIC inkcell::port_display)
  target_compile_options(${name}_pattern PRIVATE ${INKCELL_WARNINGS})

  inkcell_add_demo_font(${board})
  add_library(${name}_scene STATIC ${INKCELL_DEMO_DIR}/scene.cpp)
  target_compile_definitions(${name}_scene PUBLIC
    INKCELL_DEMO_CLOCK_PX=${INKCELL_DEMO_CLOCK_PX}
    INKCELL_DEMO_TEXT_PX=${INKCELL_DEMO_TEXT_PX})
  target_link_libraries(${name}_scene
    PUBLIC ${name}_pattern
    PRIVATE ${board}_demo_font)
  target_compile_options(${name}_scene PRIVATE ${INKCELL_WARNINGS})
endfunction()
