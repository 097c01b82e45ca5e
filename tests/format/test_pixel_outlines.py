#!/usr/bin/env python3
"""Pixel fonts that come as outlines become strikes whose pixels are those that the
outlines are made of, bit by bit.

    test_pixel_outlines.py FONTGEN PACKAGE/FILE.woff PX

npm fetches the file. Its outlines are read here a second time.
"""
import pathlib
import sys
import unittest

import test_strikes
from strikes import Picture
from test_strikes import Source
from woff_outlines import WoffOutlines, is_inside

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "host_tools/release"))
from fonts import NpmPackage  # noqa: E402

FILE = PX = None


class PixelOutlines(test_strikes.Folder):
    def test_outlines(self):
        """At their size, fitted or not, a strike has the pixels in which the
        outlines were drawn."""
        *package, folder, file = FILE.split("/")
        path = NpmPackage("/".join(package), self.path).file(
            f"{folder}/{file}")
        outlines = WoffOutlines(path.read_bytes())
        unit = outlines.units_per_em / PX
        source = Source(0, 1, PX)
        source.glyphs = {}
        for code in (*range(0x21, 0x7F), *range(0xA1, 0xA8)):
            glyph = outlines.glyph_of[code]
            contours = outlines.contours(glyph)
            for x, y in (point for points in contours for point in points):
                self.assertEqual((x % unit, y % unit), (0, 0), hex(code))
            rows = [[int(is_inside(contours, (x + .5) * unit, (y + .5) * unit))
                     for x in range(-PX, 2 * PX)]
                    for y in range(2 * PX - 1, -PX - 1, -1)]
            source.glyphs[code] = (Picture(-PX, -2 * PX, rows),
                                   outlines.advance(glyph) / unit)
        for fit in ("", ":none"):
            font = self.font(path, None, "--chars", "0x21-0x7E,0xA1-0xA7",
                             "--strike", f"{PX}:1{fit}", "--strike-only")
            self.check(font, source)
        print(f"{file}: {len(source.glyphs)} characters of {PX} px")


def main():
    global FILE, PX
    test_strikes.FONTGEN, FILE = sys.argv[1:3]
    PX = int(sys.argv[3])
    unittest.main(argv=sys.argv[:1])


if __name__ == "__main__":
    main()
