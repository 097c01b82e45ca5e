"""Makes a variable font: a Bold master of a Regular one, an axis, fontmake.

Usage: check_variable.py INKCELL_EDITOR INKCELL_DESIGN INKCELL_FONTGEN

FreeType, HarfBuzz and inkcell-fontgen open the result and draw it at places on
its axis. Exits with 77 where a Debian package is missing; it says which.
"""
import pathlib
import shutil
import subprocess
import sys
import tempfile

from problems import expect, finish

try:
    import fontmake  # run as a program
    import freetype
    from fontTools.ttLib import TTFont
except ImportError as missing:
    print(f"skipped: {missing}; install python3-freetype and fontmake")
    sys.exit(77)
if shutil.which("hb-view") is None:
    print("skipped: hb-view is missing; install libharfbuzz-bin")
    sys.exit(77)

FONT = "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf"
AXES = ('do {"do": "set_axes", "axes": [{"tag": "wght", "name": "Weight"}], '
        '"masters": {"public.default": {"wght": 400}, "Bold": {"wght": 700}}, '
        '"instances": [{"name": "Regular", "wght": 400}, '
        '{"name": "Medium", "wght": 500}, {"name": "Bold", "wght": 700}]}')


def run(*arguments, cwd):
    result = subprocess.run(list(map(str, arguments)), text=True, check=False,
                            capture_output=True, cwd=cwd)
    if result.returncode != 0:
        sys.exit(f"{' '.join(map(str, arguments))}: {result.stderr}")
    return result.stdout


def ink(file, weight):
    """The grey that FreeType draws of n at this weight."""
    face = freetype.Face(str(file))
    face.set_var_design_coords((weight,))
    face.set_char_size(64 * 64)
    face.load_char("n", freetype.FT_LOAD_RENDER | freetype.FT_LOAD_NO_HINTING)
    return sum(face.glyph.bitmap.buffer)


def main():
    editor, design, fontgen = (pathlib.Path(a).resolve() for a in sys.argv[1:4])
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        (folder / "script.txt").write_text("\n".join((
            f"open {FONT} V.ufo 0x20-0x7E,0xC0-0xFF", "bold_master 90 Bold",
            AXES, "save")))
        run(editor, "--script", "script.txt", cwd=folder)
        run(design, "export", "--project", "V.ufo", "--out", "V.designspace",
            cwd=folder)
        run(sys.executable, "-m", fontmake.__name__, "-m", "V.designspace",
            "-o", "variable", "--output-path", "V.ttf", "--keep-overlaps",
            cwd=folder)
        file = folder / "V.ttf"
        font = TTFont(file)
        expect({"fvar", "gvar", "STAT", "HVAR"} <= set(font.keys()),
               f"tables: {sorted(font.keys())}")
        axis, = font["fvar"].axes
        names = [font["name"].getDebugName(i.subfamilyNameID)
                 for i in font["fvar"].instances]
        expect((axis.axisTag, axis.minValue, axis.defaultValue, axis.maxValue)
               == ("wght", 400, 400, 700) and
               names == ["Regular", "Medium", "Bold"],
               f"axis {axis.axisTag} {axis.minValue}..{axis.maxValue}, {names}")
        greys = [ink(file, weight) for weight in (400, 500, 700)]
        expect(greys[0] < greys[1] < greys[2], f"FreeType's ink: {greys}")
        pictures = [run("hb-view", "--output-format=svg",
                        f"--variations=wght={weight}", file, "Hano2!",
                        cwd=folder) for weight in (400, 500, 700)]
        expect(len(set(pictures)) == 3, "hb-view draws one weight only")
        for weight in (400, 700):
            run(fontgen, "--font", file, "--axis", f"wght={weight}", "--chars",
                "0x20-0x7E", "--out", f"{weight}.bin", cwd=folder)
        expect((folder / "400.bin").read_bytes() !=
               (folder / "700.bin").read_bytes(), "inkcell-fontgen's weights")
        print(f"V.ttf: {file.stat().st_size} bytes, {len(font.getGlyphOrder())}"
              f" glyphs; n has {greys[2] / greys[0]:.2f} times the ink at 700")
    finish()


main()
