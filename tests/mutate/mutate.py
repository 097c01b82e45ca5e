"""Mutates sources of the core, and counts what the unit tests notice.

Each mutant is one source with one mistake, compiled and linked with the unit
tests of its row in TESTS, from the quickest on; it is killed by the first that
fails or takes too long. A mutant whose object is that of the source is no
mistake, and one that does not compile is none either: neither counts.
"""
import argparse
import concurrent.futures
import hashlib
import os
import pathlib
import random
import shutil
import subprocess
import sys
import tempfile
import threading
import time

import operators

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parents[1]
UNIT = ROOT / "tests/unit"
COMPILER = [*filter(None, [os.environ.get("CMAKE_CXX_COMPILER_LAUNCHER")]),
            "g++", "-std=c++17", "-O1", "-DINKCELL_ASSERTIONS=1",
            "-DINKCELL_BOARD_FIRMWARE=0", f"-I{ROOT}/core/include",
            f"-I{ROOT}/core/src", f"-I{ROOT}/core/field/include",
            f"-I{ROOT}/core/layout/include",
            f"-I{UNIT}", "-Wall", "-Wextra", "-Werror"]
# For each source the unit tests that should notice, the quickest first.
TESTS = {
    "core/src/base/bit_table.cpp": ("bit_table", "font"),
    "core/src/text/text.cpp": ("text", "layout"),
    "core/src/text/painter.cpp": ("painter", "text"),
    "core/src/font/code_points.cpp": ("font_tables", "font"),
    "core/src/font/font.cpp": ("font", "font_limits", "font_tables"),
    "core/src/font/grid_hints.cpp": ("grid_hints", "fit"),
    "core/src/place/style.cpp": ("style", "affine", "render"),
    "core/src/fit/fit.cpp": ("fit", "outline_draw"),
    "core/field/src/cell_values.cpp": ("field", "field_point"),
    "core/field/src/field_rows.cpp": ("render", "affine"),
    "core/field/src/field_sampler.cpp": ("field", "field_point"),
    "core/src/outlines/outline_glyph.cpp": ("outline_reader", "outline_draw"),
    "core/src/rows/area_painter.cpp": ("outline_draw", "outline_errors"),
    "core/src/rows/wide_painter.cpp": ("outline_draw", "outline_errors"),
    "core/src/rows/draw_bands.cpp": ("outline_draw", "outline_styles"),
    "core/src/rows/edge_rows.cpp": ("outline_draw", "outline_errors"),
    "core/src/rows/emit_band.cpp": ("outline_draw", "outline_styles",
                                    "outline_errors"),
    "core/src/effects/lcd.cpp": ("outline_styles", "lcd"),
    "core/src/effects/stroke.cpp": ("effects", "outline_styles"),
}
# A test may take this many times what it takes for the source, and a second.
PATIENCE = 10


def parse_arguments():
    parser = argparse.ArgumentParser(
        prog="tests/mutate.sh", description=__doc__,
        formatter_class=argparse.RawDescriptionHelpFormatter)
    add = parser.add_argument
    add("--file", action="append", choices=list(TESTS), metavar="FILE",
        help="a source to mutate, more than once for several (default: all)")
    add("--limit", type=int, default=20, metavar="N",
        help="mutants of a source, drawn by lot (default: %(default)s)")
    add("--seed", type=int, default=1, help="of the lot (default: 1)")
    add("--jobs", type=int, default=os.cpu_count(), help="at a time")
    add("--list", action="store_true", help="tell the sources and their tests")
    return parser.parse_args()


def say(text):
    print(text, file=sys.stderr, flush=True)


def compile_source(source, target):
    """What the compiler said, if it failed."""
    done = subprocess.run([*COMPILER, "-c", str(source), "-o", str(target)],
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                          text=True, check=False)
    return done.stdout if done.returncode != 0 else None


class Workshop:
    """Objects of the core and of the tests, and how long each test takes."""

    def __init__(self, folder, tests, jobs):
        self.folder = folder
        self.objects = {}
        wanted = sorted([*(ROOT / "core/src").rglob("*.cpp"),
                         *(ROOT / "core/field/src").glob("*.cpp"),
                         *(ROOT / "core/layout/src").glob("*.cpp")])
        wanted += [UNIT / f"{name}.cpp"
                   for name in ("check", "check_main", "font_builder")]
        for test in tests:
            wanted += [UNIT / f"test_{test}.cpp"]
        with concurrent.futures.ThreadPoolExecutor(jobs) as pool:
            for done, _ in enumerate(pool.map(self.compile, wanted), 1):
                if done % 10 == 0 or done == len(wanted):
                    say(f"compiled {done} of {len(wanted)}")
        self.library = folder / "core.a"
        self.library.unlink(missing_ok=True)
        subprocess.run(
            ["ar", "rc", str(self.library),
             *(str(self.objects[path]) for path in wanted
               if path.is_relative_to(ROOT / "core"))], check=True)
        self.seconds = {}
        for test in tests:
            program = folder / f"unit_{test}"
            self.link(test, None, program)
            begun = time.monotonic()
            if subprocess.run([str(program)], stdout=subprocess.DEVNULL,
                              check=False).returncode != 0:
                sys.exit(f"mutate: unit.{test} fails without a mutant")
            self.seconds[test] = time.monotonic() - begun

    def compile(self, source):
        target = self.folder / (
            str(source.relative_to(ROOT)).replace("/", "-") + ".o")
        problem = compile_source(source, target)
        if problem:
            sys.exit(f"mutate: {source} does not compile:\n{problem[-2000:]}")
        self.objects[source] = target

    def link(self, test, mutant, program):
        """The mutant's object comes before the library, so it is taken."""
        parts = [UNIT / f"test_{test}.cpp"]
        parts += [UNIT / f"{name}.cpp"
                  for name in ("check", "check_main", "font_builder")]
        subprocess.run(
            ["g++", "-o", str(program),
             *(str(self.objects[part]) for part in parts),
             *([str(mutant)] if mutant else []), str(self.library)],
            check=True)

    def passes(self, test, mutant, program):
        self.link(test, mutant, program)
        try:
            return subprocess.run(
                [str(program)], stdout=subprocess.DEVNULL,
                stderr=subprocess.DEVNULL, check=False,
                timeout=1 + PATIENCE * self.seconds[test]).returncode == 0
        except subprocess.TimeoutExpired:
            return False

    def judge(self, path, number, line):
        """killed, survived, same (object) or invalid."""
        source = ROOT / path
        lines = source.read_text().splitlines(keepends=True)
        lines[number - 1] = line + "\n"
        with tempfile.TemporaryDirectory(dir=self.folder) as name:
            folder = pathlib.Path(name)
            # The same name, so that objects of the same code are the same.
            mutated = folder / source.name
            mutated.write_text("".join(lines))
            mutant = folder / "mutant.o"
            if compile_source(mutated, mutant):
                return "invalid"
            if (code_hash(mutant, folder) ==
                    code_hash(self.objects[source], folder)):
                return "same"
            for test in TESTS[path]:
                if not self.passes(test, mutant, folder / "program"):
                    return "killed"
        return "survived"


def code_hash(path, folder):
    """Of the sections, without symbols of the file's name."""
    stripped = folder / "stripped.o"
    subprocess.run(["objcopy", "--strip-unneeded", "--remove-section=.comment",
                    str(path), str(stripped)], check=True)
    dump = subprocess.run(["objdump", "-s", "-r", str(stripped)],
                          stdout=subprocess.PIPE, check=True).stdout
    return hashlib.sha256(dump.split(b"\n", 3)[3]).hexdigest()


def draw_lots(arguments):
    """(path, number, kind, line) of the mutants that are tried."""
    chosen = []
    for path in arguments.file or TESTS:
        found = list(operators.mutants_of((ROOT / path).read_text()))
        lot = random.Random(f"{arguments.seed} {path}")
        lot.shuffle(found)
        chosen += [(path, *mutant) for mutant in found[:arguments.limit]]
    return chosen


def report(outcomes):
    print(f"{'source':44} killed survived  same invalid  score")
    rows = {}
    for (path, *_), verdict in outcomes:
        rows.setdefault(path, []).append(verdict)
    rows["all"] = [verdict for _, verdict in outcomes]
    for path, verdicts in rows.items():
        killed, survived, same, invalid = (
            verdicts.count(verdict)
            for verdict in ("killed", "survived", "same", "invalid"))
        score = (f"{100 * killed / (killed + survived):5.0f}%"
                 if killed + survived else "     -")
        print(f"{path:44} {killed:6} {survived:8} {same:5} {invalid:7} {score}")
    for (path, number, kind, line), verdict in outcomes:
        if verdict == "survived":
            was = (ROOT / path).read_text().splitlines()[number - 1].strip()
            print(f"\n{path}:{number}: {kind}\n  - {was}\n  + {line.strip()}")


def main():
    arguments = parse_arguments()
    if arguments.list:
        for path, tests in TESTS.items():
            print(f"{path}: {', '.join(tests)}")
        return
    for tool in ("g++", "ar", "objcopy", "objdump"):
        if shutil.which(tool) is None:
            sys.exit(f"mutate: {tool} is missing")
    folder = ROOT / "build/mutate"
    folder.mkdir(parents=True, exist_ok=True)
    mutants = draw_lots(arguments)
    paths = dict.fromkeys(mutant[0] for mutant in mutants)
    tests = dict.fromkeys(test for path in paths for test in TESTS[path])
    workshop = Workshop(folder, list(tests), arguments.jobs)
    killed, done, lock = 0, 0, threading.Lock()

    def judge(mutant):
        nonlocal killed, done
        path, number, _, line = mutant
        verdict = workshop.judge(path, number, line)
        with lock:
            done += 1
            killed += verdict == "killed"
            say(f"{done} of {len(mutants)}, {killed} killed: "
                f"{path}:{number} {verdict}")
        return mutant, verdict

    with concurrent.futures.ThreadPoolExecutor(arguments.jobs) as pool:
        outcomes = list(pool.map(judge, mutants))
    report(outcomes)


main()
