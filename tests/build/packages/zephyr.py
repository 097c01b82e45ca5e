"""Zephyr: module.yml leads to CMake and Kconfig; its functions are played."""
import re

from packages.consumer import check_libraries, library_symbols
from toolchains import FONT, ROOT, call, finish

PROJECT = """cmake_minimum_required(VERSION 3.25)
project(user LANGUAGES CXX)
set(CONFIG_INKCELL y)
foreach(option IN LISTS MORE)
  set(CONFIG_${option} y)
endforeach()
macro(zephyr_library_named name)
  add_library(${name} OBJECT)
endmacro()
function(zephyr_library_sources)
  target_sources(inkcell PRIVATE ${ARGN})
  list(JOIN ARGN "\\n" lines)
  file(WRITE ${CMAKE_BINARY_DIR}/sources "${lines}")
endfunction()
function(zephyr_library_link_libraries)
  target_link_libraries(inkcell PRIVATE ${ARGN})
endfunction()
function(zephyr_library_include_directories)
  foreach(folder IN LISTS ARGN)
    if(NOT IS_DIRECTORY ${folder})
      message(FATAL_ERROR "no folder ${folder}")
    endif()
  endforeach()
endfunction()
function(zephyr_include_directories)
  zephyr_library_include_directories(${ARGN})
endfunction()
add_library(zephyr_interface INTERFACE)
function(zephyr_compile_definitions)
  target_compile_definitions(zephyr_interface INTERFACE ${ARGN})
endfunction()
add_subdirectory(@FOLDER@ inkcell)
get_target_property(defined zephyr_interface INTERFACE_COMPILE_DEFINITIONS)
file(WRITE ${CMAKE_BINARY_DIR}/options "${defined}\\n")
if(NOT MORE)
  add_library(app INTERFACE)
  foreach(coding outline field)
    inkcell_add_font(app FONT @FONT@ NAME ${coding} CODING ${coding})
  endforeach()
endif()
"""


def configure(folder, more, fontgen):
    """The options of core that reach the compiler, with more of Kconfig's."""
    build = folder / ("more" if more else "build")
    call("cmake", "-G", "Ninja", "-S", folder, "-B", build,
         f"-DMORE={';'.join(more)}", f"-DINKCELL_FONTGEN={fontgen}")
    return sorted((build / "options").read_text().strip().split(";"))


def sources(folder, fontgen):
    module = (ROOT / "zephyr/module.yml").read_text()
    cmake = ROOT / re.search(r"^  cmake: (\S+)$", module, re.M).group(1)
    kconfig = ROOT / re.search(r"^  kconfig: (\S+)$", module, re.M).group(1)
    folder.mkdir()
    (folder / "CMakeLists.txt").write_text(
        PROJECT.replace("@FOLDER@", str(cmake)).replace("@FONT@", str(FONT)))
    # Each option of core has a symbol, and reaches the compiler.
    options = re.findall(r"^option\((INKCELL_\w+)",
                         (ROOT / "core/CMakeLists.txt").read_text(), re.M)
    symbols = re.findall(r"^config (INKCELL_\w+)", kconfig.read_text(), re.M)
    libraries = library_symbols(kconfig)
    defined = [configure(folder, more, fontgen)
               for more in ([], options + libraries)]
    wanted = [["INKCELL_ASSERTIONS=0"],
              sorted(f"{name}=1" for name in options)]
    if symbols != options or defined != wanted:
        finish(0, [f"Zephyr: {symbols} and {defined}, not {options}"])
    check_libraries("Zephyr",
                    (folder / "build/sources").read_text().splitlines(), [])
    return (folder / "more/sources").read_text().splitlines()
