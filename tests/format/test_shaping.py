#!/usr/bin/env python3
"""Section SHAP by the second decoder: words are shaped as the device shapes
them, and damaged tables are refused where the device refuses them.

    test_shaping.py INSPECT FONT.bin...
"""
import json
import pathlib
import random
import struct
import subprocess
import sys
import tempfile
import zlib

from decoder import (read_cmap, read_code_pages, read_header,
                     read_metrics)
from shaping import Refused, read_shaping, shape

WORDS = 400
DAMAGED = 60
IGNORABLE = {0xad, 0x34f, 0x61c, *range(0x200b, 0x2010), *range(0x2060, 0x2070),
             0xfeff, *range(0xfe00, 0xfe10)}
SARA_AM = {0xe33, 0xeb3}
MOVED = 4  # joining type of Hebrew marks that change places


class Font:
    def __init__(self, data):
        header, sections = read_header(data)
        count = header.glyph_count
        self.data, self.section = data, sections[b"SHAP"]
        self.glyph_of = read_code_pages(sections.get(b"CPAG", b""), count)
        self.glyph_of.update(read_cmap(sections.get(b"CMAP", b""), count))
        self.advances = [row[0] for row in
                         read_metrics(sections[b"METR"], count)]
        self.glyph_count = count
        self.shaping = read_shaping(self.section, count)

    def words(self):
        shaping = self.shaping
        composed = set(shaping.compositions.values())
        all_codes = [code for code in sorted(self.glyph_of)
                     if code not in composed | IGNORABLE | SARA_AM
                     and shaping.traits.get(code, (0, 0, 0))[0] != MOVED]
        marks = [code for code in all_codes
                 if shaping.traits.get(code, (0, 0, 0))[0] > MOVED]
        letters = [code for code in all_codes if code not in marks and any(
            first <= code <= first + extra
            for first, extra, _ in shaping.scripts)]
        for _ in range(WORDS):
            word = [random.choice(letters)]
            for _ in range(random.randrange(9)):
                kinds = (letters, letters, all_codes, marks or letters)
                word.append(random.choice(random.choice(kinds)))
            yield "".join(map(chr, word))


def by_device(inspect, font, words, folder):
    file = folder / "words.txt"
    file.write_text("\n".join(words) + "\n", encoding="utf-8")
    lines = subprocess.run([inspect, font, "--run-file", file], check=True,
                           capture_output=True, text=True).stdout.splitlines()
    return [[(g["glyph"], g["x"], g["y"], g["advance"])
             for g in json.loads(line)] for line in lines]


def check_words(inspect, name, font, folder):
    words = list(font.words())
    own = [shape(font.shaping, font.glyph_of, font.advances, word)
           for word in words]
    wanted = by_device(inspect, name, words, folder)
    assert len(own) == len(wanted)
    wrong = [(word, a, b) for word, a, b in zip(words, own, wanted) if a != b]
    for word, a, b in wrong[:3]:
        print(f"  {' '.join(f'{ord(c):04x}' for c in word)}\n    decoder {a}\n"
              f"    device  {b}")
    print(f"{name}: {len(words) - len(wrong)} of {len(words)} words equal")
    return not wrong


def damage(font):
    """The font with a byte or two of SHAP changed, and right checksums."""
    data = bytearray(font.data)
    at = data.index(font.section)
    for _ in range(random.randint(1, 2)):
        place = random.randrange(random.choice((33, len(font.section))))
        data[at + place] ^= random.choice((1 << random.randrange(8), 0xff))
    header_bytes, total_bytes = struct.unpack_from("<HI", data, 6)
    struct.pack_into("<I", data, 16,
                     zlib.crc32(data[header_bytes:total_bytes]))
    struct.pack_into("<I", data, 12, zlib.crc32(
        data[:12] + data[16:header_bytes]))
    section = bytes(data[at:at + len(font.section)])
    return bytes(data), section


def is_refused(font, section):
    try:
        read_shaping(section, font.glyph_count)
    except Refused:
        return True
    return False


def check_damage(inspect, name, font, folder):
    refused = 0
    for number in range(DAMAGED):
        data, section = damage(font)
        file = folder / "damaged.bin"
        file.write_bytes(data)
        result = subprocess.run([inspect, file], capture_output=True,
                                text=True, check=False)
        own = is_refused(font, section)
        refused += own
        if own != (result.returncode != 0):
            print(f"{name}: damage {number}: the decoder "
                  f"{'refuses' if own else 'takes'} what the device does not: "
                  f"{result.stderr}")
            return False
    print(f"{name}: {refused} of {DAMAGED} damaged ones refused by both")
    return 0 < refused < DAMAGED


def main():
    random.seed(1)
    good = len(sys.argv) > 2
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        for file in sys.argv[2:]:
            font = Font(pathlib.Path(file).read_bytes())
            good = check_words(sys.argv[1], file, font, folder) and good
            good = check_damage(sys.argv[1], file, font, folder) and good
    return not good


sys.exit(main())
