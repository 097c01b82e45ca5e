"""Squares of glyphs and what fills them; records of types 1 and 2."""
import math
import struct
from typing import NamedTuple


class Refused(Exception):
    """Bytes that are no font, by the number of the rule they break."""


def require(rule, holds):
    if not holds:
        raise Refused(rule)


class Field(NamedTuple):
    """A line, or an arc, as the stored integers say."""
    nx: int
    ny: int
    c: int
    along: int = None
    k: int = None

    def __str__(self):
        return "(" + " ".join(str(n) for n in self if n is not None) + ")"

    def value_and_gradient(self, x, y):
        nx, ny, c = self.nx / 2**14, self.ny / 2**14, self.c / 16
        value = nx * x + ny * y + c
        if self.k is None:
            return value, (nx, ny)
        w = nx * y - ny * x + self.along / 16
        k = self.k / 2**19
        slope = 2 * k * w
        return value + k * w * w, (nx - slope * ny, ny + slope * nx)


def least(one, other):
    """Two values with their gradients: the lesser, rounded at the vertex."""
    (a, g), (b, h) = one, other
    c = g[0] * h[0] + g[1] * h[1]
    if (min(a, b) < 0 and a - c * b <= 0 and b - c * a <= 0 and
            1 - c * c >= 0.022):
        return -math.hypot(a, (b - c * a) / math.sqrt(1 - c * c))
    return min(a, b)


def negated(term):
    return -term[0], (-term[1][0], -term[1][1])


NAMES = ("min", "max", "min_max", "max_min")


class Fields(NamedTuple):
    operator: int  # of one field: 0
    fields: tuple

    def __str__(self):
        name = "single" if len(self.fields) == 1 else NAMES[self.operator]
        return name + " " + " ".join(map(str, self.fields))

    def distance(self, x, y):
        terms = [field.value_and_gradient(x, y) for field in self.fields]
        if len(terms) == 1:
            return terms[0][0]
        sign = -1 if self.operator in (1, 3) else 1
        if sign < 0:
            terms = [negated(term) for term in terms]
        if self.operator >= 2:
            # All is negated once more than in the min of f0 and the inner.
            inner = -least(negated(terms[1]), negated(terms[2]))
            active = terms[1] if terms[1][0] >= terms[2][0] else terms[2]
            terms = [terms[0], (inner, active[1])]
        elif len(terms) == 3:
            greatest = max(range(3), key=lambda i: (terms[i][0], i))
            del terms[greatest]
        return sign * least(*terms)


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
    content: object  # "outside", "inside", Samples or Fields

    def __str__(self):
        return f"{self.x} {self.y} {self.size} {self.content}"


class Grid(NamedTuple):
    x0: int
    y0: int
    tile_log2: int
    tiles_x: int
    tiles_y: int

    def fits(self, limit):
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


def check_normal(field):
    require(14, (2**14 - 2**8)**2 <= field.nx**2 + field.ny**2
            <= (2**14 + 2**8)**2)
    return field


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


def numbered_squares(record):
    """Type 1, and the narrow form of type 2."""
    has_fields = record[0] == 2
    require(12, record[0] in (1, 2))
    require(12, has_fields or record[1] < 0x80)
    grid = read_grid(record)
    require(12, grid.fits(1984 if has_fields else 15360))
    tiles = grid.tiles_x * grid.tiles_y
    reader = Reader(record, 8)
    if has_fields:
        (nodes, arcs, lines, pairs, triples), = reader.take("5H")
        require(14, 2 + nodes + arcs + lines + pairs + triples <= 256)
        fields = [Field(*row) for row in reader.take("5h", arcs)]
        fields += [Field(*row) for row in reader.take("3h", lines)]
        triples = reader.take("4B", triples)
        pairs = reader.take("2B", pairs)
        first_leaf = 2 + nodes
        for field in fields:
            check_normal(field)
        leaves = [Fields(0, (field,)) for field in fields]
        for row in pairs:
            leaves.append(combination(int(row[0] > row[1]), row, fields))
        for operator, *row in triples:
            leaves.append(combination(operator, row, fields))
        references = [n for n, in reader.take("B", tiles + 4 * nodes)]
    else:
        (nodes, cells), = reader.take("2H")
        references = [n for n, in reader.take("H", tiles + 4 * nodes)]
        leaves = [Samples(row[0], row[1:]) for row in reader.take("h8b", cells)]
        first_leaf = 0x8000
    next_node = 0

    def resolve(reference):
        nonlocal next_node
        if reference < 2:
            return ("outside", "inside")[reference]
        if reference >= first_leaf:
            require(13, reference - first_leaf < len(leaves))
            return leaves[reference - first_leaf]
        require(13, reference - 2 == next_node < nodes)
        next_node += 1
        at = tiles + 4 * (reference - 2)
        return references[at:at + 4]

    squares = grid.squares(references.__getitem__, resolve)
    require(13, next_node == nodes)
    return squares


def combination(operator, numbers, fields):
    require(14, operator < 4 and max(numbers) < len(fields))
    if len(numbers) == 2 and numbers[0] == numbers[1]:
        return Fields(0, (fields[numbers[0]],))
    return Fields(operator, tuple(fields[n] for n in numbers))


def linked_squares(record):
    grid = read_grid(record)
    require(12, grid.fits(1984))
    reader = Reader(record, 8)
    (heap_units,), = reader.take("H")
    tiles = grid.tiles_x * grid.tiles_y
    require(12, tiles <= heap_units <= 8192)
    heap = [n for n, in reader.take("H", heap_units)]
    next_node = tiles

    def units(first, count):
        require(13, first + count <= len(heap))
        return heap[first:first + count]

    def field(unit):
        numbers = units(unit & 0x1fff, 5 if unit & 0x8000 else 3)
        return check_normal(
            Field(*struct.unpack(f"<{len(numbers)}h",
                                 struct.pack(f"<{len(numbers)}H", *numbers))))

    def resolve(reference):
        nonlocal next_node
        if reference < 2:
            return ("outside", "inside")[reference]
        tag, first = reference >> 13, reference & 0x1fff
        if tag == 1:
            require(13, first >= next_node)
            next_node = first + 4
            return units(first, 4)
        if tag in (2, 3):
            return Fields(0, (field(first | (tag == 3) << 15),))
        require(13, tag in (4, 5, 6))
        numbers = units(first, 4 if tag == 6 else 2)
        operator = numbers.pop(0) if tag == 6 else tag - 4
        require(14, operator < 4)
        named = [n & 0x9fff for n in numbers]
        if tag != 6 and named[0] == named[1]:
            return Fields(0, (field(named[0]),))
        return Fields(operator, tuple(map(field, named)))

    return grid.squares(heap.__getitem__, resolve)
