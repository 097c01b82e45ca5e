"""Checks that other programs accept our projects, and that we keep theirs.

Usage: check_ufo.py INKCELL_DESIGN

ufoLib of fontTools reads and validates our projects. fontmake compiles two of
them; FreeType draws the result and our own export of the same project, which
may differ by MOST_OF_255 in a pixel. A project that ufoLib2 writes, with the
keys that fontmake, Glyphs and RoboFont leave in libs, is opened and saved
without a difference.

Exits with 77 where a Debian package is missing; it says which.
"""
import json
import pathlib
import subprocess
import sys
import tempfile

from problems import expect, finish

try:
    import fontmake  # run as a program
    import freetype
    import ufoLib2
    from fontTools.pens.recordingPen import RecordingPointPen
    from fontTools.ufoLib import UFOReader
    from fontTools.ufoLib.glifLib import readGlyphFromString
    from freetype_glyph import picture, worst_difference
except ImportError as missing:
    print(f"skipped: {missing}; install python3-freetype and fontmake")
    sys.exit(77)

FONT = "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf"
SAMPLE = pathlib.Path(__file__).resolve().parents[1] / "samples/pen_face.lua"
SIZES_PX = (12, 24, 64)
# The error of fontmake's quadratics against our cubics; ours are within 1/3
# unit. Both round points to whole units; the pen's face has 1000 an em: two
# units together are 33/255 of a pixel at 64 px/em.
CONVERSION_ERROR_EM = 0.0003
MOST_OF_255 = 24

# One of each: strokes, a tree, a component, guides, an anchor, kerning, libs.
COMMANDS = (
    {"do": "add_glyph", "glyph": "loop", "unicodes": [9711], "width": 2048},
    {"do": "set_strokes", "glyph": "loop", "strokes": [
        {"nib": "ellipse:150,40,30", "points": [
            [600, 300], [1100, 800], [600, 1300], [100, 800], [600, 300]]}]},
    {"do": "add_glyph", "glyph": "both", "width": 1300},
    {"do": "set_tree", "glyph": "both", "tree": {
        "op": "blend", "radius": 60, "parts": [
            {"glyph": "A"},
            {"glyph": "loop", "matrix": {"turn": 90, "move": [300, 0]}}]}},
    {"do": "add_component", "glyph": "both", "base": "B",
     "matrix": {"reflect": "x", "scale": 0.5, "move": [100, 20.5]}},
    {"do": "add_anchor", "glyph": "A", "name": "top", "x": 700, "y": 1500},
    {"do": "add_guideline", "glyph": "A", "y": 750},
    {"do": "add_guideline", "glyph": "A", "x": 70, "y": 750, "angle": 30},
    {"do": "set_group", "group": "public.kern1.A", "value": ["A"]},
    {"do": "set_kerning", "left": "public.kern1.A", "right": "V",
     "value": -90},
    {"do": "set_info", "key": "styleName", "value": "Regular & Co"},
    {"do": "set_lib", "key": "org.example.any",
     "value": {"a": [1, 2.5, True, "x"]}},
    {"do": "set_glyph_lib", "glyph": "A", "key": "public.markColor",
     "value": "1,0,0,1"},
)


def run(*arguments):
    result = subprocess.run(list(map(str, arguments)), text=True, check=False,
                            stdout=subprocess.DEVNULL, stderr=subprocess.PIPE)
    if result.returncode != 0:
        sys.exit(f"{' '.join(map(str, arguments))}: {result.stderr}")


def contents(folder):
    return {path.relative_to(folder): path.read_bytes()
            for path in folder.rglob("*") if path.is_file()}


def make_projects(design, folder):
    """A face with one of each, and a face drawn by a pen."""
    face, pen = folder / "Face.ufo", folder / "Pen.ufo"
    run(design, "import", "--font", FONT, "--chars", "0x20-0x7E,0xC0-0xFF",
        "--out", face)
    script = folder / "script.jsonl"
    script.write_text("".join(json.dumps(command) + "\n"
                              for command in COMMANDS))
    run(design, "replay", script, "--project", face)
    run(design, "script", SAMPLE, "--out", pen)
    return face, pen


def check_valid(project):
    """Reads all by ufoLib, which raises on what the specification forbids."""
    class Info:
        pass

    reader = UFOReader(project, validate=True)
    reader.readInfo(Info())
    reader.readGroups()
    reader.readKerning()
    reader.readLib()
    reader.readFeatures()
    count = 0
    for layer in reader.getLayerNames():
        glyphs = reader.getGlyphSet(layer, validateRead=True)
        expect(glyphs.contents, f"{project.name}: layer {layer} is empty")
        for name in glyphs.keys():
            class Holder:
                pass

            pen = RecordingPointPen()
            glyphs.readGlyph(name, Holder(), pen)
            count += bool(pen.value)
            readGlyphFromString(glyphs.getGLIF(name), validate=True)
    expect(count > 0, f"{project.name}: no glyph has an outline")


def worst_pixel(ours, theirs):
    worst = 0
    characters = sorted(code for code, _ in ours.get_chars())
    expect(characters == sorted(code for code, _ in theirs.get_chars()),
           "fontmake maps other characters")
    for px in SIZES_PX:
        ours.set_pixel_sizes(px, px)
        theirs.set_pixel_sizes(px, px)
        for code in filter(None, characters):
            a = picture(ours, ours.get_char_index(code))
            b = picture(theirs, theirs.get_char_index(code))
            expect(ours.glyph.linearHoriAdvance ==
                   theirs.glyph.linearHoriAdvance, f"advance of U+{code:04X}")
            worst = max(worst, worst_difference(a, b))
    return worst


def check_compiled(design, project, folder):
    ours, theirs = (folder / f"{project.stem}-{name}.ttf"
                    for name in ("ours", "theirs"))
    run(design, "export", "--project", project, "--out", ours)
    run(sys.executable, "-m", fontmake.__name__, "-u", project, "-o", "ttf",
        "--output-path", theirs, "--keep-overlaps", "--conversion-error",
        CONVERSION_ERROR_EM, "--verbose", "ERROR")
    worst = worst_pixel(freetype.Face(str(ours)), freetype.Face(str(theirs)))
    print(f"{project.name}: fontmake's font and ours differ by {worst} of 255 "
          f"in a pixel at {SIZES_PX} px")
    expect(worst <= MOST_OF_255, f"{project.name}: {worst} > {MOST_OF_255}")


def make_foreign(path):
    """As other editors leave a project: each in its own habit of writing."""
    font = ufoLib2.Font()
    font.info.unitsPerEm = 1000
    font.info.familyName = "Foreign"
    font.info.openTypeOS2Panose = [2, 0, 5, 3, 6, 0, 0, 2, 0, 3]
    font.info.guidelines = [{"x": 0, "y": 700, "angle": 0, "name": "cap"}]
    font.lib.update({
        "public.glyphOrder": ["A", "o"],
        "public.postscriptNames": {"A": "A"},
        "public.openTypeCategories": {"A": "base"},
        "com.github.googlei18n.ufo2ft.filters": [
            {"name": "decomposeTransformedComponents", "pre": True}],
        "com.github.googlei18n.ufo2ft.featureWriters": [
            {"class": "KernFeatureWriter", "options": {"mode": "append"}}],
        "com.schriftgestaltung.DisplayStrings": ["A\u00e9\u4e00"],
        "com.schriftgestaltung.disablesAutomaticAlignment": False,
        "com.typemytype.robofont.segmentType": "curve",
        "com.typemytype.robofont.layerOrder": ["sketch"],
        "com.typemytype.robofont.guideline.magnetic.x": 5,
        "com.defcon.sortDescriptor": [
            {"type": "glyphList", "ascending": ["A"]}],
        "com.fontlab.v5.date": 1.25})
    font.features.text = "feature liga {\n} liga;\n"
    font.groups["public.kern1.A"] = ["A"]
    font.kerning[("public.kern1.A", "o")] = -12.5
    font.data["com.typemytype.robofont/settings.bin"] = b"\0\1\xff"
    letter = font.newGlyph("A")
    letter.width, letter.unicodes, letter.note = 600, [65, 0x391], "a < b & c"
    letter.lib.update({
        "public.markColor": "0.5,0,1,1",
        "public.verticalOrigin": 880,
        "com.typemytype.robofont.mark": [1, 0.5, 0, 1],
        "com.typemytype.robofont.Image.Brightness": 0,
        "com.schriftgestaltung.Glyphs.lastChange": "2024-01-02 03:04:05 +0000",
        "com.fontlab.hintData": {"vhints": [{"position": 5, "width": -20}]}})
    pen = letter.getPen()
    pen.moveTo((0, 0))
    pen.curveTo((0, 300), (200.5, 600), (300, 600))
    pen.lineTo((500, 0))
    pen.closePath()
    letter.contours[0].points[1].identifier = "p1"
    letter.appendAnchor({"x": 250, "y": 600, "name": "_top"})
    ring = font.newGlyph("o")
    ring.getPen().addComponent("A", (0.5, 0, 0.1, -0.5, 20, 30))
    font.newLayer("sketch").newGlyph("A").width = 5
    font.save(path)


def check_foreign(design, folder):
    project, copy = folder / "Foreign.ufo", folder / "Copy.ufo"
    make_foreign(project)
    before = contents(project)
    run(design, "replay", "--project", project, "--out", copy)
    run(design, "replay", "--project", project)
    expect(len(before) == 13, f"ufoLib2 wrote {len(before)} files")
    expect(contents(project) == before, "saving changes a foreign project")
    expect(contents(copy) == before, "a copy differs from a foreign project")
    # Changes keep data of unknown kinds.
    run(design, "replay", "--project", project, "--do",
        '{"do": "set_advance", "glyph": "A", "width": 601}')
    letter = ufoLib2.Font.open(copy)["A"]
    letter.width = 601
    expect(ufoLib2.Font.open(project)["A"] == letter,
           "a change of the advance changes more of a foreign glyph")
    check_valid(project)


def main():
    design, = sys.argv[1:]
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        for project in make_projects(design, folder):
            check_valid(project)
            check_compiled(design, project, folder)
        check_foreign(design, folder)
    finish()


main()
