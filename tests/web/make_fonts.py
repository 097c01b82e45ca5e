"""Makes fonts that the page must read: WOFF, one with an axis, a collection.

Usage: make_fonts.py <folder> <TrueType font>
"""
import sys

from fontTools.fontBuilder import FontBuilder
from fontTools.pens.ttGlyphPen import TTGlyphPen
from fontTools.ttLib import TTCollection, TTFont
from fontTools.ttLib.tables.TupleVariation import TupleVariation


def square(side):
    pen = TTGlyphPen(None)
    pen.moveTo((100, 0))
    pen.lineTo((100, side))
    pen.lineTo((100 + side, side))
    pen.lineTo((100 + side, 0))
    pen.closePath()
    return pen.glyph()


def variable():
    """Digits that are squares, wider with the weight."""
    names = [".notdef", "space", *(f"digit{n}" for n in range(10))]
    builder = FontBuilder(1000, isTTF=True)
    builder.setupGlyphOrder(names)
    builder.setupCharacterMap({0x20: "space",
                               **{0x30 + n: f"digit{n}" for n in range(10)}})
    builder.setupGlyf({name: TTGlyphPen(None).glyph() if name == "space" else
                       square(300 + 20 * i) for i, name in enumerate(names)})
    builder.setupHorizontalMetrics({name: (800, 100) for name in names})
    builder.setupHorizontalHeader(ascent=800, descent=-200)
    builder.setupNameTable({"familyName": "Squares", "styleName": "Regular"})
    builder.setupOS2()
    builder.setupPost()
    builder.setupFvar([("wght", 100, 400, 900, "Weight")], [])
    moves = [(0, 0), (0, 0), (200, 0), (200, 0)] + [(0, 0)] * 4
    builder.setupGvar({name: [TupleVariation({"wght": (0, 1, 1)}, moves)]
                       for name in names if name != "space"})
    return builder.font


def main():
    folder, source = sys.argv[1:]
    font = TTFont(source)
    font.flavor = "woff"
    font.save(f"{folder}/sans.woff")
    variable().save(f"{folder}/variable.ttf")
    collection = TTCollection()
    collection.fonts = [TTFont(source), TTFont(f"{folder}/variable.ttf")]
    collection.save(f"{folder}/both.ttc")


if __name__ == "__main__":
    main()
