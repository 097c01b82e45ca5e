"""Outlines of a WOFF file, as far as a test of pixel fonts needs them: simple
glyphs, whose points are corners, and characters of Unicode's first plane."""
import struct
import zlib


class WoffOutlines:
    def __init__(self, data):
        assert data[:4] == b"wOFF" and data[4:8] == b"\0\1\0\0"
        self.tables = {}
        for i in range(struct.unpack_from(">H", data, 12)[0]):
            tag, offset, packed, size, _ = struct.unpack_from(
                ">4sIIII", data, 44 + 20 * i)
            table = data[offset:offset + packed]
            self.tables[tag] = (table if packed == size
                                else zlib.decompress(table))
        head = self.tables[b"head"]
        self.units_per_em, = struct.unpack_from(">H", head, 18)
        count, = struct.unpack_from(">H", self.tables[b"maxp"], 4)
        if struct.unpack_from(">h", head, 50)[0]:
            self.places = struct.unpack_from(f">{count + 1}I",
                                             self.tables[b"loca"])
        else:
            self.places = [2 * half for half in struct.unpack_from(
                f">{count + 1}H", self.tables[b"loca"])]
        self.metrics, = struct.unpack_from(">H", self.tables[b"hhea"], 34)
        self.glyph_of = self.read_cmap(self.tables[b"cmap"])

    @staticmethod
    def read_cmap(cmap):
        """The characters of the subtable of format 4."""
        for i in range(struct.unpack_from(">H", cmap, 2)[0]):
            at, = struct.unpack_from(">I", cmap, 8 + 8 * i)
            if struct.unpack_from(">H", cmap, at)[0] == 4:
                break
        else:
            raise ValueError("no subtable of format 4")
        twice, = struct.unpack_from(">H", cmap, at + 6)
        starts = at + 16 + twice
        glyph_of = {}
        for i in range(0, twice, 2):
            end, = struct.unpack_from(">H", cmap, at + 14 + i)
            start, = struct.unpack_from(">H", cmap, starts + i)
            delta, offset = (struct.unpack_from(
                ">H", cmap, starts + n * twice + i)[0] for n in (1, 2))
            for code in range(start, min(end, 0xFFFE) + 1):
                glyph = code
                if offset:
                    glyph, = struct.unpack_from(
                        ">H", cmap,
                        starts + 2 * twice + i + offset + 2 * (code - start))
                if glyph or not offset:
                    glyph_of[code] = (glyph + delta) & 0xFFFF
        return glyph_of

    def advance(self, glyph):
        row = min(glyph, self.metrics - 1)
        return struct.unpack_from(">H", self.tables[b"hmtx"], 4 * row)[0]

    def contours(self, glyph):
        """Lists of points (x, y)."""
        data = self.tables[b"glyf"][self.places[glyph]:self.places[glyph + 1]]
        if not data:
            return []
        count, = struct.unpack_from(">h", data)
        assert count >= 0, "a composite"
        ends = struct.unpack_from(f">{count}H", data, 10)
        at = 10 + 2 * count
        at += 2 + struct.unpack_from(">H", data, at)[0]
        flags = []
        while len(flags) <= ends[-1]:
            flag, at = data[at], at + 1
            assert flag & 1, "a curve"
            repeats = 0
            if flag & 8:
                repeats, at = data[at], at + 1
            flags += [flag] * (repeats + 1)
        axes = []
        for short, same in ((2, 16), (4, 32)):
            value, axis = 0, []
            for flag in flags:
                if flag & short:
                    value += data[at] if flag & same else -data[at]
                    at += 1
                elif not flag & same:
                    value += struct.unpack_from(">h", data, at)[0]
                    at += 2
                axis.append(value)
            axes.append(axis)
        points = list(zip(*axes))
        return [points[begin:end + 1] for begin, end in
                zip((0, *(end + 1 for end in ends)), ends)]


def is_inside(contours, x, y):
    """Whether a point has ink, by the rule of non-zero winding."""
    winding = 0
    for points in contours:
        for (x0, y0), (x1, y1) in zip(points, (*points[1:], points[0])):
            if (y0 <= y) != (y1 <= y):
                if x0 + (y - y0) * (x1 - x0) / (y1 - y0) > x:
                    winding += 1 if y1 > y0 else -1
    return winding != 0
