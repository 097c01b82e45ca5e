"""Checks inkcell-editor as scripts drive it, and its pictures.

Usage: check_editor.py INKCELL_EDITOR INKCELL_RENDER
"""
import json
import math
import pathlib
import plistlib
import shutil
import subprocess
import sys

from editor_script import points_of, run_checks
from pictures import pixels, png
from problems import expect

FONT = "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf"
LATO = "/usr/share/fonts/truetype/lato/Lato-Regular.ttf"
PLIST = '<plist version="1.0">{}</plist>'


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
           area(contour) < 0, f"pen: {contour}")
    # It goes on at the start of an open contour, too.
    drawn, = editor.run("open P.ufo", "glyph O", "key ctrl+a", "key delete",
                        "tool Pen", "press 100 0", "release 100 0",
                        "press 100 600", "release 100 600", "key escape",
                        "press 100 0", "release 100 0", "press 400 0",
                        "release 400 0", "export O.ttf", "print")
    contour, = drawn["contours"]
    expect([point[:2] for point in contour] ==
           [[100, 600], [100, 0], [400, 0]], f"pen at a start: {contour}")
    expect("left out: open contours of O" in drawn["message"],
           drawn["message"])


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
    # The history says what the hand did.
    for tool, place, name in (("Pen", ((300, 0),), "Add point"),
                              ("Knife", ((50, 150), (700, 150)), "Cut")):
        undone, = editor.run(
            "open P.ufo", "glyph O", "key ctrl+a", "key delete",
            "tool Rectangle", "press 100 0", "move 500 300", "release 500 300",
            f"tool {tool}", *(f"{event} {x} {y}" for event, (x, y) in zip(
                ("press", "move", "release"), (place[0], *2 * place[-1:]))),
            "key ctrl+z", "print")
        expect(undone["message"] == f"Undone: {name} of O", undone["message"])
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


def ink(editor, lines, name="ink"):
    """The dark bytes of the preview after lines of a script."""
    editor.run(*lines, f"save_preview {name}.ppm")
    _, data = pixels(editor.folder / f"{name}.ppm")
    return sum(value < 128 for value in data)


def check_overlaps(editor):
    """Ink on ink is ink, on the canvas, in the preview and in fonts."""
    opened = [f"open {LATO} L.ufo l,o,A", "glyph l", "text l",
              "preview 32 grey8 light", "sizes 32"]
    editor.run(*opened)
    opened[0] = "open L.ufo"
    before = ink(editor, opened)
    over = ("tool Rectangle", "press 100 300", "move 400 700",
            "release 400 700")
    drawn, = editor.run(*opened, *over, "screenshot over.ppm", "print",
                        "action Unite", "screenshot united.ppm", "export L.ttf")
    expect(len(drawn["contours"]) == 2, f"drawn: {drawn['contours']}")
    expect(ink(editor, opened) > before, "a rectangle over l takes ink away")
    (width, _), data = pixels(editor.folder / "over.ppm")
    view = drawn["view"]
    at = (round(284 + view["width"] / 2 + (230 - view["x"]) * view["scale"]),
          round(23 + view["height"] / 2 - (500 - view["y"]) * view["scale"]))
    place = 3 * (width * at[1] + at[0])
    paper = bytes((255, 255, 255))
    expect(data[place:place + 3] != paper,
           "the canvas shows a hole where two contours overlap")
    again = ink(editor, ["open L.ttf L2.ufo", *opened[2:]])
    expect(again > before, "an exported font has a hole")
    pen, = editor.run("open L.ufo", "glyph l", "key ctrl+a", "tool Pen",
                      "press 0 300", "release 0 300", "press 900 300",
                      "release 900 300", "press 900 700", "release 900 700",
                      "press 0 700", "release 0 700", "press 0 300",
                      "release 0 300", "print")
    expect(area(pen["contours"][-1]) < 0 and area(pen["contours"][0]) < 0,
           f"the pen's direction: {pen['contours'][-1]}")
    united, cut, common, rest = editor.run(
        "open L.ufo", "glyph A", "tool Rectangle", "press 100 -100",
        "move 1300 200", "release 1300 200", "action Unite", "print",
        "key ctrl+z", "select 23", "action Subtract", "print", "key ctrl+z",
        "select 23", "action Intersect", "print", "key ctrl+z", "select 23",
        "action Exclude", "print")
    expect([len(report["contours"]) for report in (united, cut, common)] ==
           [3, 3, 2], "Unite, Subtract, Intersect")
    sums = [sum(map(area, report["contours"]))
            for report in (united, common, rest)]
    expect(abs(sums[0] - sums[1] - sums[2]) < 2000,
           f"Unite is Intersect and Exclude: {sums}")
    expect(all(value == int(value) for report in (united, cut, common, rest)
               for point in points_of(report) for value in point[:2]),
           "combined contours have whole units")
    failed = editor.start("open L.ufo", "glyph A", "action Subtract")
    expect("select some of the contours" in failed.stderr, failed.stderr)


def area(contour):
    """Of the polygon of all points; the sign is that of the curves."""
    return sum(a[0] * b[1] - a[1] * b[0] for a, b in
               zip(contour, contour[1:] + contour[:1])) / 2


def turn(contour, i):
    """The degrees by which the direction changes at a point."""
    a, b, c = (contour[(i + k) % len(contour)] for k in (-1, 0, 1))
    into, out = (math.atan2(q[1] - p[1], q[0] - p[0])
                 for p, q in ((a, b), (b, c)))
    return abs(math.degrees((out - into + math.pi) % (2 * math.pi) - math.pi))


def check_smooth_points(editor):
    """A dragged smooth point of a TrueType glyph makes no spike, neither there
    nor at its neighbours."""
    before, = editor.run(f"open {FONT} S.ufo a,o,S", "glyph S", "print")
    contour = points_of(before)
    smooth = [i for i, point in enumerate(contour) if "smooth" in point]
    expect(len(smooth) > 5, "S has smooth points")
    kept = [i for i in smooth if contour[i - 1][2] == "offcurve" and
            contour[(i + 1) % len(contour)][2] == "offcurve"]
    for i in kept[::2]:
        moved, = editor.run("open S.ufo", "glyph S", f"drag {i} 40 25",
                            "print", "key ctrl+z")
        turns = [turn(points_of(moved), k) for k in kept]
        expect(max(turns) < 3, f"dragging point {i} of S turns the outline by "
               f"{max(turns):.0f} degrees")
    controls = [i for i, point in enumerate(contour) if point[2] == "offcurve"]
    for i in controls[::5]:
        moved, = editor.run("open S.ufo", "glyph S", f"drag {i} 30 -20",
                            "print", "key ctrl+z")
        expect(max(turn(points_of(moved), k) for k in kept) < 3,
               f"dragging handle {i} of S makes a corner")
    cubic, = editor.run("open S.ufo", "glyph S", "action Convert to cubics",
                        "print")
    expect({point[2] for point in points_of(cubic)} <=
           {"line", "curve", "offcurve"}, "S is made of cubics")


def check_new_font(editor):
    """From nothing to a font: glyphs, names, characters, other projects."""
    made, added, named, again, old, gone, exported = editor.run(
        "new New.ufo A-C,U+20 Mine 1000 750 -250 500 700", "print",
        "add D,E", "add _stem", "print", "glyph D", "tool Rectangle",
        "press 100 0", "move 200 700", "release 200 700",
        'do {"do": "rename_glyph", "to": "Delta"}',
        'do {"do": "set_unicodes", "unicodes": [8710]}', "print", "save",
        "tool Rectangle", "press 300 0", "move 400 700", "release 400 700",
        "save_as Other.ufo", "print", "open New.ufo", "glyph Delta", "print",
        "open Other.ufo", "glyph Delta", "action Delete glyph", "print",
        "export New.ttf", "print")
    expect(made["glyph"] == "A" and made["width"] == 600 and
           "4 glyphs" in made["message"], f"a new font: {made['message']}")
    expect(added["glyph"] == "A", "adding glyphs shows no other one")
    expect(named["glyph"] == "Delta", f"renamed: {named['glyph']}")
    expect("Saved as Other.ufo" in again["message"] and
           len(again["contours"]) == 2, f"saved as: {again['message']}")
    expect(len(old["contours"]) == 1, "the old project has not changed")
    expect(gone["glyph"] == "E" and "'Delta'" in gone["message"],
           f"after a deletion: {gone['message']}")
    expect(" of them empty" in exported["message"],
           f"what is not drawn: {exported['message']}")
    names = plistlib.loads((editor.folder / "New.ufo/lib.plist").read_bytes())
    expect(names["public.glyphOrder"] == ["space", "A", "B", "C", "Delta", "E",
                                          "_stem"], f"order: {names}")
    reverted, = editor.run("open Other.ufo", "action Revert", "glyph Delta",
                           "print")
    expect(len(reverted["contours"]) == 2, "Revert drops what is not saved")
    for line, message in (
            ("new New.ufo A Mine 1000 750 -250 500 700", "exists"),
            ("new X.ufo A Mine 8 750 -250 500 700", "16 to 16384"),
            ("new X.ufo A Mine 1000 7 70 500 700", "above the descender"),
            ("new X A Mine 1000 750 -250 500 700", "ends with .ufo")):
        result = editor.start(line)
        expect(result.returncode == 1 and message in result.stderr,
               f"{line}: said {result.stderr!r}")


def check_history(editor):
    """Undo by glyph, and what is said of it."""
    first, gone, back, none = editor.run(
        "new U.ufo Hano2! Mine 1000 750 -250 500 700", "glyph H",
        "tool Rectangle", "press 0 0", "move 100 700", "release 100 700",
        "glyph a", "press 0 0", "move 100 500", "release 100 500", "glyph H",
        "print", "key u", "print", "key shift+u", "print", "glyph n", "key u",
        "print")
    expect(first["history"] == ["Add contour of H", "Add contour of a"],
           f"history: {first['history']}")
    expect(gone["message"] == "Undone: Add contour of H" and
           not gone["contours"], f"undo by glyph: {gone['message']}")
    expect(back["message"] == "Redone: Add contour of H" and
           back["contours"] == first["contours"], "redo by glyph")
    expect("nothing to undo in n" in none["message"], none["message"])
    # Undo of all shows the glyph that it changes.
    other, same = editor.run("open U.ufo", "glyph n", "key ctrl+z", "print",
                             "key ctrl+y", "print")
    expect(other["message"].startswith("Undone: ") and other["glyph"] == "H",
           f"{other['message']}, shown is {other['glyph']}")
    expect(same["message"].startswith("Redone: ") and same["glyph"] == "H",
           same["message"])
    # 'Hano2!' is characters; the preview's text is kept with the project.
    names = plistlib.loads((editor.folder / "U.ufo/lib.plist").read_bytes())
    expect(set(names["public.glyphOrder"]) == {"H", "a", "n", "o", "two",
                                               "exclam"}, f"Hano2!: {names}")
    editor.run("open U.ufo", "text Hano2!", "save")
    names = plistlib.loads((editor.folder / "U.ufo/lib.plist").read_bytes())
    expect(names["org.inkcell.previewText"] == "Hano2!", "the preview's text")
    # A double click opens a component.
    opened, = editor.run("open U.ufo", "glyph o",
                         'do {"do": "add_component", "base": "a"}',
                         "tool Select", "press 50 250 twice",
                         "release 50 250", "print")
    expect(opened["glyph"] == "a", f"opened: {opened['glyph']}")
    editor.run("open U.ufo", "glyph H", "screenshot points.ppm",
               "action Black", "screenshot black.ppm")
    points, black = ((editor.folder / name).read_bytes()
                     for name in ("points.ppm", "black.ppm"))
    expect(points != black, "a black glyph looks as before")


def check_spacing(editor):
    """Side bearings and kerning by dragging in a line of text."""
    group = 'do {"do": "set_group", "group": "public.kern%d.%s", "value": %s}'
    setting = ["glyph A", "text AVAW", "sizes 32", "preview 32 grey8 light"]
    box = ["tool Rectangle", "press 50 0", "move 550 700", "release 550 700"]

    def kerning(folder="K.ufo"):
        file = editor.folder / folder / "kerning.plist"
        return plistlib.loads(file.read_bytes()) if file.exists() else {}

    before, = editor.run(
        "new K.ufo A,V,W,0xC0 Mine 1000 750 -250 500 700", *setting, *box,
        "glyph V", *box, "glyph W", *box, "glyph Agrave",
        'do {"do": "add_component", "base": "A"}', "glyph A",
        group % (1, "A", '["A", "Agrave"]'), group % (2, "V", '["V", "W"]'),
        "print", "save_preview before.ppm", "save")
    opened = ["open K.ufo", *setting]
    editor.run(*opened, "key t", "press 800 300", "move 650 300",
               "release 650 300", "save_preview after.ppm",
               "screenshot line.ppm", "export K.ttf", "save")
    expect(kerning() == {"public.kern1.A": {"public.kern2.V": -150}},
           f"a dragged V kerns the groups: {kerning()}")
    widths = [pixels(editor.folder / name)[0][0]
              for name in ("before.ppm", "after.ppm")]
    expect(widths[0] - widths[1] in (9, 10), f"kerning in the preview: {widths}")
    editor.run("open K.ttf K2.ufo", "save")
    values = [value for row in kerning("K2.ufo").values()
              for value in row.values()]
    expect(values and set(values) == {-150},
           f"the exported font is kerned: {kerning('K2.ufo')}")
    # Alt kerns the pair alone; undo takes it back.
    editor.run(*opened, "key t", "press 650 300", "move 690 300 alt",
               "release 690 300", "save")
    expect(kerning().get("A") == {"V": -110}, f"an exception: {kerning()}")
    editor.run(*opened, "key t", "press 690 300", "move 700 300",
               "release 700 300", "key ctrl+z", "save")
    expect(kerning()["A"] == {"V": -110}, f"undone: {kerning()}")
    # Bearings: the left edge moves the ink, and glyphs made of it stay.
    left, right, back, first, accent = editor.run(
        *opened, "key t", "press 2 300", "move -38 300", "release -38 300",
        "print", "press 638 300", "move 668 300", "release 668 300", "print",
        "key ctrl+z", "key ctrl+z", "print", "tool Select", "glyph Agrave",
        "print", "key ctrl+y", "print")
    expect(left["width"] == 640 and points_of(left)[0][0] == 90,
           f"a left bearing: {left['width']}, {points_of(left)}")
    expect(right["width"] == 670 and points_of(right) == points_of(left),
           f"a right bearing: {right['width']}")
    expect(back["width"] == 600 and points_of(back) == points_of(before),
           "bearings are undone")
    expect(first["points"] == accent["points"] and
           first["bytes"] == accent["bytes"], "a glyph with A as a part stays")
    result = editor.start(*opened, "key t", "press 300 300", "move 320 300")
    expect("between two glyphs" in result.stderr, result.stderr)


def check_transform(editor):
    """Selections and glyphs are turned, reflected, aligned; whole units."""
    boxes = [line for x, y, size in ((0, 0, 100), (300, 50, 200), (550, 20, 60))
             for line in ("tool Rectangle", f"press {x} {y}",
                          f"move {x + size} {y + size}",
                          f"release {x + size} {y + size}")]
    first, turned, back, tops, apart = editor.run(
        "new T.ufo A,L Mine 1000 750 -250 500 700", "glyph A", *boxes, "print",
        "select 4 5 6 7", "action Turn left", "print", "action Turn right",
        "print", "select 0 4 8", "action Align top", "print", "key ctrl+z",
        "action Distribute across", "print")
    expect([box(contour) for contour in turned["contours"]] ==
           [box(contour) for contour in first["contours"]] and
           turned["contours"][1] != first["contours"][1],
           f"a square that turns about its middle: {turned['contours']}")
    expect(back["contours"] == first["contours"], "turned back")
    expect([box(contour)[3] for contour in tops["contours"]] == [250] * 3,
           f"aligned: {tops['contours']}")
    expect([box(contour)[::2] for contour in apart["contours"]] ==
           [(0, 100), (225, 425), (550, 610)],
           f"equal gaps: {apart['contours']}")
    letter, mirrored, again, slanted = editor.run(
        f"open {FONT} T2.ufo R,O", "glyph R", "print",
        "action Reflect left and right", "print",
        "action Reflect left and right", "print",
        'do {"do": "transform", "matrix": {"slant": 45}}', "print")
    expect(again["contours"] == letter["contours"] and
           mirrored["contours"] != letter["contours"], "reflected twice")
    expect(all(b[0] == a[0] + a[1] for a, b in
               zip(points_of(letter), points_of(slanted))), "slanted by 45")
    # A part that is reflected stays ink; the hole of an O, a hole.
    kept, = editor.run("open T2.ufo", "glyph O", "key ctrl+a",
                       "action Reflect up and down", "print")
    before, = editor.run("open T2.ufo", "key ctrl+z", "glyph O", "print")
    expect([area(c) > 0 for c in kept["contours"]] ==
           [area(c) > 0 for c in before["contours"]], "directions of contours")


def box(contour):
    xs, ys = ([point[axis] for point in contour] for axis in (0, 1))
    return min(xs), min(ys), max(xs), max(ys)


def check_parts(editor):
    """A glyph made of others follows them; its parts move, not its points."""
    tree = {"op": "blend", "radius": 60,
            "parts": [{"glyph": "_stem"}, {"glyph": "_bowl"}]}
    first, dragged, blended, live = editor.run(
        "new C.ufo b Mine 1000 750 -250 500 700", "add _stem", "add _bowl",
        "glyph _stem", "tool Rectangle", "press 60 0", "move 140 700",
        "release 140 700", "glyph _bowl", "tool Ellipse", "press 100 -10",
        "move 520 510", "release 520 510", "glyph b",
        'do {"do": "add_component", "base": "_stem"}',
        'do {"do": "add_component", "base": "_bowl"}',
        "action Combine components", "print", "tool Select", "press 100 600",
        "move 80 600 free", "release 80 600", "print", "key ctrl+z",
        f'do {{"do": "set_tree", "tree": {json.dumps(tree)}}}', "print",
        "glyph _stem", "select 0 1 2 3", "key ctrl+left", "glyph b", "print",
        "save")
    expect(first["tree"]["op"] == "union" and first["components"] == 0 and
           len(first["contours"]) == 1, f"combined: {first['tree']}")
    expect(box(dragged["contours"][0])[0] == 40 and
           dragged["tree"]["parts"][0]["matrix"][4] == -20,
           f"a dragged part: {dragged['tree']}")
    corners = [[60, 0], [60, 700], [140, 700]]
    expect(all(corner in [point[:2] for point in points_of(blended)]
               for corner in corners), "a blend keeps the stem's corners")
    expect(all(value == int(value) for point in points_of(blended)
               for value in point[:2]), "a blend has whole units")
    expect(box(live["contours"][0])[0] == -40,
           f"the glyph follows its stem: {box(live['contours'][0])}")
    refused, outline, back = editor.run(
        "open C.ufo", "glyph b", "screenshot parts.ppm",
        'try do {"do": "move_points", "points": [[0, 0]], "dx": 3}', "print",
        "action Turn into outline", "print", "key ctrl+z", "print")
    expect("Turn into outline" in refused["message"] and
           refused["contours"] == live["contours"],
           f"a point of the result: {refused['message']}")
    expect(outline["tree"] is None and points_of(outline)[0][0] ==
           points_of(live)[0][0] + 3, "an outline, then the moved point")
    expect(back["tree"] == tree and back["contours"] == live["contours"],
           "undo brings the parts back")


def check_lua(editor):
    """A program in Lua draws letters; again with other parameters; undo."""
    sample = pathlib.Path(__file__).resolve().parents[1] / \
        "samples/pen_face.lua"
    thin, bold, u, back, gone = editor.run(
        "new Lua.ufo A Mine 1000 750 -250 500 700", f"lua {sample}", "glyph n",
        "print", f"lua {sample} weight=150", "print", "glyph u", "print",
        "glyph n", "key ctrl+z", "print", "glyph A", "key ctrl+z",
        "try glyph n", "print")
    expect(bold["width"] == thin["width"] + 70 and
           bold["contours"] != thin["contours"], "a heavier pen")
    expect(u["components"] == 1, f"u is drawn anew: {u['components']}")
    expect(back["contours"] == thin["contours"], "the thin pen comes back")
    expect("'n'" in gone["message"], "a program is one step for undo")
    failed = editor.start("open Lua.ufo", "glyph A", f"lua {sample} wight=3")
    expect("no such parameter; it has weight" in failed.stderr, failed.stderr)


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
    part, = editor.run("open P.ufo", "key ctrl+z", "key ctrl+z", "glyph a",
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
    handle, = editor.run("open P.ufo", "glyph a", "print")
    x, y = next(point[:2] for point in points_of(handle)
                if point[2] == "offcurve")
    shots = {}
    for name, *more in (("far", "hover -9000 0"), ("near", f"hover {x} {y}"),
                        ("dark", "key shift+d"), ("light", "key shift+d",
                                                  "key shift+d")):
        editor.run("open P.ufo", "glyph a", *more, "screenshot c.ppm")
        shots[name] = (editor.folder / "c.ppm").read_bytes()
    expect(shots["far"] == first != shots["near"],
           "handles are not only where the pointer is")
    expect(shots["dark"] != first == shots["light"], "the dark theme")
    size, colours = pixels(editor.folder / "a.ppm")
    expect(size == (1440, 900) and len(set(colours[::3])) > 50, "screenshot")


def check_picture(editor):
    """A picture behind a glyph: shown, saved as it was, taken away."""
    picture = png(64, 1, bytes(0 if (x // 8 + y // 8) % 2 else 255
                             for y in range(64) for x in range(64)))
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
    above = slice(-1440 * 3 * 30)  # the line below says what was undone
    expect(shots[0][above] != shots[1][above] and
           shots[0][above] == shots[2][above], "a picture is seen")
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
    render = str(pathlib.Path(sys.argv[2]).resolve())
    run_checks(check_edits, check_points, check_tools, check_new_font,
               check_history,
               check_overlaps, check_smooth_points, check_spacing,
               check_transform, check_parts, check_lua, check_clipboard,
               check_levels, check_latency,
               lambda editor: check_preview(editor, render),
               check_screenshots, check_picture, check_layers, check_messages,
               check_errors)


main()
