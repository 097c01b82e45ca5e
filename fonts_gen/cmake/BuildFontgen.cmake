# Builds inkcell-fontgen for the machine that runs this script:
#
#   cmake -DSOURCE=<fonts_gen> -DFOLDER=<build folder> [-DGENERATOR=<name>]
#         [-DMAKE_PROGRAM=<path>] [-DCXX=<compiler>] -P BuildFontgen.cmake
#
# Nothing of a cross build may reach it: its toolchain file, compilers and flags
# can come through the environment. So can the limit of its jobs: make would take
# one core, because only its own calls of make share theirs.
foreach(name CC CXX CFLAGS CXXFLAGS CPPFLAGS LDFLAGS CMAKE_TOOLCHAIN_FILE
        CMAKE_GENERATOR CPATH CPLUS_INCLUDE_PATH MAKEFLAGS MFLAGS)
  unset(ENV{${name}})
endforeach()

# Several build trees may ask for the same folder at once.
file(MAKE_DIRECTORY "${FOLDER}")
file(LOCK "${FOLDER}" DIRECTORY GUARD PROCESS TIMEOUT 1800)

# Checkouts and compilers may take turns in it: `configured` says whose it is.
set(configured "${SOURCE}\n${CXX}\n")
set(before "")
if(EXISTS "${FOLDER}/configured")
  file(READ "${FOLDER}/configured" before)
endif()
if(NOT "${before}" STREQUAL "${configured}")
  file(REMOVE "${FOLDER}/configured")
  set(options)
  if(GENERATOR)
    list(APPEND options -G "${GENERATOR}")
  endif()
  if(MAKE_PROGRAM)
    list(APPEND options "-DCMAKE_MAKE_PROGRAM=${MAKE_PROGRAM}")
  endif()
  if(CXX)
    list(APPEND options "-DCMAKE_CXX_COMPILER=${CXX}")
  endif()
  execute_process(
    COMMAND "${CMAKE_COMMAND}" --fresh -S "${SOURCE}" -B "${FOLDER}" ${options}
      -DCMAKE_BUILD_TYPE=Release "-DCMAKE_CXX_FLAGS_RELEASE=-O2 -DNDEBUG"
    OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
  file(WRITE "${FOLDER}/configured" "${configured}")
endif()
# The first time takes a while, and shows how far it is; later there is seldom
# anything to do.
set(quiet OUTPUT_VARIABLE output ERROR_VARIABLE output)
if(NOT EXISTS "${FOLDER}/inkcell-fontgen${CMAKE_HOST_EXECUTABLE_SUFFIX}")
  set(quiet)
  set(output "see above")
endif()
cmake_host_system_information(RESULT cores QUERY NUMBER_OF_LOGICAL_CORES)
execute_process(
  COMMAND "${CMAKE_COMMAND}" --build "${FOLDER}" --config Release
    --target inkcell-fontgen --parallel ${cores}
  ${quiet} RESULT_VARIABLE result)
if(NOT result EQUAL 0)
  message(FATAL_ERROR "inkcell-fontgen cannot be built:\n${output}")
endif()
