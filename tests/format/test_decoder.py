#!/usr/bin/env python3
"""Two decoders, of which one was written from docs/FORMAT.md alone, read the
same fonts and refuse the same bytes.

    test_decoder.py --dump DUMP_CELLS FONT...
"""
import argparse
import pathlib
import random
import struct
import subprocess
import sys
import tempfile
import unittest
import zlib

import decoder
from packed import CODES, CONTENT, Quantisation
from squares import Refused, Samples

REFUSED = 3
DUMP = None
FONTS = []


def device(data, *options):
    """The lines that the device's reader makes of a font; None: refused."""
    with tempfile.NamedTemporaryFile() as file:
        file.write(data)
        file.flush()
        done = subprocess.run([DUMP, file.name, *options],
                              stdout=subprocess.PIPE)
    if done.returncode == REFUSED:
        return None
    done.check_returncode()
    return done.stdout.decode(errors="surrogateescape").split("\n")


def own(data):
    """The same lines by the other decoder."""
    try:
        lines = decoder.listing(decoder.Font(data))
    except Refused:
        return None
    return "".join(line + "\n" for line in lines).split("\n")


def with_checksums(data):
    """A font whose checksums are right again."""
    data = bytearray(data)
    header_bytes, total_bytes = struct.unpack_from("<HI", data, 6)
    struct.pack_into("<I", data, 16,
                     zlib.crc32(data[header_bytes:total_bytes]))
    struct.pack_into("<I", data, 12,
                     zlib.crc32(data[:12] + data[16:header_bytes]))
    return bytes(data)


def section(data, tag):
    """Where a section lies: offset and size."""
    count = struct.unpack_from("<H", data, 42)[0]
    for i in range(count):
        name, place, size = struct.unpack_from("<4sII", data, 76 + 12 * i)
        if name == tag:
            return place & ~1, size
    raise AssertionError(f"no {tag}")


def font_where(holds):
    for path in FONTS:
        data = path.read_bytes()
        if holds(data):
            return data
    raise AssertionError("no such font in the golden set")


def is_packed(data):
    return data[40] == 1


def is_linked(data):
    return data[40] == 0 and any(
        record[:1] == b"\x02" and record[1] & 0x80 for record in records(data))


def is_narrow(data):
    return data[40] == 0 and not is_linked(data) and any(
        record[:1] == b"\x02" for record in records(data))


def is_samples(data):
    return data[39] == 0


def records(data):
    offset, size = section(data, b"GLYF")
    header, _ = decoder.read_header(data)
    return decoder.read_records(data[offset:offset + size], header)


def record_at(data, number):
    """Where the number-th record that is not empty begins."""
    found = [record for record in records(data) if record][number]
    return data.index(found, section(data, b"GLYF")[0])


class Agreement(unittest.TestCase):
    def test_the_set_holds_every_kind_of_record(self):
        for holds in (is_packed, is_linked, is_narrow, is_samples):
            font_where(holds)

    def test_every_cell_of_every_font(self):
        for path in FONTS:
            data = path.read_bytes()
            lines = own(data)
            self.assertIsNotNone(lines, path.name)
            self.assertEqual(lines, device(data), path.name)
            self.assertEqual(lines, device(data, "--rows"), path.name)

    def test_packed_fonts_hold_the_cells_of_direct_ones(self):
        def cells(path):
            for number, glyph in enumerate(decoder.Font(path.read_bytes())
                                           .glyphs):
                for x, y, size, content in glyph.squares:
                    # The narrow form states the operator of a pair by order.
                    if not isinstance(content, str) and content.operator < 2:
                        fields = sorted(map(str, content.fields))
                        content = (content.operator, fields)
                    yield number, x, y, size, str(content)

        packed = [path for path in FONTS if is_packed(path.read_bytes())]
        for path in packed:
            direct = path.with_name(path.name.replace("_packed", ""))
            self.assertNotEqual(direct, path)
            self.assertEqual(list(cells(path)), list(cells(direct)), path.name)

    def test_packed_rows_one_by_one_in_little_ram(self):
        """Each row of a packed font fits what its header states, and one unit
        less is too little for the largest."""
        data = bytearray(font_where(is_packed))
        for place in (60, 64):
            stated, = struct.unpack_from("<I", data, place)
            less = bytearray(data)
            struct.pack_into("<I", less, place, stated - 2)
            less = with_checksums(less)
            self.assertIsNone(own(less), place)
            self.assertIsNone(device(less), place)

    def test_distances(self):
        """The equations in real numbers, in the middle of every cell."""
        for path in FONTS:
            data = path.read_bytes()
            squares = [square for glyph in decoder.Font(data).glyphs
                       for square in glyph.squares
                       if not isinstance(square.content, str)]
            lines = [line for line in device(data, "--distances")
                     if " at " in line]
            self.assertEqual(len(squares), len(lines))
            self.assertGreater(len(squares), 0)
            for square, line in zip(squares, lines):
                device_u = int(line.rsplit(" ", 1)[1]) / 1024
                content = square.content
                if isinstance(content, Samples):
                    truth = content.distance(.5, .5, square.size)
                    allowed = (2 * square.size + 1) / 1024
                else:
                    half = square.size / 2
                    truth = content.distance(square.x + half, square.y + half)
                    # A bend, a vertex, and a step in Q10.
                    allowed = 1 / 128 + abs(truth) / 128 + 1 / 1024
                self.assertLessEqual(abs(device_u - truth), allowed,
                                     f"{path.name}: {line}, not {truth}")

    def test_the_document_states_complete_codes(self):
        self.assertEqual([len(codes) for codes in CODES.values()], [7, 6, 2])
        for codes in CODES.values():
            for code in codes:
                self.assertEqual(sum(2.0**-length for length, _ in code), 1)
                for length, word in code:
                    self.assertLess(word, 2**length)


def without_hints(data):
    """A font whose hints have become a section that nobody knows."""
    return with_checksums(bytearray(data.replace(b"HINT", b"none", 1)))


class Refusal(unittest.TestCase):
    """Both decoders refuse; the document's rule is in `rule`."""

    def refuse(self, rule, data, at, layout, value, checksums=True):
        changed = bytearray(data)
        struct.pack_into("<" + layout, changed, at, value)
        self.assertNotEqual(bytes(changed), data)
        changed = with_checksums(changed) if checksums else bytes(changed)
        with self.assertRaises(Refused) as raised:
            decoder.Font(changed)
        self.assertEqual(raised.exception.args[0], rule)
        self.assertIsNone(device(changed))

    def test_header(self):
        data = without_hints(font_where(is_narrow))
        self.refuse(2, data, 0, "I", 0)
        self.refuse(2, data, 4, "B", 1)
        self.refuse(3, data, 42, "H", 33, checksums=False)
        self.refuse(3, data, 8, "I", len(data) + 1, checksums=False)
        self.refuse(4, data, 24, "h", -1, checksums=False)
        self.refuse(5, data, 39, "B", 2)
        self.refuse(6, data, 76 + 4, "I", 2)
        self.refuse(6, data, 76, "4s", b"ABCD")
        self.refuse(7, data, 22, "H", 15)
        self.refuse(8, data, 20, "H", 65535)
        self.refuse(9, data, len(data) - 1, "B", data[-1] ^ 1, checksums=False)
        with self.assertRaises(Refused):
            decoder.Font(data[:75])
        self.assertIsNone(device(data[:75]))

    def test_tables(self):
        data = font_where(lambda d: is_narrow(d) and b"KERN" in d)
        cmap = section(data, b"CMAP")[0]
        kern = section(data, b"KERN")[0]
        self.refuse(10, data, cmap + 6, "H", 65535)
        self.refuse(10, data, cmap, "I", 0x110000)
        self.refuse(11, data, kern, "I", 4194304)
        self.refuse(11, data, kern + 16, "B", 26)
        self.refuse(12, data, section(data, b"GLYF")[0] + 1, "B", 0)

    def test_narrow_record(self):
        data = font_where(is_narrow)
        at = record_at(data, 0)
        nodes, arcs, lines, pairs, triples = struct.unpack_from(
            "<5H", data, at + 8)
        tiles = data[at + 6] * data[at + 7]
        tree = (at + 18 + 10 * arcs + 6 * lines + 4 * triples + 2 * pairs)
        self.refuse(12, data, at, "B", 4)
        self.refuse(12, data, at + 1, "B", 12)
        self.refuse(12, data, at + 2, "h", -1985)
        self.refuse(14, data, at + 8, "H", 255)
        self.refuse(14, data, at + 18, "h", 0x7fff)
        self.refuse(13, data, tree, "B", 255)
        self.refuse(13, data, tree, "B", 2 + nodes - 1)
        self.refuse(13, data, tree + tiles, "B", 2)

    def test_linked_record(self):
        data = font_where(is_linked)
        at = next(at for at in (record_at(data, i) for i in
                                range(sum(map(bool, records(data)))))
                  if data[at] == 2 and data[at + 1] & 0x80)
        tiles = data[at + 6] * data[at + 7]
        heap = at + 10
        first_node = next(tile for tile in range(tiles) if struct.unpack_from(
            "<H", data, heap + 2 * tile)[0] >> 13 == 1)
        self.refuse(12, data, at + 8, "H", 8193)
        self.refuse(12, data, at + 8, "H", tiles - 1)
        self.refuse(13, data, heap + 2 * first_node, "H", 2)
        self.refuse(13, data, heap + 2 * first_node, "H", 7 << 13 | tiles)
        self.refuse(13, data, heap + 2 * first_node, "H", 1 << 13)
        self.refuse(13, data, heap + 2 * first_node, "H", 1 << 13 | 8189)

    def test_packed_record(self):
        data = font_where(is_packed)
        at = record_at(data, 0)
        self.assertGreater(data[at + 1] >> 4, 1)
        self.refuse(12, data, at, "B", 2)
        self.refuse(12, data, at + 1, "B", 0)
        self.refuse(12, data, at + 3, "H", 0x8000)
        self.refuse(15, data, at + 5, "B", 255)

    def test_samples_record(self):
        data = font_where(is_samples)
        at = record_at(data, 0)
        nodes, cells = struct.unpack_from("<2H", data, at + 8)
        tiles = data[at + 6] * data[at + 7]
        self.refuse(13, data, at + 12, "H", 0x8000 | cells)
        self.refuse(13, data, at + 12, "H", 2 + nodes)
        self.refuse(13, data, at + 12 + 2 * tiles, "H", 2)
        self.refuse(12, data, at + 10, "H", 0x8000)

    def test_any_bytes(self):
        """With bytes changed at random, both refuse or both read the same."""
        random_bytes = random.Random(1)
        read = refused = 0
        for holds in (is_packed, is_linked, is_narrow, is_samples):
            data = font_where(holds)
            begin = struct.unpack_from("<H", data, 6)[0]
            for _ in range(60):
                changed = bytearray(data)
                changed[random_bytes.randrange(begin, len(data))] = (
                    random_bytes.randrange(256))
                changed = with_checksums(changed)
                lines = own(changed)
                self.assertEqual(lines, device(changed))
                read += lines is not None
                refused += lines is None
        self.assertGreater(read, 40)
        self.assertGreater(refused, 40)


def hint_section(glyph_count):
    """Three levels, of which the last two are in zones; glyphs have all of
    them, one of them, or none, and some have stems."""
    header = struct.pack("<6BhBB", 3, 2, 2, 2, 6, 7, -20, 90, 0)
    levels = struct.pack("<3H", 0xff0, 0x1000, 0x2200)
    bits = 0
    for glyph in range(glyph_count):
        # start, count, stem, gap, third
        start, count, stem, gap, third = [(0, 3, 9, 0, 0), (1, 1, 60, 77, 1),
                                          (0, 0, 1, 5, 0), (0, 2, 0, 3, 1)][
                                              glyph % 4]
        row = start | count << 2 | stem << 4 | gap << 10 | third << 17
        bits |= row << 18 * glyph
    rows = bits.to_bytes((18 * glyph_count + 7) // 8, "little")
    return header + levels + bytes([0x81, 2]) + rows + bytes([0x80, 1, 2])


def with_hints(data, hints):
    """A font with one section more, behind all others."""
    header_bytes, total_bytes = struct.unpack_from("<HI", data, 6)
    count = struct.unpack_from("<H", data, 42)[0]
    hints += bytes(-len(hints) % 4)
    header = bytearray(data[:header_bytes])
    for i in range(count):
        place = struct.unpack_from("<I", header, 80 + 12 * i)[0]
        struct.pack_into("<I", header, 80 + 12 * i, place + 12)
    header += struct.pack("<4sII", b"HINT", total_bytes + 12, len(hints))
    struct.pack_into("<HI", header, 6, header_bytes + 12,
                     total_bytes + 12 + len(hints))
    struct.pack_into("<H", header, 42, count + 1)
    return with_checksums(header + data[header_bytes:total_bytes] + hints)


class WithHints(unittest.TestCase):
    """Hints of every kind, in a font that had others."""

    def setUp(self):
        self.plain = without_hints(font_where(is_narrow))
        self.glyphs = struct.unpack_from("<H", self.plain, 20)[0]
        self.hints = hint_section(self.glyphs)
        self.data = with_hints(self.plain, self.hints)

    def test_both_read_the_same(self):
        lines = own(self.data)
        self.assertIn("edges 128 1 2 stems 1 16", lines)
        self.assertIn("edges 1 stems 3 220 308", lines)
        self.assertIn("zone 0 1", lines)
        self.assertEqual(lines, device(self.data))

    def test_both_refuse(self):
        for at, byte in [(0, 0), (0, 129), (1, 16), (1, 1), (2, 21), (3, 5),
                         (4, 13), (5, 13), (11, 0x05), (15, 0x32), (16, 0x83)]:
            hints = bytearray(self.hints)
            hints[at] = byte
            data = with_hints(self.plain, bytes(hints))
            self.assertIsNone(own(data), (at, byte))
            self.assertIsNone(device(data), (at, byte))
        cut = with_hints(self.plain, self.hints[:8])
        self.assertIsNone(own(cut))
        self.assertIsNone(device(cut))

    def test_any_bytes(self):
        random_bytes = random.Random(2)
        read = refused = 0
        for _ in range(300):
            hints = bytearray(self.hints)
            for _ in range(random_bytes.randrange(1, 3)):
                hints[random_bytes.randrange(len(hints))] = (
                    random_bytes.randrange(256))
            data = with_hints(self.plain, bytes(hints))
            lines = own(data)
            self.assertEqual(lines, device(data))
            read += lines is not None
            refused += lines is None
        self.assertGreater(read, 40)
        self.assertGreater(refused, 40)


class Stream:
    """Writes the bits of a packed glyph of one tile without shared fields."""

    def __init__(self, quantisation):
        self.quantisation = quantisation
        self.bits = "0000" + "0000"  # no shared field, to the end of a byte

    def word(self, name, context, wanted):
        for (length, word), symbol in CODES[name][context].items():
            if symbol == wanted:
                self.bits += f"{word:0{length}b}"
                return self
        raise AssertionError(f"no code for {name} {wanted}")

    def node(self, log2, name):
        return self.word("node", min(8 - log2, 6), CONTENT.index(name))

    def new(self, context, kind, log2, ones=0):
        """A field whose numbers are 0; kinds are axis, axis_arc, line, arc."""
        self.word("kind", context, kind + 1)
        d0_bits, angle_bits, low_bits = self.quantisation.widths(log2)
        self.bits += "0" * (d0_bits + (angle_bits if kind >= 2 else 2))
        if kind % 2:
            self.bits += "1" * ones + "0" + "0" * (low_bits + 1)
        return self

    def reuse(self, context, rank_context, rank):
        return self.word("kind", context, 0).word("rank", rank_context, rank)

    def record(self, size):
        """Padded: zeros behind the end of a stream are what is read there."""
        count = (len(self.bits) + 7) // 8
        stream = int(self.bits.ljust(8 * count, "0"), 2).to_bytes(count, "big")
        return (bytes((3, 0x11, 0, 0, 0)) + stream).ljust(size, b"\0")


class PackedStreams(unittest.TestCase):
    def setUp(self):
        self.font = font_where(is_packed)
        self.at = record_at(self.font, 0)
        self.size = len(next(filter(None, records(self.font))))

    def stream(self):
        return Stream(Quantisation(self.font[68:76]))

    def squares(self, stream):
        """What both decoders make of a stream; None: both refuse it."""
        record = stream.record(self.size)
        self.assertEqual(len(record), self.size)
        data = with_checksums(self.font[:self.at] + record +
                              self.font[self.at + self.size:])
        lines = own(data)
        self.assertEqual(lines, device(data))
        if lines is None:
            return None
        begin = next(i for i, line in enumerate(lines)
                     if line.startswith("glyph 0"))
        return lines[begin + 1:lines.index(next(
            line for line in lines if line.startswith("glyph 1")))]

    def test_one_cell(self):
        self.assertEqual(self.squares(self.stream().node(8, "inside")),
                         ["0 0 256 inside"])
        squares = self.squares(self.stream().node(8, "single").new(0, 0, 8))
        self.assertEqual(len(squares), 1)
        self.assertRegex(squares[0], r"^0 0 256 single \(16384 0 -\d+\)$")

    def test_what_has_been_used_is_used_again(self):
        stream = self.stream().node(8, "split")
        stream.node(7, "single").new(0, 0, 7)
        stream.node(7, "min_max").reuse(0, 0, 0).new(2, 2, 7).new(5, 1, 7)
        stream.node(7, "max2").reuse(0, 0, 1).reuse(2, 1, 0)
        stream.node(7, "outside")
        squares = self.squares(stream)
        single, nested, pair, _ = squares
        field = single.split("single ")[1]
        self.assertIn("min_max " + field, nested)
        # The list was f0, f1, f2: the pair is f1, f2.
        self.assertEqual(pair.split("max ")[1],
                         nested.split("min_max " + field + " ")[1])

    def test_a_square_of_1_u_is_not_split(self):
        for depth in 8, 9:
            stream = self.stream()
            for log2 in range(8, 8 - depth, -1):
                stream.node(log2, "split")
            # Then zeros: what they make ends, or has no field to use again.
            for log2 in range(8 - depth, 8):
                for _ in range(4 if log2 == 8 - depth else 3):
                    stream.node(max(log2, 0), "outside")
            self.assertEqual(self.squares(stream) is None, depth == 9)

    def test_ranks_are_below_the_length_of_the_list(self):
        stream = self.stream().node(8, "single").reuse(0, 0, 0)
        self.assertIsNone(self.squares(stream))

    def test_nested_fields_are_not_the_first(self):
        for rank in 0, 1:
            stream = self.stream().node(8, "split")
            stream.node(7, "min2").new(0, 0, 7).new(3, 2, 7)
            stream.node(7, "max_min").reuse(0, 0, 0).reuse(2, 0, rank)
            stream.new(4, 0, 7)
            stream.node(7, "outside").node(7, "outside")
            self.assertEqual(self.squares(stream) is None, rank == 0)

    def test_bends_have_at_most_15_ones(self):
        for ones in 15, 16:
            stream = self.stream().node(8, "single").new(0, 3, 8, ones)
            self.assertEqual(self.squares(stream) is None, ones == 16)

    def test_the_shared_stream_ends_within_the_record(self):
        least = min(map(len, filter(None, records(self.font))))
        at = next(record_at(self.font, i) for i, record in enumerate(
            filter(None, records(self.font))) if len(record) == least)
        stream = self.stream()
        stream.bits = "1111"  # 15 fields take more
        data = bytearray(self.font)
        data[at:at + least] = stream.record(least)
        self.assertIsNone(own(with_checksums(data)))
        self.assertIsNone(device(with_checksums(data)))


def main():
    global DUMP, FONTS
    parser = argparse.ArgumentParser()
    parser.add_argument("--dump", required=True)
    parser.add_argument("fonts", nargs="+", type=pathlib.Path)
    arguments, rest = parser.parse_known_args()
    DUMP = arguments.dump
    FONTS = sorted(arguments.fonts)
    unittest.main(argv=[sys.argv[0], *rest])


if __name__ == "__main__":
    main()
