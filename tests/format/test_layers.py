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

try:
    from fontTools.colorLib import builder as colours_of
except ImportError:
    sys.path.append("/usr/lib/python3/dist-packages")  # Debian's
    try:
        from fontTools.colorLib import builder as colours_of
    except ImportError:
        colours_of = None
if colours_of is not None:
    from fontTools.fontBuilder import FontBuilder
    from fontTools.pens.transformPen import TransformPen
    from fontTools.pens.ttGlyphPen import TTGlyphPen

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


# Paints that move glyph 'shape', and the same as a matrix: xx, xy, yx, yy, dx,
# dy. An em has 1024 units.
SHAPE = {"Format": 10, "Glyph": "shape",
         "Paint": {"Format": 2, "PaletteIndex": 0, "Alpha": 1.0}}
MOVES = [
    ({"Format": 12, "Transform": (.5, .25, -.25, 1, 10, 20)},
     (.5, .25, -.25, 1, 10, 20)),
    ({"Format": 14, "dx": 128, "dy": -64}, (1, 0, 0, 1, 128, -64)),
    ({"Format": 16, "scaleX": .5, "scaleY": 1.25}, (.5, 0, 0, 1.25, 0, 0)),
    ({"Format": 18, "scaleX": .5, "scaleY": 1.5, "centerX": 100,
      "centerY": 200}, (.5, 0, 0, 1.5, 50, -100)),
    ({"Format": 20, "scale": .5}, (.5, 0, 0, .5, 0, 0)),
    ({"Format": 22, "scale": .5, "centerX": 100, "centerY": 200},
     (.5, 0, 0, .5, 50, 100)),
    # Counter-clockwise, as skews of an axis are.
    ({"Format": 24, "angle": 90}, (0, 1, -1, 0, 0, 0)),
    ({"Format": 26, "angle": 90, "centerX": 100, "centerY": 200},
     (0, 1, -1, 0, 300, 100)),
    ({"Format": 28, "xSkewAngle": 45, "ySkewAngle": 0}, (1, 0, -1, 1, 0, 0)),
    ({"Format": 30, "xSkewAngle": 0, "ySkewAngle": 45, "centerX": 100,
      "centerY": 200}, (1, 1, 0, 1, 0, -100)),
    # What is inside is moved first.
    ({"Format": 14, "dx": 100, "dy": 0,
      "Paint": {"Format": 20, "scale": .5, "Paint": SHAPE}},
     (.5, 0, 0, .5, 100, 0)),
    ({"Format": 20, "scale": .5,
      "Paint": {"Format": 14, "dx": 100, "dy": 0, "Paint": SHAPE}},
     (.5, 0, 0, .5, 50, 0)),
]


def fill(index, alpha=1.0):
    return {"Format": 2, "PaletteIndex": index, "Alpha": alpha}


def gradient(*stops):
    """A linear one, of (place, colour, opacity)."""
    return {"Format": 4, "x0": 0, "y0": 0, "x1": 500, "y1": 0, "x2": 0,
            "y2": 500, "ColorLine": {"Extend": "pad", "ColorStop": [
                {"StopOffset": at, "PaletteIndex": index, "Alpha": alpha}
                for at, index, alpha in stops]}}


def painted_font(paints, palette, moves=()):
    """A font whose characters from A on have paints. Glyph 'shape' is there,
    too, and as m0, m1 and so on moved."""
    letters = [chr(0x41 + i) for i in range(len(paints))]
    moved = [f"m{i}" for i in range(len(moves))]
    made = FontBuilder(1024, isTTF=True)
    made.setupGlyphOrder([".notdef", "space", *letters, "shape", *moved])
    made.setupCharacterMap({0x20: "space", **{ord(c): c for c in letters}})

    def shape(matrix=(1, 0, 0, 1, 0, 0)):
        pen = TTGlyphPen(None)
        out = TransformPen(pen, matrix)
        out.moveTo((100, 0))
        out.lineTo((300, 600))
        out.qCurveTo((500, 400), (500, 0))
        out.closePath()
        return pen.glyph()

    made.setupGlyf({
        ".notdef": shape(), "space": TTGlyphPen(None).glyph(),
        **{c: TTGlyphPen(None).glyph() for c in letters}, "shape": shape(),
        **{name: shape(matrix) for name, matrix in zip(moved, moves)}})
    made.setupHorizontalMetrics({
        name: (700, getattr(made.font["glyf"][name], "xMin", 0))
        for name in made.font.getGlyphOrder()})
    made.setupHorizontalHeader(ascent=800, descent=-200)
    made.setupNameTable({"familyName": "Paints", "styleName": "Regular"})
    made.setupOS2()
    made.setupPost()
    made.font["COLR"] = colours_of.buildCOLR(
        dict(zip(letters, paints)), version=1)
    made.font["CPAL"] = colours_of.buildCPAL(
        [[tuple(c / 255 for c in colour) for colour in palette]])
    return made.font


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

    def convert(self, font):
        """The layers of a font of paints, and what the generator tells."""
        source = self.folder / "paints.ttf"
        out = self.folder / "paints.bin"
        if isinstance(font, bytes):
            source.write_bytes(font)
        else:
            font.save(source)
        done = subprocess.run(
            [FONTGEN, "--font", source, "--chars", "A-Z", "--colour",
             "--no-layout-glyphs", "--max-px", "32", "--out", out],
            capture_output=True, text=True)
        if done.returncode != 0:
            return None, done.stderr
        header, sections = decoder.read_header(out.read_bytes())
        if b"COLR" not in sections:
            return (), done.stderr
        return (read_layers(sections[b"COLR"], header.glyph_count),
                done.stderr)

    @unittest.skipIf(colours_of is None, "install python3-fonttools")
    def test_paints_are_moved(self):
        paints = []
        for i, (move, _) in enumerate(MOVES):
            moved = {"Paint": SHAPE, **move}
            paints.append({"Format": 1, "Layers": [moved, {
                "Format": 10, "Glyph": f"m{i}", "Paint": fill(1)}]})
        layers, told = self.convert(painted_font(
            paints, [(9, 8, 7, 255), (1, 2, 3, 255)],
            [matrix for _, matrix in MOVES]))
        self.assertIsNotNone(layers, told)
        self.assertEqual(layers.palettes, [[(9, 8, 7, 255), (1, 2, 3, 255)]])
        self.assertEqual(len(layers.lists), len(MOVES))
        # Equal outlines are one.
        for (first, below), (second, above) in layers.lists.values():
            self.assertEqual((first, below, above), (second, 0, 1))
        self.assertEqual(len({of[0][0] for of in layers.lists.values()}),
                         len(MOVES))

    @unittest.skipIf(colours_of is None, "install python3-fonttools")
    def test_paints_are_layers(self):
        def glyph(paint):
            return {"Format": 10, "Glyph": "shape", "Paint": paint}
        palette = [(200, 0, 0, 255), (0, 100, 0, 255), (0, 0, 80, 100)]
        layers, told = self.convert(painted_font([
            glyph(gradient((0, 0, 1.0), (1, 1, 1.0))),
            # A gradient that is moved, of three stops.
            glyph({"Format": 14, "dx": 9, "dy": 9, "Paint": gradient(
                (0, 0, 1.0), (.5, 0, 1.0), (1, 0, 0.0))}),
            glyph(fill(0xFFFF, 0.5)),
            {"Format": 32, "CompositeMode": "src_over",
             "BackdropPaint": glyph(fill(2, 0.5)),
             "SourcePaint": {"Format": 11, "Glyph": "C"}},
        ], palette))
        self.assertIsNotNone(layers, told)
        self.assertEqual(layers.palettes, [[
            (100, 50, 0, 255), (200, 0, 0, 191), (0, 0, 80, 50)]])
        shape = 6  # .notdef, the space, A to D
        self.assertEqual(layers.lists, {
            2: [(shape, 0)], 3: [(shape, 1)], 4: [(shape, 3 + 127)],
            5: [(shape, 2), (shape, 3 + 127)]})
        for word in ("gradients of 2 glyphs become their mean", "U+0041",
                     "U+0042", "flat fills"):
            self.assertIn(word, told)
        self.assertNotIn("U+0043", told)

    @unittest.skipIf(colours_of is None, "install python3-fonttools")
    def test_paints_are_refused_with_a_remedy(self):
        def glyph(paint):
            return {"Format": 10, "Glyph": "shape", "Paint": paint}
        flat = glyph(fill(0))
        deep = flat
        for _ in range(40):
            deep = {"Format": 14, "dx": 0, "dy": 0, "Paint": deep}
        wide = flat
        for _ in range(3):
            wide = {"Format": 1, "Layers": [wide] * 17}
        for paint, words in (
                ({"Format": 32, "CompositeMode": "src_in",
                  "BackdropPaint": flat, "SourcePaint": flat},
                 ("by mode 5", "lie over each other")),
                ({"Format": 11, "Glyph": "A"}, ("circle",)),
                ({"Format": 11, "Glyph": "B"}, ("circle",)),
                ({"Format": 11, "Glyph": "shape"}, ("has no paint",)),
                (deep, ("within each other",)),
                (wide, ("more than 4096",)),
                (fill(0), ("no glyph that bounds it",)),
                (glyph(flat), ("more than a fill",)),
                (glyph(fill(1)), ("colour 1 of a palette of 1",)),
                (glyph(gradient((0, 0, 1.0), (1, 0xFFFF, 1.0))),
                 ("gradient", "that of the text")),
                (glyph({"Format": 3, "PaletteIndex": 0, "Alpha": 1.0,
                        "VarIndexBase": 0}), ("vary along axes", "make an instance"))):
            layers, told = self.convert(painted_font(
                [paint, {"Format": 11, "Glyph": "A"}], [(1, 2, 3, 255)]))
            self.assertIsNone(layers, paint)
            for word in ("paints.ttf: U+0041", *words, "leave the character"):
                self.assertIn(word, told)

    @unittest.skipIf(colours_of is None, "install python3-fonttools")
    def test_damaged_paints_are_refused_or_drawn(self):
        source = self.folder / "good.ttf"
        paints = [{"Format": 1, "Layers": [{"Paint": SHAPE, **move}, {
            "Format": 10, "Glyph": "shape",
            "Paint": gradient((0, 0, 1.0), (1, 1, 1.0))}]}
                  for move, _ in MOVES]
        font = painted_font(paints, [(9, 8, 7, 255), (1, 2, 3, 255)])
        font.save(source)
        good = source.read_bytes()
        place, size = next(
            struct.unpack_from(">II", good, 20 + 16 * i)
            for i in range(struct.unpack_from(">H", good, 4)[0])
            if good[12 + 16 * i:16 + 16 * i] == b"COLR")
        draw = random.Random(2)
        refused = 0
        rounds = 60
        for _ in range(rounds):
            damaged = bytearray(good)
            for _ in range(draw.randint(1, 3)):
                damaged[place + draw.randrange(size)] = draw.randrange(256)
            layers, told = self.convert(bytes(damaged))
            refused += layers is None
            if layers is None:
                self.assertIn("paints.ttf: ", told)
        self.assertTrue(10 < refused < rounds)

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
