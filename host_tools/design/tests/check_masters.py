"""Checks masters in inkcell-editor: layers whose points correspond, what does
not, and glyphs between them.

Usage: check_masters.py INKCELL_EDITOR
"""
from editor_script import run_checks
from problems import expect

NEW = ("new M.ufo n,o,v Untitled 1000 800 -200 500 700", "glyph n",
       "tool Rectangle", "press 60 0", "move 140 500", "release 140 500",
       "tool Select", "sizes 24")

FIRST_CELL = 67, 88  # the picture of the first glyph in the grid [px]
CELL = 40
CELLS = 49           # from one to the next one


def right_edge(report):
    return max(point[0] for point in report["contours"][0])


def check_edits(editor):
    """Each master has its own points, strokes and bearings."""
    one, added, bold, undone, back, fresh = editor.run(
        *NEW, "print", "add_master Bold", "print", "drag 1 40 0",
        "drag 2 40 0", "print", "key ctrl+z", "print", "key ctrl+y",
        "master Default", "print", "glyph v", "print")
    expect(one["master"] == "Default" and one["mismatches"] is None,
           f"one master: {one['master']}, {one['mismatches']}")
    expect(added["master"] == "Bold" and not added["mismatches"] and
           added["contours"] == one["contours"], f"a copy: {added}")
    expect([right_edge(r) for r in (one, bold, undone, back)] ==
           [140, 180, 180, 140], "points of masters")
    expect(undone["contours"] != bold["contours"], "undo in a master")
    expect(back["contours"] == one["contours"], "the other master")
    expect(fresh["master"] == "Default", "another glyph")
    # Strokes and the spacing tool; unsaved, from the journal.
    recovered, strokes, outline = editor.run(
        "open M.ufo", "master Bold", "glyph n", "print", "glyph o",
        "nib ellipse:80,80,0", "tool Stroke", "press 100 400", "move 100 0",
        "release 100 0", "tool Select", "press 100 0", "move 130 0 free",
        "release 130 0", "print", "action Turn into outline", "print", "save")
    expect(recovered["master"] == "Bold" and right_edge(recovered) == 180,
           f"recovered: {recovered['contours']}")
    expect(strokes["strokes"][0]["points"][1] == [130, 0] and
           strokes["mismatches"] == ["1 contour here, 0 in Default"],
           f"strokes in a master: {strokes}")
    expect(not outline["strokes"] and outline["master"] == "Bold" and
           outline["contours"] == strokes["contours"], "an outline")
    default, bold = editor.run("open M.ufo", "glyph o", "print",
                               "master Bold", "print")
    expect(not default["contours"] and
           bold["contours"] == outline["contours"], "saved masters")
    exported, = editor.run("open M.ufo", "master Bold", "export M.ttf",
                           "open M.ttf R.ufo", "glyph n", "print")
    expect(right_edge(exported) == 140, "an export has the default master")
    # New glyphs are in all masters, and one that varies nothing is refused.
    added, refused = editor.run(
        "open M.ufo", "add e", "glyph e", "master Bold", "print",
        "add_master Same", 'do {"do": "set_axes", "axes": [{"tag": "wght", '
        '"name": "Weight"}], "masters": {"public.default": {"wght": 400}, '
        '"Same": {"wght": 700}}}', "try export M.designspace", "print")
    expect(added["glyph"] == "e" and added["master"] == "Bold", added["master"])
    expect("the master Same is the same as Default" in refused["message"],
           refused["message"])


def check_mismatches(editor):
    """The window names the points that do not correspond."""
    line, named, more = editor.run(
        "open M.ufo", "glyph n", "master Bold",
        'do {"do": "set_point", "contour": 0, "point": 2, "type": "curve"}',
        "print", "key ctrl+z",
        'do {"do": "insert_points", "contour": 0, "at": 1, "points": '
        '[[100, 0], [110, 0]]}', "print",
        'do {"do": "add_contour", "points": [[0, 0], [9, 0], [9, 9]]}',
        "between 0.5", "print")
    expect(line["mismatches"] == ["point 3 of contour 1: the end of a curve "
                                  "here, the end of a line in Default"],
           f"types: {line['mismatches']}")
    expect(named["mismatches"] == ["contour 1: 6 points here, 4 in Default"],
           f"points: {named['mismatches']}")
    expect(more["mismatches"][0] == "2 contours here, 1 in Default",
           f"contours: {more['mismatches']}")


def check_thumbnails(editor):
    """Pictures of composites show the parts of the shown master."""
    editor.run("new T.ufo i,l,x Untitled 1000 800 -200 500 700", "glyph l",
               "tool Rectangle", "press 60 0", "move 140 500",
               "release 140 500", "glyph i",
               'do {"do": "add_component", "base": "l"}', "add_master Bold",
               "glyph l", "drag 1 300 0", "drag 2 300 0", "save")
    editor.run("open T.ufo", "glyph x", "master Bold", "screenshot t.ppm")
    rows = (editor.folder / "t.ppm").read_bytes().split(b"\n", 3)[3]
    i, l = ([rows[3 * (1440 * y + x):3 * (1440 * y + x + CELL)]
             for y in range(FIRST_CELL[1], FIRST_CELL[1] + CELL)]
            for x in (FIRST_CELL[0], FIRST_CELL[0] + CELLS))
    expect(i == l and len(set(i)) > 1, "the picture of i is not that of its part")


def check_field(editor):
    """Curves of the field begin where the contours did, and still correspond if
    they have as many points."""
    before, after = editor.run("sample", "add_master Bold", "glyph o",
                               "master Bold", "print",
                               "action Curves from the field", "print")
    starts = zip(before["contours"], after["contours"])
    expect(all(abs(a[0][0] - b[0][0]) + abs(a[0][1] - b[0][1]) <= 2
               for a, b in starts) and not after["mismatches"],
           f"curves of the field: {after['mismatches']}, {after['contours']}")


def check_between(editor):
    """The preview of a glyph between masters is that of a glyph made so."""
    editor.run(*(line.replace("M.ufo", "B.ufo") for line in NEW),
               "add_master Bold", "drag 1 40 0", "drag 2 40 0",
               "between 0.25", "preview 24 grey4", "text n",
               "save_preview quarter.ppm", "between 0", "drag 1 -10 0",
               "drag 2 -10 0", "save_preview same.ppm", "drag 1 -10 0",
               "drag 2 -10 0", "save_preview other.ppm")
    quarter, same, other = (
        (editor.folder / name).read_bytes()
        for name in ("quarter.ppm", "same.ppm", "other.ppm"))
    expect(quarter == same != other, "a preview between masters")


def check_removal(editor):
    """A master goes; the next one has a folder of its own."""
    gone, again, default = editor.run(
        "open M.ufo", "remove_master Bold", "glyph n", "master Same", "print",
        "add_master Heavy", "drag 1 40 0", "save", "open M.ufo", "glyph n",
        "master Heavy", "print", "master Same", "try remove_master Default",
        "print")
    expect(gone["master"] == "Same" and again["master"] == "Heavy" and
           right_edge(again) != right_edge(default) == 140,
           f"a master that was removed: {gone}, {again}, {default}")
    expect("there is no other master" in default["message"],
           default["message"])


run_checks(check_edits, check_mismatches, check_thumbnails, check_field,
           check_between, check_removal)
