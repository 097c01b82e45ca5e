"""Checks inkcell-editor as scripts drive it, and its pictures.

Usage: check_editor.py INKCELL_EDITOR INKCELL_RENDER
"""
import json
import pathlib
import shutil
import struct
import subprocess
import sys
import tempfile
import zlib

FONT = "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf"
PLIST = '<plist version="1.0">{}</plist>'
PROBLEMS = []


def expect(condition, what):
    if not condition:
        PROBLEMS.append(what)


class Editor:
    """Runs scripts in a folder, without a display."""

    def __init__(self, program, folder):
        self.program = program
        self.folder = folder

    def run(self, *lines):
        """What the script printed, as a list of reports."""
        result = self.start(*lines)
        if result.returncode != 0:
            sys.exit(f"{lines}: {result.stderr.strip()}")
        return [json.loads(line) for line in result.stdout.splitlines()]

    def start(self, *lines):
        script = self.folder / "script.txt"
        script.write_text("\n".join(lines) + "\n")
        return subprocess.run([self.program, "--script", script], text=True,
                              cwd=self.folder, capture_output=True,
                              check=False)


def points_of(report):
    return [point for contour in report["contours"] for point in contour]


def check_edits(editor):
    """A dragged point, undo and redo, and what survives a program's end."""
    before, moved, undone, redone = editor.run(
        f"open {FONT} P.ufo A,a,H,O", "glyph a", "print", "drag 3 10 0",
        "print", "key ctrl+z", "print", "key ctrl+y", "print")
    old, new = points_of(before)[3], points_of(moved)[3]
    expect([new[0] - old[0], new[1] - old[1]] == [10, 0],
           f"drag: {old} became {new}")
    expect(undone["contours"] == before["contours"], "undo")
    expect(redone["contours"] == moved["contours"], "redo")
    expect(0 < moved["bytes"] < 200 and moved["points"] > 8,
           f"figures: {moved['bytes']} bytes, {moved['points']} points")
    # Nothing was saved: the journal has it.
    opened, = editor.run("open P.ufo", "print")
    expect("Recovered 3 changes" in opened["message"], opened["message"])
    editor.run("open P.ufo", "save", "export F.ttf", "save Q.ufo")
    # FreeType reads the exported font.
    font, = editor.run("open F.ttf R.ufo", "glyph a", "print")
    places = [point[:2] for point in points_of(font)]
    expect(new[:2] in places and old[:2] not in places,
           "the exported outline holds the new point")
    expect((editor.folder / "Q.ufo/glyphs").is_dir(), "a copy is written")


def check_points(editor):
    """Keys on the selection."""
    before, nudged, shorter = editor.run(
        "open P.ufo", "glyph A", "print", "select 0 1", "key shift+up", "print",
        "select 0", "key delete", "print")
    old, new = points_of(before), points_of(nudged)
    expect([p[1] for p in new[:2]] == [p[1] + 10 for p in old[:2]]
           and new[2:] == old[2:], "nudge")
    expect(len(points_of(shorter)) == len(old) - 1, "delete")
    drawn, = editor.run("open P.ufo", "glyph O", "key ctrl+a", "key delete",
                        "tool Pen", "press 0 0", "release 0 0",
                        "press 400 0", "release 400 0",
                        "press 400 400", "move 300 500", "release 300 500",
                        "press 0 0", "release 0 0", "print")
    contour, = drawn["contours"]
    expect([point[2] for point in contour].count("curve") == 2 and
           contour[0][2] == "curve", f"pen: {contour}")


def check_tools(editor):
    knife, ring = editor.run(
        "open P.ufo", "glyph O", "key ctrl+a", "key delete", "tool Rectangle",
        "press 100 0", "move 500 300", "release 500 300", "tool Ellipse",
        "press 600 0", "move 900 300 shift", "release 900 300", "tool Knife",
        "press 50 150", "move 1000 150", "release 1000 150", "print",
        "key ctrl+a", "key delete", "nib ellipse:60,20,30", "tool Stroke",
        "press 100 100", "move 300 500", "move 500 100", "release 500 100",
        "print")
    expect(len(knife["contours"]) == 4, f"knife: {knife['contours']}")
    height = {point[1] for contour in knife["contours"] for point in contour}
    expect({0, 150, 300} <= height, f"knife: {height}")
    expect(len(ring["contours"]) == 1 and ring["bytes"] > 0, "stroke")
    # A cut through both contours of a ring leaves two parts.
    halves, = editor.run("open P.ufo", "key ctrl+z", "glyph O", "key ctrl+a",
                         "key delete", "tool Ellipse", "press 0 0",
                         "move 800 800", "release 800 800", "press 200 200",
                         "move 600 600", "release 600 600", "select 12",
                         "do {\"do\": \"reverse_contour\", \"contour\": 1}",
                         "tool Knife", "press -50 401", "move 900 401",
                         "release 900 401", "print")
    expect(len(halves["contours"]) == 2, f"ring: {halves['contours']}")
    parts, = editor.run("open P.ufo", "glyph A",
                        'do {"do": "add_component", "base": "H"}', "print")
    expect(parts["components"] == 1, "component")
    # A command ends a drag.
    guided, = editor.run("open P.ufo", "glyph O", "key ctrl+a",
                         "key delete", "tool Rectangle", "press 100 0",
                         "move 500 300", "key g", "release 500 300", "print")
    expect(not guided["contours"] and len(guided["guides"]) == 1,
           f"a guide during a drag: {guided}")
    gone, = editor.run("open P.ufo", 'do {"do": "add_glyph", "glyph": "x"}',
                       "glyph x", "tool Pen", "press 0 0", "release 0 0",
                       "press 90 0", 'do {"do": "delete_contour", '
                       '"contour": 0}', "move 300 300", "release 300 300",
                       "tool Rectangle", "press 0 0", "move 90 90",
                       'try do {"do": "delete_glyph"}', "try key ctrl+v",
                       "try release 90 90", "glyph a", "try glyph x", "print")
    expect(gone["glyph"] == "a" and "'x'" in gone["message"],
           f"a glyph that goes during a drag: {gone['message']}")


def check_clipboard(editor):
    """Copies within a glyph and between glyphs."""
    before, twice, pasted, gone = editor.run(
        "open P.ufo", "glyph H", "print", "select 0", "key ctrl+a",
        "key ctrl+d", "print", "key ctrl+z", "key ctrl+a", "key ctrl+x",
        "glyph a", "key ctrl+v", "print", "glyph H", "print")
    old, new = before["contours"][0], twice["contours"][1]
    expect([(b[0] - a[0], b[1] - a[1]) for a, b in zip(old, new)] ==
           [(41, -41)] * len(old), f"duplicate: {old} became {new}")
    expect(twice["selected"] == len(old), "the duplicate is not selected")
    expect(pasted["contours"][-1] == old and not gone["contours"],
           f"paste: {pasted['contours'][-1]}, left {gone['contours']}")
    part, = editor.run("open P.ufo", "key ctrl+z", "glyph a", "key ctrl+z",
                       "select 3 6", "key ctrl+c", "key ctrl+v", "print",
                       "key ctrl+z")
    contour = part["contours"][-1]
    expect([point[2] for point in contour] == ["move", "offcurve",
                                                 "offcurve", "qcurve"],
           f"a part of a contour: {contour}")


def check_levels(editor):
    """Guides, snapping, alignment, lines that become curves."""
    free, level, guided, moved, aligned, curved = editor.run(
        "open P.ufo", "glyph H", "key ctrl+a", "key delete", "tool Rectangle",
        "press 100 0", "move 400 500", "release 400 500", "tool Rectangle",
        "press 600 3", "move 900 700", "release 900 700", "tool Select",
        "press 400 500", "move 497 703 free", "release 497 703", "print",
        "press 497 703", "move 400 703", "release 400 703", "print",
        'do {"do": "add_guideline", "x": 450}', "press 400 700", "move 447 650",
        "release 447 650", "print", "press 450 -300", "move 350 -300",
        "release 350 -300", "print", "select 4 5 6 7", "select 0 4",
        "key ctrl+shift+a", "print", "press 250 2 alt", "release 250 2",
        "print")
    point = points_of(free)[2]
    expect(point[:2] == [497, 703], f"without snapping: {point}")
    point = points_of(level)[2]
    expect(point[:2] == [400, 700], f"level with a neighbour: {point}")
    point = points_of(guided)[2]
    expect(point[:2] == [450, 650], f"on a guide: {point}")
    expect(moved["guides"] == [{"x": 350}], f"guides: {moved['guides']}")
    expect({points_of(aligned)[i][1] for i in (0, 4)} == {2},
           f"aligned: {points_of(aligned)}")
    kinds = [point[2] for point in curved["contours"][0]]
    expect(kinds.count("curve") == 1 and kinds.count("offcurve") == 2,
           f"a line becomes a curve: {curved['contours'][0]}")


def check_latency(editor):
    times, = editor.run("open P.ufo", "glyph a", "sizes 12 48", "latency 3")
    expect(all(0 < times[what]["median_ms"] <= times[what]["worst_ms"]
               for what in ("drag", "device", "stroke")), f"latency: {times}")


def check_preview(editor, render):
    """The pixels of the preview are those of inkcell-render."""
    mono = ("--levels", "2", "--hint", "display")
    for px, display, options in ((12, "mono", mono), (20, "mono", mono),
                                 (16, "lcd", ("--lcd", "rgb"))):
        editor.run("open P.ufo", "glyph a", "text Haa",
                   f"preview {px} {display} dark", f"sizes {px}",
                   "save_preview p.ppm", "save_preview p.bin")
        subprocess.run([render, "--font", "p.bin", "--text", "Haa", "--px",
                        str(px), *options, "--out", "r.ppm" if display == "lcd"
                        else "r.pgm"], cwd=editor.folder, check=True,
                       capture_output=True)
        ours = pixels(editor.folder / "p.ppm")
        theirs = pixels(editor.folder / ("r.ppm" if display == "lcd" else
                                         "r.pgm"))
        expect(ours == theirs and any(ours[1]), f"{px} px {display}: the "
               "preview differs from inkcell-render")
    cells, lacking = editor.run("open P.ufo", "glyph a", "text Haa",
                                "cells on", "print", "text Ha\u017fx",
                                "print")
    expect(cells["cells"] > 20 and cells["missing"] == "", "cells")
    expect(lacking["missing"] == "x\u017f", f"missing: {lacking['missing']}")


def pixels(file):
    """Size and bytes of a PGM or PPM; three bytes a pixel."""
    data = file.read_bytes()
    magic, width, height = data[:20].split()[:3]
    size = (int(width), int(height))
    data = data[-size[0] * size[1] * (3 if magic == b"P6" else 1):]
    if magic == b"P5":
        data = bytes(value for value in data for _ in range(3))
    return size, data


def check_screenshots(editor):
    lines = ("open P.ufo", "glyph a", "screenshot a.ppm")
    editor.run(*lines)
    first = (editor.folder / "a.ppm").read_bytes()
    editor.run(*lines)
    expect(first == (editor.folder / "a.ppm").read_bytes(),
           "two screenshots of one state differ")
    editor.run("open P.ufo", "glyph a", "select 3", "screenshot b.ppm")
    expect(first != (editor.folder / "b.ppm").read_bytes(),
           "a selected point is not seen")
    size, colours = pixels(editor.folder / "a.ppm")
    expect(size == (1440, 900) and len(set(colours[::3])) > 50, "screenshot")


def png(width, height, rows):
    """The bytes of a PNG of greys."""
    def chunk(kind, data):
        return (struct.pack(">I", len(data)) + kind + data +
                struct.pack(">I", zlib.crc32(kind + data)))
    head = struct.pack(">IIBBBBB", width, height, 8, 0, 0, 0, 0)
    data = zlib.compress(b"".join(b"\0" + bytes(row) for row in rows))
    return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", head) +
            chunk(b"IDAT", data) + chunk(b"IEND", b""))


def check_picture(editor):
    """A picture behind a glyph: shown, saved as it was, taken away."""
    picture = png(64, 64, [[0 if (x // 8 + y // 8) % 2 else 255
                            for x in range(64)] for y in range(64)])
    (editor.folder / "board.png").write_bytes(picture)
    kept = editor.folder / "P.ufo/images/board.png"
    shown, undone, again = editor.run(
        "open P.ufo", "glyph a", "screenshot without.ppm",
        "background board.png", "print", "screenshot with.ppm", "key ctrl+z",
        "print", "screenshot undone.ppm", "key ctrl+y", "print", "save")
    expect([r["picture"] for r in (shown, undone, again)] ==
           ["board.png", "", "board.png"], "a picture, undone and redone")
    names = ("without.ppm", "with.ppm", "undone.ppm")
    shots = [(editor.folder / name).read_bytes() for name in names]
    expect(shots[0] != shots[1] and shots[0] == shots[2], "a picture is seen")
    expect(kept.read_bytes() == picture, "the project keeps the picture")
    glif = next((editor.folder / "P.ufo/glyphs").glob("a.glif")).read_text()
    expect('<image fileName="board.png" xScale="32" yScale="32"' in glif,
           f"the picture is as high as the em: {glif[:400]}")
    editor.run("open P.ufo", "glyph a", 'do {"do": "set_image"}', "save")
    expect(not kept.exists(), "a picture that no glyph names is taken away")
    for line, message in (("background none.png", "none.png: No such file"),
                          ("background script.txt", "is no sound PNG"),
                          ('do {"do": "set_image", "file": "none.png"}',
                           "images/none.png is missing")):
        result = editor.start("open P.ufo", "glyph a", line)
        expect(result.returncode == 1 and message in result.stderr,
               f"{line}: said {result.stderr!r}")


def check_layers(editor):
    """The outline of another layer lies behind the glyph."""
    folder = editor.folder / "P.ufo/glyphs.sketch"
    editor.run("open P.ufo", "glyph H", "screenshot alone.ppm", "save")
    folder.mkdir()
    shutil.copy(editor.folder / "P.ufo/glyphs/A_.glif", folder / "H_.glif")
    (folder / "contents.plist").write_text(PLIST.format(
        "<dict><key>H</key><string>H_.glif</string></dict>"))
    (editor.folder / "P.ufo/layercontents.plist").write_text(PLIST.format(
        "<array><array><string>public.default</string><string>glyphs</string>"
        "</array><array><string>sketch</string><string>glyphs.sketch</string>"
        "</array></array>"))
    editor.run("open P.ufo", "glyph H", "screenshot layer.ppm", "key shift+l",
               "screenshot hidden.ppm", "save")
    alone, layer, hidden = ((editor.folder / name).read_bytes() for name in
                            ("alone.ppm", "layer.ppm", "hidden.ppm"))
    expect(alone != layer, "another layer is not seen")
    expect(alone == hidden, "another layer cannot be hidden")
    expect((folder / "H_.glif").exists(), "another layer is lost")


def check_messages(editor):
    """What went wrong is said in red until the next change."""
    failed, after = editor.run(
        "open P.ufo", "glyph H", "screenshot said.ppm",
        'try do {"do": "delete_contour", "contour": 9}', "print",
        "screenshot problem.ppm", "key g", "print", "key ctrl+z")
    expect("allowed are" in failed["message"] and after["message"] == "",
           f"messages: {failed['message']!r}, {after['message']!r}")
    red = bytes((196, 64, 52))
    status = slice(-1440 * 3 * 25, None)  # the lowest 25 rows
    said, problem = ((editor.folder / name).read_bytes()[status]
                     for name in ("said.ppm", "problem.ppm"))
    expect(red in problem and red not in said, "a problem is not red")


def check_errors(editor):
    for line, message in (("glyph a", "open a font first"),
                          ("frob", "'frob' is not known"),
                          ("open missing.ufo", "missing.ufo")):
        result = editor.start(line)
        expect(result.returncode != 0 and message in result.stderr,
               f"{line}: said {result.stderr!r}")
    result = editor.start(f"open {FONT} P.ufo")
    expect("exists" in result.stderr, "a project is not overwritten")


def main():
    program, render = (str(pathlib.Path(name).resolve())
                       for name in sys.argv[1:])
    with tempfile.TemporaryDirectory() as name:
        editor = Editor(program, pathlib.Path(name))
        check_edits(editor)
        check_points(editor)
        check_tools(editor)
        check_clipboard(editor)
        check_levels(editor)
        check_latency(editor)
        check_preview(editor, render)
        check_screenshots(editor)
        check_picture(editor)
        check_layers(editor)
        check_messages(editor)
        check_errors(editor)
    for problem in PROBLEMS:
        print(problem)
    sys.exit(1 if PROBLEMS else 0)


main()
