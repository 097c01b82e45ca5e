"""Section GRID, and the hints at the end of each glyph's record."""
import struct
from typing import NamedTuple, Optional

from squares import require

BAR, SERIF, LONE_EDGE, FREE_END = range(4)
HEADS, HEIGHTS, GAPS_Y, WIDTHS_Y, GAPS_X, WIDTHS_X = range(6)
HEIGHT_NAMES = ("bar", "serif", "edge", "end")
NO_ZONE = 255


class Zone(NamedTuple):
    flat: int  # [u]
    overshoot: int
    is_top: bool


class Edge(NamedTuple):
    zone: Optional[int]
    is_round: bool
    position: int  # [u]


class Height(NamedTuple):
    kind: int
    flag: int  # the top edge is stored; of a free end: it rises
    edge: Edge
    width: int  # [u] 0 for lone edges and free ends

    def edges(self):
        """The lower and the upper edge."""
        at = self.edge.position
        return (at - self.width, at) if self.flag else (at, at + self.width)

    def __str__(self):
        text = HEIGHT_NAMES[self.kind]
        if self.kind in (BAR, SERIF):
            text += " {} to {}".format(*self.edges())
        else:
            text += f" at {self.edge.position}"
        if self.kind == FREE_END:
            text += " rises" if self.flag else " hangs"
        if self.edge.zone is not None:
            text += f" zone {self.edge.zone}"
            text += " round" if self.edge.is_round else " flat"
        return text


class Stem(NamedTuple):
    position: int  # [u]
    width: int

    def __str__(self):
        return f"stem {self.position} to {self.position + self.width}"


class GlyphHints(NamedTuple):
    is_symmetric: bool
    insets: tuple  # left, right [u]
    heights: list
    stems: list


class GridHints(NamedTuple):
    zones: list
    flags: int
    stem_width: int
    bar_width: int
    x_zone: int
    firsts: tuple  # y, x [2 u]
    tables: list
    glyphs: list


class BackwardBits:
    """Bits of a record from its last byte to its first, the lowest first."""

    def __init__(self, record):
        self.bits = int.from_bytes(record, "big")
        self.at = 0

    def u(self, count):
        value = self.bits >> self.at & ((1 << count) - 1)
        self.at += count
        return value

    def number(self, table):
        entry = table[self.bits >> self.at & (len(table) - 1)]
        self.at += entry & 7
        return (entry >> 7) + self.u(entry >> 3 & 15)


class RecordReader:
    def __init__(self, record, hints):
        self.bits = BackwardBits(record)
        self.hints = hints

    def number(self, table):
        return self.bits.number(self.hints.tables[table])

    def width(self, table, standard):
        return 2 * (self.number(table) & 127) or standard

    def height(self, y):
        """The height, and where the next gap begins. [2 u]"""
        word = self.number(HEIGHTS)
        kind, flag = word >> 6 & 3, word >> 5 & 1
        zone, is_round = (word >> 1 & 15) - 1, bool(word & 1)
        if zone >= 0:
            require(14, zone < len(self.hints.zones))
            place = self.hints.zones[zone]
            at = place.flat + (place.overshoot if is_round else 0)
            edge = Edge(zone, is_round, at)
        else:
            at = 2 * ((y + self.number(GAPS_Y)) % 1024) - 512
            edge = Edge(None, is_round, at)
        width = (self.width(WIDTHS_Y, self.hints.bar_width)
                 if kind in (BAR, SERIF) else 0)
        height = Height(kind, flag, edge, width)
        low = height.edges()[0] if kind in (BAR, SERIF) else at
        return height, (low + 512) // 2

    def glyph(self):
        head = self.number(HEADS)
        insets = (0, 0)
        if head & 0x80:
            insets = (2 * self.bits.u(6), 2 * self.bits.u(6))
        heights = []
        y, x = self.hints.firsts
        for _ in range(head >> 3 & 15):
            height, y = self.height(y)
            heights.append(height)
        stems = []
        for _ in range(head & 7):
            left = 2 * ((x + self.number(GAPS_X)) % 1024) - 512
            stem = Stem(left, self.width(WIDTHS_X, self.hints.stem_width))
            stems.append(stem)
            x = (left + stem.width + 512) // 2
        return GlyphHints(bool(head & 0x100), insets, heights, stems)


def read_tables(data, code_bits):
    require(14, code_bits <= 7 and len(data) >= 12 << code_bits)
    size = 1 << code_bits
    entries = struct.unpack_from(f"<{6 * size}H", data)
    tables = [entries[i:i + size] for i in range(0, 6 * size, size)]
    for table in tables:
        for number, entry in enumerate(table):
            require(14, entry & 7 <= code_bits)
            require(14, table[number & ((1 << (entry & 7)) - 1)] == entry)
    return tables


def read_grid(data, records):
    """None if the font has no such section. `records`: of each glyph, with the
    bits before its hints; those of composites are not counted."""
    if not data:
        return None
    require(14, len(data) >= 8)
    count, flags, stem, bar, x_zone, code_bits, first_y, first_x = data[:8]
    require(14, count <= 8)
    require(14, x_zone == NO_ZONE or x_zone < count)
    tables_at = 8 + 4 * count
    require(14, tables_at <= len(data))
    zones = [Zone(flat, overshoot, bool(zone_flags & 1))
             for flat, overshoot, zone_flags in struct.iter_unpack(
                 "<hbB", data[8:tables_at])]
    hints = GridHints(zones, flags, stem, bar, x_zone,
                      (4 * first_y, 4 * first_x),
                      read_tables(data[tables_at:], code_bits), [])
    for record, bits in records:
        if not record:
            hints.glyphs.append(GlyphHints(False, (0, 0), [], []))
            continue
        reader = RecordReader(record, hints)
        glyph = reader.glyph()
        size = ((bits or 0) + reader.bits.at + 7) // 8
        require(14, size == len(record) or (bits is None and
                                            size < len(record)))
        lows = [height.edges()[0] if height.kind in (BAR, SERIF)
                else height.edge.position for height in glyph.heights]
        require(14, lows == sorted(lows))
        ends = [at for one in glyph.stems
                for at in (one.position, one.position + one.width)]
        require(14, all(a < b for a, b in zip(ends[1::2], ends[2::2])))
        hints.glyphs.append(glyph)
    return hints


def grid_listing(hints):
    """The hints as lines."""
    yield (f"grid flags {hints.flags} stems {hints.stem_width} bars "
           f"{hints.bar_width} x-height {hints.x_zone}")
    for zone in hints.zones:
        side = "top" if zone.is_top else "bottom"
        yield f"zone {zone.flat} {zone.overshoot} {side}"
    for number, glyph in enumerate(hints.glyphs):
        yield (f"hints {number} symmetric {int(glyph.is_symmetric)} insets "
               f"{glyph.insets[0]} {glyph.insets[1]}")
        for hint in glyph.heights + glyph.stems:
            yield f"  {hint}"
