# Inkcell as a component of ESP-IDF: the top-level CMakeLists.txt comes here.
get_filename_component(root ${CMAKE_CURRENT_LIST_DIR}/../.. ABSOLUTE)
file(GLOB_RECURSE sources
  ${root}/core/src/*.cpp
  ${root}/core/kinetic/src/*.cpp
  ${root}/port/pixel/src/*.cpp
  ${root}/port/display/src/*.cpp
  ${root}/port/c/src/*.cpp)
idf_component_register(
  SRCS ${sources}
  INCLUDE_DIRS
    ${root}/core/include
    ${root}/core/kinetic/include
    ${root}/port/pixel/include
    ${root}/port/display/include
    ${root}/port/c/include
  PRIV_INCLUDE_DIRS ${root}/core/src)
target_compile_features(${COMPONENT_LIB} PUBLIC cxx_std_17)
set_property(GLOBAL PROPERTY inkcell_library ${COMPONENT_LIB})
target_compile_options(${COMPONENT_LIB} PRIVATE -ffunction-sections -fdata-sections)

# After idf_component_register() of a component that has REQUIRES inkcell:
#   inkcell_add_font(${COMPONENT_LIB} FONT DejaVuSans.ttf NAME dejavu_sans)
include(${root}/fonts_gen/cmake/InkcellFonts.cmake)
