"""Strikes, read as docs/FORMAT.md states them, and fonts of strikes alone."""
import struct
from typing import NamedTuple

from squares import require

ENTRY_BYTES = 32


class Picture(NamedTuple):
    left: int
    top: int
    rows: list  # of values


class Strike(NamedTuple):
    px: int
    bits: int
    fit: int
    pictures: dict  # by glyph; those without one are left out


def signed_8(value):
    return value - (value >> 7 << 8)


class Bits:
    """Numbers of a bit stream, the lowest bits first; zeros follow."""

    def __init__(self, data):
        self.data, self.at = data, 0

    def take(self, width):
        first, self.at = self.at, self.at + width
        part = self.data[first // 8:(self.at + 7) // 8]
        return (int.from_bytes(part, "little") >> first % 8
                & (1 << width) - 1)


def read_rows(data, width, height, bits, guesses):
    stream = Bits(data)
    rows = []
    for y in range(height):
        if y != 0 and stream.take(1):
            rows.append(rows[-1])
            continue
        row = []
        for x in range(width):
            if bits == 1:
                row.append(stream.take(1))
                continue
            left = row[-1] if row else 0
            above = rows[-1][x] if rows else 0
            if stream.take(1):
                context = 4 * (left >> bits - 2) + (above >> bits - 2)
                guess = guesses >> 2 * context & 3
                row.append((0, (1 << bits) - 1, above, left)[guess])
            else:
                row.append(stream.take(bits))
        rows.append(row)
    return rows


def box_in_pixels(metrics, unit):
    """left, top, width and height of a glyph by its metrics. [px]"""
    _, *box = metrics
    require(20, unit in (1, 2) and all(side % unit == 0 for side in box))
    x_min, y_min, x_max, y_max = (side // unit for side in box)
    return x_min, -y_max, x_max - x_min, y_max - y_min


def read_strikes(data, metrics=None, units_per_em=0):
    """The strikes of a section STRK, or of GLYF where they are alone: `metrics`
    has the boxes then."""
    zero, count = struct.unpack_from("<HH", data)
    require(19, zero == 0 and len(data) >= 4 + ENTRY_BYTES * count)
    strikes = []
    for i in range(count):
        (px, bits, fit, first, glyphs, coding, *widths, left_base, top_base,
         step, reserved, guesses, boxes, base) = struct.unpack_from(
             "<HBBHHB5BBBHHIII", data, 4 + ENTRY_BYTES * i)
        require(19, 4 <= px <= 255 and bits in (1, 2, 4) and fit <= 3)
        require(19, coding == 0 and reserved == 0)
        require(19, all(a <= b for a, b in zip(widths, (9, 9, 8, 8, 25))))
        require(19, bits != 1 or guesses == 0)
        table = Bits(data[boxes:])
        rows = [[table.take(width) for width in widths]
                for _ in range(glyphs + 1)]
        require(20, rows[-1][:4] == [0, 0, 0, 0])
        begins = [(base + (n * step >> 8) + row[4]) & 0xffffffff
                  for n, row in enumerate(rows)]
        require(20, begins == sorted(begins) and begins[-1] <= len(data))
        pictures = {}
        for n, (left, top, width, height, _) in enumerate(rows[:-1]):
            left, top = signed_8(left_base) + left, signed_8(top_base) + top
            if metrics is not None:
                require(19, widths[:4] == [0] * 4 and left == top == 0)
                require(20, units_per_em % px == 0)
                left, top, width, height = box_in_pixels(
                    metrics[first + n], units_per_em // px)
            if width != 0:
                pictures[first + n] = Picture(
                    left, top,
                    read_rows(data[begins[n]:begins[n + 1]], width, height,
                              bits, guesses))
        strikes.append(Strike(px, bits, fit, pictures))
    return strikes
