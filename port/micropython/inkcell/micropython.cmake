# The module `inkcell` in a port of MicroPython that is built by CMake: ESP32, RP2.
#
#   make -C ports/esp32 USER_C_MODULES=<this file>
#
# inkcell_module.c says how it is used.
get_filename_component(inkcell ${CMAKE_CURRENT_LIST_DIR}/../../.. ABSOLUTE)
set(parts core core/cache core/field core/layout core/motion port/pixel
  port/display port/c)
add_library(usermod_inkcell INTERFACE)
foreach(part ${parts})
  file(GLOB_RECURSE sources ${inkcell}/${part}/src/*.cpp)
  target_sources(usermod_inkcell INTERFACE ${sources})
  target_include_directories(usermod_inkcell INTERFACE ${inkcell}/${part}/include)
endforeach()
target_sources(usermod_inkcell INTERFACE
  ${CMAKE_CURRENT_LIST_DIR}/inkcell_module.c)
target_include_directories(usermod_inkcell INTERFACE ${inkcell}/core/src)
target_compile_features(usermod_inkcell INTERFACE cxx_std_17)
target_link_libraries(usermod INTERFACE usermod_inkcell)
