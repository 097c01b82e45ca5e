"""Makes a family of the eight letters that check_window.py draws: in
inkcell-editor's window, in Xvfb, by pointer and keys, a Bold master and an axis,
and by fontmake a variable font.

Usage: check_family.py INKCELL_EDITOR INKCELL_RENDER INKCELL_FONTGEN
                       INKCELL_ANIMATE [PICTURES]

FreeType, HarfBuzz and inkcell-fontgen open the font; the watch of the reel shows
it, and the OLED of an emulated board where its compiler and QEMU are installed.
Writes family_oled.png and family_watch.png to the folder PICTURES. Exits with 77
where a Debian package is missing; it says which.
"""
import json
import pathlib
import shutil
import subprocess
import sys
import tempfile

try:
    import fontmake  # run as a program
    import freetype
    from fontTools.ttLib import TTFont
except ImportError as missing:
    print(f"skipped: {missing}; install python3-freetype and fontmake")
    sys.exit(77)
if shutil.which("hb-shape") is None:
    print("skipped: hb-shape is missing; install libharfbuzz-bin")
    sys.exit(77)

ROOT = pathlib.Path(__file__).resolve().parents[3]
sys.path.append(str(ROOT / "host_tools/screens"))

import screens
from check_window import (HEIGHT, SELECTED_TEXT, WIDTH, Letters, Window, picture,
                          run_script)
from problems import expect, finish
from xvfb import Display, wait

FILE_MENU = 25, 12       # the menu, and two of its items [px]
ADD_MASTER = 52, 194
AXIS = 72, 216
STEMS = 60               # that Bold's stems are wider by [units]
WEIGHTS = 400, 500, 700
BOARD = "lm3s6965evb"
OLED_SCALE = 4           # QEMU's pixels for one of the OLED
OLED_LINE = 21           # of its text [px], of OLED_PX px/em
OLED_PX = 18
WATCH_S = 0.5            # of the reel [s]
OLED_INK = 0.03          # that 16 greys take or add, of a line


def run(*arguments, cwd):
    result = subprocess.run(list(map(str, arguments)), text=True, check=False,
                            capture_output=True, cwd=cwd)
    if result.returncode != 0:
        sys.exit(f"{' '.join(map(str, arguments))}: {result.stderr}")
    return result.stdout


def answer(window, item, *keys):
    """Opens a dialog of the menu File, and types into it."""
    for place in (FILE_MENU, item):
        window.send("mousemove", *place)
        window.send("click", 1)
    wait(lambda: SELECTED_TEXT in window.display.pixels(),
         "the first value of the dialog is not selected")
    for event in keys:
        window.display.send(*event)


def make_family(display, folder):
    letters = Letters(["save"])
    letters.make()
    letters.run_script(folder)
    shown = folder / "opened.ppm"
    run_script(folder, f"open {Letters.NAME}", f"screenshot {shown.name}")
    window = Window(display, folder, Letters.NAME)
    journal = folder / f"{Letters.NAME}.journal"
    try:
        window.wait_for(picture(shown), "the letters are not opened")
        answer(window, ADD_MASTER, ("type", "Bold"), ("key", "Tab"),
               ("type", STEMS), ("key", "Return"))
        wait(lambda: journal.exists() and
             "change_weight" in journal.read_text(), "there is no Bold")
        answer(window, AXIS, ("key", "Return"))
        wait(lambda: "set_axes" in journal.read_text(), "there is no axis")
        window.export(folder, "Letters.designspace")
    finally:
        window.process.kill()
        window.process.wait()
        display.close()
    for glyph in "bdhnu":
        file = folder / Letters.NAME / "glyphs" / f"{glyph}.glif"
        expect("org.inkcell." in file.read_text(),
               f"{glyph} lost its strokes or parts in the default master")


def stem(face, letter, weight, height):
    """The ink of a letter's row. [units]"""
    face.set_var_design_coords((weight,))
    face.set_char_size(1000 * 64)
    face.load_char(letter, freetype.FT_LOAD_RENDER |
                   freetype.FT_LOAD_NO_HINTING)
    bitmap = face.glyph.bitmap
    row = face.glyph.bitmap_top - height
    return sum(bitmap.buffer[row * bitmap.pitch:(row + 1) * bitmap.pitch]) / 255


def draw_on_oled(folder, fontgen):
    """Three lines of text, each of one weight: their ink [px]; and the shot."""
    build = folder / "oled"
    run("cmake", "-G", "Ninja", "-S", pathlib.Path(__file__).parent /
        "family_board", "-B", build, "-DCMAKE_BUILD_TYPE=MinSizeRel",
        f"-DCMAKE_TOOLCHAIN_FILE={ROOT}/boards/{BOARD}/toolchain.cmake",
        f"-DINKCELL_FONTGEN={fontgen}", f"-DFAMILY={folder / 'V.ttf'}",
        f"-DCHARS={Letters.CHARS}", cwd=folder)
    run("cmake", "--build", build, cwd=folder)
    shot, _ = screens.run_and_shoot([BOARD, build / "family.elf"], "",
                                       screens.wait_until_ready, folder)
    greys = shot.pixels[::3]
    row = OLED_LINE * OLED_SCALE * shot.width
    return [sum(greys[i * row:(i + 1) * row]) / 255 / OLED_SCALE ** 2
            for i in range(len(WEIGHTS))], shot


def check_oled(folder, fontgen, pictures):
    """The board's ink is that of the same font ROM on this machine."""
    if not shutil.which("arm-none-eabi-g++") or not shutil.which(
            "qemu-system-arm"):
        print("no OLED: gcc-arm-none-eabi or qemu-system-arm is missing")
        return
    render = pathlib.Path(sys.argv[2]).resolve()
    inks, shot = draw_on_oled(folder, fontgen)
    shot.save_png(pictures / "family_oled.png")
    for weight, ink in zip(WEIGHTS, inks):
        run(render, "--font", f"{weight}.bin", "--text", Letters.TEXT, "--px",
            OLED_PX, "--filter", "area", "--ox", 2, "--oy", OLED_PX, "--width",
            128, "--height", 2 * OLED_PX, "--out", "line.pgm", cwd=folder)
        greys = (folder / "line.pgm").read_bytes().split(b"\n", 3)[3]
        wanted = sum(greys) / 255
        expect(abs(ink - wanted) <= OLED_INK * wanted,
               f"{ink:.0f} px of ink on the OLED at {weight}, not {wanted:.0f}")
    print(f"ink on the OLED: {[round(ink) for ink in inks]} px")


def check_watch(folder, animate, pictures):
    """The watch shows the word of the reel in Regular and in Bold."""
    shown = []
    for weight in WEIGHTS[0], WEIGHTS[-1]:
        file = pictures / "family_watch.png"
        run(animate, "reel", "--font", "V.ttf", "--axis", f"wght={weight}",
            "--text", "blind", "--from", WATCH_S, "--seconds", 0, "--format",
            "sheet", "--out", file, cwd=folder)
        shown.append(file.read_bytes())
    expect(shown[0] != shown[1], "the watch shows one weight only")


def main():
    fontgen = pathlib.Path(sys.argv[3]).resolve()
    with tempfile.TemporaryDirectory() as name:
        folder, screen = (pathlib.Path(name) / part for part in
                          ("letters", "screen"))
        for part in (folder, screen):
            part.mkdir()
        make_family(Display(screen, WIDTH, HEIGHT), folder)
        run(sys.executable, "-m", fontmake.__name__, "-m",
            "Letters.designspace", "-o", "variable", "--output-path", "V.ttf",
            "--keep-overlaps", cwd=folder)
        face = freetype.Face(str(folder / "V.ttf"))
        expect(TTFont(folder / "V.ttf")["OS/2"].fsType == 0,
               "V.ttf may not be embedded")
        for letter, stems, height in (("l", 1, 167), ("i", 1, 167),
                                      ("h", 2, 167), ("n", 2, 167),
                                      ("u", 2, 333)):
            thin, *more = (stem(face, letter, weight, height)
                           for weight in WEIGHTS)
            for weight, ink in zip(WEIGHTS[1:], more):
                wider = stems * STEMS * (weight - 400) / 300
                expect(abs(ink - thin - wider) <= 2 * stems,
                       f"{letter} at {weight}: {thin:.0f} > {ink:.0f} units, "
                       f"not {wider:.0f} more")
        for letter in Letters.LETTERS:
            tops = []
            for weight in WEIGHTS:
                face.set_var_design_coords((weight,))
                face.load_char(letter, freetype.FT_LOAD_NO_SCALE)
                tops.append(face.glyph.outline.get_bbox().yMax)
            expect(max(tops) - min(tops) <= 1, f"{letter} is {tops} high")
        shaped = [json.loads(run(
            "hb-shape", "--output-format=json", f"--variations=wght={weight}",
            "V.ttf", Letters.TEXT, cwd=folder)) for weight in WEIGHTS]
        widths = [sum(glyph["ax"] for glyph in line) for line in shaped]
        expect(all(glyph["g"] != ".notdef" for glyph in shaped[0]) and
               widths[0] < widths[1] < widths[2], f"HarfBuzz: {shaped}")
        fonts = []
        for weight in WEIGHTS:
            out = folder / f"{weight}.bin"
            run(fontgen, "--font", "V.ttf", "--axis", f"wght={weight}",
                "--chars", Letters.CHARS, "--out", out, cwd=folder)
            fonts.append(out.read_bytes())
        expect(len(set(fonts)) == 3, "inkcell-fontgen makes one weight only")
        pictures = pathlib.Path(sys.argv[5] if len(sys.argv) > 5 else folder)
        check_oled(folder, fontgen, pictures.resolve())
        check_watch(folder, pathlib.Path(sys.argv[4]).resolve(),
                    pictures.resolve())
        print(f"'{Letters.TEXT}' is {widths} units wide at {WEIGHTS}")
    finish()


main()
