"""Converts the faces of packages.txt at the defaults and measures each font.

A Latin face is scalable, has the space and the 52 letters of ASCII (some old
types have no digits), and is no font of symbols: neither its character map says
so nor its name (barcode, dingbat, emoji, icon, symbol). It is asked for the 95
characters of ASCII.

Prints one row a face, separated by tabs, and keeps the rows in --out. A face that
the same build has measured is not measured again. Columns:

  face      file and number of the face
  name      family and style
  accepted  yes, or no: the program refused it or took longer than --limit
  promised  bound of all pixels with the filter area at any position [1/255]
  missed    glyphs whose bound is beyond 16/255; a warning names them
  area      worst with the filter area at --positions random 1/64 px positions a
            glyph and size, from 8 to 64 px, none of which the generator tries
            [1/255]
  distance  the same with the filter text
  bytes     of the font
  seconds   of user CPU time to make it
  why       the first line of the error
"""
import argparse
import fnmatch
import hashlib
import json
import os
import pathlib
import re
import statistics
import string
import subprocess
import sys
import tempfile
import time

ROOT = pathlib.Path(__file__).resolve().parents[2]
DOCUMENT = ROOT / "docs/BENCHMARKS.md"
COLUMNS = ("build", "face", "name", "accepted", "promised", "missed", "area",
           "distance", "bytes", "seconds", "why")
ENDINGS = (".ttf", ".otf", ".ttc", ".otc")
SYMBOLS = re.compile("barcode|dingbat|emoji|icon|symbol", re.IGNORECASE)
TOLERANCE = 16
COARSE = 24


def arguments():
    parser = argparse.ArgumentParser(
        prog="corpus.sh", description=__doc__,
        formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--faces", default="*", metavar="GLOB",
                        help="only faces whose file or name is like this")
    parser.add_argument("--positions", type=int, default=8,
                        help="positions a glyph and size [8]")
    parser.add_argument("--seed", type=int, default=1,
                        help="which positions [1]")
    parser.add_argument("--limit", type=int, default=600,
                        help="seconds a face may take [600]")
    parser.add_argument("--out", type=pathlib.Path,
                        default=ROOT / "build" / "corpus.tsv",
                        help="the rows [build/corpus.tsv]")
    parser.add_argument("--build", type=pathlib.Path,
                        default=ROOT / "build" / "host",
                        help="where the programs are [build/host]")
    parser.add_argument("--write-docs", action="store_true",
                        help="write the chapter of docs/BENCHMARKS.md")
    parser.add_argument("--list", action="store_true",
                        help="print the faces and measure nothing")
    return parser.parse_args()


def files_of(line):
    """The font files of a line of packages.txt."""
    package, pattern = (line.split(None, 1) + ["*"])[:2]
    done = subprocess.run(["dpkg", "-L", package], text=True,
                          capture_output=True, check=False)
    if done.returncode != 0:
        sys.exit(f"corpus: {package} is not installed; start corpus.sh")
    return [pathlib.Path(name) for name in done.stdout.splitlines()
            if name.lower().endswith(ENDINGS) and
            fnmatch.fnmatch(pathlib.Path(name).name, pattern.strip())]


def has_letters(charset):
    """fc-query writes '20-7e a0-ff'."""
    needed = {ord(c) for c in " " + string.ascii_letters}
    for part in charset.split():
        first, _, last = part.partition("-")
        needed -= set(range(int(first, 16), int(last or first, 16) + 1))
    return not needed


def latin_faces(file):
    """Number and name of each Latin face of a file."""
    form = "%{index}\t%{family[0]} %{style[0]}\t%{scalable}\t%{symbol}\t" \
           "%{charset}\n"
    text = subprocess.run(["fc-query", "-f", form, file], text=True,
                          capture_output=True, check=False).stdout
    seen = set()
    for line in text.splitlines():
        index, name, scalable, symbol, charset = line.split("\t")
        number = int(index) & 0xffff  # above: the instance of a variable font
        if number not in seen and scalable == "True" and symbol != "True" and \
                not SYMBOLS.search(name) and has_letters(charset):
            seen.add(number)
            yield number, name


def all_faces(pattern):
    faces = {}
    lines = (ROOT / "tests" / "fonts" / "packages.txt").read_text()
    for line in lines.splitlines():
        line = line.split("#")[0].strip()
        for file in files_of(line) if line else ():
            for number, name in latin_faces(file):
                if fnmatch.fnmatch(file.name, pattern) or \
                        fnmatch.fnmatch(name, pattern):
                    # One face may be in several forms: TTF before OTF.
                    faces.setdefault(f"{file.name}:{number}",
                                     (file, number, name))
    return dict(sorted(faces.items()))


def run(command, limit):
    """Exit code, errors and seconds of user CPU time; None: out of time."""
    with tempfile.TemporaryFile("w+") as errors:
        before = os.times().children_user
        try:
            code = subprocess.run(command, stdout=subprocess.DEVNULL,
                                  stderr=errors, timeout=limit,
                                  check=False).returncode
        except subprocess.TimeoutExpired:
            code = None
        errors.seek(0)
        return code, errors.read(), os.times().children_user - before


def first_error(text):
    for line in text.splitlines():
        if line.startswith("error: "):
            return line[len("error: "):].replace("\t", " ")
    return "ended without an error message"


def measure(options, file, number, name):
    generator = options.build / "fonts_gen" / "inkcell-fontgen"
    judge = options.build / "host_tools" / "inkcell-accuracy"
    row = dict.fromkeys(COLUMNS, "")
    row.update(face=f"{file.name}:{number}", name=name, accepted="no")
    with tempfile.TemporaryDirectory() as folder:
        font = pathlib.Path(folder) / "font.bin"
        report = pathlib.Path(folder) / "report.json"
        code, errors, seconds = run(
            [generator, "--font", file, "--face", str(number), "--out", font,
             "--report", report, "--quiet"], options.limit)
        row["seconds"] = f"{seconds:.2f}"
        if code != 0:
            row["why"] = (f"more than {options.limit} s" if code is None
                          else first_error(errors))
            return row
        made = json.loads(report.read_text())
        row.update(accepted="yes", promised=f"{made['error']['max']:.1f}",
                   missed=str(len(made["missed"])),
                   bytes=str(font.stat().st_size))
        code, errors, _ = run(
            [judge, "--font", font, "--truth", file, "--face", str(number),
             "--sizes", "8-64", "--positions", str(options.positions),
             "--seed", str(options.seed), "--no-check", "--report", report],
            None)
        if code != 0:
            row["why"] = first_error(errors)
            return row
        rows = json.loads(report.read_text())["rows"]
        for column, name in (("area", "area"), ("distance", "text")):
            worst = max(size["max"] for size in rows if size["filter"] == name)
            row[column] = f"{worst:.1f}"
        return row


def build_of(options):
    """Changes with the programs and with what is asked of them."""
    total = hashlib.sha256(f"{options.positions} {options.seed}".encode())
    for name in ("fonts_gen/inkcell-fontgen", "host_tools/inkcell-accuracy"):
        program = options.build / name
        if not program.is_file():
            sys.exit(f"corpus: {program} is missing; start corpus.sh, or name "
                     "its build with --build")
        total.update(program.read_bytes())
    return total.hexdigest()[:12]


def known_rows(file, build):
    if not file.is_file():
        return {}
    lines = [line.split("\t") for line in file.read_text().splitlines()]
    rows = [dict(zip(COLUMNS, line)) for line in lines
            if len(line) == len(COLUMNS)]
    return {row["face"]: row for row in rows if row["build"] == build}


def text_of(row):
    return "\t".join(row[column] for column in COLUMNS) + "\n"


def write(file, rows):
    """Whole or not at all: a row is never cut by an interruption."""
    file.parent.mkdir(parents=True, exist_ok=True)
    beside = file.with_suffix(".new")
    beside.write_text("\t".join(COLUMNS) + "\n" +
                      "".join(map(text_of, rows.values())))
    beside.replace(file)


def share(values, limit):
    return f"{100 * sum(value <= limit for value in values) / len(values):.1f} %"


def summary(rows):
    """Figures by name; a refused face misses all limits."""
    held = [row for row in rows if row["missed"] == "0"]
    areas = [float(row["area"] or "inf") for row in held]
    distances = [float(row["distance"] or "inf") for row in rows]
    sizes = [int(row["bytes"]) for row in rows if row["bytes"]]
    seconds = [float(row["seconds"]) for row in rows]
    return {"faces": len(rows),
            "refused": sum(row["accepted"] != "yes" for row in rows),
            "without a warning": f"{100 * len(held) / len(rows):.1f} %",
            f"of them area <= {TOLERANCE}/255":
                share(areas, TOLERANCE) if areas else "-",
            "area, worst": f"{max(areas, default=0):.1f}",
            f"distance <= {TOLERANCE}/255": share(distances, TOLERANCE),
            f"<= {COARSE}/255": share(distances, COARSE),
            "worst": f"{max(distances):.1f}",
            "bytes, mean": f"{statistics.mean(sizes or [0]):.0f}",
            "median": f"{statistics.median(sizes or [0]):.0f}",
            "s, median": f"{statistics.median(seconds):.1f}",
            "s, worst": f"{max(seconds):.1f}"}


def write_docs(rows, positions):
    figures = summary(rows)
    chapter = (
        "## Faces\n\nLatin faces of Debian at the defaults, by `sh "
        "tests/fonts/corpus.sh --write-docs`, whose `--help`\nsays which: 95 "
        "characters, 8 to 64 px, 16/255. Errors, in 1/255, are at "
        f"{positions} random positions a glyph and\nsize, in 1/64 px, that the "
        "generator does not try: with the default filter (area) of the\nfaces "
        "that are made without a warning, with the filter `text` (distance) of "
        "all. Seconds are\nof user CPU time.\n\n" +
        "".join(f"| {' | '.join(map(str, cells))} |\n" for cells in
                (figures, ["---:"] * len(figures), figures.values())) + "\n")
    text = DOCUMENT.read_text(encoding="utf-8")
    text = re.sub(r"^## Faces\n.*?\n(?=## |\Z)", "", text,
                  flags=re.DOTALL | re.MULTILINE)
    DOCUMENT.write_text(text.replace("## In LVGL\n", chapter +
                                     "## In LVGL\n"), encoding="utf-8")


def main():
    options = arguments()
    faces = all_faces(options.faces)
    if not faces:
        sys.exit(f"corpus: no face is like '{options.faces}'; --list shows all")
    if options.list:
        for face, (_, _, name) in faces.items():
            print(f"{face}\t{name}")
        return 0
    build = build_of(options)
    rows = known_rows(options.out, build)
    left = [face for face in faces if face not in rows]
    print("\t".join(COLUMNS))
    for face in faces:
        if face in rows:
            sys.stdout.write(text_of(rows[face]))
    begin = time.monotonic()
    for i, face in enumerate(left):
        spent = time.monotonic() - begin
        until = f", {spent / i * (len(left) - i) / 60:.0f} min left" if i else ""
        print(f"{i} of {len(left)} faces{until}: {face}", file=sys.stderr,
              flush=True)
        rows[face] = measure(options, *faces[face])
        rows[face]["build"] = build
        write(options.out, rows)
        sys.stdout.write(text_of(rows[face]))
        sys.stdout.flush()
    chosen = [rows[face] for face in faces]
    print("# " + "; ".join(f"{name}: {value}"
                           for name, value in summary(chosen).items()))
    if options.write_docs:
        write_docs(chosen, options.positions)
    return 0


if __name__ == "__main__":
    sys.exit(main())
