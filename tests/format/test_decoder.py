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
from squares import Refused

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
        name, place, size = struct.unpack_from(
            "<4sII", data, decoder.HEADER_BYTES + 12 * i)
        if name == tag:
            return place & ~1, size
    raise AssertionError(f"no {tag}")


def records(data):
    offset, size = section(data, b"GLYF")
    header, _ = decoder.read_header(data)
    return decoder.read_records(data[offset:offset + size], header)


def record_at(data, number):
    """Where the number-th record that is not empty begins."""
    found = [record for record in records(data) if record][number]
    return data.index(found, section(data, b"GLYF")[0])


class Agreement(unittest.TestCase):
    def test_every_cell_of_every_font(self):
        for path in FONTS:
            data = path.read_bytes()
            lines = own(data)
            self.assertIsNotNone(lines, path.name)
            self.assertEqual(lines, device(data), path.name)

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
                truth = square.content.distance(.5, .5, square.size)
                allowed = (2 * square.size + 1) / 1024
                self.assertLessEqual(abs(device_u - truth), allowed,
                                     f"{path.name}: {line}, not {truth}")


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
        data = FONTS[0].read_bytes()
        self.refuse(2, data, 0, "I", 0)
        self.refuse(2, data, 4, "B", 1)
        self.refuse(3, data, 42, "H", 33, checksums=False)
        self.refuse(3, data, 8, "I", len(data) + 1, checksums=False)
        self.refuse(4, data, 24, "h", -1, checksums=False)
        self.refuse(5, data, 39, "B", 3)
        self.refuse(15, data, 39, "B", 2)  # code_bits is 0
        self.refuse(6, data, 64 + 4, "I", 2)
        self.refuse(6, data, 64, "4s", b"ABCD")
        self.refuse(7, data, 22, "H", 3)
        self.refuse(8, data, 20, "H", 65535)
        self.refuse(9, data, len(data) - 1, "B", data[-1] ^ 1, checksums=False)
        with self.assertRaises(Refused):
            decoder.Font(data[:63])
        self.assertIsNone(device(data[:63]))

    def test_tables(self):
        data = FONTS[0].read_bytes()
        cmap = section(data, b"CMAP")[0]
        kern = section(data, b"KERN")[0]
        self.refuse(10, data, cmap + 6, "H", 65535)
        self.refuse(10, data, cmap, "I", 0x110000)
        self.refuse(11, data, kern, "I", 4194304)
        self.refuse(11, data, kern + 16, "B", 26)
        self.refuse(12, data, section(data, b"GLYF")[0] + 1, "B", 0)

    def test_samples_record(self):
        data = FONTS[0].read_bytes()
        at = record_at(data, 0)
        nodes, cells = struct.unpack_from("<2H", data, at + 8)
        tiles = data[at + 6] * data[at + 7]
        self.refuse(12, data, at, "B", 4)
        self.refuse(12, data, at + 1, "B", 12)
        self.refuse(12, data, at + 2, "h", -15361)
        self.refuse(13, data, at + 12, "H", 0x8000 | cells)
        self.refuse(13, data, at + 12, "H", 2 + nodes)
        self.refuse(13, data, at + 12 + 2 * tiles, "H", 2)
        self.refuse(12, data, at + 10, "H", 0x8000)

    def test_any_bytes(self):
        """With bytes changed at random, both refuse or both read the same."""
        random_bytes = random.Random(1)
        read = refused = 0
        for font in FONTS:
            data = font.read_bytes()
            begin = struct.unpack_from("<H", data, 6)[0]
            for _ in range(300):
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


def main():
    global DUMP, FONTS
    parser = argparse.ArgumentParser()
    parser.add_argument("--dump", required=True)
    parser.add_argument("fonts", nargs="+", type=pathlib.Path)
    arguments, rest = parser.parse_known_args()
    DUMP = arguments.dump
    # Those of cells; outlines are read in test_outlines.py.
    FONTS = sorted(font for font in arguments.fonts
                   if font.read_bytes()[39] != 2)
    unittest.main(argv=[sys.argv[0], *rest])


if __name__ == "__main__":
    main()
