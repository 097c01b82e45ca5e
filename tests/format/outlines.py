"""Section CODE, and records of outlines and composites."""
import struct
from fractions import Fraction
from typing import NamedTuple

from squares import require

OFF_CURVE, SMOOTH, CORNER, END = range(4)
NAMES = ("off", "smooth", "corner")


class CodeWord(NamedTuple):
    length: int
    kind: int
    x_bits: int
    y_bits: int
    change: int  # of the table's number


def read_code(data, code_bits):
    """The tables of section CODE."""
    require(15, 1 <= code_bits <= 7)
    table_bytes = 2 << code_bits
    require(15, len(data) in [table_bytes << i for i in range(4)])
    return [read_table(data[at:at + table_bytes], code_bits,
                       len(data) // table_bytes)
            for at in range(0, len(data), table_bytes)]


def read_table(data, code_bits, tables):
    entries = [entry for entry, in struct.iter_unpack("<H", data)]
    words = [CodeWord(entry & 7, entry >> 3 & 3, entry >> 5 & 15,
                      entry >> 9 & 15, entry >> 13) for entry in entries]
    for number, (entry, word) in enumerate(zip(entries, words)):
        require(15, word.change < tables)
        require(15, 1 <= word.length <= code_bits)
        require(15, word.kind != END or word.x_bits == word.y_bits == 0)
        # All entries that begin with the word are equal, or with its bits and
        # the first one of its numbers.
        count = 1 << (code_bits - word.length)
        if word.x_bits or word.y_bits:
            count = max(count // 2, 1)
        first = number // count * count
        require(15, entries[first:first + count] == [entry] * count)
    return words


class Bits:
    """Bits from the highest of a byte to its lowest; zeros after the end."""

    def __init__(self, data):
        self.data = data
        self.at = 0

    def u(self, count):
        value = 0
        for _ in range(count):
            byte = self.at // 8
            bit = 0
            if byte < len(self.data):
                bit = self.data[byte] >> (7 - self.at % 8) & 1
            value = value << 1 | bit
            self.at += 1
        return value

    def s(self, count):
        value = self.u(count)
        return value - (value >> (count - 1) << count) if count else 0

    def word(self, table):
        code_bits = len(table).bit_length() - 1
        at = self.at
        word = table[self.u(code_bits)]
        self.at = at + word.length
        return word


class Point(NamedTuple):
    x: int  # grid units of an outline; font units of a glyph
    y: int
    kind: int

    def __str__(self):
        return f"{self.x} {self.y} {NAMES[self.kind]}"


def is_outline(record):
    return len(record) > 0 and record[0] >= 0x80


def record_start(x_min, y_min, grid_shift):
    """The position before the first point. [grid units]"""
    if grid_shift < 0:
        return x_min << -grid_shift, y_min << -grid_shift
    return x_min >> grid_shift, y_min >> grid_shift


def read_outline(record, code, start, max_points):
    """The contours of a record: lists of points in grid units; and the bits that
    they take."""
    require(16, is_outline(record))
    bits = Bits(record)
    bits.u(1)
    x, y = start
    contours = []
    points = []
    table = 0
    for _ in range(max_points):
        word = bits.word(code[table])
        table ^= word.change
        if word.kind == END:
            require(16, points)
            contours.append(points)
            points = []
            if not bits.u(1):
                return contours, bits.at
        else:
            x += bits.s(word.x_bits)
            y += bits.s(word.y_bits)
            require(16, points or word.kind == CORNER)
            points.append(Point(x, y, word.kind))
    return require(16, False)


def count_points(contours):
    """As max_points counts them."""
    return sum(len(points) + 1 for points in contours)


class Component(NamedTuple):
    glyph: int
    dx: int  # [font units]
    dy: int
    matrix: tuple = (1, 0, 0, 1)  # xx, xy, yx, yy

    def place(self, point):
        """A point of the component in the composite. [font units]"""
        xx, xy, yx, yy = self.matrix
        return Point(xx * point.x + xy * point.y + self.dx,
                     yx * point.x + yy * point.y + self.dy, point.kind)


def read_composite(record):
    bits = Bits(record)
    require(12, bits.u(8) == 3)
    components = []
    more = 1
    while more:
        glyph = bits.u(16)
        has_matrix = bits.u(1)
        width = bits.u(4)
        component = Component(glyph, bits.s(width), bits.s(width))
        if has_matrix:
            component = component._replace(matrix=tuple(
                Fraction(bits.s(16), 2**14) for _ in range(4)))
        components.append(component)
        more = bits.u(1)
    return components


class OutlineFont(NamedTuple):
    """What the records of an outline font need to be read."""
    code: list
    grid_shift: int
    max_points: int
    records: list
    metrics: list  # of each glyph: advance, x_min, y_min, x_max, y_max

    def simple(self, number):
        """Contours of a glyph whose record is an outline. [font units]"""
        start = record_start(*self.metrics[number][1:3], self.grid_shift)
        unit = Fraction(2)**self.grid_shift
        return [[Point(x * unit, y * unit, kind) for x, y, kind in points]
                for points in read_outline(self.records[number], self.code,
                                           start, self.max_points)[0]]

    def bits(self, number):
        """Bits of a record before its hints; None: a composite, or nothing."""
        record = self.records[number]
        return read_outline(record, self.code, (0, 0), self.max_points)[1] \
            if is_outline(record) else None

    def contours(self, number):
        """Contours of any glyph. [font units]"""
        record = self.records[number]
        if not record:
            return []
        if is_outline(record):
            return self.simple(number)
        contours = []
        for component in read_composite(record):
            require(17, component.glyph < len(self.records))
            require(17, is_outline(self.records[component.glyph]))
            xx, xy, yx, yy = component.matrix
            require(17, xx * yy > xy * yx)
            contours += [[component.place(point) for point in points]
                         for points in self.simple(component.glyph)]
        require(17, count_points(contours) <= self.max_points)
        return contours


def curves(points):
    """The lines and quadratics of a contour, as tuples of (x, y)."""
    result = []
    begin = points[0][:2]
    control = None
    for point in [*points[1:], points[0]]:
        place = point[:2]
        if point.kind == OFF_CURVE:
            if control is not None:
                middle = tuple(Fraction(a + b) / 2
                               for a, b in zip(control, place))
                result.append((begin, control, middle))
                begin = middle
            control = place
        else:
            result.append((begin, place) if control is None else
                          (begin, control, place))
            begin = place
            control = None
    return result
