# Inkcell as a component of ESP-IDF: the top-level CMakeLists.txt comes here. The
# menu "Inkcell" of menuconfig chooses libraries: CONFIG_INKCELL_LAYOUT=y.
include(${CMAKE_CURRENT_LIST_DIR}/../libraries.cmake)
idf_component_register(
  SRCS ${inkcell_sources}
  INCLUDE_DIRS ${inkcell_includes}
  PRIV_INCLUDE_DIRS ${root}/core/src
  KCONFIG ${CMAKE_CURRENT_LIST_DIR}/Kconfig)
target_compile_features(${COMPONENT_LIB} PUBLIC cxx_std_17)
if(CONFIG_INKCELL_LVGL)
  idf_component_optional_requires(PUBLIC lvgl lvgl__lvgl)
endif()
target_compile_options(${COMPONENT_LIB} PRIVATE -ffunction-sections -fdata-sections)

# After idf_component_register() of a component that has REQUIRES inkcell:
#   inkcell_add_font(${COMPONENT_LIB} FONT DejaVuSans.ttf NAME dejavu_sans)
include(${root}/fonts_gen/cmake/InkcellFonts.cmake)
