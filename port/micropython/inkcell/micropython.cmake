# The module `inkcell` in a port of MicroPython that is built by CMake: ESP32, RP2.
#
#   make -C ports/esp32 USER_C_MODULES=<this file>
#
# inkcell_module.c says how it is used.
set(CONFIG_INKCELL_C y)
foreach(name CACHE FIELD FIGURES LAYERS LAYOUT MOTION SHAPING STRIKE TRUETYPE)  # its needs
  set(CONFIG_INKCELL_${name} y)
endforeach()
include(${CMAKE_CURRENT_LIST_DIR}/../../libraries.cmake)
add_library(usermod_inkcell INTERFACE)
target_sources(usermod_inkcell INTERFACE ${inkcell_sources}
  ${CMAKE_CURRENT_LIST_DIR}/inkcell_module.c)
target_include_directories(usermod_inkcell INTERFACE
  ${inkcell_includes} ${root}/core/src)
target_compile_features(usermod_inkcell INTERFACE cxx_std_17)
target_link_libraries(usermod INTERFACE usermod_inkcell)
