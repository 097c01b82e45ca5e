#!/bin/sh
# Clang-Tidy (.clang-tidy) and cppcheck over the core, the ports and the generator:
#
#   sh tests/lint.sh
#
# Reads build/alone, which `sh tests/run.sh --only alone` makes. A remark is mended,
# or told apart in its line, by `// NOLINT(check): why` or
# `// cppcheck-suppress id ; why`; kinds that are false everywhere are below. Exits
# with 0 if there is none.
set -eu
cd "$(dirname "$0")/.."
. host_tools/setup.sh
inkcell_setup packages clang-tidy cppcheck
if [ ! -f build/alone/compile_commands.json ]; then
  sh tests/run.sh --only alone
fi
code=0
run-clang-tidy -quiet -p build/alone '/(core|port|fonts_gen)/.*\.cpp$' \
  2>build/tests/clang-tidy.err || code=1
includes=$(ls -d core/include core/src core/*/include core/*/src \
  port/*/include build/alone/inkcell/port/c/include \
  fonts_gen/src fonts_gen/include 2>/dev/null | sed 's/^/-I/')
# Right shifts of negative numbers floor, as fixed.hpp asserts; products of 64 bits
# are taken for ones of 32. Members that are arrays, those of aggregates that are
# initialized by braces, and objects made in bytes count as left out.
false_kinds='shiftNegativeLHS shiftTooManyBits shiftTooManyBitsSigned uninitMemberVar
  uninitDerivedMemberVar uninitvar'
# shellcheck disable=SC2046,SC2086  # one option a word
cppcheck $(printf -- '--suppress=%s ' $false_kinds) --std=c++17 --language=c++ \
  --inline-suppr --quiet -j "$(nproc)" \
  --enable=warning,performance,portability --error-exitcode=1 \
  --template='{file}:{line}: {id}: {message}' $includes \
  core port/pixel/src port/display/src build/alone/inkcell/port/c/src port/lvgl/src \
  fonts_gen/src ||
  code=1
exit $code
