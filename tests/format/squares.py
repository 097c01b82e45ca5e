"""Squares of glyphs and what fills them; records of type 1."""
import struct
from typing import NamedTuple


class Refused(Exception):
    """Bytes that are no font, by the number of the rule they break."""


def require(rule, holds):
    if not holds:
        raise Refused(rule)


class Samples(NamedTuple):
    centre: int
    offsets: tuple  # d1 d2 d3 d4 d6 d7 d8 d9

    def __str__(self):
        return f"samples {self.centre} " + " ".join(map(str, self.offsets))

    def distance(self, x, y, size):
        """x, y: 0 to 1 across the cell."""
        def weights(t):
            return (1 - t) * (1 - 2 * t), 4 * t * (1 - t), t * (2 * t - 1)
        offsets = (*self.offsets[:4], 0, *self.offsets[4:])
        above = sum(wy * wx * offsets[3 * j + i]
                    for j, wy in enumerate(weights(y))
                    for i, wx in enumerate(weights(x)))
        return self.centre / 64 + above * size / 128


class Square(NamedTuple):
    x: int
    y: int
    size: int
    content: object  # "outside", "inside" or Samples

    def __str__(self):
        return f"{self.x} {self.y} {self.size} {self.content}"


class Grid(NamedTuple):
    x0: int
    y0: int
    tile_log2: int
    tiles_x: int
    tiles_y: int

    def fits(self, limit=15360):
        width, height = (n << self.tile_log2
                         for n in (self.tiles_x, self.tiles_y))
        return (self.tile_log2 <= 11 and
                -limit <= self.x0 and self.x0 + width <= limit and
                -limit <= self.y0 and self.y0 + height <= limit)

    def squares(self, reference_of_tile, resolve):
        """All cells, tile by tile. `resolve` makes four references or a content
        of a reference."""
        found = []

        def visit(reference, x, y, size):
            content = resolve(reference)
            if not isinstance(content, list):
                found.append(Square(x, y, size, content))
                return
            require(13, size > 1)
            half = size // 2
            for child, at in enumerate(content):
                visit(at, x + child % 2 * half, y + child // 2 * half, half)

        size = 1 << self.tile_log2
        for row in range(self.tiles_y):
            for column in range(self.tiles_x):
                visit(reference_of_tile(row * self.tiles_x + column),
                      self.x0 + column * size, self.y0 + row * size, size)
        return found


def read_grid(record):
    log2, x0, y0, tiles_x, tiles_y = struct.unpack_from("<BhhBB", record, 1)
    return Grid(x0, y0, log2 & 0x7f, tiles_x, tiles_y)


class Reader:
    """Numbers from a record, one after the other."""

    def __init__(self, record, at):
        self.record = record
        self.at = at

    def take(self, layout, count=1):
        """`count` tuples of struct's letters `layout`."""
        size = struct.calcsize("<" + layout)
        end = self.at + size * count
        require(12, end <= len(self.record))
        part = self.record[self.at:end]
        self.at = end
        return list(struct.iter_unpack("<" + layout, part))


def read_squares(record):
    """Type 1."""
    if not record:
        return []
    require(12, len(record) >= 10 and record[0] == 1 and record[1] < 0x80)
    grid = read_grid(record)
    require(12, grid.fits())
    tiles = grid.tiles_x * grid.tiles_y
    reader = Reader(record, 8)
    (nodes, cells), = reader.take("2H")
    references = [n for n, in reader.take("H", tiles + 4 * nodes)]
    leaves = [Samples(row[0], row[1:]) for row in reader.take("h8b", cells)]
    next_node = 0

    def resolve(reference):
        nonlocal next_node
        if reference < 2:
            return ("outside", "inside")[reference]
        if reference >= 0x8000:
            require(13, reference - 0x8000 < len(leaves))
            return leaves[reference - 0x8000]
        require(13, reference - 2 == next_node < nodes)
        next_node += 1
        at = tiles + 4 * (reference - 2)
        return references[at:at + 4]

    squares = grid.squares(references.__getitem__, resolve)
    require(13, next_node == nodes)
    return squares
