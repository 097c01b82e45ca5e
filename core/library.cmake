# For who builds once, not for who edits, as where the generator is built alone.
set(default OFF)
if(CMAKE_PROJECT_NAME STREQUAL inkcell_fontgen)
  set(default ON)
endif()
option(INKCELL_JOIN_FOLDERS
  "Compile the sources of a folder as one, in half of the time" ${default})

# inkcell_join_folders(<target> [<folder>/<source>...]): does so with the sources
# of a target if INKCELL_JOIN_FOLDERS is on; but not with those whose path ends so,
# here and in targets that follow.
function(inkcell_join_folders target)
  if(NOT INKCELL_JOIN_FOLDERS)
    return()
  endif()
  get_target_property(sources ${target} SOURCES)
  get_target_property(folder ${target} SOURCE_DIR)
  set_property(GLOBAL APPEND PROPERTY inkcell_alone ${ARGN})
  get_property(alone GLOBAL PROPERTY inkcell_alone)
  list(FILTER sources INCLUDE REGEX "\\.cpp$")
  foreach(source ${sources})
    cmake_path(ABSOLUTE_PATH source BASE_DIRECTORY ${folder} NORMALIZE)
    cmake_path(GET source PARENT_PATH group)
    cmake_path(GET source FILENAME name)
    cmake_path(GET group FILENAME folder_name)
    if("${folder_name}/${name}" IN_LIST alone)
      continue()
    endif()
    cmake_path(RELATIVE_PATH group BASE_DIRECTORY ${CMAKE_SOURCE_DIR})
    string(MAKE_C_IDENTIFIER "${group}" group)
    set_property(SOURCE ${source} TARGET_DIRECTORY ${target}
      PROPERTY UNITY_GROUP "${group}")
  endforeach()
  set_target_properties(${target} PROPERTIES
    UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
  # Joined sources are included by their absolute paths: __FILE__ without them
  # makes objects the same in every clone, for a compiler cache.
  target_compile_options(${target} PRIVATE
    -fmacro-prefix-map=${CMAKE_SOURCE_DIR}/=)
endfunction()

# inkcell_library(<name> <source>... [USES <target>...]
#   [ALONE <folder>/<source>...]): inkcell_<name>, or inkcell::<name>, which runs
# on the device. Its headers are in include/; it sees those of core's rooms, too.
# ALONE: sources that inkcell_join_folders() leaves apart.
function(inkcell_library name)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "USES;ALONE")
  set(target inkcell_${name})
  add_library(${target} STATIC ${arg_UNPARSED_ARGUMENTS})
  add_library(inkcell::${name} ALIAS ${target})
  target_compile_features(${target} PUBLIC cxx_std_17)
  target_include_directories(${target}
    PUBLIC include PRIVATE ${CMAKE_CURRENT_FUNCTION_LIST_DIR}/src)
  target_link_libraries(${target} PUBLIC ${arg_USES})
  target_compile_options(${target} PRIVATE
    -ffreestanding -fno-exceptions -fno-rtti -fno-threadsafe-statics
    -ffunction-sections -fdata-sections ${INKCELL_WARNINGS})
  inkcell_join_folders(${target} ${arg_ALONE})
endfunction()
