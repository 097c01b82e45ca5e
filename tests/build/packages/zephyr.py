"""Zephyr: module.yml leads to CMake and Kconfig; its functions are played."""
import re

from packages.consumer import call
from toolchains import ROOT

PROJECT = """cmake_minimum_required(VERSION 3.25)
project(user LANGUAGES CXX)
set(CONFIG_INKCELL y)
set(CONFIG_INKCELL_OUTLINES y)
macro(zephyr_library_named name)
  add_library(${name} OBJECT)
endmacro()
function(zephyr_library_sources)
  target_sources(inkcell PRIVATE ${ARGN})
  list(JOIN ARGN "\\n" lines)
  file(WRITE ${CMAKE_BINARY_DIR}/sources "${lines}")
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
function(zephyr_compile_definitions)
  file(APPEND ${CMAKE_BINARY_DIR}/definitions "${ARGN}\\n")
endfunction()
add_subdirectory(@FOLDER@ inkcell)
if(NOT COMMAND inkcell_add_font)
  message(FATAL_ERROR "no inkcell_add_font()")
endif()
"""


def sources(folder, _):
    module = (ROOT / "zephyr/module.yml").read_text()
    cmake = ROOT / re.search(r"^  cmake: (\S+)$", module, re.M).group(1)
    kconfig = ROOT / re.search(r"^  kconfig: (\S+)$", module, re.M).group(1)
    folder.mkdir()
    (folder / "CMakeLists.txt").write_text(
        PROJECT.replace("@FOLDER@", str(cmake)))
    call("cmake", "-G", "Ninja", "-S", folder, "-B", folder / "build")
    # Each option of core has a symbol, and reaches the compiler.
    options = re.findall(r"^option\((INKCELL_\w+)",
                         (ROOT / "core/CMakeLists.txt").read_text(), re.M)
    symbols = re.findall(r"^config (INKCELL_\w+)", kconfig.read_text(), re.M)
    defined = (folder / "build/definitions").read_text().split()
    wanted = [f"{name}={int(name == 'INKCELL_OUTLINES')}" for name in options]
    if symbols != options or defined != wanted:
        raise SystemExit(f"Zephyr: {symbols} and {defined}, not {options}\n"
                         "0 passed, 1 failed")
    return (folder / "build/sources").read_text().splitlines()
