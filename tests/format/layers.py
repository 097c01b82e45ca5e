"""Layers of glyphs of several colours, read as docs/FORMAT.md states them."""
import struct
from typing import NamedTuple

from squares import require
from strikes import Bits

HEADER_BYTES = 8
MOST_LAYERS = 64
FAINTEST = 254


class Layers(NamedTuple):
    palettes: list  # of lists of (red, green, blue, opacity)
    lists: dict  # of (glyph, colour), the lowest first, by glyph


def read_layers(data, glyph_count):
    require(24, len(data) >= HEADER_BYTES)
    count, colours, palettes, *widths = struct.unpack_from("<HHBBBB", data)
    glyph_bits, colour_bits, start_bits = widths
    require(24, count > 0 and (colours == 0) == (palettes == 0))
    require(24, max(glyph_bits, colour_bits) <= 16 and start_bits <= 25)
    end = HEADER_BYTES + 4 * colours * palettes
    table = Bits(data[end:])
    rows = [(table.take(glyph_bits), table.take(start_bits))
            for _ in range(count + 1)]
    layers = [(table.take(glyph_bits), table.take(colour_bits))
              for _ in range(rows[-1][1])]
    require(24, (table.at + 7) // 8 <= len(data) - end)
    glyphs = [glyph for glyph, _ in rows[:-1]]
    require(24, glyphs == sorted(set(glyphs)) and rows[0][1] == 0)
    require(24, all(1 <= after - start <= MOST_LAYERS
                    for (_, start), (_, after) in zip(rows, rows[1:])))
    require(24, max(glyphs) < glyph_count)
    require(24, all(glyph < glyph_count and colour <= colours + FAINTEST
                    for glyph, colour in layers))
    bytes_of = [data[HEADER_BYTES + 4 * i:HEADER_BYTES + 4 * i + 4]
                for i in range(colours * palettes)]
    return Layers(
        [[tuple(colour) for colour in bytes_of[colours * i:colours * (i + 1)]]
         for i in range(palettes)],
        {glyph: layers[start:after]
         for (glyph, start), (_, after) in zip(rows, rows[1:])})
