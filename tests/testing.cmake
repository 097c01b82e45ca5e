# What the folders of tests have in common. The targets that they test get the
# warnings, too, so a project includes this before it adds any.
enable_testing()

# The project builds without a warning where it is tested; its users choose their
# own, and have compilers that it does not know.
set(INKCELL_WARNINGS -Wall -Wextra -Wpedantic -Wconversion -Wsign-conversion
  -Wshadow -Wold-style-cast -Wundef -Werror)

# Sources with GTest compile in two thirds of the time with few optimisations;
# what they test has all.
set(INKCELL_GTEST_OPTIONS ${INKCELL_WARNINGS} $<$<CONFIG:Release>:-O1>)

# inkcell_test_seconds(<seconds> <test>...)
#
# Tests that take more than 20 s of processor time on an idle machine say how
# much, and the longest start first. A limit ends what hangs, and nothing else:
# it is 20 times as long, because 20 busy processes on two cores leave a test an
# eleventh. Others have that of 20 s (tests/run.sh). Sanitizers and an emulated
# processor take longer.
function(inkcell_test_seconds seconds)
  set(factor 1)
  if(CMAKE_CXX_FLAGS MATCHES "-fsanitize")
    set(factor 5)
  elseif(CMAKE_CROSSCOMPILING AND NOT INKCELL_BOARD)
    set(factor 10)
  endif()
  math(EXPR limit "20 * ${factor} * ${seconds}")
  set_tests_properties(${ARGN} PROPERTIES TIMEOUT ${limit} COST ${seconds})
endfunction()
