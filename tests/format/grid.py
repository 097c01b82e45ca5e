"""Section GRID: zones of the face and hints of each glyph."""
import struct
from typing import NamedTuple, Optional

from outlines import Bits
from squares import require

BAR, SERIF, LONE_EDGE, FREE_END = range(4)
STEM, FOOT = range(2)
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


class Across(NamedTuple):
    kind: int
    position: int  # [u]
    width: int

    def __str__(self):
        if self.kind == FOOT:
            return f"foot at {self.position}"
        return f"stem {self.position} to {self.position + self.width}"


class GlyphHints(NamedTuple):
    is_symmetric: bool
    insets: tuple  # left, right [u]
    heights: list
    across: list


class GridHints(NamedTuple):
    zones: list
    flags: int
    stem_width: int
    bar_width: int
    x_zone: int
    glyphs: list


class RecordReader:
    def __init__(self, record, hints):
        self.bits = Bits(record)
        self.hints = hints

    def position(self):
        return 2 * self.bits.u(10) - 512

    def zone_edge(self):
        number = self.bits.u(3)
        is_round = bool(self.bits.u(1))
        require(14, number < len(self.hints.zones))
        zone = self.hints.zones[number]
        return Edge(number, is_round,
                    zone.flat + (zone.overshoot if is_round else 0))

    def edge(self):
        if self.bits.u(1):
            return self.zone_edge()
        return Edge(None, False, self.position())

    def width(self, standard):
        return standard if self.bits.u(1) else 2 * self.bits.u(7)

    def height(self):
        kind = self.bits.u(2)
        if kind in (BAR, SERIF):
            flag = self.bits.u(1)
            edge = self.edge()
            return Height(kind, flag, edge, self.width(self.hints.bar_width))
        if kind == LONE_EDGE:
            return Height(kind, 0, self.zone_edge(), 0)
        flag = self.bits.u(1)
        return Height(kind, flag, Edge(None, False, self.position()), 0)

    def across(self):
        kind = self.bits.u(1)
        position = self.position()
        if kind == FOOT:
            return Across(kind, position, 0)
        return Across(kind, position, self.width(self.hints.stem_width))

    def glyph(self):
        is_symmetric = bool(self.bits.u(1))
        has_insets = self.bits.u(1)
        heights = self.bits.u(4)
        across = self.bits.u(3)
        insets = (0, 0)
        if has_insets:
            insets = (2 * self.bits.u(6), 2 * self.bits.u(6))
        return GlyphHints(is_symmetric, insets,
                          [self.height() for _ in range(heights)],
                          [self.across() for _ in range(across)])


def read_grid(data, glyph_count, bit_table):
    """None if the font has no such section. `bit_table` reads numbers of the
    container's tables."""
    if not data:
        return None
    require(14, len(data) >= 8)
    count, flags, stem, bar, x_zone, offset_bits, _ = struct.unpack_from(
        "<6BH", data)
    require(14, count <= 8 and offset_bits <= 20)
    require(14, x_zone == NO_ZONE or x_zone < count)
    table_at = 8 + 4 * count
    records_at = table_at + (offset_bits * (glyph_count + 1) + 7) // 8
    require(14, records_at <= len(data))
    zones = [Zone(flat, overshoot, bool(zone_flags & 1))
             for flat, overshoot, zone_flags in struct.iter_unpack(
                 "<hbB", data[8:table_at])]
    table = bit_table(data[table_at:records_at])
    ends = [table.get(i * offset_bits, offset_bits)
            for i in range(glyph_count + 1)]
    require(14, ends == sorted(ends))
    require(14, records_at + ends[-1] <= len(data))
    hints = GridHints(zones, flags, stem, bar, x_zone, [])
    for begin, end in zip(ends, ends[1:]):
        record = data[records_at + begin:records_at + end]
        hints.glyphs.append(RecordReader(record, hints).glyph())
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
        for hint in glyph.heights + glyph.across:
            yield f"  {hint}"
