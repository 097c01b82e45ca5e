"""Programs that open fonts of one coding: they draw those fonts, answer others
with `unsupported`, and have no code of the other coding.

Usage: check_codings.py WORK_FOLDER PROBE_OF_OUTLINES PROBE_OF_FIELDS
"""
import zlib

from toolchains import ROOT, arguments, finish, run

FONTS = [ROOT / "tests/golden/fonts" / f"dejavu_sans_{coding}.bin"
         for coding in ("outline", "field")]
# Names that only the coding needs: canvases of 1 bit fit outlines alone.
FUNCTIONS = [["OutlineReader::", "OutlineGlyph::", "kFitTwoLevels"],
             ["FieldRows::", "FieldSampler::"]]
DRAWN = "0 1"
UNSUPPORTED = "7 0"


def font_of_edges(work):
    """A font of coding 1, which only earlier versions made."""
    data = bytearray(FONTS[1].read_bytes())
    header_bytes = int.from_bytes(data[6:8], "little")
    data[39] = 1
    crc = zlib.crc32(data[16:header_bytes], zlib.crc32(data[:12]))
    data[12:16] = crc.to_bytes(4, "little")
    font = work / "edges.bin"
    font.write_bytes(data)
    return font


def main():
    work, *probes = arguments()
    fonts = [*FONTS, font_of_edges(work)]
    problems = []
    for own, probe in enumerate(probes):
        wanted = [DRAWN if font == own else UNSUPPORTED for font in range(3)]
        found = run([probe, *fonts]).stdout.splitlines()
        if found != wanted:
            problems.append(f"{probe}: {found}, not {wanted}")
        names = run(["nm", "-C", "--defined-only", probe]).stdout
        problems += [f"{probe}: {name} is{'' if is_wanted else ' not'} missing"
                     for coding, listed in enumerate(FUNCTIONS)
                     for name in listed
                     for is_wanted in [coding == own]
                     if (name in names) != is_wanted]
    finish(len(probes) * len(fonts), problems)


main()
