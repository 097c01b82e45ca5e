#!/usr/bin/env python3
"""Judges small text: how well a machine reads it, and its stems.

Draws lines with inkcell-render, and with FreeType's three ways to hint, and
prints one JSON object a row and a table of means over the fonts:

  read     characters that Tesseract reads from pixels enlarged four times [%]
  peak     grey: darkest column of a stem [%], and
  vary     how much that varies; 1 bit: how much widths of stems vary [%]
  length   of the lines, against unhinted advances [%]

OCR is one reader: a point is noise from 10 px on, two at 8 px.
"""
import argparse
import json
import os
import subprocess
import sys
import tempfile
from pathlib import Path

import freetype

FONTS = ["dejavu/DejaVuSans.ttf",
         "liberation/LiberationSerif-Regular.ttf",
         "roboto/unhinted/RobotoTTF/Roboto-Regular.ttf"]
FOLDER = Path("/usr/share/fonts/truetype")
LINES = Path(__file__).resolve().parent / "reading_lines.txt"
STEMS = ["illimhnurihul", "dinnhumpliqurm"]  # and words of capitals
CAPITALS = ["HIHLHITLIH"]

# Row: options of inkcell-render, or FreeType's load flags; levels of grey.
LIGHT = freetype.FT_LOAD_FORCE_AUTOHINT | freetype.FT_LOAD_TARGET_LIGHT
ROWS = {
    "grey": (["--hint", "none"], 256),
    "grey, vertical": (["--hint", "vertical"], 256),
    "grey, both": (["--hint", "both"], 256),
    "1 bit": (["--hint", "both", "--levels", "2"], 2),
    "2 bits": (["--hint", "both", "--levels", "4"], 4),
    "FreeType light": (LIGHT, 256),
    "FreeType native": (freetype.FT_LOAD_TARGET_NORMAL, 256),
    "FreeType native, 1 bit": (freetype.FT_LOAD_TARGET_MONO, 2),
    "FreeType light, 2 bits": (LIGHT, 4),
}


class Job:
    """A line, where its pen starts, and the size of its picture."""

    def __init__(self, face, text, px, shift=0):
        face.set_char_size(round(px * 64), 0, 72, 72)
        length = 0
        for char in text:
            face.load_char(char, freetype.FT_LOAD_NO_HINTING |
                           freetype.FT_LOAD_NO_BITMAP)
            length += face.glyph.linearHoriAdvance / 65536
        self.text, self.px, self.shift, self.length = text, px, shift, length
        self.x = 4 + int(px)
        self.y = 4 + int(1.1 * px)
        self.width = int(1.35 * length) + 3 * int(px) + 12
        self.height = self.y + int(0.4 * px) + 5


def freetype_picture(face, flags, job, levels):
    """Rows of 0..255, with whole-pixel advances as hinting has them."""
    face.set_char_size(round(job.px * 64), 0, 72, 72)
    rows = [[0] * job.width for _ in range(job.height)]
    pen = job.x + (job.shift + 32 >> 6)
    for char in job.text:
        face.load_char(char, flags | freetype.FT_LOAD_RENDER |
                       freetype.FT_LOAD_NO_BITMAP)
        bitmap = face.glyph.bitmap
        is_mono = bitmap.pixel_mode == freetype.FT_PIXEL_MODE_MONO
        buffer, pitch = bitmap.buffer, bitmap.pitch
        for j in range(bitmap.rows):
            for i in range(bitmap.width):
                ink = buffer[j * pitch + (i >> 3 if is_mono else i)]
                if is_mono:
                    ink = 255 if ink >> 7 - (i & 7) & 1 else 0
                y = job.y - face.glyph.bitmap_top + j
                x = pen + face.glyph.bitmap_left + i
                if 0 <= y < job.height and 0 <= x < job.width:
                    rows[y][x] = min(255, rows[y][x] + ink)
        pen += face.glyph.advance.x + 32 >> 6
    if levels < 256:
        step = 255 // (levels - 1)
        rows = [[(v + step // 2) // step * step for v in row] for row in rows]
    return rows


def read_pgm(path):
    data = path.read_bytes()
    fields = data.split(maxsplit=4)
    width, height = int(fields[1]), int(fields[2])
    pixels = data[len(data) - width * height:]
    return [pixels[y * width:(y + 1) * width] for y in range(height)]


class Row:
    """One way to draw one font."""

    def __init__(self, name, font, options, folder):
        self.options, self.levels = ROWS[name]
        self.face = freetype.Face(str(font), options.face)
        self.font, self.texts = font, options.texts
        self.render, self.folder = options.render, folder
        self.number, self.language = options.face, options.language
        self.rom = folder / f"{font.stem}.ink"

    def draw(self, jobs):
        if isinstance(self.options, int):
            return [freetype_picture(self.face, self.options, job,
                                     self.levels) for job in jobs]
        if not self.rom.exists():
            subprocess.run([self.render.parents[1] /
                            "fonts_gen/inkcell-fontgen", "--quiet", "--font",
                            self.font, "--face", str(self.number), "--chars",
                            "0x20-0x7E", f"--symbols={''.join(self.texts)}",
                            "--out", self.rom], check=True)
        lines = []
        for i, job in enumerate(jobs):
            lines.append(json.dumps({
                "font": str(self.rom), "text": job.text, "size": job.px,
                "w": job.width, "h": job.height, "ox": job.x, "oy": job.y,
                "dx": job.shift, "out": f"{self.folder}/{i}.pgm"}))
        listed = self.folder / "jobs.jsonl"
        listed.write_text("\n".join(lines) + "\n")
        subprocess.run([self.render, "--jobs", listed, *self.options],
                       check=True, stdout=subprocess.DEVNULL)
        return [read_pgm(self.folder / f"{i}.pgm") for i in range(len(jobs))]

    def jobs(self, texts, px, shifts=(0,)):
        return [Job(self.face, text, px, shift)
                for text in texts for shift in shifts]


def distance(a, b):
    """Edits from one text to the other (Levenshtein)."""
    row = list(range(len(b) + 1))
    for i, char in enumerate(a, 1):
        corner, row[0] = row[0], i
        for j, other in enumerate(b, 1):
            corner, row[j] = row[j], min(row[j] + 1, row[j - 1] + 1,
                                         corner + (char != other))
    return row[-1]


def end_of_ink(rows):
    return max((i for row in rows for i, v in enumerate(row) if v > 40),
               default=0)


def read(row, px):
    jobs = row.jobs(row.texts, px)
    pictures = row.draw(jobs)
    width = max(map(end_of_ink, pictures)) + 9
    page = [[255] * (width + 8)] * 8
    for picture in pictures:
        for line in picture:
            inverse = [255 - v for v in line[:width]]
            page.append([255] * 8 + inverse + [255] * (width - len(inverse)))
    page += [[255] * (width + 8)] * 8
    zoom = 4
    lines = [bytes(v for v in line for _ in range(zoom)) for line in page]
    path = row.folder / "page.pgm"
    path.write_bytes(b"P5 %d %d 255\n" % (len(lines[0]), zoom * len(lines)) +
                     b"".join(line * zoom for line in lines))
    text = subprocess.run(
        ["tesseract", path, "-", "--psm", "6", "-l", row.language, "--dpi", "300"],
        env=dict(os.environ, OMP_THREAD_LIMIT="1"), check=True, text=True,
        stdout=subprocess.PIPE, stderr=subprocess.DEVNULL).stdout
    blank = " " if row.language == "eng" else ""
    wanted = blank.join(row.texts)
    missed = distance(wanted, blank.join(text.split()))
    drawn = sum(end_of_ink(p) - job.x for p, job in zip(pictures, jobs))
    return {"read": 100 * max(0.0, 1 - missed / len(wanted)),
            "length": 100 * drawn / sum(job.length for job in jobs) - 100}


def spread(values):
    """Standard deviation over mean. [%]"""
    mean = sum(values) / len(values)
    return 100 * (sum((v - mean) ** 2 for v in values) /
                  len(values)) ** 0.5 / mean


def stems(row, px):
    """Runs of ink half-way up, and the darkest pixel of each."""
    widths, peaks = [], []
    for texts, height in ((STEMS, 0.24), (CAPITALS, 0.22)):
        jobs = row.jobs(texts, px, (0, 37))
        for job, picture in zip(jobs, row.draw(jobs)):
            line = [0, *picture[int(job.y - height * px)], 0]
            start = None
            for i, value in enumerate(line):
                if value > 51 and start is None:
                    start = i
                if value <= 51 and start is not None:
                    run = line[start:i]
                    if len(run) <= 3:
                        widths.append(sum(v > 127 for v in run))
                        peaks.append(max(run))
                    start = None
    if row.levels == 2:
        return {"vary": spread(widths)}
    return {"peak": 100 / 255 * sum(peaks) / len(peaks),
            "vary": spread(peaks)}


def parse(arguments):
    parser = argparse.ArgumentParser(
        prog="reading.sh", description=__doc__,
        formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--font", action="append", type=Path,
                        help="TTF or OTF; repeatable [three faces]")
    parser.add_argument("--face", type=int, default=0,
                        help="its number in a collection [0]")
    parser.add_argument("--lines", type=Path, default=LINES,
                        help="what is read; of other letters than ASCII only "
                        "the column `read` is told")
    parser.add_argument("--language", default="eng",
                        help="of Tesseract: chi_sim, of Debian's package "
                        "tesseract-ocr-chi-sim, reads reading_hanzi.txt")
    parser.add_argument("--px", default="8,9,10,12", help="sizes")
    parser.add_argument("--rows", help="names of rows, with ; between them")
    parser.add_argument("--at-least", type=float, default=0,
                        help="exit with 1 if a row reads less [%%]")
    parser.add_argument("--render", type=Path, required=True,
                        help="inkcell-render, in the folder of a build")
    options = parser.parse_args(arguments)
    options.font = options.font or [FOLDER / font for font in FONTS]
    options.px = [float(px) for px in options.px.split(",")]
    options.texts = options.lines.read_text().splitlines()
    options.judges = (read, stems)
    if not options.lines.read_text().isascii():
        options.judges = (read,)
    options.rows = options.rows.split(";") if options.rows else list(ROWS)
    for row in options.rows:
        if row not in ROWS:
            parser.error(f"no row {row!r}: there are {'; '.join(ROWS)}")
    return options


def main(arguments):
    options = parse(arguments)
    results = {}
    todo = [(name, px, font) for name in options.rows for px in options.px
            for font in options.font]
    with tempfile.TemporaryDirectory() as folder:
        for done, (name, px, font) in enumerate(todo):
            print(f"\r{done} of {len(todo)}: {name}, {px:g} px, "
                  f"{font.stem}\033[K", end="", file=sys.stderr)
            row = Row(name, font, options, Path(folder))
            figures = {}
            for judge in options.judges:
                figures.update(judge(row, px))
            results.setdefault((name, px), []).append(figures)
            print(json.dumps({"row": name, "px": px, "font": font.stem,
                              **{k: round(v, 2) for k, v in figures.items()}
                              }), flush=True)
    print("\r\033[K", end="", file=sys.stderr)
    columns = ("read", "peak", "vary", "length")
    print(f"{'mean of the fonts':24}   px" +
          "".join(f"{c:>8}" for c in columns), file=sys.stderr)
    for (name, px), fonts in results.items():
        cells = ""
        for column in columns:
            values = [f[column] for f in fonts if column in f]
            cells += (f"{sum(values) / len(values):8.1f}" if values
                      else " " * 8)
        print(f"{name:24}{px:5g}{cells}", file=sys.stderr)
    return 1 if any(figures["read"] < options.at_least
                    for fonts in results.values() for figures in fonts) else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
