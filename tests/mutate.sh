#!/bin/sh
# Would the unit tests notice a mistake? Changes one operator or number of the
# core at a time, and runs the tests that should fail.
#
#   sh tests/mutate.sh [--file core/src/FILE.cpp]... [--limit N] [--seed N]
#       [--jobs N] [--list] [--help]
#
# Prints a table of the mistakes that no test noticed, and the score. By hand
# only: a mutant takes seconds, and tests/run.sh must not.
exec python3 -B "$(dirname "$0")/mutate/mutate.py" "$@"
