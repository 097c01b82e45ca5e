"""What a check finds wrong."""
import sys

PROBLEMS = []


def expect(condition, what):
    if not condition:
        PROBLEMS.append(what)


def finish():
    """Ends the program."""
    for problem in PROBLEMS:
        print(problem)
    sys.exit(1 if PROBLEMS else 0)
