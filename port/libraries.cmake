# Sources and include folders of what a configuration by Kconfig asks for, in
# inkcell_sources and inkcell_includes: the core, the adapters of pixel formats
# and displays, and the libraries of libraries.kconfig.
get_filename_component(root ${CMAKE_CURRENT_LIST_DIR}/.. ABSOLUTE)
set(parts core port/pixel port/display)
foreach(part core/cache core/field core/layout core/motion core/simulation
    core/stored port/c)
  get_filename_component(name ${part} NAME)
  string(TOUPPER ${name} name)
  if(CONFIG_INKCELL_${name})
    list(APPEND parts ${part})
  endif()
endforeach()
set(inkcell_sources)
set(inkcell_includes)
foreach(part IN LISTS parts)
  file(GLOB_RECURSE found ${root}/${part}/src/*.cpp)
  list(APPEND inkcell_sources ${found})
  list(APPEND inkcell_includes ${root}/${part}/include)
endforeach()
