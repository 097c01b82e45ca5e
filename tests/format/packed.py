"""Records of type 3: packed cells of fields."""
import math
import pathlib
import struct

from squares import Field, Fields, Grid, Square, require

CONTENT = ("split", "outside", "inside", "single", "min2", "max2", "min3",
           "max3", "min_max", "max_min")
SINES = [round(32768 * math.sin(math.pi / 2 * i / 256)) for i in range(257)]


DOCUMENT = pathlib.Path(__file__).parents[2] / "docs/FORMAT.md"


def make_code(lengths):
    """From words, as their lengths and values, to symbols."""
    code = {}
    word = 0
    previous = 0
    for length, symbol in sorted((int(length), symbol)
                                 for symbol, length in enumerate(lengths)
                                 if length != "-"):
        word = word + 1 if code else 0
        word <<= length - previous
        previous = length
        code[length, word] = symbol
    return code


def read_codes():
    """The codes of the document's tables: rows such as | kind 1 | - | 2 |"""
    codes = {"node": [], "kind": [], "rank": []}
    for line in DOCUMENT.read_text().splitlines():
        name, *lengths = (part.strip() for part in line.strip("|").split("|"))
        kind, _, context = name.partition(" ")
        if kind in codes and context == str(len(codes[kind])):
            codes[kind].append(make_code(lengths))
    return codes


CODES = read_codes()


class Bits:
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

    def code(self, name, context):
        code = CODES[name][context]
        length = word = 0
        while (length, word) not in code:
            word = word << 1 | self.u(1)
            length += 1
        return code[length, word]


class Quantisation:
    def __init__(self, data):
        (self.d0_step, self.bend_step, self.d0_base, self.d0_log2,
         self.angle_base, _, self.bend_bits) = struct.unpack("<6BH", data)

    def widths(self, log2):
        level = min(3, max(0, 8 - log2))
        return (min(16, self.d0_base + max(0, log2 - self.d0_log2)),
                min(16, self.angle_base + max(0, log2 - 5)),
                self.bend_bits >> 4 * level & 15)


def normal(turn):
    def mix(a, b, f):
        return (64 * a + (b - a) * f + 64) >> 7
    t = turn % 2**14
    i, f = t >> 6, t % 64
    nx = mix(SINES[256 - i], SINES[255 - i], f)
    ny = mix(SINES[i], SINES[i + 1], f)
    if turn >> 14 & 1:
        nx, ny = -ny, nx
    if turn >> 15 & 1:
        nx, ny = -nx, -ny
    return nx, ny


def to_i16(sum_q14):
    sum_q14 = (sum_q14 + 2**31) % 2**32 - 2**31
    return max(-32768, min(32767, sum_q14 >> 10))


class Expansion:
    """The cells of some rows, and the units of the heap that they take."""

    def __init__(self, quantisation, units):
        self.quantisation = quantisation
        self.units = units
        self.squares = []
        self.recent = []

    def take(self, units):
        self.units += units
        require(15, self.units <= 8192)

    def field(self, bits, kind, log2, x, y):
        q = self.quantisation
        d0_bits, angle_bits, low_bits = q.widths(log2)
        d0 = bits.u(d0_bits) - (1 << d0_bits) // 2
        turn = (bits.u(angle_bits) << (16 - angle_bits) if kind >= 2 else
                bits.u(2) << 14)
        k = 0
        if kind % 2:
            ones = 0
            while bits.u(1):
                ones += 1
                require(15, ones < 16)
            bend = ((ones << low_bits) + bits.u(low_bits) + 1) * q.bend_step
            bend = -bend if bits.u(1) else bend
            e = 13 - 2 * max(5, log2 - 1)
            k = bend << e if e >= 0 else (bend + 2**(-e - 1)) >> -e
            k = max(-32767, min(32767, k))
        nx, ny = normal(turn)
        c = to_i16(256 * d0 * q.d0_step - (nx * x + ny * y) + 512)
        if k == 0:
            self.take(3)
            return Field(nx, ny, c)
        self.take(5)
        return Field(nx, ny, c, to_i16(512 - (nx * y - ny * x)), k)

    def square(self, bits, log2, x, y):
        content = CONTENT[bits.code("node", min(8 - log2, 6))]
        if content == "split":
            require(15, log2 > 0)
            self.take(4)
            half = 1 << (log2 - 1)
            for child in range(4):
                self.square(bits, log2 - 1, x + child % 2 * half,
                            y + child // 2 * half)
            return
        if content not in ("outside", "inside"):
            content = self.cell(bits, content, log2, x, y)
        self.squares.append(Square(x, y, 1 << log2, content))

    def cell(self, bits, name, log2, x, y):
        groups = {"single": [1], "min2": [2], "max2": [2], "min3": [3],
                  "max3": [3], "min_max": [1, 2], "max_min": [1, 2]}[name]
        used = []  # entries of the list: fields are told apart by identity
        half = (1 << log2) // 2
        for size in groups:
            rank = -1
            after_new = False
            for place in range(size):
                kind = bits.code("kind", 2 * len(used) + after_new)
                if kind == 0:
                    rank += 1 + bits.code("rank", int(place > 0))
                    require(15, rank < len(self.recent))
                    entry = self.recent[rank]
                    require(15, all(entry is not other for other in used))
                    used.append(entry)
                else:
                    used.append([self.field(bits, kind - 1, log2, x + half,
                                            y + half)])
                    after_new = True
        for entry in reversed(used):
            self.recent = [entry] + [old for old in self.recent
                                     if old is not entry]
        del self.recent[16:]
        self.take({1: 0, 2: 2, 3: 4}[len(used)])
        operator = {"max2": 1, "max3": 1, "min_max": 2, "max_min": 3}
        return Fields(operator.get(name, 0), tuple(field for field, in used))


def packed_squares(record, quantisation, workspace, row_workspace):
    require(12, len(record) >= 5)
    corner = int.from_bytes(record[2:5], "little")
    x0, y0 = ((n ^ 0x800) - 0x800 for n in (corner & 0xfff, corner >> 12))
    grid = Grid(x0, y0, 8, record[1] & 15, record[1] >> 4)
    require(12, grid.tiles_x > 0 and grid.tiles_y > 0 and grid.fits(1984))
    layout = "<%d%s" % (grid.tiles_y - 1, "H" if record[0] & 0x80 else "B")
    at = 5 + struct.calcsize(layout)
    require(12, at <= len(record))
    lengths = struct.unpack_from(layout, record, 5)

    bits = Bits(record[at:])
    shared = Expansion(quantisation, 0)
    log2 = 8 + (max(grid.tiles_x, grid.tiles_y) - 1).bit_length()
    fields = [[shared.field(bits, bits.u(2), log2, x0 + 128 * grid.tiles_x,
                            y0 + 128 * grid.tiles_y)]
              for _ in range(bits.u(4))]
    at += (bits.at + 7) // 8
    require(15, at <= len(record))

    squares = []
    whole = shared.units
    for row in range(grid.tiles_y):
        end = len(record) if row == len(lengths) else at + lengths[row]
        require(15, end <= len(record))
        expansion = Expansion(quantisation, shared.units)
        expansion.recent = list(fields)
        expansion.take(grid.tiles_x)
        bits = Bits(record[at:end])
        for column in range(grid.tiles_x):
            expansion.square(bits, 8, x0 + 256 * column, y0 + 256 * row)
        require(15, 2 * expansion.units <= row_workspace)
        squares += expansion.squares
        whole += expansion.units - shared.units
        at = end
    require(15, whole <= 8192 and 2 * whole <= workspace)
    return squares
