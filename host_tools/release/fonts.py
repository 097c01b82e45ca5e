#!/usr/bin/env python3
"""Makes fonts that are ready to include, of the faces that fonts.json names:

    python3 host_tools/release/fonts.py FONTGEN FOLDER [--only FACE...]

FOLDER gets each set of characters of each face in three forms:

    hpp/fonts/inter_latin1.hpp      fonts::inter_latin1; needs the library's headers
    c/fonts/inter_latin1.c and .h   inter_latin1; needs nothing
    bin/inter_latin1.bin            what both hold

and licences/FACE.txt, specimens/FACE.png, and FONTS.md, the table of all. FOLDER/hpp
and FOLDER/c are for the compiler's -I: #include <fonts/inter_latin1.hpp>. All of it
is the same, byte by byte, if it is made again of the same packages.

Most faces come from Debian packages, which `inkcell_setup fonts` of
host_tools/setup.sh installs. A package `npm:NAME@VERSION` is fetched by npm.
"""
import argparse
import concurrent.futures
import json
import os
import pathlib
import subprocess
import sys
import tempfile
import textwrap

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "host_tools/common"))
from png_bytes import png  # noqa: E402

DEBIAN_FONTS = pathlib.Path("/usr/share/fonts")
DEBIAN_DOC = pathlib.Path("/usr/share/doc")
COMMON_LICENCES = pathlib.Path("/usr/share/common-licenses")
NPM = "npm:"
SPECIMEN_PX = (8, 10, 12, 14, 16, 20, 24, 32, 48)
MARGIN = 6  # around and between the lines of a specimen [px]
WHITE = 255

INTRODUCTION = """# Fonts ready to include

Made by `host_tools/release/fonts.py` for sizes from 8 to 64 px/em. Each set of a face is a font:
`hpp/fonts/FACE_SET.hpp` for C++, `c/fonts/FACE_SET.c` and `.h` for C, `bin/FACE_SET.bin` for
mapped memory. Ship `licences/FACE.txt` with a product that has the face.

A set's column has the bytes of the font and, where the face lacks characters of the set, how many
it has. Specimens are drawn at {sizes} px/em.
"""


class MakingError(Exception):
    """What went wrong, and the remedy."""


def call(*command, **options):
    """What the program printed."""
    done = subprocess.run([str(word) for word in command], capture_output=True,
                          text=True, **options)
    if done.returncode != 0:
        raise MakingError(f"{' '.join(map(str, command))}\n"
                          f"{done.stderr.strip() or done.stdout.strip()}")
    return done.stdout


class DebianPackage:
    def __init__(self, name):
        self.name = name

    def file(self, name):
        path = DEBIAN_FONTS / name
        if not path.is_file():
            raise MakingError(
                f"{path} is missing: apt-get install {self.name}, or for all faces\n"
                "  sh -c '. host_tools/setup.sh && inkcell_setup fonts'")
        return path

    def origin(self):
        return call("dpkg-query", "-W", "-f", "Debian: ${Package} ${Version}",
                    self.name)

    def licence(self, name):
        """The package's own text, and the licence that it only refers to."""
        text = (DEBIAN_DOC / self.name / "copyright").read_text()
        common = COMMON_LICENCES / name
        if common.is_file():
            text += f"\n{'-' * 72}\n\n{common.read_text()}"
        return text


class NpmPackage:
    """A package of npm, which is unpacked below the folder."""

    def __init__(self, name, folder):
        self.name = name
        self.folder = folder / name.replace("/", "_")

    def fetch(self):
        self.folder.mkdir()
        try:
            packed = call("npm", "pack", "--silent", self.name, cwd=self.folder)
        except FileNotFoundError:
            raise MakingError(f"{self.name} needs npm: apt-get install npm") from None
        except MakingError as error:
            raise MakingError(f"{self.name} can't be fetched: {error}") from None
        call("tar", "-xzf", packed.split()[-1], cwd=self.folder)

    def file(self, name):
        if not self.folder.is_dir():
            self.fetch()
        path = self.folder / "package" / name
        if not path.is_file():
            raise MakingError(f"{self.name} lacks {name}")
        return path

    def origin(self):
        return f"npm: {self.name}"

    def licence(self, _):
        return self.file("LICENSE").read_text()


class Face:
    """A face of the table, its files and the options of its sets."""

    def __init__(self, entry, sets, downloads):
        self.name = entry["face"]
        self.kind = entry["kind"]
        self.licence = entry["licence"]
        self.icons = entry.get("icons", {})
        package = entry["package"]
        self.package = (
            NpmPackage(package.removeprefix(NPM), downloads)
            if package.startswith(NPM) else DebianPackage(package))
        self.files = [self.package.file(name) for name in entry["files"]]
        self.options = {}
        self.specimens = {}
        self.reports = {}
        self.codes = {}  # of icons and emoji, which are no letters
        for name, shared in sets.items():
            if self.icons:
                codes = self.icons[name].values()
                self.codes[name] = ", ".join(f"{icon} U+{code}" for icon, code in
                                             self.icons[name].items())
                self.options[name] = [f"--chars={','.join(map('0x{}'.format, codes))}"]
                self.specimens[name] = "".join(chr(int(code, 16)) for code in codes)
            else:
                self.options[name] = shared["options"]
                self.specimens[name] = shared["specimen"]
                if self.kind == "emoji":
                    asked = shared["options"][0].partition("=")[2]
                    self.codes[name] = (
                        asked.replace("0x", "U+") if asked.startswith("0x") else
                        ", ".join(f"{sign} U+{ord(sign):04X}" for sign in asked))


def grey_picture(path):
    """Rows of a PGM, which has no comments."""
    _, size, _, pixels = path.read_bytes().split(b"\n", 3)
    width, height = map(int, size.split())
    return [pixels[y * width:(y + 1) * width] for y in range(height)]


def tell_icons(header, codes):
    """Writes the names and codes of icons into the header of their font."""
    lines = textwrap.fill(f"/* {codes} */", 80, subsequent_indent=" * ")
    header.write_text(header.read_text().replace(
        "#pragma once\n", f"{lines}\n#pragma once\n", 1))


class Maker:
    """Makes all that one face has, on one core."""

    def __init__(self, fontgen, render, folder, work):
        self.fontgen = fontgen
        self.render = render
        self.folder = folder
        self.work = work

    def generate(self, face, *options):
        first, *others = face.files
        call(self.fontgen, "--quiet", "--threads=1", f"--font={first}",
             *(f"--merge={path}" for path in others), *options)

    def make(self, face):
        # Sets share characters, so that the glyphs of all are built first, and once.
        built = self.work / f"{face.name}.built"
        self.generate(face, "--part=0/1", f"--out={built}",
                      *(option for options in face.options.values()
                        for option in options))
        for name, options in face.options.items():
            font = f"{face.name}_{name}"
            report = self.work / f"{font}.json"
            in_c = self.folder / "c/fonts"
            self.generate(face, *options, f"--built={built}", f"--name={font}",
                          f"--report={report}",
                          f"--out={self.folder}/hpp/fonts/{font}.hpp",
                          f"--out={in_c}/{font}.c", f"--header={in_c}/{font}.h",
                          f"--out={self.folder}/bin/{font}.bin")
            face.reports[name] = json.loads(report.read_text())
            if face.icons:
                for header in (f"hpp/fonts/{font}.hpp", f"c/fonts/{font}.h"):
                    tell_icons(self.folder / header, face.codes[name])
        (self.folder / f"licences/{face.name}.txt").write_text(
            face.package.licence(face.licence))
        self.draw_specimen(face)
        return face

    def draw_specimen(self, face):
        """A line of each set at each size."""
        lines = []
        for name, text in face.specimens.items():
            for px in SPECIMEN_PX:
                picture = self.work / f"{face.name}.pgm"
                call(self.render, f"--font={self.folder}/bin/{face.name}_{name}.bin",
                     f"--text={text}", f"--px={px}", "--invert", f"--out={picture}")
                lines.append(grey_picture(picture))
        width = 2 * MARGIN + max(len(line[0]) for line in lines)

        def padded(row=b""):
            return (bytes([WHITE]) * MARGIN + row).ljust(width, bytes([WHITE]))

        gap = [padded()] * MARGIN
        rows = [*gap]
        for line in lines:
            rows += [*map(padded, line), *gap]
        picture = png(width, 1, b"".join(rows))
        (self.folder / f"specimens/{face.name}.png").write_bytes(picture)


def bytes_of(face, name):
    report = face.reports[name]
    size = f"{report['bytes']['total']:,}"
    asked = report["characters"] + report["missing"]
    return (f"{size} ({report['characters']} of {asked})" if report["missing"]
            else size)


def tables(faces):
    """FONTS.md: a table for the faces of the same sets, and codes of icons, emoji."""
    parts = [INTRODUCTION.format(sizes=", ".join(map(str, SPECIMEN_PX)))]
    for sets in dict.fromkeys(tuple(face.options) for face in faces):
        titles = ["face", "kind", *(f"`{name}`" for name in sets), "licence", "from",
                  "picture"]
        rows = [titles, ["---"] * len(titles)]
        for face in faces:
            if tuple(face.options) == sets:
                rows.append([
                    f"`{face.name}`", face.kind,
                    *(bytes_of(face, name) for name in sets),
                    f"[{face.licence}](licences/{face.name}.txt)",
                    face.package.origin(), f"![](specimens/{face.name}.png)"])
        parts.append("".join(f"| {' | '.join(row)} |\n" for row in rows))
    parts += [f"`{face.name}_{name}`: {codes}.\n" for face in faces
              for name, codes in face.codes.items()]
    return "\n".join(parts)


def check_known(option, names, known):
    for name in names:
        if name not in known:
            raise MakingError(f"{option}: '{name}' is not known; there are "
                              f"{', '.join(dict.fromkeys(known))}")


def results_of(jobs):
    """Results as they come. After an error no other job begins."""
    try:
        for job in concurrent.futures.as_completed(jobs):
            yield job.result()
    except MakingError:
        for job in jobs:
            job.cancel()
        raise


def faces_of(table, options, downloads):
    """The faces that are asked for, with these sets; their files are there."""
    for entry in table["faces"]:
        sets = {name: table["sets"].get(name) for name in table["kinds"][entry["kind"]]
                if not options.sets or name in options.sets}
        if sets and (not options.only or entry["face"] in options.only):
            yield Face(entry, sets, downloads)


def make_all(options):
    table = json.loads((pathlib.Path(__file__).parent / "fonts.json").read_text())
    check_known("--only", options.only, [entry["face"] for entry in table["faces"]])
    check_known("--sets", options.sets, sum(table["kinds"].values(), []))
    for tool in (options.fontgen, options.render):
        if not tool.is_file():
            raise MakingError(f"{tool} is missing: cmake --build build/host "
                              f"--target {tool.name}")
    for name in ("hpp/fonts", "c/fonts", "bin", "licences", "specimens"):
        (options.folder / name).mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory() as work:
        work = pathlib.Path(work)
        faces = list(faces_of(table, options, work))
        maker = Maker(options.fontgen, options.render, options.folder, work)
        with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
            jobs = [pool.submit(maker.make, face) for face in faces]
            for i, face in enumerate(results_of(jobs), 1):
                sizes = ", ".join(f"{name} {bytes_of(face, name)}"
                                  for name in face.options)
                print(f"[{i}/{len(faces)}] {face.name}: {sizes}", flush=True)
        (options.folder / "FONTS.md").write_text(tables(faces))


def main():
    parser = argparse.ArgumentParser(
        description=__doc__,
        formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("fontgen", type=pathlib.Path, metavar="FONTGEN",
                        help="the program inkcell-fontgen")
    parser.add_argument("folder", type=pathlib.Path, metavar="FOLDER",
                        help="where the fonts go; other files in it stay")
    parser.add_argument("--only", nargs="+", default=[], metavar="FACE",
                        help="make these faces, and a FONTS.md of them")
    parser.add_argument("--sets", nargs="+", default=[], metavar="SET",
                        help="make these sets of characters")
    parser.add_argument("--render", type=pathlib.Path, metavar="PROGRAM",
                        help="the program inkcell-render [that of FONTGEN's build]")
    options = parser.parse_args()
    options.fontgen = options.fontgen.resolve()
    if options.render is None:
        options.render = options.fontgen.parents[1] / "host_tools/inkcell-render"
    try:
        make_all(options)
    except MakingError as error:
        sys.exit(f"fonts.py: {error}")


if __name__ == "__main__":
    main()
