"""Compares what was measured with what another commit measures.

The other commit's own bench runs, on the fonts that this generator makes: what
differs is the code of the device.
"""
import hashlib
import json
import subprocess
import sys

from peers import say

# What is compared; all else tells results apart.
MEASURES = ("instructions_mean", "instructions_max", "instructions", "stack",
            "code", "workspace", "ram", "glyphs", "area", "text", "matrix",
            "all_formats", "libraries", "heap", "static_ram", "font_bytes")
# How much more a commit may cost before its body must say so: a share of what it
# was, and bytes.
LIMITS = {"instructions": (0.05, 0), "code": (0, 256), "stack": (0, 32),
          "memory": (0, 0)}
# The limits' names of measures.
LIMITED = {"instructions_mean": "instructions",
           "instructions_max": "instructions", "instructions": "instructions",
           "stack": "stack", "workspace": "memory", "ram": "memory",
           "heap": "memory", "static_ram": "memory"}
LIMITED.update(dict.fromkeys(
    ("code", "glyphs", "area", "text", "matrix", "all_formats", "libraries"),
    "code"))
# Those that follow from others.
LEFT_OUT = ("over_plain", "over_upright", "over_bitmap", "per_pixel")


def export(root, revision, folder):
    """The sources of a commit, below `folder`."""
    found = subprocess.run(
        ["git", "-C", str(root), "rev-parse", "--verify", "--quiet",
         revision + "^{commit}"], stdout=subprocess.PIPE, text=True,
        check=False)
    if found.returncode != 0:
        sys.exit(f"bench: --against {revision}: there is no such commit here; "
                 "a shallow clone may lack it (git fetch --unshallow)")
    commit = found.stdout.strip()
    source = folder / commit[:12] / "source"
    if not source.exists():
        say(f"exporting {commit[:12]}")
        source.mkdir(parents=True)
        archive = subprocess.run(["git", "-C", str(root), "archive", commit],
                                 stdout=subprocess.PIPE, check=True).stdout
        subprocess.run(["tar", "-x", "-C", str(source)], input=archive,
                       check=True)
    return source


def measure(root, revision, build, options, fontgen):
    """The lines that the other commit's bench prints.

    `fontgen` is None where all fonts are made already.
    """
    source = export(root, revision, build / "against")
    # Fonts are made anew where the generator changed.
    key = "fonts"
    if fontgen:
        key = hashlib.sha256(fontgen.read_bytes()).hexdigest()[:12]
        options = [*options, "--fontgen", str(fontgen)]
    command = [sys.executable, "-B", str(source / "tests/bench/bench.py"),
               *options, "--build", str(source.parent / f"build-{key}")]
    say(f"measuring {revision}")
    done = subprocess.run(command, stdout=subprocess.PIPE,
                          stderr=subprocess.PIPE, text=True, check=False)
    if done.returncode != 0:
        sys.exit(f"{done.stderr[-2000:]}\nbench: the bench of {revision} "
                 "failed; perhaps it reads another format, or has no such "
                 "option")
    return [json.loads(line) for line in done.stdout.splitlines()]


def keyed(lines):
    """Measures of each line, by all that tells lines apart."""
    return {
        tuple((name, value) for name, value in line.items()
              if name not in MEASURES and name not in LEFT_OUT):
        {name: line[name] for name in MEASURES if name in line}
        for line in lines}


def is_over(measure_name, was, value):
    """Whether a measure grew by more than a commit may leave unsaid."""
    limit = LIMITS.get(LIMITED.get(measure_name))
    return limit is not None and value > was * (1 + limit[0]) + limit[1]


def compare(before, after):
    """Prints what differs; returns the names of limits that are exceeded."""
    old, new = keyed(before), keyed(after)
    exceeded = set()
    changes = {}
    for key, measures in new.items():
        name = " ".join(str(value) for _, value in key)
        for measure_name, value in measures.items():
            was = old.get(key, {}).get(measure_name)
            if was is None:
                continue
            changes.setdefault(measure_name, []).append(
                value / was if was else 1)
            if was != value:
                share = f" {100 * (value / was - 1):+.1f} %" if was else ""
                over = is_over(measure_name, was, value)
                if over:
                    exceeded.add(LIMITED[measure_name])
                print(f"{name}: {measure_name} {was} -> {value}{share}"
                      f"{' OVER ITS LIMIT' if over else ''}")
    for measure_name, ratios in changes.items():
        ratios.sort()
        print(f"{measure_name}: {len(ratios)} compared, median "
              f"{100 * (ratios[len(ratios) // 2] - 1):+.1f} %, "
              f"{100 * (ratios[0] - 1):+.1f} % to "
              f"{100 * (ratios[-1] - 1):+.1f} %")
    alone = len(new.keys() - old.keys()) + len(old.keys() - new.keys())
    if alone:
        print(f"{alone} results are in one of the two only")
    if not changes:
        sys.exit("bench: nothing could be compared")
    return exceeded


def check_limits(root, revision, exceeded):
    """Fails where the commits since `revision` do not name what costs more."""
    bodies = subprocess.run(
        ["git", "-C", str(root), "log", "--format=%B", f"{revision}..HEAD"],
        stdout=subprocess.PIPE, text=True, check=True).stdout
    named = {name.strip() for line in bodies.splitlines()
             if line.startswith("Costs:") for name in line[6:].split(",")}
    unknown = named - LIMITS.keys()
    if unknown:
        sys.exit(f"bench: a commit has the line `Costs: {min(unknown)}`; "
                 f"there is {', '.join(LIMITS)}")
    unsaid = sorted(exceeded - named)
    if unsaid:
        limits = ", ".join(
            f"{name} +{100 * share:.0f} %" if share else f"{name} +{size} bytes"
            for name, (share, size) in LIMITS.items())
        sys.exit(f"bench: costs more than {revision}: {', '.join(unsaid)} "
                 f"(limits: {limits}). Make it cheaper, or say why in the "
                 f"commit's body and end it with `Costs: {', '.join(unsaid)}`")
    print(f"bench: within the limits, or named: {', '.join(sorted(named))}"
          if named else "bench: within the limits")
