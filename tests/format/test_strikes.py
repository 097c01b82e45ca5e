#!/usr/bin/env python3
"""Bitmap fonts become fonts of strikes, which the second decoder reads: bit by
bit those of the source.

    test_strikes.py FONTGEN [FONT.hex|FONT.pcf.gz...]

Fonts of the command line are converted whole.
"""
import gzip
import pathlib
import random
import struct
import subprocess
import sys
import tempfile
import time
import unittest

import decoder
from pcf import read_pcf
from strikes import Picture

FONTGEN = None
FONTS = []


class Source:
    """A bitmap font made at random: pictures and advances by code point."""

    def __init__(self, seed, bits, px=16):
        self.random = random.Random(seed)
        self.bits, self.px = bits, px
        self.glyphs = {code: self.glyph() for code in (*range(0x21, 0x7F),
                                                        0xB0, 0x20AC)}

    def glyph(self):
        width, height = self.random.randint(1, 12), self.random.randint(1, 14)
        # Rows that are the one above, and pixels that are their neighbours.
        shades = [self.random.randrange(1 << self.bits) for _ in range(3)]
        rows = []
        for _ in range(height):
            row = [self.random.choice(shades) for _ in range(width)]
            rows.append(rows[-1] if rows and self.random.random() < .3 else row)
        left, bottom = self.random.randint(-2, 3), self.random.randint(-3, 2)
        return Picture(left, -bottom - height, rows), width + 2


def cropped(picture):
    rows = picture.rows
    ys = [y for y, row in enumerate(rows) if any(row)]
    xs = [x for x in range(len(rows[0])) if any(row[x] for row in rows)]
    if not ys:
        return None
    return Picture(picture.left + xs[0], picture.top + ys[0],
                   [row[xs[0]:xs[-1] + 1] for row in rows[ys[0]:ys[-1] + 1]])


def bdf(source):
    lines = ["STARTFONT 2.1", "FONT -x-Test-Medium-R-Normal--16-160-72-72-C-"
             "80-ISO10646-1", f"SIZE 16 72 72 {source.bits}",
             "FONTBOUNDINGBOX 16 20 -2 -4", "STARTPROPERTIES 6",
             'FAMILY_NAME "Test"', f"PIXEL_SIZE {source.px}", "FONT_ASCENT 13",
             "FONT_DESCENT 4", 'CHARSET_REGISTRY "ISO10646"',
             'CHARSET_ENCODING "1"', "ENDPROPERTIES",
             f"CHARS {len(source.glyphs)}"]
    for code, (picture, advance) in source.glyphs.items():
        width, height = len(picture.rows[0]), len(picture.rows)
        lines += [f"STARTCHAR u{code:04X}", f"ENCODING {code}",
                  "SWIDTH 500 0", f"DWIDTH {advance} 0",
                  f"BBX {width} {height} {picture.left} "
                  f"{-picture.top - height}", "BITMAP"]
        for row in picture.rows:
            text = "".join(f"{value:0{source.bits}b}" for value in row)
            text += "0" * (-len(text) % 8)
            lines.append(f"{int(text, 2):0{len(text) // 4}X}")
        lines.append("ENDCHAR")
    return "\n".join((*lines, "ENDFONT", "")).encode()


def in_runs(values, bits):
    """LVGL's runs, as its decoder reads them."""
    out, at = "", 0
    while at < len(values):
        value, length = values[at], 1
        while at + length < len(values) and values[at + length] == value:
            length += 1
        word = f"{value:0{bits}b}"
        out += word
        at += 1
        if length == 1:
            continue
        out += word  # the second one says that it is a run
        at += 1
        ones = min(length - 2, 10)
        out += "1" * ones
        at += ones
        more = length - 2 - ones
        if more == 0:
            out += "0"  # the next value follows as it is
            continue
        taken = min(more, 63)
        out += "1" + f"{taken:06b}"
        at += taken
    return out


def lvgl(source, compression, kerning):
    """A font in LVGL's format: kerning by pairs or by a matrix of classes."""
    codes = sorted(source.glyphs)
    streams = [""]
    for code in codes:
        picture, advance = source.glyphs[code]
        rows = picture.rows
        height = len(rows)
        if compression == 1:
            rows = [rows[0]] + [[a ^ b for a, b in zip(row, above)]
                                for above, row in zip(rows, rows[1:])]
        values = [value for row in rows for value in row]
        bits = (in_runs(values, source.bits) if compression else "".join(
            f"{value:0{source.bits}b}" for value in values))
        streams.append(f"{advance * 16:09b}{picture.left & 31:05b}"
                       f"{(-picture.top - height) & 31:05b}"
                       f"{len(rows[0]):05b}{height:05b}{bits}")
    glyphs, offsets = b"", []
    for bits in streams:
        offsets.append(8 + len(glyphs))
        bits = bits or "0" * 29
        bits += "0" * (-len(bits) % 8)
        glyphs += int(bits, 2).to_bytes(len(bits) // 8, "big")

    def table(name, content):
        return struct.pack("<I", len(content) + 8) + name + content

    head = struct.pack("<IHHHhHhHhhHHBBBBBBBBBBhH", 1, 4, source.px, 13, -4, 13,
                       -4, 0, -4, 13, 0, 16, 0, 1, 1, source.bits, 5, 5, 9,
                       compression, 0, 0, 0, 0)
    ascii_codes = [code for code in codes if code < 0x7F]
    others = codes[len(ascii_codes):]
    cmap = struct.pack("<I", 2)
    data = 12 + 32
    cmap += struct.pack("<IIHHHBB", data, ascii_codes[0], len(ascii_codes), 1,
                        0, 2, 0)
    cmap += struct.pack("<IIHHHBB", data, others[0],
                        others[-1] - others[0] + 1, 1 + len(ascii_codes),
                        len(others), 3, 0)
    cmap += struct.pack(f"<{len(others)}H", *(c - others[0] for c in others))
    a, v = 1 + codes.index(ord("A")), 1 + codes.index(ord("V"))
    if kerning == "pairs":
        kern = struct.pack("<B3xIHHHHbb", 0, 2, a, v, v, a, -16, 24)
    else:
        count = len(codes) + 1
        left, right = bytearray(count), bytearray(count)
        left[a], left[v], right[v], right[a] = 1, 2, 1, 2
        kern = struct.pack("<B3xHBB", 3, count, 2, 2) + left + right
        kern += struct.pack("4b", -16, 0, 0, 24)
    return b"".join((
        table(b"head", head), table(b"cmap", cmap),
        table(b"loca", struct.pack(f"<I{len(offsets)}H", len(offsets),
                                   *offsets)),
        table(b"glyf", glyphs), table(b"kern", kern)))


class Folder(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.path = pathlib.Path(self.folder.name)

    def call(self, name, content, *options):
        file = self.path / name
        if content is not None:
            file.write_bytes(content)
        out = self.path / "font.bin"
        out.unlink(missing_ok=True)
        return subprocess.run(
            [FONTGEN, "--font", file, "--out", out, "--quiet",
             "--no-layout-glyphs", *options], stderr=subprocess.PIPE,
            encoding="utf-8"), out

    def font(self, name, content, *options):
        done, out = self.call(name, content, *options)
        self.assertEqual(done.returncode, 0, done.stderr)
        font = decoder.StrikeFont(out.read_bytes())
        self.assertEqual(len(font.strikes), 1)
        return font

    def check(self, font, source, strike_bits=None):
        strike = font.strikes[0]
        self.assertEqual(strike.px, source.px)
        self.assertEqual(strike.bits, strike_bits or source.bits)
        unit = font.units_per_em // source.px
        self.assertEqual(font.units_per_em, unit * source.px)
        depth = ((1 << strike.bits) - 1) // ((1 << source.bits) - 1)
        for code, (picture, advance) in source.glyphs.items():
            glyph = font.glyph_of[code]
            wanted = cropped(picture)
            if wanted is not None:
                wanted = wanted._replace(rows=[[value * depth for value in row]
                                               for row in wanted.rows])
            self.assertEqual(strike.pictures.get(glyph), wanted, hex(code))
            self.assertEqual(font.metrics[glyph][0], advance * unit)


CHARS = "0x21-0x7E,0xB0,0x20AC"


class Formats(Folder):
    def test_bdf(self):
        for bits in (1, 2, 4):
            source = Source(bits, bits)
            self.check(self.font("a.bdf", bdf(source), "--chars", CHARS),
                       source)

    def test_gzip(self):
        source = Source(7, 1)
        packed = gzip.compress(bdf(source))
        self.check(self.font("a.bdf.gz", packed, "--chars", CHARS), source)

    def test_more_bits(self):
        source = Source(8, 1)
        self.check(self.font("a.bdf", bdf(source), "--chars", CHARS,
                             "--strike-only", "--strike", "16:4"), source, 4)

    def test_lvgl(self):
        for bits in (1, 2, 4):
            for compression in (0, 1, 2):
                source = Source(10 * bits + compression, bits)
                for kerning in ("pairs", "classes"):
                    font = self.font("a.bin",
                                     lvgl(source, compression, kerning),
                                     "--chars", CHARS)
                    self.check(font, source)
                    a, v = font.glyph_of[ord("A")], font.glyph_of[ord("V")]
                    unit = font.units_per_em // 16
                    pairs = {pair: value for pair, value
                             in font.kerning.items() if value != 0}
                    # 24/16 px are rounded with the advance, as LVGL does.
                    self.assertEqual(pairs, {(a, v): -unit, (v, a): 2 * unit})

    def test_merged(self):
        """Outlines give what a bitmap font lacks, and the other way round."""
        source = Source(9, 1)
        for code in range(ord("A"), ord("G")):
            del source.glyphs[code]
        dejavu = "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf"
        font = self.font("a.bdf", bdf(source), "--chars", CHARS, "--merge",
                         dejavu)
        self.check(font, source)
        for code in range(ord("A"), ord("G")):
            picture = font.strikes[0].pictures[font.glyph_of[code]]
            self.assertEqual((picture.top, len(picture.rows)), (-12, 12))
        alone = ("--strike-only", "--strike", "16:1")
        done, out = self.call(dejavu, None, "--chars", "A-C,0xE000", "--merge",
                              str(self.path / "b.bdf") + "=0xE000", *alone)
        self.assertEqual(done.returncode, 1)
        source.glyphs[0xE000] = source.glyphs[0x21]
        (self.path / "b.bdf").write_bytes(bdf(source))
        done, out = self.call(dejavu, None, "--chars", "A-C,0xE000", "--merge",
                              str(self.path / "b.bdf"), *alone)
        self.assertEqual(done.returncode, 0, done.stderr)
        merged = decoder.StrikeFont(out.read_bytes())
        self.assertEqual(merged.strikes[0].pictures[merged.glyph_of[0xE000]],
                         cropped(source.glyphs[0x21][0]))
        done, _ = self.call(dejavu, None, "--chars", "A-C,0xE000", "--merge",
                            str(self.path / "b.bdf"))
        self.assertIn("give --strike-only --strike 16:1", done.stderr)


class Refusals(Folder):
    def refuse(self, said, name, content, *options):
        done, out = self.call(name, content, *options)
        self.assertEqual(done.returncode, 1, done.stderr)
        self.assertIn(said, done.stderr)
        self.assertFalse(out.exists())

    def test_damage(self):
        source = Source(3, 4)
        good = lvgl(source, 1, "pairs")
        for size in range(12, len(good) - 60, 97):
            done, _ = self.call("a.bin", good[:size], "--chars", CHARS)
            self.assertEqual(done.returncode, 1, size)
            self.assertIn("a.bin: is damaged or truncated", done.stderr)
        rand = random.Random(5)
        for _ in range(60):
            bad = bytearray(good)
            for _ in range(3):
                bad[rand.randrange(8, len(bad))] = rand.randrange(256)
            done, _ = self.call("a.bin", bytes(bad), "--chars", CHARS)
            self.assertIn(done.returncode, (0, 1), done.stderr)
        text = bdf(source)
        self.refuse("FreeType cannot read it", "a.bdf", text[:300])
        self.refuse("gzip cannot unpack it", "a.bdf.gz",
                    gzip.compress(text)[:-40])
        self.refuse("line 2 is not CODE:ROWS", "a.hex",
                    b"0041:" + 32 * b"1" + b"\n0042:123\n")

    def test_limits(self):
        one = Source(3, 1)
        bits = lvgl(one, 0, "pairs")
        at = 8 + 29
        self.refuse("make it with --bpp 1, 2 or 4", "a.bin",
                    bits[:at] + b"\3" + bits[at + 1:], "--chars", CHARS)
        self.refuse("no Unicode characters", "a.bdf",
                    bdf(one).replace(b"ISO10646", b"KOI8"))
        self.refuse("has 3 px/em", "a.bdf",
                    bdf(one).replace(b"PIXEL_SIZE 16", b"PIXEL_SIZE 3"))
        self.refuse("give --strike-only --strike 16:1", "a.bdf", bdf(one),
                    "--strike", "12:1")
        self.refuse("neither outlines nor shaping", "a.bdf", bdf(one),
                    "--coding", "field")
        self.refuse("is not a font; TTF", "a.txt", b"Hello, hexadecimal 123")
        self.refuse("has other pixels than", "a.bdf", bdf(one), "--merge",
                    self.other(), "--symbols", "A\u0142")

    def other(self):
        source = Source(4, 2)
        source.glyphs[0x142] = source.glyphs[0x21]
        (self.path / "other.bdf").write_bytes(bdf(source))
        return str(self.path / "other.bdf")


class Whole(Folder):
    """The fonts of the command line, each read here a second time."""

    def test_hex(self):
        for path in (path for path in FONTS if path.suffix == ".hex"):
            glyphs = {}
            for line in path.read_text().split():
                code, digits = line.split(":")
                width = len(digits) // 4
                glyphs[int(code, 16)] = Picture(0, -14, [
                    [int(bit) for bit in f"{int(row, 16):0{width}b}"]
                    for row in (digits[i:i + width // 4] for i in range(
                        0, len(digits), width // 4))]), width
            source = Source(0, 1)
            source.glyphs = glyphs
            self.check_whole(path, source, 50000)

    def test_pcf(self):
        for path in (path for path in FONTS if path.suffix == ".gz"):
            # Terminus of 12 px: ter-u12n_unicode.pcf.gz.
            source = Source(0, 1, int(path.name[5:7]))
            source.glyphs = read_pcf(gzip.decompress(path.read_bytes()))
            self.check_whole(path, source, 1250)

    def check_whole(self, path, source, least):
        source.glyphs = {code: glyph for code, glyph in source.glyphs.items()
                         if code >= 0x20}
        self.assertGreater(len(source.glyphs), least)
        before = time.monotonic()
        font = self.font(path, None, "--chars", "0x20-0x2FFFF")
        seconds = time.monotonic() - before
        size = (self.path / "font.bin").stat().st_size
        print(f"{path.name}: {len(source.glyphs)} characters, {size} bytes, "
              f"{seconds:.1f} s")
        self.check(font, source)


def main():
    global FONTGEN, FONTS
    FONTGEN = sys.argv[1]
    FONTS = [pathlib.Path(name) for name in sys.argv[2:]]
    unittest.main(argv=sys.argv[:1])


if __name__ == "__main__":
    main()
