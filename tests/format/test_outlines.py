"""Outlines and composites as docs/FORMAT.md states them: its examples, and
records that are read back."""
import pathlib
import random
import re
import struct
import unittest
from fractions import Fraction

from outlines import (CORNER, END, OFF_CURVE, SMOOTH, Component, OutlineFont,
                      Point, count_points, curves, read_code, read_composite,
                      read_outline, record_start)
from squares import Refused

DOCUMENT = pathlib.Path(__file__).parents[2] / "docs/FORMAT.md"


def example(title):
    """Bytes of an example of the document."""
    text = DOCUMENT.read_text().split("#### " + title + "\n", 1)[1]
    line = re.search(r"^    0000  ((?:[0-9a-f]{2} ?)+)", text, re.MULTILINE)
    return bytes.fromhex(line.group(1))


CODE = read_code(example("Example of a code"), 2)
TRIANGLE = [Point(20, 0, CORNER), Point(420, 0, CORNER),
            Point(220, 500, CORNER)]


class Writer:
    def __init__(self):
        self.bits = ""

    def u(self, count, value):
        self.bits += format(value, f"0{count}b") if count else ""

    def s(self, count, value):
        self.u(count, value % (1 << count))

    def bytes(self):
        size = (len(self.bits) + 7) // 8
        return bytes(int(self.bits.ljust(8 * size, "0")[8 * i:8 * i + 8], 2)
                     for i in range(size))


def wide_code():
    """A word of 2 bits for each kind, with numbers of 15 bits."""
    return read_code(
        struct.pack("<4H", *[2 | kind << 3 |
                             (0 if kind == END else 15 << 5 | 15 << 9)
                             for kind in range(4)]), 2)


def write_outline(contours, start):
    writer = Writer()
    writer.u(1, 1)
    x, y = start
    for i, points in enumerate(contours):
        for point in points:
            writer.u(2, point.kind)
            writer.s(15, point.x - x)
            writer.s(15, point.y - y)
            x, y, _ = point
        writer.u(2, END)
        writer.u(1, int(i + 1 < len(contours)))
    return writer.bytes()


class Examples(unittest.TestCase):
    def test_code(self):
        self.assertEqual(CODE, [[(2, END, 0, 0, 0), (2, OFF_CURVE, 8, 8, 0),
                                 (2, CORNER, 10, 0, 0),
                                 (2, CORNER, 9, 10, 0)]])

    def test_outline(self):
        record = example("Example of an outline")
        self.assertEqual(read_outline(record, CODE, (20, 0), 4)[0], [TRIANGLE])
        with self.assertRaises(Refused):
            read_outline(record, CODE, (20, 0), 3)

    def test_composite(self):
        self.assertEqual(read_composite(example("Example of a composite")),
                         [Component(69, 0, 0), Component(123, 40, -3)])


class Records(unittest.TestCase):
    def test_random_outlines(self):
        code = wide_code()
        source = random.Random(1)
        for _ in range(200):
            reach = 1 << source.randrange(14)
            contours = []
            for _ in range(source.randrange(1, 6)):
                contours.append([
                    Point(source.randrange(-reach, reach),
                          source.randrange(-reach, reach),
                          source.randrange(3) if i else CORNER)
                    for i in range(source.randrange(1, 20))])
            record = write_outline(contours, (-reach, -reach))
            count = count_points(contours)
            self.assertEqual(
                read_outline(record, code, (-reach, -reach), count)[0],
                contours)

    def test_records_end_where_their_zeros_begin(self):
        record = example("Example of an outline")
        self.assertEqual(
            read_outline(record + bytes(2), CODE, (20, 0), 4)[0],
            [TRIANGLE])
        self.assertEqual(read_composite(bytes((3,))), [Component(0, 0, 0)])

    def test_first_points(self):
        self.assertEqual(record_start(-5, 7, 1), (-3, 3))
        self.assertEqual(record_start(-5, 7, -1), (-10, 14))
        smooth = write_outline([[Point(0, 0, SMOOTH)]], (0, 0))
        with self.assertRaises(Refused):
            read_outline(smooth, wide_code(), (0, 0), 9)

    def test_codes_that_are_none(self):
        table = example("Example of a code")
        for at, byte in (0, 0x18), (0, 0x1b), (0, 0x3a), (1, 0x20), (0, 0x19):
            data = bytearray(table)
            data[at] = byte
            with self.assertRaises(Refused, msg=(at, byte)):
                read_code(bytes(data), 2)
        for wrong, bits in (table, 3), (table * 3, 2), (table * 16, 2):
            with self.assertRaises(Refused):
                read_code(wrong, bits)

    def test_words_tell_the_next_table_and_share_a_bit(self):
        # Lines along x: in table 0 of 4 bits, then in table 1 of 3 bits if dx
        # is not negative, else of 6 bits, and back to table 0.
        end, line = 1 | END << 3, 1 | CORNER << 3 | 1 << 13
        code = read_code(struct.pack(
            "<8H", *[end] * 2, *[line | 4 << 5] * 2,
            *[end] * 2, line | 3 << 5, line | 6 << 5), 2)
        writer = Writer()
        for value, width in (1, 1), (-8, 4), (3, 3), (-1, 4), (-32, 6):
            if width > 1:
                writer.u(1, 1)
            writer.s(width, value)
        writer.u(2, 0)
        points = [Point(x, 0, CORNER) for x in (-8, -5, -6, -38)]
        self.assertEqual(read_outline(writer.bytes(), code, (0, 0), 5)[0],
                         [points])

    def test_composites(self):
        writer = Writer()
        writer.u(8, 3)
        writer.u(16, 0)
        writer.u(1, 1)
        writer.u(4, 5)
        writer.s(5, -10)
        writer.s(5, 7)
        for value in 0, -2**14, 2**13, 0:
            writer.s(16, value)
        writer.u(1, 1)
        writer.u(16, 0)
        writer.u(6, 0)
        records = [example("Example of an outline"), writer.bytes(), b""]
        metrics = [(500, 20, 0, 420, 500)] * 3
        font = OutlineFont(CODE, 0, 8, records, metrics)
        self.assertEqual(font.contours(0), [TRIANGLE])
        self.assertEqual(font.contours(1), [
            [Point(-10, 17, CORNER), Point(-10, 217, CORNER),
             Point(-510, 117, CORNER)], TRIANGLE])
        self.assertEqual(font.contours(2), [])
        with self.assertRaises(Refused):
            font._replace(max_points=7).contours(1)
        for wrong in b"\x03\x00\x01", b"\x03\x00\x03", b"\x03\x00\x02":
            with self.assertRaises(Refused):
                font._replace(records=[*records[:2], b"", wrong],
                              metrics=metrics + metrics).contours(3)


class Curves(unittest.TestCase):
    def test_lines_and_quadratics(self):
        self.assertEqual(curves(TRIANGLE), [
            ((20, 0), (420, 0)), ((420, 0), (220, 500)),
            ((220, 500), (20, 0))])

    def test_implied_points(self):
        points = [Point(0, 0, CORNER), Point(4, 0, OFF_CURVE),
                  Point(4, 7, OFF_CURVE)]
        middle = (4, Fraction(7, 2))
        self.assertEqual(curves(points), [((0, 0), (4, 0), middle),
                                          (middle, (4, 7), (0, 0))])


if __name__ == "__main__":
    unittest.main()
