#!/usr/bin/env python3
"""Drawings and fonts of several colours become layers, which a second decoder reads.

    test_layers.py FONTGEN INSPECT DEJAVU

It refuses what the device's verify_layers() refuses of damaged sections.
"""
import json
import pathlib
import random
import struct
import subprocess
import sys
import tempfile
import unittest
import zlib

import decoder
from layers import read_layers
from squares import Refused

FONTGEN = INSPECT = DEJAVU = None

SHAPES = {
    "disc": '<circle cx="18" cy="18" r="16"{}/>',
    "bar": '<rect x="6" y="14" width="24" height="8"{}/>',
    "leaf": '<path d="M4 30 C4 10 20 4 32 4 C32 20 24 32 4 30z"{}/>',
    "line": '<path d="M5 5L30 28" fill="none" stroke-width="3"{}/>',
}


def drawing(parts):
    return ('<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 36 36">'
            + "".join(parts) + "</svg>")


def section_of(font):
    header, sections = decoder.read_header(font)
    return header, sections[b"COLR"]


def with_section(font, section):
    """The font with other bytes of COLR, and right checksums."""
    count = struct.unpack_from("<H", font, 42)[0]
    out = bytearray(font)
    for i in range(count):
        tag, place, size = struct.unpack_from("<4sII", font, 64 + 12 * i)
        if tag == b"COLR":
            assert size == len(section)
            out[place & ~3:(place & ~3) + size] = section
    end = struct.unpack_from("<H", font, 6)[0]
    total = struct.unpack_from("<I", font, 8)[0]
    struct.pack_into("<I", out, 16, zlib.crc32(out[end:total]))
    struct.pack_into("<I", out, 12, zlib.crc32(out[:12] + out[16:end]))
    return bytes(out)


def with_colours(font, layers, colours):
    """A TrueType file whose A, glyph 36, has layers: (glyph, colour)."""
    count = struct.unpack_from(">H", font, 4)[0]
    tables = {}
    for i in range(count):
        tag, _, place, size = struct.unpack_from(">4sIII", font, 12 + 16 * i)
        tables[tag] = font[place:place + size]
    tables[b"COLR"] = (struct.pack(">HHIIH", 0, 1, 14, 20, len(layers))
                       + struct.pack(">HHH", 36, 0, len(layers))
                       + b"".join(struct.pack(">HH", *layer)
                                  for layer in layers))
    tables[b"CPAL"] = (struct.pack(">HHHHIH", 0, len(colours), 1,
                                   len(colours), 14, 0)
                       + b"".join(bytes((c[2], c[1], c[0], c[3]))
                                  for c in colours))
    directory = struct.pack(">4sHHHH", font[:4], len(tables), 0, 0, 0)
    place = 12 + 16 * len(tables)
    body = b""
    for tag, table in sorted(tables.items()):
        directory += struct.pack(">4sIII", tag, 0, place + len(body),
                                 len(table))
        body += table + bytes(-len(table) % 4)
    return directory + body


class Layers(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def make(self, drawings, *options, most_px="32"):
        icons = self.folder / "icons"
        icons.mkdir(exist_ok=True)
        for name, text in drawings.items():
            (icons / f"{name}.svg").write_text(text)
        font = self.folder / "font.bin"
        done = subprocess.run(
            [FONTGEN, "--svg-dir", icons, "--out", font, "--colour",
             "--min-px", "16", "--max-px", most_px, *options],
            capture_output=True, text=True)
        return done, font

    def test_layers_are_those_of_the_drawing(self):
        done, file = self.make({
            "a": drawing([SHAPES["disc"].format(' fill="#fc0"'),
                          SHAPES["bar"].format(' fill="#fc0"'),
                          SHAPES["leaf"].format(
                              ' fill="rgb(1,2,3)" fill-opacity=".5"'),
                          SHAPES["line"].format(' stroke="currentColor"')]),
            "b": drawing([SHAPES["disc"].format(""),
                          SHAPES["bar"].format("")]),
            "c": drawing([SHAPES["leaf"].format(' fill="red"'),
                          SHAPES["line"].format(
                              ' stroke="currentColor" opacity=".2"')]),
            # Thinner than the rim of a form, and its fill is black, of no area.
            "d": drawing([SHAPES["line"].replace('fill="none"', "").format(
                ' stroke="#fc0"')]),
        })
        self.assertEqual(done.returncode, 0, done.stderr)
        header, section = section_of(file.read_bytes())
        layers = read_layers(section, header.glyph_count)
        self.assertEqual(layers.palettes, [[(255, 204, 0, 255),
                                            (1, 2, 3, 128),
                                            (255, 0, 0, 255)]])
        # .notdef and drawings, then outlines in the order in which they come.
        self.assertEqual(header.glyph_count, 5 + 3)
        self.assertEqual(layers.lists, {
            1: [(5, 0), (6, 1), (7, 3)],
            3: [(6, 2), (7, 3 + 204)],
            4: [(7, 0)]})

    def test_report_has_sizes_that_not_all_glyphs_have(self):
        report = self.folder / "report.json"
        done, _ = self.make({"2600": drawing([
            SHAPES["disc"].format(' fill="#fc0"'),
            SHAPES["leaf"].format(' fill="red"')])},
            "--font", DEJAVU, "--chars", "A", "--report", report,
            most_px="40")
        self.assertEqual(done.returncode, 0, done.stderr)
        error = json.loads(report.read_text())["error"]
        self.assertLess(error["mean"], error["max"])

    def test_layers_are_those_of_the_font(self):
        source = self.folder / "colours.ttf"
        out = self.folder / "font.bin"
        dejavu = pathlib.Path(DEJAVU).read_bytes()
        make = [FONTGEN, "--font", source, "--chars", "A-C", "--colour",
                "--no-layout-glyphs", "--out", out]
        colours = [(1, 2, 3, 255), (4, 5, 6, 128)]
        source.write_bytes(with_colours(
            dejavu, [(37, 1), (38, 0xFFFF), (37, 0)], colours))
        subprocess.run(make, check=True, capture_output=True)
        header, section = section_of(out.read_bytes())
        layers = read_layers(section, header.glyph_count)
        # .notdef, the space, A to C, and the outlines of B and C once more.
        self.assertEqual(header.glyph_count, 5 + 2)
        self.assertEqual(layers.palettes, [[colours[1], colours[0]]])
        self.assertEqual(layers.lists, {2: [(5, 0), (6, 2), (5, 1)]})
        source.write_bytes(with_colours(dejavu, [(37, 2)], colours))
        done = subprocess.run(make, capture_output=True, text=True)
        self.assertNotEqual(done.returncode, 0)
        for word in ("colours.ttf", "U+0041", "colour 2 of a palette of 2",
                     "repair table COLR"):
            self.assertIn(word, done.stderr)

    def test_drawings_are_refused_with_a_remedy(self):
        many = [SHAPES["disc"].format(f' fill="#0000{n:02x}"')
                for n in range(65)]
        for parts, words in (
                (['<g filter="url(#f)">' + SHAPES["bar"].format("") + "</g>"],
                 ("<g>", "filter", "remove it")),
                ([SHAPES["bar"].format(' fill="url(#g)"')],
                 ("<rect>", "gradient", "one colour")),
                ([SHAPES["bar"].format(' fill="chartreux"')],
                 ("<rect>", "chartreux", "#rrggbb")),
                ([SHAPES["bar"].format(' opacity="much"')],
                 ("<rect>", "opacity='much'", "write one")),
                (many, ("65 layers", "at most 64", "join parts"))):
            done, _ = self.make({"a": drawing(parts)})
            self.assertNotEqual(done.returncode, 0)
            for word in ("a.svg", *words):
                self.assertIn(word, done.stderr)

    def test_damaged_sections_are_refused_alike(self):
        done, file = self.make({
            name: drawing([SHAPES["disc"].format(f' fill="#{n}00"'),
                           SHAPES[name].format(
                               ' fill="#00f" stroke="#00f"')])
            for n, name in enumerate(("bar", "leaf", "line"))})
        self.assertEqual(done.returncode, 0, done.stderr)
        font = file.read_bytes()
        header, good = section_of(font)
        draw = random.Random(1)
        seen = set()
        for _ in range(120):
            section = bytearray(good)
            for _ in range(draw.randint(1, 3)):
                section[draw.randrange(len(section))] = draw.randrange(256)
            file.write_bytes(with_section(font, section))
            shown = subprocess.run([INSPECT, file], capture_output=True,
                                   text=True).stdout
            try:
                read_layers(bytes(section), header.glyph_count)
                is_good = True
            except Refused:
                is_good = False
            self.assertEqual("corrupt" not in shown, is_good, section.hex())
            seen.add(is_good)
        self.assertEqual(seen, {True, False})


if __name__ == "__main__":
    FONTGEN, INSPECT, DEJAVU = sys.argv[1:4]
    unittest.main(argv=sys.argv[:1])
