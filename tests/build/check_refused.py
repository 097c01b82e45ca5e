"""Compiles the files in refused/: good as they are, refused with REFUSED set.

Each says in a line `// refused: PATTERN` what the compiler must complain about,
so that it is refused for the reason that it is there for.

Usage: check_refused.py
"""
import re

from toolchains import (COMPILERS, INCLUDES, ROOT, WARNINGS, finish,
                        in_parallel, require, run)

FILES = ROOT / "tests/build/refused"


def check_file(machine, path):
    command, _ = COMPILERS[machine]
    base = [*command, "-std=c++17", "-ffreestanding", *WARNINGS, *INCLUDES,
            "-fsyntax-only", path]
    good = run([*base, "-DREFUSED=0"])
    if good.returncode != 0:
        return f"{path.name} ({machine}): the good form:\n{good.stdout}"
    bad = run([*base, "-DREFUSED=1"])
    if bad.returncode == 0:
        return f"{path.name} ({machine}): compiles, but must not"
    pattern = re.search(r"^// refused: (.+)$", path.read_text(), re.M).group(1)
    if not re.search(pattern, bad.stdout):
        return f"{path.name} ({machine}): another reason:\n{bad.stdout}"
    return None


def main():
    machines = ["Cortex-M0", "RV32", "host", "host clang"]
    require([COMPILERS[machine][0][0] for machine in machines])
    jobs = [(machine, path) for machine in machines
            for path in sorted(FILES.glob("*.cpp"))]
    problems = [found for found in in_parallel(check_file, jobs) if found]
    finish(len(jobs) - len(problems), problems)


main()
