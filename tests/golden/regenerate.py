#!/usr/bin/env python3
"""Makes the golden files of this folder anew from a built tree.

    tests/golden/regenerate.py BUILD            hashes and pictures
    tests/golden/regenerate.py BUILD --fonts    the frozen fonts first
    tests/golden/regenerate.py BUILD --fonts outline    those whose names
                                                contain "outline"

Do this when a picture is meant to change, look at sheet.png, and say in the
commit why it changed. Fonts are frozen: they change only with the format.
"""
import re
import subprocess
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parents[1] / "host_tools/common"))
from png_bytes import png  # noqa: E402

SYSTEM_FONTS = Path("/usr/share/fonts")
# File, face, characters. Small, but with kerning, a character above U+FFFF and
# a space.
SERIF = ("DejaVuSerif.ttf", 0, "AVQuav& ")
ROBOTO = ("Roboto-Regular.ttf", 0, "Roboty ")
CJK = ("NotoSansCJK-Regular.ttc", 2, "\u6c38\u5b57\u8f5f")
OUTLINE = ["--coding", "outline", "--tolerance", "32/255"]
FONTS = {
    "dejavu_sans_field": (("DejaVuSans.ttf", 0, "Again"),
                            ["--coding", "field", "--max-px", "24",
                             "--tolerance", "24/255"]),
    # With a composite: a letter and its accent.
    "dejavu_sans_outline": (
        ("DejaVuSans.ttf", 0, "Inkcel 42\u00e4\U0001d538"), OUTLINE),
    "dejavu_serif_outline": (SERIF, OUTLINE),
    "noto_sans_cjk_outline": (CJK, OUTLINE),
    "roboto_outline": (ROBOTO, OUTLINE),
}
OPTIONS = ["--format", "bin", "--quiet"]


def make_fonts(build, part):
    for name, ((file, face, symbols), options) in FONTS.items():
        if part not in name:
            continue
        source = next(SYSTEM_FONTS.rglob(file))
        out = HERE / "fonts" / (name + ".bin")
        subprocess.run(
            [build / "fonts_gen/inkcell-fontgen", "--font", source, "--face",
             str(face), "--symbols", symbols, "--out", out, *OPTIONS,
             *options],
            check=True)
        print(out.name, out.stat().st_size, "bytes")


def write_hashes(build):
    run = subprocess.run([build / "tests/unit/unit_tests", "golden"],
                         capture_output=True, text=True, check=False)
    hashes = re.findall(r"^([0-9a-f]{64})  (.*)$", run.stdout, re.MULTILINE)
    pages = [digits for digits, name in hashes if name != "sheet"]
    sheet = [digits for digits, name in hashes if name == "sheet"]
    if len(sheet) != 1 or not pages:
        sys.exit("regenerate.py: unit_tests printed no hashes")
    lines = "".join(f'    "{digits}",\n' for digits in pages)
    (HERE / "expected.hpp").write_text(
        "// The hashes of the test sheet: written by regenerate.py.\n"
        "#pragma once\n\nnamespace golden {\n\n"
        "inline constexpr const char* kSheetHash =\n"
        f'    "{sheet[0]}";\n'
        "inline constexpr const char* kPageHashes[] = {\n"
        f"{lines}}};\n\n"
        "}  // namespace golden\n")
    print("sheet", sheet[0])


def png_from_ppm(ppm):
    """The bytes of a PNG with the pixels of a binary PPM."""
    kind, width, height, _, pixels = ppm.split(maxsplit=4)
    if kind != b"P6":
        sys.exit("regenerate.py: not a PPM")
    width, height = int(width), int(height)
    return png(width, 3, ppm[-3 * width * height:])


def write_pictures(build):
    program = build / "tests/golden/golden_write_sheet"
    subprocess.run([program, "grey", HERE / "grey_page.pgm"], check=True)
    ppm = build / "tests/golden/sheet.ppm"
    subprocess.run([program, "sheet", ppm], check=True)
    (HERE / "sheet.png").write_bytes(png_from_ppm(ppm.read_bytes()))


def main():
    arguments = sys.argv[1:]
    if not arguments or arguments[1:2] not in ([], ["--fonts"]):
        sys.exit(__doc__)
    build = Path(arguments[0])
    targets = ["unit_tests", "golden_write_sheet"]
    if arguments[1:]:
        subprocess.run(["cmake", "--build", build, "--target",
                        "inkcell-fontgen"], check=True)
        make_fonts(build, "".join(arguments[2:3]))
    subprocess.run(["cmake", "--build", build, "--target", *targets],
                   check=True)
    write_hashes(build)
    write_pictures(build)
    # The test holds the hashes.
    subprocess.run(["cmake", "--build", build, "--target", "unit_tests"],
                   check=True)


if __name__ == "__main__":
    main()
