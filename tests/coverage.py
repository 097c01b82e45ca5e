"""Sums up what tests/coverage.sh counted, and compares it with its limits.

A line or branch counts as run where one of the programs has run it.

Usage: coverage.py BUILD_FOLDER
"""
import json
import pathlib
import re
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[1]
LEAST = {"lines": 99, "branches": 95}  # [%]
CORE = re.compile(r"core/")  # of the sources


def run(*command):
    return subprocess.run([str(word) for word in command], check=True,
                          stdout=subprocess.PIPE, text=True).stdout


def programs(folder):
    """The tests' programs that were built."""
    return [path for path in folder.glob("tests/*/*")
            if path.is_file() and path.stat().st_mode & 0o111 and
            path.suffix == ""]


def main():
    folder = pathlib.Path(sys.argv[1]).resolve()
    merged = folder / "merged.profdata"
    run("llvm-profdata", "merge", "-sparse", *folder.glob("raw/*.profraw"),
        "-o", merged)
    first, *more = programs(folder)
    options = [first, *(f"-object={path}" for path in more),
               f"-instr-profile={merged}"]
    data = json.loads(run("llvm-cov", "export", *options,
                          "-skip-expansions"))["data"][0]
    files = {}
    for entry in data["files"]:
        name = str(pathlib.Path(entry["filename"]).relative_to(ROOT)) if (
            entry["filename"].startswith(str(ROOT))) else ""
        if CORE.match(name):
            files[name] = entry
    total = {}
    for what in LEAST:
        count = sum(entry["summary"][what]["count"] for entry in files.values())
        covered = sum(entry["summary"][what]["covered"]
                      for entry in files.values())
        total[what] = 100 * covered / count
    for name, entry in sorted(files.items()):
        never = sorted({segment[0] for segment in entry["segments"]
                        if segment[3] and segment[2] == 0})
        sides = sorted({branch[0] for branch in entry["branches"]
                        if 0 in branch[4:6]})
        if never or sides:
            print(f"{name}: never run: {never}; one side of branches: {sides}")
    print(", ".join(f"{share:.2f} % of {what} (at least {LEAST[what]})"
                    for what, share in total.items()))
    sys.exit(any(total[what] < LEAST[what] for what in LEAST))


main()
