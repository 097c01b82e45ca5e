#!/usr/bin/env python3
"""Section GRID and hints, written bit by bit and read by the second decoder."""
import random
import struct
import unittest

from grid import Edge, Height, Stem, grid_listing, read_grid
from squares import Refused

BASELINE = struct.pack("<hbB", 0, -15, 0)
X_HEIGHT = struct.pack("<hbB", 560, 14, 1)
# Each table has one word without bits, for numbers of a fixed width.
WIDTHS = (9, 8, 10, 7, 10, 7)


def record(outline_bits, *fields):
    """Bits of an outline, 0, then hints of (value, bits): with their count."""
    number = 0
    at = 0
    for value, width in fields:
        number |= value << at
        at += width
    size = (outline_bits + at + 7) // 8
    return number.to_bytes(size, "big"), outline_bits


def section(header=(2, 1, 92, 80, 1, 0, 64, 70)):
    tables = struct.pack("<6H", *(width << 3 for width in WIDTHS))
    return bytes(header) + BASELINE + X_HEIGHT + tables


# An 'e' of a face, a symmetric glyph, and one without a record.
RECORDS = [
    record(20, (0x80 | 5 << 3 | 1, 9), (4, 6), (0, 6),
           (1 << 1 | 1, 8), (0, 7),
           (3 << 6 | 0x20, 8), (306 - 248, 10),
           (1 << 6, 8), (400 - 306, 10), (14, 7),
           (0x20 | 2 << 1 | 1, 8), (38, 7),
           (2 << 6 | 2 << 1, 8),
           (284 - 280, 10), (0, 7)),
    record(9, (0x100, 9)),
    (b"", None),
]


class Grid(unittest.TestCase):
    def test_all_kinds(self):
        hints = read_grid(section(), RECORDS)
        first, second, third = hints.glyphs
        self.assertEqual(first.insets, (8, 0))
        self.assertEqual(first.heights, [
            Height(0, 0, Edge(0, True, -15), 80),
            Height(3, 1, Edge(None, False, 100), 0),
            Height(1, 0, Edge(None, False, 288), 28),
            Height(0, 1, Edge(1, True, 574), 76),
            Height(2, 0, Edge(1, False, 560), 0)])
        self.assertEqual(first.heights[0].edges(), (-15, 65))
        self.assertEqual(first.heights[3].edges(), (498, 574))
        self.assertEqual(first.stems, [Stem(56, 92)])
        self.assertTrue(second.is_symmetric)
        self.assertEqual((third.heights, third.stems), ([], []))
        lines = list(grid_listing(hints))
        self.assertIn("zone 560 14 top", lines)
        self.assertIn("  bar 498 to 574 zone 1 round", lines)
        self.assertIn("  end at 100 rises", lines)

    def test_refusal(self):
        good = section()
        for at, byte in ((0, 9), (4, 2), (5, 8), (5, 1), (16, 9 << 3 | 1)):
            data = bytearray(good)
            data[at] = byte
            with self.assertRaises(Refused):
                read_grid(bytes(data), RECORDS)
        for size in (7, 15, len(good) - 1):
            with self.assertRaises(Refused):
                read_grid(good[:size], RECORDS)
        # A byte between the outline and the hints.
        with self.assertRaises(Refused):
            read_grid(good, [(b"\0" + RECORDS[0][0], RECORDS[0][1])])
        self.assertIsNone(read_grid(b"", RECORDS))

    def test_any_bytes(self):
        random_bytes = random.Random(3)
        for _ in range(1000):
            data = bytearray(section())
            data[random_bytes.randrange(len(data))] = (
                random_bytes.randrange(256))
            changed = bytearray(RECORDS[0][0])
            changed[random_bytes.randrange(len(changed))] = (
                random_bytes.randrange(256))
            try:
                list(grid_listing(read_grid(bytes(data),
                                            [(bytes(changed), 20)])))
            except Refused as refused:
                self.assertEqual(refused.args[0], 14)


if __name__ == "__main__":
    unittest.main()
