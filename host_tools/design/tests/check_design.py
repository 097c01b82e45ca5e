"""Checks inkcell-design as people use it: each subcommand, and its errors.

Usage: check_design.py INKCELL_DESIGN
"""
import json
import pathlib
import plistlib
import struct
import subprocess
import sys
import tempfile

from pictures import png
from problems import expect, finish

FONT = "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf"
LATO = "/usr/share/fonts/truetype/lato/Lato-Regular.ttf"
SERIF = "/usr/share/fonts/truetype/liberation/LiberationSerif-Regular.ttf"
SAMPLE = pathlib.Path(__file__).resolve().parents[1] / "samples/pen_face.lua"


def run(program, *arguments):
    return subprocess.run([program, *map(str, arguments)], text=True,
                          capture_output=True, check=False)


def good(program, *arguments):
    result = run(program, *arguments)
    expect(result.returncode == 0,
           f"{' '.join(map(str, arguments))}: {result.stderr.strip()}")
    return result.stdout


def bad(program, message, *arguments):
    """Fails with one line that begins with error: and holds `message`."""
    result = run(program, *arguments)
    lines = result.stderr.strip().splitlines()
    expect(result.returncode != 0 and lines and
           lines[-1].startswith("error: ") and message in lines[-1],
           f"{' '.join(map(str, arguments))}: said {result.stderr!r} "
           f"instead of {message!r}")


def check_help(design):
    text = good(design, "--help")
    for name in ("export", "import", "import-svg", "replay", "roundtrip",
                 "script", "trace"):
        expect(name in text, f"--help does not name {name}")
        expect("--" in good(design, name, "--help"), f"{name} --help")


def check_roundtrip(design, folder):
    report = folder / "r.json"
    good(design, "roundtrip", "--font", FONT, "--symbols", "eB", "--report",
         report)
    data = json.loads(report.read_text())
    expect(len(data["glyphs"]) == 2, "roundtrip: two glyphs")
    expect(0 < data["second_round_u"] <= 0.5,
           f"roundtrip: a second round moves {data['second_round_u']} u")
    # The tip of a wedge of 15 degrees is narrower than the walk's squares.
    good(design, "roundtrip", "--font", SERIF, "--symbols", "3", "--report",
         report)
    three = json.loads(report.read_text())
    expect(three["worst_u"] <= 0.5 and three["second_round_u"] <= 0.5,
           f"roundtrip: the tip of 3 is off by {three['worst_u']} u")
    # The end of a tip 1.5 u wide.
    good(design, "roundtrip", "--font", SERIF.replace("Regular", "Italic"),
         "--symbols", "{", "--report", report)
    tip = json.loads(report.read_text())
    expect(tip["second_round_u"] <= 0.4,
           f"roundtrip: {{ moves by {tip['second_round_u']} u")
    for name, glyph in data["glyphs"].items():
        expect(0 < glyph["worst_u"] <= 1.5 and 0 < glyph["rms_u"] <= 0.5,
               f"roundtrip: {name} is off by {glyph['worst_u']} u")
        expect(0 < glyph["segments"] <= glyph["source_segments"],
               f"roundtrip: {name} has {glyph['segments']} segments")
    bad(design, "'x' is not within", "roundtrip", "--font", FONT,
        "--tolerance", "x")


def check_projects(design, folder):
    project = folder / "P.ufo"
    good(design, "import", "--font", FONT, "--chars", "A-C", "--out", project)
    bad(design, "exists", "import", "--font", FONT, "--out", project)
    script = folder / "script.jsonl"
    script.write_text(
        '# a wider A, and a ring drawn with a pen\n'
        '{"do": "set_advance", "glyph": "A", "width": 1500}\n'
        '{"do": "add_glyph", "glyph": "ring", "unicodes": [9711],'
        ' "width": 2048}\n'
        '{"do": "set_strokes", "glyph": "ring", "strokes": [{"nib":'
        ' "ellipse:150", "points": [[600,300],[1100,800],[600,1300],[100,800],'
        '[600,300]]}]}\n')
    good(design, "replay", script, "--project", project)
    for name in ("f.ttf", "f.bin", "Q.ufo"):
        good(design, "export", "--project", project, "--out", folder / name)
    good(design, "export", "--project", project, "--out", folder / "f.ttf")
    foreign = folder / "foreign.ttf"
    foreign.write_bytes(pathlib.Path(FONT).read_bytes())
    bad(design, "is a font file, which would be replaced", "export",
        "--project", project, "--out", foreign)
    # The generator has read it with the device's reader.
    expect((folder / "f.bin").stat().st_size > 300, "export: f.bin is small")
    expect((folder / "f.ttf").read_bytes()[:4] == b"\0\1\0\0", "export: TTF")
    good(design, "export", "--project", project, "--glyph", "ring", "--out",
         folder / "ring.svg")
    expect((folder / "ring.svg").read_text().count("M") == 2,
           "export: a ring has two contours")
    bad(design, "--glyph", "export", "--project", project, "--out",
        folder / "x.svg")
    bad(design, "its ending says", "export", "--project", project, "--out",
        folder / "x.doc")
    script.write_text('{"do": "set_advance", "glyph": "Z", "width": 1}\n')
    bad(design, "record 1 of 1: command 'set_advance', glyph 'Z'", "replay",
        script, "--project", project)


def check_names(design, folder):
    """Glyphs of a file without names are named by their characters."""
    font = bytearray(pathlib.Path(FONT).read_bytes())
    entry = font.index(b"post", 12)  # of the table directory
    post, = struct.unpack_from(">I", font, entry + 8)
    struct.pack_into(">I", font, post, 0x30000)
    unnamed = folder / "unnamed.ttf"
    unnamed.write_bytes(font)
    project = folder / "Unnamed.ufo"
    good(design, "import", "--font", unnamed, "--chars", "A,a,0x31,0x1D538",
         "--out", project)
    names = set(plistlib.loads(
        (project / "glyphs/contents.plist").read_bytes()))
    expect(names == {".notdef", "A", "a", "one", "u1D538"},
           f"import: glyphs without names are named {sorted(names)}")


def contours_of(project, name):
    glif, = (project / "glyphs").glob(f"{name}.glif")
    return glif.read_text().count("<contour>"), glif.read_text()


def check_additions(design, folder):
    """Strokes are added to glyphs; new glyphs get their characters; each
    command says what it did."""
    project = folder / "Lato.ufo"
    said = good(design, "import", "--font", LATO, "--chars", "l,A,V,0xC4",
                "--out", project)
    expect("tables of" in said and "GSUB" in said and "fpgm" in said and
           "GPOS except kerning" in said and "hmtx" not in said,
           f"import names the tables that it leaves out: {said!r}")
    bar = folder / "bar.svg"
    bar.write_text('<svg xmlns="http://www.w3.org/2000/svg">'
                   '<path d="M0 0H600V-80H0Z"/></svg>')
    glyph = ("import-svg", "--drawing", bar, "--project", project, "--glyph")
    said = good(design, *glyph, "l")
    expect("beside 1 contour (--replace" in said and
           contours_of(project, "l")[0] == 2, f"a drawing is added: {said!r}")
    said = good(design, *glyph, "l", "--replace")
    expect("in place of 2 contours" in said and
           contours_of(project, "l")[0] == 1, f"a drawing replaces: {said!r}")
    said = good(design, *glyph, "Q")
    expect("new glyph 'Q', U+0051" in said and
           '<unicode hex="0051"' in contours_of(project, "Q_")[1],
           f"a new Q: {said!r}")
    said = good(design, *glyph, "circled", "--unicode", "U+2460")
    expect("U+2460" in said, f"--unicode: {said!r}")
    said = good(design, *glyph, "_bar", "--grid", "0")
    expect("no code point" in said, f"a part: {said!r}")
    bad(design, "is for new glyphs", *glyph, "Q", "--unicode", "U+51")
    bad(design, "one character", *glyph, "new", "--unicode", "A-C")
    good(design, "replay", "--project", project, "--do",
         '{"do": "add_component", "glyph": "V", "base": "_bar"}',
         "--do", '{"do": "set_features", "text": "feature liga {} liga;"}')
    said = good(design, "export", "--project", project, "--out",
                folder / "lato.ttf")
    expect("pairs of kerning" in said and "features.fea" in said and
           "left out: glyphs without a code point: " in said and
           "_bar" in said,
           f"export says what it leaves out: {said!r}")
    said = good(design, "export", "--project", project, "--out",
                folder / "lato.bin")
    expect("_bar" in said, f"export of an Inkcell font: {said!r}")
    again = folder / "Again2.ufo"
    good(design, "import", "--font", folder / "lato.ttf", "--out", again)
    names = set(plistlib.loads((again / "glyphs/contents.plist").read_bytes()))
    expect("_bar" not in names and "dieresis" in " ".join(names),
           f"the font has no parts but components: {sorted(names)}")
    info = [plistlib.loads((path / "fontinfo.plist").read_bytes())
            for path in (project, again)]
    expect(info[0] == info[1], f"fontinfo: {info[0]} became {info[1]}")
    for key in ("openTypeNameLicense", "openTypeOS2WinAscent", "copyright"):
        expect(key in info[0], f"import takes {key}")


def check_components(design, folder):
    """A letter with an accent is a reference, or contours if asked for."""
    for option, components in ((), 2), (("--decompose",), 0):
        project = folder / f"Accents{components}.ufo"
        good(design, "import", "--font", FONT, "--chars", "0xC9", *option,
             "--out", project)
        glif, = project.glob("glyphs/E_acute.glif")
        expect(glif.read_text().count("<component ") == components,
               f"import {' '.join(option)}: Eacute has not {components} "
               "components")
        good(design, "export", "--project", project, "--out",
             folder / f"accents{components}.ttf")


def check_scripts(design, folder):
    """Programs in Lua: parameters, curves, limits, and errors with lines."""
    thin, bold, again = (folder / name for name in
                         ("Thin.ufo", "Bold.ufo", "Again.ufo"))
    commands = folder / "commands.jsonl"
    good(design, "script", SAMPLE, "--out", thin, "--set", "weight=40",
         "--commands", commands)
    good(design, "script", SAMPLE, "--out", bold, "--set", "weight=150")
    good(design, "replay", commands, "--out", again)
    files = sorted(path.relative_to(thin) for path in thin.rglob("*.*"))
    expect(len(files) > 8 and all((again / name).read_bytes() ==
                                  (thin / name).read_bytes()
                                  for name in files),
           "script: its commands do not make the same project")
    expect((bold / "glyphs/n.glif").read_bytes() !=
           (thin / "glyphs/n.glif").read_bytes(), "script: --set does nothing")
    good(design, "export", "--project", bold, "--out", folder / "bold.ttf")
    script = folder / "s.lua"

    def fails(message, text, *options):
        script.write_text(text)
        bad(design, message, "script", script, "--out", folder / "N.ufo",
            *options)
        expect(not (folder / "N.ufo").exists(),
               f"{message}: a script that fails leaves a project")

    fails("s.lua:2: ", "local a = 1\nlocal b = = 2\n")
    fails("s.lua:2: attempt to", "local a = nil\nlocal b = a.x\n")
    fails("s.lua:3: command 'set_advance', glyph 'q'", "\n\n"
          "set_advance{glyph = 'q', width = 1}\n")
    fails("s.lua:2: curve: knot 2 is not", "\ncurve{{0, 0}, {1}}\n")
    fails("s.lua:1: parameter 'w' is 9", "param('w', 1, 0, 2)", "--set", "w=9")
    fails("no such parameter; it has w", "param('w', 1)", "--set", "v=9")
    fails("steps", "while true do pcall(function() while true do end end) end",
          "--steps", "100000")
    fails("memory", "local t = 'x' while true do t = t .. t end")
    for name in ("io", "os", "require", "load", "dofile", "debug"):
        fails("nil value", f"local f = {name}.x or {name}()\n")
    # A circle of four knots: handles of 0.5523 radii, Hobby's figure.
    good_script = """
local path = curve{{100, 0}, {0, 100}, {-100, 0}, {0, -100}, closed = true}
local function near(a, b) return math.abs(a - b) < 0.01 end
assert(#path == 4 and near(path[1][4], 55.228) and near(path[1][5], 55.228))
local given = curve{{0, 0, dir = 90}, {100, 100, dir = 0}}[1]
assert(near(given[3], 0) and near(given[6], 100) and near(given[4], 55.228))
local straight = curve{{0, 0}, {100, 0}, {250, 0}}
assert(near(straight[1][4], 0) and near(straight[2][5], 200))
local round = superellipse(0, 0, 100, 100)
for _, p in ipairs(round) do assert(near(p[1] ^ 2 + p[2] ^ 2, 10000)) end
add_glyph{glyph = "o", width = 200}
set_contours{glyph = "o", contours = {contour(path)}}
assert(#glyph("o").contours[1] == 12 and glyphs()[1] == "o")
"""
    script.write_text(good_script)
    good(design, "script", script, "--out", folder / "N.ufo")


def check_pictures(design, folder):
    master = folder / "m.png"
    master.write_bytes(png(100, 1, bytes(
        0 if 20 < x < 80 and 30 < y < 70 else 255
        for y in range(100) for x in range(100))))
    report = folder / "t.json"
    good(design, "trace", "--master", master, "--px-per-em", 1024, "--out",
         folder / "t.svg", "--report", report)
    data = json.loads(report.read_text())
    expect(data["contours"] == 1 and data["segments"] >= 4, f"trace: {data}")
    check_glyphs(design, folder, master)
    master.write_bytes(png(2, 1, bytes([255] * 4)))
    bad(design, "holds no ink", "trace", "--master", master, "--px-per-em",
        1024, "--out", folder / "t.svg")


def stroke(glyph, nib, points):
    """The command that draws a glyph with a pen."""
    return json.dumps({"do": "set_strokes", "glyph": glyph,
                       "strokes": [{"nib": nib, "points": points}]})


def check_glyphs(design, folder, master):
    """Pictures that become glyphs, and glyphs that are combined."""
    project = folder / "G.ufo"
    good(design, "replay", "--do", '{"do": "add_glyph", "glyph": "empty"}',
         "--do", '{"do": "add_glyph", "glyph": "dot"}', "--do",
         stroke("dot", "ellipse:80", [[300, 300]]), "--do",
         '{"do": "add_glyph", "glyph": "line"}', "--do",
         stroke("line", "rectangle:80,20,45",
                [[100, 100], [300, 700, 40, 80, 30], [600, 100]]),
         "--out", project)
    bad(design, "nib 'round'", "replay", "--project", project, "--do",
        stroke("dot", "round", [[300, 300]]))
    bad(design, "points of a stroke are", "replay", "--project", project,
        "--do", stroke("dot", "ellipse:80", [[100]]))
    glyph = ("--project", project, "--glyph")
    good(design, "trace", "--master", master, "--em", "0,99,90,99",
         "--threshold", 100, *glyph, "bar")
    good(design, "trace", "--master", master, "--px-per-em", 90,
         "--scan", *glyph, "bar")
    good(design, "export", *glyph, "line", "--out", folder / "s.svg")
    good(design, "import-svg", "--drawing", folder / "s.svg", *glyph, "stroke")
    good(design, "replay", "--project", project, "--do",
         '{"do": "add_glyph", "glyph": "both"}', "--do",
         '{"do": "set_tree", "glyph": "both", "tree": {"op": "blend",'
         ' "radius": 60, "parts": [{"glyph": "bar"}, {"glyph": "dot",'
         ' "matrix": {"reflect": "x", "turn": 90, "move": [300, 500]}}]}}',
         "--do", '{"do": "add_component", "glyph": "empty", "base": "bar",'
         ' "matrix": {"reflect": "y"}}')
    for name in ("bar", "stroke", "dot", "both", "empty"):
        picture = folder / "glyph.svg"
        good(design, "export", *glyph, name, "--out", picture)
        expect("C" in picture.read_text() or "L" in picture.read_text(),
               f"{name} has no outline")
    bad(design, "--out which picture", "import-svg", "--drawing",
        folder / "s.svg")
    bad(design, "or with --em", "trace", "--master", master, *glyph, "bar")
    bad(design, "record 1 of 1: a tree of shapes", "replay", "--project",
        project, "--do", '{"do": "set_tree", "glyph": "bar", "tree": 3}')
    bad(design, "--do '{'", "replay", "--project", project, "--do", "{")


def main():
    design, = sys.argv[1:]
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        check_help(design)
        check_roundtrip(design, folder)
        check_projects(design, folder)
        check_names(design, folder)
        check_additions(design, folder)
        check_components(design, folder)
        check_scripts(design, folder)
        check_pictures(design, folder)
    finish()


main()
