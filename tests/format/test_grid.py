#!/usr/bin/env python3
"""Section GRID, written bit by bit and read by the second decoder."""
import random
import struct
import unittest

from decoder import BitTable
from grid import Across, Edge, Height, grid_listing, read_grid
from squares import Refused

BASELINE = struct.pack("<hbB", 0, -15, 0)
X_HEIGHT = struct.pack("<hbB", 560, 14, 1)


def record(*fields):
    """A record of (value, bits)."""
    bits = "".join(format(value, f"0{width}b") for value, width in fields)
    bits += "0" * (-len(bits) % 8)
    return bytes(int(bits[i:i + 8], 2) for i in range(0, len(bits), 8))


def section(records, header=(2, 1, 92, 80, 1)):
    ends = [0]
    for each in records:
        ends.append(ends[-1] + len(each))
    width = ends[-1].bit_length()
    table = sum(end << width * i for i, end in enumerate(ends))
    table = table.to_bytes((width * len(ends) + 7) // 8, "little")
    return (struct.pack("<6BH", *header, width, 0) + BASELINE + X_HEIGHT +
            table + b"".join(records))


# An 'e' of a face, a diagonal, and a glyph without hints.
RECORDS = [
    record((0, 1), (1, 1), (5, 4), (1, 3), (4, 6), (0, 6),
           (0, 2), (0, 1), (1, 1), (0, 3), (1, 1), (1, 1),
           (3, 2), (1, 1), (306, 10),
           (1, 2), (0, 1), (0, 1), (400, 10), (0, 1), (14, 7),
           (2, 2), (1, 3), (0, 1),
           (0, 2), (1, 1), (1, 1), (1, 3), (1, 1), (0, 1), (38, 7),
           (0, 1), (284, 10), (1, 1)),
    record((1, 1), (0, 1), (0, 4), (1, 3), (1, 1), (256, 10)),
    b"",
]


class Grid(unittest.TestCase):
    def test_all_kinds(self):
        hints = read_grid(section(RECORDS), 3, BitTable)
        first, second, third = hints.glyphs
        self.assertEqual(first.insets, (8, 0))
        self.assertEqual(first.heights, [
            Height(0, 0, Edge(0, True, -15), 80),
            Height(3, 1, Edge(None, False, 100), 0),
            Height(1, 0, Edge(None, False, 288), 28),
            Height(2, 0, Edge(1, False, 560), 0),
            Height(0, 1, Edge(1, True, 574), 76)])
        self.assertEqual(first.heights[0].edges(), (-15, 65))
        self.assertEqual(first.heights[4].edges(), (498, 574))
        self.assertEqual(first.across, [Across(0, 56, 92)])
        self.assertTrue(second.is_symmetric)
        self.assertEqual(second.across, [Across(1, 0, 0)])
        self.assertEqual((third.heights, third.across), ([], []))
        lines = list(grid_listing(hints))
        self.assertIn("zone 560 14 top", lines)
        self.assertIn("  bar 498 to 574 zone 1 round", lines)
        self.assertIn("  end at 100 rises", lines)

    def test_refusal(self):
        good = section(RECORDS)
        for at, byte in ((0, 9), (4, 2), (5, 21), (5, 20)):
            data = bytearray(good)
            data[at] = byte
            with self.assertRaises(Refused):
                read_grid(bytes(data), 3, BitTable)
        for size in (7, 15, len(good) - 1):
            with self.assertRaises(Refused):
                read_grid(good[:size], 3, BitTable)
        self.assertIsNone(read_grid(b"", 3, BitTable))

    def test_any_bytes(self):
        random_bytes = random.Random(3)
        for _ in range(1000):
            data = bytearray(section(RECORDS))
            data[random_bytes.randrange(len(data))] = (
                random_bytes.randrange(256))
            try:
                list(grid_listing(read_grid(bytes(data), 3, BitTable)))
            except Refused as refused:
                self.assertEqual(refused.args[0], 14)


if __name__ == "__main__":
    unittest.main()
