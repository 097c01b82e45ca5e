# Sources and include folders of what a configuration by Kconfig asks for, in
# inkcell_sources and inkcell_includes: the core, the adapters of pixel formats
# and displays, and the libraries of libraries.kconfig.
get_filename_component(root ${CMAKE_CURRENT_LIST_DIR}/.. ABSOLUTE)
set(parts ${root}/core ${root}/port/pixel ${root}/port/display)
foreach(name cache field layout motion shaping simulation stored strike truetype)
  string(TOUPPER ${name} option)
  if(CONFIG_INKCELL_${option})
    list(APPEND parts ${root}/core/${name})
  endif()
endforeach()
# The interface for C is made when CMake runs, which it does again after a change of
# the tables.
if(CONFIG_INKCELL_C)
  find_package(Python3 3.9 REQUIRED COMPONENTS Interpreter)
  set(made ${CMAKE_CURRENT_BINARY_DIR}/port/c)
  execute_process(RESULT_VARIABLE failed
    COMMAND ${Python3_EXECUTABLE} -B ${root}/port/c/make_api.py ${made})
  if(failed)
    message(FATAL_ERROR "${root}/port/c/make_api.py did not make ${made}")
  endif()
  file(GLOB tables ${root}/port/c/*.* ${root}/port/display/c_api.txt)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${tables})
  list(APPEND parts ${made})
endif()
set(inkcell_sources)
set(inkcell_includes)
foreach(part IN LISTS parts)
  file(GLOB_RECURSE found ${part}/src/*.cpp)
  list(APPEND inkcell_sources ${found})
  list(APPEND inkcell_includes ${part}/include)
endforeach()
