"""Reads fonts of X11 in PCF: pictures and advances by code point."""
import struct

from strikes import Picture

METRICS, BITMAPS, ENCODINGS = 1 << 2, 1 << 3, 1 << 5
COMPRESSED, BIG_BYTES, HIGH_BITS = 0x100, 1 << 2, 1 << 3


class Table:
    """Numbers of a table, which says in which order their bytes are."""

    def __init__(self, data, kind):
        _, count = struct.unpack_from("<4sI", data)
        entries = [struct.unpack_from("<4I", data, 8 + 16 * i)
                   for i in range(count)]
        self.data = data
        self.at = next(at for found, _, _, at in entries if found == kind)
        self.order = "<"
        self.form, = self.take("I")
        self.order = ">" if self.form & BIG_BYTES else "<"

    def take(self, types):
        size = struct.calcsize("<" + types)
        self.at += size
        return struct.unpack_from(self.order + types, self.data,
                                  self.at - size)


def read_metrics(data):
    """Of each glyph where its columns begin and end, advance, ascent, descent."""
    table = Table(data, METRICS)
    if table.form & COMPRESSED:
        count, = table.take("H")
        return [[byte - 0x80 for byte in table.take("5B")]
                for _ in range(count)]
    count, = table.take("I")
    return [table.take("5hH")[:5] for _ in range(count)]


def read_pcf(data):
    metrics = read_metrics(data)
    table = Table(data, BITMAPS)
    # Bytes of 8 pixels, from the highest bit on.
    assert table.form & HIGH_BITS and table.form >> 4 & 3 == 0
    count, = table.take("I")
    offsets = table.take(f"{count}I")
    table.take("4I")
    glyphs = []
    for (left, right, advance, ascent, descent), offset in zip(
            metrics, offsets):
        width, pad = right - left, 1 << (table.form & 3)
        stride = (width + 8 * pad - 1) // (8 * pad) * pad
        rows = []
        for y in range(ascent + descent):
            begin = table.at + offset + y * stride
            bits = int.from_bytes(data[begin:begin + stride], "big")
            rows.append([bits >> (8 * stride - 1 - x) & 1
                         for x in range(width)])
        glyphs.append((Picture(left, -ascent, rows), advance))
    table = Table(data, ENCODINGS)
    low_min, low_max, high_min, high_max, _ = table.take("5H")
    return {high << 8 | low: glyphs[index]
            for high in range(high_min, high_max + 1)
            for low in range(low_min, low_max + 1)
            for index in table.take("H") if index != 0xffff}
