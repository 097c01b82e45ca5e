"""A second decoder of Inkcell fonts, written from docs/FORMAT.md alone.

It refuses what `Font::verify` must refuse; numbers in its messages are those
of the document's list. `listing` is everything that a font says, as lines.
"""
import struct
import zlib
from typing import NamedTuple

from grid import grid_listing, read_grid
from outlines import OutlineFont, read_code
from squares import read_squares, require
from strikes import read_strikes

HEADER_BYTES = 64
SAMPLES = 0
OUTLINE = 2
STRIKE = 3


class Glyph(NamedTuple):
    metrics: tuple  # advance, x_min, y_min, x_max, y_max
    squares: list  # of cells
    contours: list  # of outlines: lists of points in font units


class Header(NamedTuple):
    glyph_count: int
    units_per_em: int
    coding: int
    grid_shift: int
    code_bits: int
    max_points: int


class BitTable:
    """Numbers of stated widths without gaps, the lowest bits first."""

    def __init__(self, data):
        self.data = data
        self.size = 8 * len(data)

    def get(self, at, width):
        if width > 25 or at + width > self.size:
            return 0
        part = int.from_bytes(self.data[at // 8:(at + width + 7) // 8],
                              "little")
        return part >> at % 8 & ((1 << width) - 1)


def signed(value, bits=16):
    value &= (1 << bits) - 1
    return value - (value >> (bits - 1) << bits)


def read_header(data):
    require(1, len(data) >= HEADER_BYTES)
    require(2, data[:6] == b"INKC\x03\x00")
    header_bytes, total_bytes, header_crc, content_crc = struct.unpack_from(
        "<HIII", data, 6)
    section_count = struct.unpack_from("<H", data, 42)[0]
    require(3, section_count <= 32)
    require(3, header_bytes == HEADER_BYTES + 12 * section_count)
    require(3, header_bytes <= total_bytes <= len(data))
    require(4, header_crc == zlib.crc32(data[:12] + data[16:header_bytes]))
    glyph_count, units_per_em = struct.unpack_from("<HH", data, 20)
    header = Header(glyph_count, units_per_em, data[39],
                    *struct.unpack_from("<bBH", data, 60))
    require(5, header.coding in (SAMPLES, OUTLINE, STRIKE))
    require(7, glyph_count > 0 and units_per_em <= 16384)
    require(7, units_per_em >= (16 if data[39] == OUTLINE else 4))
    sections = read_directory(data[:total_bytes], section_count)
    require(9, content_crc == zlib.crc32(data[header_bytes:total_bytes]))
    return header, sections


def read_directory(data, section_count):
    sections = {}
    for i in range(section_count):
        tag, place, size = struct.unpack_from("<4sII", data,
                                              HEADER_BYTES + 12 * i)
        offset = place & ~1
        require(6, offset % 4 == 0 and offset + size <= len(data))
        known = tag in (b"CMAP", b"CPAG", b"METR", b"KERN", b"GRID", b"CODE",
                        b"GLYF", b"NAME")
        require(6, known or place % 2 == 0)
        sections.setdefault(tag, data[offset:offset + size])
    return sections


def read_cmap(data, glyph_count):
    require(10, len(data) % 8 == 0)
    glyph_of = {}
    end = 0
    for first, extra, glyph in struct.iter_unpack("<IHH", data):
        require(10, end <= first <= 0x10ffff)
        require(10, glyph + extra < glyph_count)
        end = first + extra + 1
        for step in range(extra + 1):
            glyph_of[first + step] = glyph + step
    return glyph_of


def read_code_pages(data, glyph_count):
    if not data:
        return {}
    require(10, len(data) >= 6)
    first_page, count, glyph_base = struct.unpack_from("<3H", data)
    header_bytes = 8 + 2 * count
    require(10, count > 0 and first_page + count <= 0x1100)
    require(10, header_bytes <= len(data))
    starts = struct.unpack_from(f"<{count + 1}H", data, 6)
    require(10, starts[0] == header_bytes and starts[-1] == len(data))
    require(10, list(starts) == sorted(starts))
    first_glyph = (glyph_base + header_bytes) % 65536
    require(10, first_glyph + len(data) - header_bytes <= glyph_count)
    glyph_of = {}
    for page, (begin, end) in enumerate(zip(starts, starts[1:]), first_page):
        low = list(data[begin:end])
        require(10, low == sorted(set(low)))
        for at in range(begin, end):
            glyph_of[page << 8 | data[at]] = first_glyph + at - header_bytes
    return glyph_of


def read_metrics(data, glyph_count):
    require(8, len(data) >= 17)
    *bases, advances = struct.unpack_from("<6H", data)
    widths = data[12:17]
    bits = widths[0] * advances + sum(widths[1:]) * glyph_count
    require(8, (bits + 7) // 8 <= len(data) - 17)
    require(11, max(widths) <= 16 and advances <= glyph_count)
    table = BitTable(data[17:])
    rows = []
    at = 0
    for glyph in range(glyph_count):
        row = []
        for column, (base, width) in enumerate(zip(bases, widths)):
            width = 0 if column == 0 and glyph >= advances else width
            row.append(base + table.get(at, width))
            at += width
        rows.append((row[0] & 0xffff, *map(signed, row[1:])))
    return rows


def read_kerning(data, glyph_count):
    """The value of each pair of glyphs that kerns."""
    if not data:
        return {}
    require(11, len(data) >= 17)
    (pair_count, member_count, left_classes, right_classes,
     base) = struct.unpack_from("<IHHHH", data)
    glyph_bits, left_bits, right_bits, value_bits, start_bits = data[12:17]
    require(11, pair_count <= 4194303 and start_bits <= 25)
    require(11, max(glyph_bits, left_bits, right_bits, value_bits) <= 16)
    member_bits = glyph_bits + left_bits + right_bits
    starts_at = member_count * member_bits
    pairs_at = starts_at + (left_classes + 1) * start_bits
    pair_bits = right_bits + value_bits
    end = pairs_at + pair_count * pair_bits
    require(11, (end + 7) // 8 <= len(data) - 17)
    table = BitTable(data[17:])

    lefts = {}  # class -> glyphs
    rights = {}
    previous = -1
    for i in range(member_count):
        at = i * member_bits
        glyph = table.get(at, glyph_bits)
        left = table.get(at + glyph_bits, left_bits)
        right = table.get(at + glyph_bits + left_bits, right_bits)
        require(11, previous < glyph < glyph_count)
        require(11, left <= left_classes and right <= right_classes)
        lefts.setdefault(left, []).append(glyph)
        rights.setdefault(right, []).append(glyph)
        previous = glyph
    starts = [table.get(starts_at + i * start_bits, start_bits)
              for i in range(left_classes + 1)]
    require(11, starts[0] == 0 and starts[-1] == pair_count)
    require(11, starts == sorted(starts))
    values = {}
    for left in range(1, left_classes + 1):
        previous = 0
        for i in range(starts[left - 1], starts[left]):
            at = pairs_at + i * pair_bits
            right = table.get(at, right_bits)
            require(11, previous < right <= right_classes)
            previous = right
            value = signed(base + table.get(at + right_bits, value_bits))
            for a in lefts.get(left, []):
                for b in rights.get(right, []):
                    values[a, b] = value
    return values


def read_records(data, header):
    count = header.glyph_count
    require(8, len(data) >= 2)
    width, unit_log2 = data[:2]
    table_bytes = (width * (count + 1) + 7) // 8
    require(8, table_bytes <= len(data) - 2)
    require(11, width <= 25 and unit_log2 <= 7)
    table = BitTable(data[2:])
    ends = [table.get(i * width, width) << unit_log2 for i in range(count + 1)]
    require(12, ends[0] >= 2 + table_bytes and ends[-1] <= len(data))
    require(12, ends == sorted(ends))
    records = [data[a:b] for a, b in zip(ends, ends[1:])]
    for record, at in zip(records, ends):
        require(12, not record or header.coding == OUTLINE or at % 2 == 0)
    return records


class Font:
    def __init__(self, data):
        header, sections = read_header(data)
        require(5, header.coding != STRIKE)  # StrikeFont reads those
        require(8, b"METR" in sections and b"GLYF" in sections)
        count = header.glyph_count
        self.glyph_of = read_code_pages(sections.get(b"CPAG", b""), count)
        self.glyph_of.update(read_cmap(sections.get(b"CMAP", b""), count))
        self.kerning = read_kerning(sections.get(b"KERN", b""), count)
        self.hints = None
        self.name = sections.get(b"NAME", b"").decode(
            errors="surrogateescape")
        metrics = read_metrics(sections[b"METR"], count)
        records = read_records(sections[b"GLYF"], header)
        if header.coding == OUTLINE:
            require(15, -4 <= header.grid_shift <= 3)
            code = read_code(sections.get(b"CODE", b""), header.code_bits)
            outlines = OutlineFont(code, header.grid_shift, header.max_points,
                                   records, metrics)
            self.glyphs = [Glyph(row, [], outlines.contours(number))
                           for number, row in enumerate(metrics)]
            self.hints = read_grid(
                sections.get(b"GRID", b""),
                [(record, outlines.bits(number))
                 for number, record in enumerate(records)])
        else:
            self.glyphs = [Glyph(row, read_squares(record), [])
                           for row, record in zip(metrics, records)]


class StrikeFont:
    """A font of strikes alone."""

    def __init__(self, data):
        header, sections = read_header(data)
        count = header.glyph_count
        require(5, header.coding == STRIKE)
        self.units_per_em = header.units_per_em
        self.glyph_of = read_code_pages(sections.get(b"CPAG", b""), count)
        self.glyph_of.update(read_cmap(sections.get(b"CMAP", b""), count))
        self.kerning = read_kerning(sections.get(b"KERN", b""), count)
        self.metrics = read_metrics(sections[b"METR"], count)
        self.strikes = read_strikes(sections[b"GLYF"], self.metrics,
                                    self.units_per_em)


def listing(font):
    yield "name " + font.name
    for code_point, glyph in sorted(font.glyph_of.items()):
        yield f"code point {code_point:x} {glyph}"
    for (left, right), value in sorted(font.kerning.items()):
        if value != 0:
            yield f"kerning {left} {right} {value}"
    if font.hints is not None:
        yield from grid_listing(font.hints)
    for number, glyph in enumerate(font.glyphs):
        yield f"glyph {number} " + " ".join(map(str, glyph.metrics))
        for square in glyph.squares:
            yield str(square)
        for contour in glyph.contours:
            yield "contour"
            for point in contour:
                yield str(point)
