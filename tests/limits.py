"""The hard limits of tests/limits.json, for the tests that measure.

A limit stands about 2 % above what was measured when it was set. A commit that
raises one says why.
"""
import json
import pathlib

LIMITS = json.loads(
    pathlib.Path(__file__).with_name("limits.json").read_text())


def exceeded(group, found):
    """Problems of what was measured, by name: figures above their limits,
    figures without a limit, and limits without a figure."""
    limits = LIMITS[group]
    problems = [f"tests/limits.json: {group}: {name} is measured or limited, "
                "not both" for name in sorted(limits.keys() ^ found.keys())]
    return problems + [
        f"{group}: {name}: {found[name]}, at most {limits[name]} "
        "(tests/limits.json)"
        for name in limits.keys() & found.keys() if found[name] > limits[name]]
