"""Compares what was measured with what another commit measures.

The other commit's own bench runs, on the fonts that this generator makes: what
differs is the code of the device.
"""
import hashlib
import json
import subprocess
import sys

# What is compared; all else tells results apart.
MEASURES = ("instructions_mean", "instructions_max", "instructions", "stack",
            "code", "workspace", "ram", "glyphs", "area", "text", "matrix",
            "all_formats", "libraries", "heap", "static_ram", "font_bytes")
# Those that follow from others.
LEFT_OUT = ("over_plain", "over_upright", "over_bitmap", "per_pixel")


def say(text):
    print(text, file=sys.stderr, flush=True)


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
    """The lines that the other commit's bench prints."""
    source = export(root, revision, build / "against")
    # Fonts are made anew where the generator changed.
    key = hashlib.sha256(fontgen.read_bytes()).hexdigest()[:12]
    command = [sys.executable, "-B", str(source / "tests/bench/bench.py"),
               *options, "--fontgen", str(fontgen),
               "--build", str(source.parent / f"build-{key}")]
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


def compare(before, after):
    """Prints what differs; returns how many measures do."""
    old, new = keyed(before), keyed(after)
    differing = 0
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
                differing += 1
                share = f"{100 * (value / was - 1):+.1f} %" if was else ""
                print(f"{name}: {measure_name} {was} -> {value} {share}")
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
    return differing
