# inkcell_add_font(): fonts as headers, made while the project is built.
#
#   inkcell_add_font(<target> [FONT <file>]
#     [NAME <identifier>]      default: the file's name
#     [CHARS <list>...]        0x20-0x7E,U+B0,A-Z; default 0x20-0x7E
#     [SET <name>...]          latin-1, greek, gb2312-1, ...: `--help` lists all
#     [SYMBOLS <string>] [TEXT_FILE <utf-8 file>...]
#     [STRINGS_FROM <C or C++ file, translation, or src/**/*.c>...]
#     [STRINGS <file of strings>...] [STRICT]
#     [NO_LAYOUT_GLYPHS]       without '.' and '-' for ellipses, soft hyphens
#     [MIN_PX <n>] [MAX_PX <n>] [TOLERANCE <n>] [BAND_PX <n>]
#     [FACE <n>] [INSTANCE <name>]    of a variable font
#     [AXIS <tag=value, or tag=from..to>...]    the latter: with second masters
#     [CODING outline|field] [HINTS on|off] [MORPH <characters>...]
#     [PREDICATE size|fixed] [EFFORT <0..9>] [BEST_EFFORT]
#     [BUDGET <bytes, or 24K>] [PREVIEW <file.png>]
#     [MERGE <file>[:<setting>,...][=<list>]...]    more faces, in order of
#                              priority: icons.ttf:FILL=1,height=cap=0xE88A
#     [SVG <file>=<code point>...] [SVG_DIR <folder>...]    icons
#     [SVG_HEIGHT em|cap|<em>] [SVG_BASELINE middle|bottom|<em>]
#     [STRIKE <px:bits[:none|vertical|both]>...] [STRIKE_ONLY]    pictures
#     [COLOUR]                 layers of colours, of icons and colour fonts
#     [SHAPE <script>...]      shaped at run time: arab:FAS hebr latn+smcp
#     [KEEP_LAYOUT]            tables for HarfBuzz on the device
#     [COMPOSE on|off]         letters and marks become composed letters
#     [LANGUAGE CXX|C] [SECTION <section of the array>]
#     [PAGED 512|1024|2048|4096])    for storage that is not mapped
#
# FONT may be left out where there are icons; NAME is needed then.
#
# The target's sources then find the array fonts::<NAME> in <fonts/NAME.hpp>, and
# strings as fonts::<NAME>_strings::<string>; with LANGUAGE C they find <NAME>,
# <NAME>_size and <NAME>_strings_<string> in <fonts/NAME.h>. A file that is new
# below a pattern of STRINGS_FROM counts when the font is made next.
# The arguments are those of inkcell-fontgen; see `inkcell-fontgen --help`.
# CODING says what glyphs are made of:
#   outline   points of lines and curves, about 6 KB for 95 characters; default
#   field     a quadtree of cells of nine distances: the field at any point
# A target with a font of fields is linked with inkcell::field and opens it with
# Font::open(fonts::NAME, inkcell::kFieldCoding, font).
#
# STRIKE 12:1 adds pictures of all glyphs at 12 px, of 1 bit, which draw that size
# at a bitmap's cost; with STRIKE_ONLY, or of a bitmap font, there are no outlines.
# The target is linked with inkcell::strike, and opens the font with
# Font::open(fonts::NAME, fonts::NAME_coding, font).
#
# With PAGED the font is a file for an SD card, a flash chip or a file system, and
# no array: inkcell_fonts/<target>/fonts/NAME.bin below the binary folder, which
# the target's property INKCELL_FILE_<NAME> names. <fonts/NAME.hpp> has what
# inkcell::StoredFont needs to know of it, as fonts::<NAME>::kBlockBytes. The
# target is linked with inkcell::stored.
#
# A glyph that misses TOLERANCE is an error, unless BEST_EFFORT is there. One that
# misses the default, 16, is drawn as well as possible, with a warning.
#
# A NAME must be unique in a program and its libraries: the linker merges two
# arrays of one name silently.
#
# The generator runs on the build host. Which one is used:
# - INKCELL_FONTGEN, if set: the path of the program;
# - else the one of this build, or the one that was installed with this file;
# - else, in another project, an installed one of the same version, if the
#   machine's PATH has one;
# - else, when cross compiling or when inkcell is part of another project, one
#   that is built from the sources with the machine's own compiler, into
#   INKCELL_FONTGEN_DIR. Several build trees may share that folder; another
#   checkout or INKCELL_HOST_CXX has the generator built anew in it.
set(INKCELL_FONTGEN "" CACHE FILEPATH "Generator to use: inkcell-fontgen")
set(INKCELL_FONTGEN_DIR "" CACHE PATH
  "Where the generator is built if needed [<build>/inkcell-fontgen]")
set(INKCELL_FONTGEN_LAUNCHER "$ENV{INKCELL_FONTGEN_LAUNCHER}" CACHE STRING
  "Program that runs the generator, as CMAKE_<LANG>_COMPILER_LAUNCHER does")
set(INKCELL_HOST_CXX "" CACHE FILEPATH
  "Compiler that builds the generator [the machine's default]")

# Makes a target that builds the generator with the machine's own compiler.
function(_inkcell_build_fontgen program)
  set(folder "${INKCELL_FONTGEN_DIR}")
  if(NOT folder)
    set(folder "${CMAKE_BINARY_DIR}/inkcell-fontgen")
  endif()
  set(built "${folder}/inkcell-fontgen${CMAKE_HOST_EXECUTABLE_SUFFIX}")
  set(${program} "${built}" PARENT_SCOPE)
  if(TARGET inkcell_fontgen_native)
    return()
  endif()
  if(NOT EXISTS "${built}")
    message(STATUS
      "inkcell: the first build makes inkcell-fontgen for this machine in "
      "${folder}: about a minute on two cores, once. Build trees that set "
      "INKCELL_FONTGEN_DIR share it; an installed one is taken instead.")
  endif()
  cmake_path(SET source NORMALIZE "${CMAKE_CURRENT_FUNCTION_LIST_DIR}/..")
  add_custom_target(inkcell_fontgen_native
    COMMAND ${CMAKE_COMMAND}
      "-DSOURCE=${source}"
      "-DFOLDER=${folder}"
      "-DGENERATOR=${CMAKE_GENERATOR}"
      "-DMAKE_PROGRAM=${CMAKE_MAKE_PROGRAM}"
      "-DCXX=${INKCELL_HOST_CXX}"
      -P "${CMAKE_CURRENT_FUNCTION_LIST_DIR}/BuildFontgen.cmake"
    BYPRODUCTS "${built}"
    COMMENT "Building inkcell-fontgen for this machine, unless it is up to date"
    USES_TERMINAL VERBATIM)
endfunction()

# Sets `program` to an installed generator of the version of these sources, or to
# nothing. The project itself takes none: its sources may be ahead of its version.
function(_inkcell_same_fontgen program)
  set(${program} "" PARENT_SCOPE)
  if(inkcell_IS_TOP_LEVEL)
    return()
  endif()
  file(STRINGS
    "${CMAKE_CURRENT_FUNCTION_LIST_DIR}/../../core/include/inkcell/version.hpp"
    version REGEX "kLibraryVersion")
  list(TRANSFORM version REPLACE "[^0-9]*8_t [^0-9]*([0-9]+);.*" "\\1")
  list(JOIN version "." version)
  find_program(_inkcell_fontgen_in_path inkcell-fontgen
    NO_CMAKE_FIND_ROOT_PATH NO_CACHE)
  if(_inkcell_fontgen_in_path)
    execute_process(COMMAND "${_inkcell_fontgen_in_path}" --version
      OUTPUT_VARIABLE said ERROR_QUIET)
    if("${said}" MATCHES "^inkcell-fontgen ${version},")
      message(STATUS "inkcell: fonts are made by ${_inkcell_fontgen_in_path}")
      set(${program} "${_inkcell_fontgen_in_path}" PARENT_SCOPE)
    endif()
  endif()
endfunction()

# Sets `program` to the generator and `depends` to what must be built first.
function(_inkcell_find_fontgen program depends)
  set(${depends} "" PARENT_SCOPE)
  if(INKCELL_FONTGEN)
    set(${program} "${INKCELL_FONTGEN}" PARENT_SCOPE)
    set(${depends} "${INKCELL_FONTGEN}" PARENT_SCOPE)
    return()
  endif()
  if(TARGET inkcell-fontgen AND NOT CMAKE_CROSSCOMPILING)
    set(${program} "$<TARGET_FILE:inkcell-fontgen>" PARENT_SCOPE)
    set(${depends} inkcell-fontgen PARENT_SCOPE)
    return()
  endif()
  if(EXISTS "${CMAKE_CURRENT_FUNCTION_LIST_DIR}/../src/app/main.cpp")
    _inkcell_same_fontgen(same)
    if(same)
      set(${program} "${same}" PARENT_SCOPE)
      set(${depends} "${same}" PARENT_SCOPE)
      return()
    endif()
    _inkcell_build_fontgen(built)
    set(${program} "${built}" PARENT_SCOPE)
    set(${depends} inkcell_fontgen_native "${built}" PARENT_SCOPE)
    return()
  endif()
  # Installed as <prefix>/lib/cmake/inkcell/InkcellFonts.cmake.
  find_program(_inkcell_installed_fontgen inkcell-fontgen
    HINTS "${CMAKE_CURRENT_FUNCTION_LIST_DIR}/../../../bin"
    NO_CMAKE_FIND_ROOT_PATH NO_CACHE)
  if(NOT _inkcell_installed_fontgen)
    message(FATAL_ERROR
      "inkcell_add_font: there is no inkcell-fontgen; set INKCELL_FONTGEN to "
      "the path of one that runs on this machine")
  endif()
  set(${program} "${_inkcell_installed_fontgen}" PARENT_SCOPE)
  set(${depends} "${_inkcell_installed_fontgen}" PARENT_SCOPE)
endfunction()

function(_inkcell_write_if_different file text)
  set(old "")
  if(EXISTS "${file}")
    file(READ "${file}" old)
  endif()
  if(NOT EXISTS "${file}" OR NOT "${old}" STREQUAL "${text}")
    file(WRITE "${file}" "${text}")
  endif()
endfunction()

# Ends with an error unless the value of the argument `word` is empty or one of
# those that follow.
function(_inkcell_check_choice word value)
  if(NOT "${value}" STREQUAL "" AND NOT "${value}" IN_LIST ARGN)
    list(JOIN ARGN " or " choices)
    message(FATAL_ERROR
      "inkcell_add_font: ${word} is ${choices}, not ${value}")
  endif()
endfunction()

# Sets `option` to the generator's one for an argument: --min-px for MIN_PX.
function(_inkcell_option option word)
  string(TOLOWER "--${word}" text)
  string(REPLACE "_" "-" text "${text}")
  set(${option} "${text}" PARENT_SCOPE)
endfunction()

# Appends the options for more faces and for icons to the list that `to_options`
# names, and the files that they name to that of `to_inputs`.
function(_inkcell_face_options to_options to_inputs merge svg folders)
  set(words "${${to_options}}")
  set(files "${${to_inputs}}")
  foreach(option IN ITEMS merge svg)
    foreach(value IN LISTS ${option})
      # What is behind the last "=" is no part of the file's name, and a face may
      # have settings before that, as parse_merged_face() reads them.
      string(REGEX MATCH "=[^=]*$" suffix "${value}")
      string(REGEX REPLACE "=[^=]*$" "" file "${value}")
      cmake_path(ABSOLUTE_PATH file NORMALIZE OUTPUT_VARIABLE there)
      if(option STREQUAL "merge" AND NOT EXISTS "${there}" AND
          value MATCHES "^([^:]*(:[/\\][^:]*)?)(:[^=:,/\\]+=.*)$")
        set(file "${CMAKE_MATCH_1}")
        set(suffix "${CMAKE_MATCH_3}")
      endif()
      cmake_path(ABSOLUTE_PATH file NORMALIZE)
      list(APPEND words "--${option}=${file}${suffix}")
      list(APPEND files "${file}")
    endforeach()
  endforeach()
  foreach(folder IN LISTS folders)
    cmake_path(ABSOLUTE_PATH folder NORMALIZE)
    list(APPEND words "--svg-dir=${folder}")  # its files are in the depfile
  endforeach()
  set(${to_options} "${words}" PARENT_SCOPE)
  set(${to_inputs} "${files}" PARENT_SCOPE)
endfunction()

function(inkcell_add_font target)
  set(single
    FONT NAME SYMBOLS MIN_PX MAX_PX TOLERANCE BAND_PX FACE INSTANCE CODING
    HINTS PREDICATE EFFORT COMPOSE BUDGET PREVIEW LANGUAGE SECTION SVG_HEIGHT
    SVG_BASELINE PAGED)
  set(several
    CHARS SET TEXT_FILE STRINGS_FROM STRINGS AXIS MORPH MERGE SVG SVG_DIR STRIKE
    SHAPE)
  set(flags BEST_EFFORT KEEP_LAYOUT STRICT NO_LAYOUT_GLYPHS STRIKE_ONLY COLOUR)
  cmake_parse_arguments(PARSE_ARGV 1 arg "${flags}" "${single}" "${several}")
  # A word that stands where characters do is a misspelt option.
  set(words ${arg_CHARS})
  list(FILTER words INCLUDE REGEX "^[A-Z][A-Z_]+$")
  string(JOIN " " words
    ${arg_UNPARSED_ARGUMENTS} ${words} ${arg_KEYWORDS_MISSING_VALUES})
  if(NOT "${words}" STREQUAL "")
    string(JOIN " " options ${single} ${several} ${flags})
    message(FATAL_ERROR
      "inkcell_add_font(<target> FONT <file> ...): not understood: ${words}. The "
      "options are ${options}; the head of ${CMAKE_CURRENT_FUNCTION_LIST_FILE} "
      "explains them")
  endif()
  if(NOT TARGET "${target}")
    message(FATAL_ERROR
      "inkcell_add_font: there is no target ${target}; add it before its fonts")
  endif()
  # cmake_parse_arguments() leaves out what is empty, as if it were not asked for.
  math(EXPR last "${ARGC} - 1")
  foreach(index RANGE ${last})
    if("${ARGV${index}}" STREQUAL "")
      message(FATAL_ERROR
        "inkcell_add_font: the value after ${before} is empty; give it one, or "
        "leave ${before} out")
    endif()
    set(before "${ARGV${index}}")
  endforeach()
  if(NOT DEFINED arg_FONT AND NOT DEFINED arg_SVG AND NOT DEFINED arg_SVG_DIR)
    message(FATAL_ERROR
      "inkcell_add_font: there is no FONT <file>, and no SVG or SVG_DIR")
  endif()
  if(NOT DEFINED arg_FONT AND NOT DEFINED arg_NAME)
    message(FATAL_ERROR
      "inkcell_add_font: icons without FONT need a NAME <identifier>")
  endif()

  _inkcell_check_choice(CODING "${arg_CODING}" outline field)
  _inkcell_check_choice(HINTS "${arg_HINTS}" on off)
  _inkcell_check_choice(PREDICATE "${arg_PREDICATE}" size fixed)
  _inkcell_check_choice(LANGUAGE "${arg_LANGUAGE}" CXX C)
  _inkcell_check_choice(PAGED "${arg_PAGED}" 512 1024 2048 4096)
  if(DEFINED arg_PAGED AND "${arg_LANGUAGE}" STREQUAL "C")
    message(FATAL_ERROR
      "inkcell_add_font: PAGED is for C++, which has StoredFont; leave LANGUAGE C "
      "out, and open the font in a source of C++")
  endif()
  if("${arg_PREDICATE}" STREQUAL "fixed" AND
      NOT "${arg_CODING}" STREQUAL "field")
    message(FATAL_ERROR
      "inkcell_add_font: PREDICATE fixed is for CODING field")
  endif()

  set(inputs)
  set(font)
  if(DEFINED arg_FONT)
    cmake_path(ABSOLUTE_PATH arg_FONT NORMALIZE OUTPUT_VARIABLE file)
    if(NOT EXISTS "${file}")
      message(FATAL_ERROR "inkcell_add_font: there is no font file ${file}")
    endif()
    list(APPEND inputs "${file}")
    set(font "--font=${file}")
  endif()
  if(NOT DEFINED arg_NAME)
    cmake_path(GET font STEM LAST_ONLY arg_NAME)
    string(MAKE_C_IDENTIFIER "${arg_NAME}" arg_NAME)
  endif()

  set(options)
  foreach(word IN LISTS flags)
    if(arg_${word})
      _inkcell_option(option ${word})
      list(APPEND options ${option})
    endif()
  endforeach()
  foreach(word
      MIN_PX MAX_PX TOLERANCE BAND_PX FACE INSTANCE CODING HINTS PREDICATE
      EFFORT COMPOSE BUDGET SECTION SVG_HEIGHT SVG_BASELINE PAGED CHARS SET AXIS
      MORPH STRIKE)
    _inkcell_option(option ${word})
    foreach(value IN LISTS arg_${word})
      # "=" keeps a value apart from options even if it begins with a dash.
      list(APPEND options "${option}=${value}")
    endforeach()
  endforeach()
  if(DEFINED arg_SHAPE)
    string(JOIN "," shape ${arg_SHAPE})
    list(APPEND options "--shape=${shape}")
  endif()
  foreach(word TEXT_FILE STRINGS STRINGS_FROM)
    _inkcell_option(option ${word})
    foreach(value IN LISTS arg_${word})
      cmake_path(ABSOLUTE_PATH value NORMALIZE)
      list(APPEND options "${option}=${value}")
      # The generator finds the files of a pattern, and names them in the depfile.
      if(NOT word STREQUAL "STRINGS_FROM")
        list(APPEND inputs "${value}")
      endif()
    endforeach()
  endforeach()
  set(preview)
  if(DEFINED arg_PREVIEW)
    cmake_path(ABSOLUTE_PATH arg_PREVIEW BASE_DIRECTORY
      "${CMAKE_CURRENT_BINARY_DIR}" NORMALIZE OUTPUT_VARIABLE preview)
    list(APPEND options "--preview=${preview}")
  endif()
  _inkcell_face_options(
    options inputs "${arg_MERGE}" "${arg_SVG}" "${arg_SVG_DIR}")

  # GCC puts inline arrays of one section into the group of the first: a source
  # that has one font alone then loses those of others.
  if(DEFINED arg_SECTION AND NOT "${arg_LANGUAGE}" STREQUAL "C")
    get_target_property(other ${target} "INKCELL_SECTION_${arg_SECTION}")
    if(other AND NOT other STREQUAL arg_NAME)
      message(FATAL_ERROR
        "inkcell_add_font: SECTION ${arg_SECTION} is that of ${other}; in C++ "
        "give each font its own, such as ${arg_SECTION}.${arg_NAME}, or use "
        "LANGUAGE C")
    endif()
    set_target_properties(${target} PROPERTIES
      "INKCELL_SECTION_${arg_SECTION}" "${arg_NAME}")
  endif()

  set(include "${CMAKE_CURRENT_BINARY_DIR}/inkcell_fonts/${target}")
  if(DEFINED arg_PAGED)
    set(header "${include}/fonts/${arg_NAME}.hpp")
    set(made "${include}/fonts/${arg_NAME}.bin")
    set(outputs "${made}" "${header}")
    set(form --format=bin "--header=${header}")
    set_target_properties(${target} PROPERTIES "INKCELL_FILE_${arg_NAME}" "${made}")
  elseif("${arg_LANGUAGE}" STREQUAL "C")
    set(header "${include}/fonts/${arg_NAME}.h")
    set(made "${include}/fonts/${arg_NAME}.c")
    set(outputs "${made}" "${header}")
    set(form --format=c "--header=${header}")
  else()
    set(header "${include}/fonts/${arg_NAME}.hpp")
    set(made "${header}")
    set(outputs "${made}")
    set(form --format=hpp)
  endif()
  file(MAKE_DIRECTORY "${include}/fonts")
  if(DEFINED arg_SYMBOLS)
    # By way of a file: no list and no shell takes a ; or a \ for its own.
    set(symbols "${header}.symbols")
    _inkcell_write_if_different("${symbols}" "${arg_SYMBOLS}")
    list(APPEND options "--text-file=${symbols}")
    list(APPEND inputs "${symbols}")
  endif()

  _inkcell_find_fontgen(program depends)
  add_custom_command(
    OUTPUT ${outputs}
    BYPRODUCTS ${preview}
    COMMAND ${INKCELL_FONTGEN_LAUNCHER} "${program}" ${font} ${options} --quiet
      ${form} "--name=${arg_NAME}" "--out=${made}" "--depfile=${made}.d"
    DEPENDS ${inputs} ${depends}
    DEPFILE "${made}.d"
    COMMENT "Making the font ${arg_NAME}"
    VERBATIM)
  # Targets of other directories that link `target` wait for the font, too.
  add_custom_target(${target}_${arg_NAME}_files DEPENDS ${outputs})
  add_dependencies(${target} ${target}_${arg_NAME}_files)

  set(scope PRIVATE)
  get_target_property(type ${target} TYPE)
  if(type STREQUAL "INTERFACE_LIBRARY")
    set(scope INTERFACE)
  endif()
  target_sources(${target} ${scope} ${outputs})
  target_include_directories(${target} ${scope} "${include}")
  set(library)
  if(arg_CODING STREQUAL "field")
    set(library inkcell::field)
  elseif(DEFINED arg_PAGED)
    set(library inkcell::stored)
  endif()
  if(library AND TARGET ${library})
    # Not target_link_libraries(), which refuses to mix its two signatures.
    set(property LINK_LIBRARIES)
    if(type STREQUAL "INTERFACE_LIBRARY")
      set(property INTERFACE_LINK_LIBRARIES)
    endif()
    set_property(TARGET ${target} APPEND PROPERTY ${property} ${library})
  endif()
endfunction()
