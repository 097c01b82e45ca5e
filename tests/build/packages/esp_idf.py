"""ESP-IDF: its component function, played by CMake, says what it was given."""
from packages.consumer import check_libraries, library_symbols
from toolchains import FONT, ROOT, call

PROJECT = """cmake_minimum_required(VERSION 3.25)
project(user LANGUAGES CXX)
set(ESP_PLATFORM 1)
# As if this were the oldest CMake of ESP-IDF 5.
function(cmake_minimum_required word version)
  if(version VERSION_GREATER 3.22)
    message(FATAL_ERROR "CMake ${version} is asked for")
  endif()
endfunction()
foreach(option IN LISTS MORE)
  set(CONFIG_${option} y)
endforeach()
function(idf_component_register)
  cmake_parse_arguments(arg "" "KCONFIG" "SRCS;INCLUDE_DIRS;PRIV_INCLUDE_DIRS" ${ARGN})
  foreach(folder IN LISTS arg_INCLUDE_DIRS arg_PRIV_INCLUDE_DIRS)
    if(NOT IS_DIRECTORY ${folder})
      message(FATAL_ERROR "no folder ${folder}")
    endif()
  endforeach()
  if(NOT EXISTS ${arg_KCONFIG})
    message(FATAL_ERROR "no file ${arg_KCONFIG}")
  endif()
  list(JOIN arg_SRCS "\\n" lines)
  file(WRITE ${CMAKE_BINARY_DIR}/sources "${lines}")
  add_library(component OBJECT ${arg_SRCS})
  set(COMPONENT_LIB component PARENT_SCOPE)
endfunction()
# Where a project has LVGL.
function(idf_component_optional_requires kind)
  if(NOT "lvgl" IN_LIST ARGN)
    message(FATAL_ERROR "LVGL is ${ARGN}")
  endif()
endfunction()
add_subdirectory(@ROOT@ inkcell)
add_library(main INTERFACE)
foreach(coding outline field)
  inkcell_add_font(main FONT @FONT@ NAME ${coding} CODING ${coding})
endforeach()
"""


def sources(folder, fontgen):
    folder.mkdir()
    (folder / "CMakeLists.txt").write_text(
        PROJECT.replace("@ROOT@", str(ROOT)).replace("@FONT@", str(FONT)))
    libraries = library_symbols(ROOT / "port/esp_idf/Kconfig")
    for build, more in (("build", []), ("more", libraries)):
        call("cmake", "-G", "Ninja", "-S", folder, "-B", folder / build,
             f"-DMORE={';'.join(more)}", f"-DINKCELL_FONTGEN={fontgen}")
    check_libraries("ESP-IDF",
                    (folder / "build/sources").read_text().splitlines(), [])
    return (folder / "more/sources").read_text().splitlines()
