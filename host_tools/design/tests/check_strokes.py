"""Checks glyphs that are made of strokes in inkcell-editor: knots and nibs that
are dragged, what is kept, contours beside them, the changes between strokes,
curves and fields, and the sample.

Usage: check_strokes.py INKCELL_EDITOR
"""
import re

from editor_script import points_of, run_checks
from problems import expect

NEW = "new P.ufo n,o,v Untitled 1000 800 -200 500 700"
STEM = ("tool Stroke", "press 100 500", "move 100 400", "move 100 250",
        "move 100 100", "move 100 0", "release 100 0")


def stroke_of(report, number=0):
    return report["strokes"][number]


def edges(report, y):
    """Where the outline's lines and curves have points near a height."""
    xs = [p[0] for p in points_of(report) if abs(p[1] - y) < 40]
    return (min(xs), max(xs)) if xs else None


def check_knots(editor):
    drawn, moved, undone, redone = editor.run(
        NEW, "screenshot 0.ppm", "nib ellipse:80,80,0", *STEM, "print",
        "tool Select", "press 100 0", "move 150 -20", "move 200 -30",
        "release 200 -30", "print", "key ctrl+z", "print", "key ctrl+y",
        "print")
    stroke = stroke_of(drawn)
    expect(stroke["smooth"] and stroke["points"] == [[100, 500], [100, 0]],
           f"a straight stroke has two knots: {stroke}")
    expect(stroke_of(moved)["points"] == [[100, 500], [200, -30]],
           f"a dragged knot: {stroke_of(moved)}")
    expect(edges(moved, -30)[1] > 215 and moved["contours"] !=
           drawn["contours"], f"the outline follows: {moved['contours']}")
    expect(undone["contours"] == drawn["contours"] and
           undone["strokes"] == drawn["strokes"], "undo of a knot")
    expect(redone["contours"] == moved["contours"], "redo of a knot")
    # The journal, the project and an export have it.
    opened, = editor.run("open P.ufo", "glyph n", "print", "save",
                         "export F.ttf")
    expect(opened["strokes"] == moved["strokes"], "recovered strokes")
    saved, = editor.run("open P.ufo", "glyph n", "print")
    expect(saved["strokes"] == moved["strokes"] and
           saved["contours"] == moved["contours"], "saved strokes")
    font, = editor.run("open F.ttf R.ufo", "glyph n", "print")
    expect(not font["strokes"] and edges(font, -30)[1] > 215,
           f"an exported stroke: {font['contours']}")


def click(x, y, *more):
    return " ".join(map(str, ("press", x, y, *more))), f"release {x} {y}"


def check_clicks(editor):
    """Each click adds a knot; a double click, or an undo, ends the stroke."""
    dot, drawn, ended, undone, again = editor.run(
        NEW.replace("P.ufo", "C.ufo"), "screenshot 0.ppm",
        "nib ellipse:80,80,0",
        "tool Stroke", *click(100, 0), "print", *click(100, 400),
        *click(300, 500), "print", *click(300, 500, "twice"),
        *click(500, 0), "print", "key ctrl+z", "print", *click(500, 100),
        "print")
    bend = [[100, 0], [100, 400], [300, 500]]
    expect(stroke_of(dot)["points"] == [[100, 0]] and
           edges(dot, 0) == (60, 140), f"a dot of the nib: {dot['contours']}")
    expect(len(drawn["strokes"]) == 1 and stroke_of(drawn)["smooth"] and
           stroke_of(drawn)["points"] == bend, f"clicks: {drawn['strokes']}")
    expect([s["points"] for s in ended["strokes"]] == [bend, [[500, 0]]],
           f"a double click ends a stroke: {ended['strokes']}")
    expect(undone["strokes"] == drawn["strokes"], "undo of a click")
    expect([s["points"] for s in again["strokes"]] == [bend, [[500, 100]]],
           f"a click after undo: {again['strokes']}")


def check_nibs(editor):
    """The nib of one knot turns and widens; the other keeps its own."""
    wide, turned, high, refused = editor.run(
        "open P.ufo", "glyph o", "nib ellipse:80,60,0", *STEM, "tool Select",
        "press 100 0", "release 100 0", "press 140 0", "move 180 0",
        "release 200 0", "print", "press 180 0", "move 100 80",
        "release 100 80", "print", "press 70 0", "move 20 5", "release 20 5",
        "print", 'try do {"do": "move_points", "points": [[0, 0]], "dx": 1}',
        "print")
    expect([p[2:] for p in stroke_of(wide)["points"]] ==
           [[80, 60, 0], [160, 60, 0]], f"a wider nib: {stroke_of(wide)}")
    low, top = edges(wide, 0), edges(wide, 500)
    expect(abs(low[0] - 20) <= 1 and abs(low[1] - 180) <= 1 and
           top == (60, 140),
           f"the outline widens: {low}, {top}")
    expect(stroke_of(turned)["points"][1][2:] == [160, 60, 90],
           f"a turned nib: {stroke_of(turned)}")
    expect(stroke_of(high)["points"][1][2:] == [160, 160, 90],
           f"a higher nib: {stroke_of(high)}")
    expect("Turn into outline" in refused["message"], refused["message"])


def check_corners(editor):
    """Knots are added, deleted, and made corners."""
    added, corner, gone = editor.run(
        "open P.ufo", "glyph o", "key ctrl+a", "key delete",
        "nib ellipse:40,40,0", *STEM, "tool Select", "press 100 250",
        "release 100 250", "press 100 250 twice", "release 100 250",
        "press 100 250", "move 300 250", "release 300 250", "print", "key s",
        "print", "key delete", "print")
    expect([p[:2] for p in stroke_of(added)["points"]] ==
           [[100, 500], [300, 250], [100, 0]], f"a knot: {added['strokes']}")
    expect(stroke_of(corner)["points"][1][5:] == ["corner"],
           f"a corner: {corner['strokes']}")

    def widest(report):
        return max(p[0] for p in points_of(report))

    # A bend passes the knot upright, with the nib's edge right of it.
    expect(abs(widest(added) - 320) <= 1 and
           any(p[2] == "curve" and p[1] > 300 for p in points_of(added)),
           f"a bend: {added['contours']}")
    expect(corner["contours"] != added["contours"], "a corner is no bend")
    expect(len(stroke_of(gone)["points"]) == 2, f"deleted: {gone['strokes']}")


def check_change_of_paradigm(editor):
    """Strokes and trees become curves, and are back by undo."""
    made, curves, edited, back = editor.run(
        "open P.ufo", "glyph n", "print", "action Turn into outline", "print",
        "drag 0 5 0", "print", "key ctrl+z", "key ctrl+z", "print")
    expect(not curves["strokes"] and curves["contours"] == made["contours"],
           "strokes become their outline")
    expect(edited["contours"] != made["contours"], "its points move")
    expect(back["strokes"] == made["strokes"] and
           back["contours"] == made["contours"], "strokes are back")
    # A part that is made of strokes: the tree follows its knots.
    tree, followed, outline, again = editor.run(
        "open P.ufo", "glyph v", 'do {"do": "set_tree", "tree": {"op": '
        '"union", "parts": [{"glyph": "n"}, {"glyph": "n", "matrix": '
        '{"move": [200, 0]}}]}}', "print", "glyph n", "press 200 -30",
        "move 250 -30", "release 250 -30", "glyph v", "print",
        "action Turn into outline", "print", "key ctrl+z", "print")
    expect(followed["contours"] != tree["contours"], "a tree of strokes")
    expect(outline["contours"] == followed["contours"] and
           not outline["tree"], "a tree becomes its outline")
    expect(again["tree"] == tree["tree"], "a tree is back")
    times, = editor.run("open P.ufo", "glyph n", "latency 3")
    expect(all(0 < times[what]["cpu_ms"] < 500 for what in
               ("knot", "nib", "to_outline", "back")), f"latency: {times}")
    print({what: times[what]["cpu_ms"] for what in times})


def check_field_curves(editor):
    """The outline goes to a field and back; undo brings the points back."""
    font = "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf"
    before, curves, back, none, asked, agreed = editor.run(
        f"open {font} F.ufo a,U+20", "glyph a", "print",
        "action Curves from the field", "print", "key ctrl+z", "print",
        "glyph space", "try action Curves from the field", "print",
        "open P.ufo", "glyph n", "try action Curves from the field", "print",
        "action Turn into outline", "print", "key ctrl+z")
    said = re.fullmatch(
        r"Curves from the field: (\d+) points became (\d+), the edge moved by "
        r"([\d.]+) units at most", curves["message"])
    counts = [len(points_of(report)) for report in (before, curves)]
    expect(said and [int(said[1]), int(said[2])] == counts,
           f"{counts}: {curves['message']}")
    # The font has 2048 units an em: `roundtrip` finds twice 0.33, and points
    # are rounded by up to 0.7.
    expect(said and 0 < float(said[3]) < 1.5, curves["message"])
    expect(curves["contours"] != before["contours"] == back["contours"],
           "undo of curves")
    expect("no closed contours" in none["message"], none["message"])
    expect("Turn into outline" in asked["message"] and asked["strokes"],
           asked["message"])
    expect(not agreed["strokes"] and
           agreed["contours"] != asked["contours"], "curves of strokes")


def check_mixed(editor):
    """A glyph of contours and strokes keeps both apart, and exports one."""
    new = "new M.ufo n,o Untitled 1000 800 -200 500 700"
    arch = ("press 140 400", "move 250 460", "move 400 300", "move 400 0",
            "release 400 0")
    drawn, point, knot, moved, undone = editor.run(
        new, "glyph n", "tool Rectangle", "press 60 0", "move 140 500",
        "release 140 500", "nib ellipse:80,60,20", "tool Stroke", *arch,
        "print", "tool Select", "press 140 500", "move 155 520 free",
        "release 155 520", "print", "press 400 0", "release 400 0",
        "press 400 0", "move 430 30 free", "release 430 30", "print",
        "key ctrl+a", "key right", "print", *["key ctrl+z"] * 3, "print")
    stem, arch_outline = drawn["contours"]
    expect(drawn["own_contours"] == 1 and len(drawn["strokes"]) == 1 and
           [p[:2] for p in stem] == [[60, 0], [140, 0], [140, 500], [60, 500]],
           f"a stroke beside a contour: {drawn['contours']}")
    expect(point["contours"][0][2][:2] == [155, 520] and
           point["contours"][1] == arch_outline and
           point["strokes"] == drawn["strokes"], "a point beside a stroke")
    expect(knot["strokes"][0]["points"][-1] == [430, 30] and
           knot["contours"][0] == point["contours"][0] and
           knot["contours"][1] != arch_outline, "a knot beside a contour")
    expect(moved["selected"] == 4 + len(moved["strokes"][0]["points"]) and
           moved["strokes"][0]["points"][-1] == [431, 30] and
           moved["contours"][0][2][:2] == [156, 520], "both move")
    expect(undone["contours"] == drawn["contours"] and
           undone["strokes"] == drawn["strokes"] and
           undone["own_contours"] == 1, "undo beside a stroke")
    # More contours, some of them deleted; then the project and a font.
    more, fewer, united = editor.run(
        "open M.ufo", "glyph n", "tool Rectangle", "press 300 600",
        "move 340 640", "release 340 640", "print", "key delete", "print",
        "save", "export M.ttf", "open M.ttf RM.ufo", "glyph n", "print")
    expect(more["own_contours"] == 2 and len(more["contours"]) == 3 and
           more["strokes"] == drawn["strokes"] and more["selected"] == 4,
           f"a contour beside a stroke: {more['contours']}")
    expect(fewer["own_contours"] == 1 and
           fewer["contours"] == drawn["contours"], "deleted beside a stroke")
    expect(len(united["contours"]) == 1, f"exported: {united['contours']}")
    opened, outline, back = editor.run(
        "open M.ufo", "glyph n", "print", "action Turn into outline", "print",
        "key ctrl+z", "print")
    expect(opened["contours"] == back["contours"] == drawn["contours"] and
           opened["own_contours"] == back["own_contours"] == 1, "saved")
    expect(outline["own_contours"] == 2 and not outline["strokes"] and
           outline["contours"] == drawn["contours"], "all are contours")


def check_snapping(editor):
    """Knots snap to guides, points and other knots, which they stay off with
    Ctrl."""
    guided, free, level = editor.run(
        "new S.ufo n Untitled 1000 800 -200 500 700", "glyph n",
        'do {"do": "add_guideline", "x": 300}', "nib ellipse:60,60,0",
        "tool Stroke", "press 100 400", "move 100 100", "release 100 100",
        "tool Select", "press 100 100", "release 100 100", "press 100 100",
        "move 303 140", "release 303 140", "print", "key ctrl+z",
        "press 100 100", "move 303 140 free", "release 303 140", "print",
        "press 303 140", "move 250 398", "release 250 398", "print")
    ends = [stroke_of(report)["points"][1] for report in
            (guided, free, level)]
    expect(ends == [[300, 140], [303, 140], [250, 400]], f"snapped: {ends}")


def check_sample(editor):
    """The project that shows the three ways to make glyphs."""
    stroke, curves, tree, changed = editor.run(
        "sample", "print", "glyph o", "print", "glyph b", "print", "glyph n",
        'do {"do": "set_advance", "width": 570}', "print")
    expect(len(stroke["strokes"]) == 2 and "n is made of strokes" in
           stroke["message"], f"sample: {stroke['strokes']}")
    expect(len(curves["contours"]) == 2 and not curves["strokes"] and
           not curves["tree"], f"sample: {curves['contours']}")
    expect(tree["tree"]["op"] == "blend", f"sample: {tree['tree']}")
    again, = editor.run("sample", "print")
    expect(again["width"] == changed["width"] == 570, "the sample again")


run_checks(check_knots, check_clicks, check_nibs, check_corners, check_change_of_paradigm,
           check_field_curves, check_mixed, check_snapping, check_sample)
