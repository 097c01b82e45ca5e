"""Checks that docs/BENCHMARKS.md describes the core as it is.

Usage: check_benchmarks.py
"""
import sys

from toolchains import COMPILERS, ROOT, finish, require

sys.path.insert(0, str(ROOT / "tests/bench"))
import fingerprint  # noqa: E402

require([COMPILERS[machine][0][0] for machine, _ in
         fingerprint.BUILDS.values()])
problem = fingerprint.problem()
finish(1 if problem is None else 0, [problem] if problem else [])
