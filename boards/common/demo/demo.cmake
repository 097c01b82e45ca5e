# The libraries of the demo, for a firmware and for the host that compares.
include(${CMAKE_CURRENT_LIST_DIR}/../../../fonts_gen/cmake/InkcellFonts.cmake)

set(INKCELL_DEMO_FONT /usr/share/fonts/truetype/dejavu/DejaVuSans.ttf CACHE
  FILEPATH "TTF or OTF that the demo's font is made from")
set(INKCELL_DEMO_DIR ${CMAKE_CURRENT_LIST_DIR})

# The boards that have a display.
set(INKCELL_DISPLAY_BOARDS lm3s6965evb lm3s811evb versatilepb riscv_virt)

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
  inkcell_add_font(${board}_demo_font NAME ${board}_demo
    FONT ${INKCELL_DEMO_FONT} MIN_PX 8 MAX_PX ${max_px} CODING ${INKCELL_DEMO_CODING})
endfunction()

# inkcell_add_demo(<name> <board> <format> [<rows>])
#
# <name>_pattern: the test picture. <name>_scene: the scene with its font. Both
# for the display of a board, in one of its formats, drawn in strips of so many
# rows; by default as the board draws them. What they define is in a namespace of
# that name: a program may link the demos of several displays.
function(inkcell_add_demo name board format)
  set(INKCELL_DEMO_CODING outline)
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
    INKCELL_DEMO_NAME=${name}
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
  set(coding kOutlineCoding inkcell/coding.hpp)
  if(INKCELL_DEMO_CODING STREQUAL field)
    set(coding kFieldCoding inkcell/field/draw.hpp)
  endif()
  list(GET coding 0 coding_name)
  list(GET coding 1 coding_header)
  target_compile_definitions(${name}_scene PRIVATE
    INKCELL_DEMO_CODING=${coding_name}
    INKCELL_DEMO_CODING_HEADER=<${coding_header}>
    INKCELL_DEMO_FONT_NAME=${board}_demo
    INKCELL_DEMO_FONT_HEADER=<fonts/${board}_demo.hpp>)
  target_link_libraries(${name}_scene
    PUBLIC ${name}_pattern
    PRIVATE ${board}_demo_font)
  target_compile_options(${name}_scene PRIVATE ${INKCELL_WARNINGS})
endfunction()

# inkcell_motion_font: the font of scenes that move, on every board. Distances
# reach farther than fields of text know them: it is of outlines. The pairs are
# those of the clock (clock_scene.hpp).
function(inkcell_add_motion_font)
  if(NOT TARGET inkcell_motion_font)
    add_library(inkcell_motion_font INTERFACE)
    inkcell_add_font(inkcell_motion_font NAME motion FONT ${INKCELL_DEMO_FONT}
      MIN_PX 8 MAX_PX 96 CODING outline
      MORPH "01 12 23 34 45 56 67 78 89 90 50 20 30 18")
  endif()
endfunction()

# Scenes that move: header and class of each. A board plays those of its
# INKCELL_DEMO_MOTIONS; by default all.
set(INKCELL_MOTION_path path_scene.hpp PathScene)
set(INKCELL_MOTION_clock clock_scene.hpp ClockScene)
set(INKCELL_MOTION_particles particle_scene.hpp ParticleScene)
set(INKCELL_MOTION_figure14 offset_scene.hpp OffsetScene)
set(INKCELL_MOTION_figure15 vortex_scene.hpp VortexScene)
set(INKCELL_MOTION_print print_scene.hpp PrintScene)

# inkcell_add_motions(<name> <board> <format> <scenes>)
#
# <name>_motion_<scene> for each scene that the board plays, and for `values`, on
# what <name>_pattern draws on; their names in the variable <scenes>.
function(inkcell_add_motions name board format scenes)
  inkcell_add_motion_font()
  set(INKCELL_DEMO_MOTIONS path clock particles figure15)
  include(${INKCELL_DEMO_DIR}/../../${board}/board.cmake)
  foreach(scene ${INKCELL_DEMO_MOTIONS})
    list(GET INKCELL_MOTION_${scene} 0 header)
    list(GET INKCELL_MOTION_${scene} 1 class)
    add_library(${name}_motion_${scene} STATIC ${INKCELL_DEMO_DIR}/motion.cpp)
    target_compile_definitions(${name}_motion_${scene} PRIVATE
      INKCELL_MOTION_HEADER="${header}" INKCELL_MOTION_SCENE=${class})
    target_link_libraries(${name}_motion_${scene}
      PUBLIC ${name}_pattern
      PRIVATE inkcell_scenes inkcell_motion_font)
    target_compile_options(${name}_motion_${scene} PRIVATE ${INKCELL_WARNINGS})
  endforeach()
  # The host draws at once what boards draw change by change.
  set(at_once 1)
  if(INKCELL_BOARD)
    set(at_once 0)
  endif()
  add_library(${name}_motion_values STATIC ${INKCELL_DEMO_DIR}/values.cpp)
  target_compile_definitions(${name}_motion_values PRIVATE
    INKCELL_VALUES_AT_ONCE=${at_once})
  target_link_libraries(${name}_motion_values
    PUBLIC ${name}_pattern
    PRIVATE inkcell_motion_font)
  target_compile_options(${name}_motion_values PRIVATE ${INKCELL_WARNINGS})
  set(${scenes} ${INKCELL_DEMO_MOTIONS} values PARENT_SCOPE)
endfunction()

# inkcell_add_page(<name>)
#
# <name>_page: pages of Chinese, and <name>_face: a face at some sizes, on what
# <name>_pattern draws on. Their fonts are no part of them.
function(inkcell_add_page name)
  foreach(picture page face)
    add_library(${name}_${picture} STATIC ${INKCELL_DEMO_DIR}/${picture}.cpp)
    target_link_libraries(${name}_${picture}
      PUBLIC ${name}_pattern
      PRIVATE inkcell::layout)
    target_compile_options(${name}_${picture} PRIVATE ${INKCELL_WARNINGS})
  endforeach()
endfunction()

# Fonts of notices, in the order of notice.cpp: name, file below the folder of
# Debian's fonts, script of SHAPE, characters.
set(INKCELL_NOTICE_FOLDER /usr/share/fonts/truetype)
set(INKCELL_NOTICE_FONTS
  "latin noto/NotoSans-Regular.ttf latn \
0x20-0x7E,0xA0-0x17F,0x1A0-0x1B0,0x300-0x303,0x309,0x31B,0x323,0x1EA0-0x1EF9,0x2010-0x2026,0x20AB"
  "arabic noto/NotoNaskhArabic-Regular.ttf arab \
0x20,0x60C,0x61B,0x61F,0x621-0x655,0x660-0x66C,0x670,0x67E,0x686,0x698,0x6A9,0x6AF,0x6CC"
  "devanagari lohit-devanagari/Lohit-Devanagari.ttf deva 0x20,0x900-0x97F"
  "hebrew noto/NotoSansHebrew-Regular.ttf hebr 0x20,0x5B0-0x5BC,0x5BE,0x5C1-0x5C2,0x5D0-0x5EA"
  "thai noto/NotoSansThai-Regular.ttf thai 0x20,0xE01-0xE3A,0xE3F-0xE5B")

# Whether this machine has their files.
set(INKCELL_HAS_NOTICES ON)
foreach(font ${INKCELL_NOTICE_FONTS})
  separate_arguments(font)
  list(GET font 1 file)
  if(NOT EXISTS ${INKCELL_NOTICE_FOLDER}/${file})
    message(STATUS "Notices are left out: there is no ${INKCELL_NOTICE_FOLDER}/${file}")
    set(INKCELL_HAS_NOTICES OFF)
  endif()
endforeach()

# inkcell_add_notice(<name>)
#
# <name>_notice: notices of several scripts, on what <name>_pattern draws on.
function(inkcell_add_notice name)
  if(NOT TARGET inkcell_notice_fonts)
    add_library(inkcell_notice_fonts INTERFACE)
    foreach(font ${INKCELL_NOTICE_FONTS})
      separate_arguments(font)
      list(POP_FRONT font id file script chars)
      inkcell_add_font(inkcell_notice_fonts NAME notice_${id}
        FONT ${INKCELL_NOTICE_FOLDER}/${file} SHAPE ${script} CHARS ${chars}
        NO_LAYOUT_GLYPHS MIN_PX 16 MAX_PX 18)
    endforeach()
  endif()
  add_library(${name}_notice STATIC ${INKCELL_DEMO_DIR}/notice.cpp)
  target_link_libraries(${name}_notice
    PUBLIC ${name}_pattern
    PRIVATE inkcell::layout inkcell_notice_fonts)
  target_compile_options(${name}_notice PRIVATE ${INKCELL_WARNINGS})
endfunction()
