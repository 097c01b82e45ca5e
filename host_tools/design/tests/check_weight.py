"""Checks change_weight on ten letters of three faces, and compares it with
FontForge's Change Weight where python3-fontforge is installed.

Usage: check_weight.py INKCELL_DESIGN

Heights stay to the unit, counters to COUNTER_UNITS where stems are upright, that
of v halfway up to SLANTED_UNITS, points and their kinds are the same, corners
stay corners, and stems get what was asked for. Outlines turn by TURNS degrees
more than before at most: waves and loops would turn more. An eleventh letter, w,
keeps its inner counter as v does. FontForge gets the same number of units and
"retain" for counters.
"""
import json
import math
import pathlib
import subprocess
import sys
import tempfile

from problems import expect, finish

try:
    from fontTools.pens.recordingPen import DecomposingRecordingPen
    from fontTools.ttLib import TTFont
except ImportError as missing:
    print(f"skipped: {missing}; install python3-fonttools")
    sys.exit(77)
try:
    import fontforge
except ImportError:
    fontforge = None
    print("python3-fontforge is missing: nothing to compare with")

FONTS = pathlib.Path("/usr/share/fonts/truetype")
FACES = (FONTS / "dejavu/DejaVuSans.ttf",
         FONTS / "liberation/LiberationSerif-Regular.ttf",
         FONTS / "lato/Lato-Regular.ttf")
LETTERS = "HnoeavsBgR"
ALL = LETTERS + "w"
GROWTH_EM = 0.03
ROUND_LETTERS = "no"     # whose counters are between upright stems
COUNTER_UNITS = 2        # both edges are rounded
SLANTED = {"v": 0, "w": 1}  # letters, and which of their counters is measured
SLANTED_UNITS = 8        # their rows are not exactly halfway up the counter
# Where stems and counters are measured, of the height [0.3].
ROWS = {"o": 0.5, "v": 0.625, "w": 0.4}
TURNS = 150              # [degrees]
CHORDS = 12
CORNER = 20              # [degrees]
OTHER_CORNERS = 1        # letters of ten where a turn passes CORNER


def lerp(points, t):
    while len(points) > 1:
        points = [tuple(a + t * (b - a) for a, b in zip(p, q))
                  for p, q in zip(points, points[1:])]
    return points[0]


def polygons(font, letter):
    """The contours as polygons, and the number of segments and corners."""
    glyphs = font.getGlyphSet()
    pen = DecomposingRecordingPen(glyphs)
    glyphs[font.getBestCmap()[ord(letter)]].draw(pen)
    loops, segments, corners = [], 0, 0
    for operation, points in pen.value:
        if operation == "moveTo":
            loops.append([points[0]])
            tangents = []
        elif operation == "closePath":
            if loops[-1][0] != loops[-1][-1]:
                tangents.append(piece(loops[-1], [loops[-1][0]]))
            segments += len(tangents)
            corners += sum(turn(a[1], b[0]) > CORNER for a, b in
                           zip(tangents, tangents[1:] + tangents[:1]))
        elif operation == "qCurveTo":
            controls = list(points[:-1])
            for i, control in enumerate(controls):
                end = points[-1] if i + 1 == len(controls) else lerp(
                    [control, controls[i + 1]], 0.5)
                tangents.append(piece(loops[-1], [control, end]))
        else:
            tangents.append(piece(loops[-1], points))
    return loops, segments, corners


def piece(loop, points):
    """Adds a line or curve to a polygon; its directions at both ends."""
    all_points = [loop[-1], *points]
    count = 1 if len(points) == 1 else CHORDS
    loop.extend(lerp(all_points, (i + 1) / count) for i in range(count))
    distinct = [p for i, p in enumerate(all_points)
                if i == 0 or p != all_points[i - 1]] or all_points
    return (direction(distinct[0], distinct[min(1, len(distinct) - 1)]),
            direction(distinct[-2 if len(distinct) > 1 else 0], distinct[-1]))


def direction(a, b):
    return math.atan2(b[1] - a[1], b[0] - a[0])


def turn(a, b):
    return abs(math.degrees((b - a + math.pi) % (2 * math.pi) - math.pi))


def turns(loop):
    """How far a polygon turns, to both sides. [degrees]"""
    points = [p for i, p in enumerate(loop) if p != loop[i - 1]]
    ways = [direction(a, b) for a, b in zip(points, points[1:] + points[:1])]
    return sum(turn(a, b) for a, b in zip(ways, ways[1:] + ways[:1]))


def runs(loops, y):
    """Ends of ink on a level line."""
    found = []
    for loop in loops:
        for a, b in zip(loop, loop[1:] + loop[:1]):
            if (a[1] <= y) != (b[1] <= y):
                x = a[0] + (y - a[1]) * (b[0] - a[0]) / (b[1] - a[1])
                found.append((x, 1 if b[1] > a[1] else -1))
    ends, winding = [], 0
    for x, step in sorted(found):
        if winding == 0 or winding + step == 0:
            ends.append(x)
        winding += step
    return ends


class Figures:
    """Of a letter of a font."""

    def __init__(self, font, letter):
        self.loops, self.segments, self.corners = polygons(font, letter)
        self.turns = sum(turns(loop) for loop in self.loops)
        heights = [p[1] for loop in self.loops for p in loop]
        self.height = (min(heights), max(heights))
        row = runs(self.loops, self.height[0] + ROWS.get(letter, 0.3) *
                   (self.height[1] - self.height[0]))
        self.stems = [b - a for a, b in zip(row[::2], row[1::2])]
        self.counters = [b - a for a, b in zip(row[1::2], row[2::2])]
        name = font.getBestCmap()[ord(letter)]
        self.advance = font["hmtx"][name][0]


def ours(design, face, folder, units):
    project, font = folder / "P.ufo", folder / "ours.ttf"
    command = {"do": "change_weight", "by": units, "glyphs": "all"}
    for arguments in (
            ("import", "--font", face, "--chars",
             ",".join(f"U+{ord(c):04X}" for c in ALL + "xdp"), "--out",
             project),
            ("replay", "--project", project, "--do", json.dumps(command)),
            ("export", "--project", project, "--out", font)):
        subprocess.run([design, *map(str, arguments)], check=True,
                       stdout=subprocess.DEVNULL)
    return TTFont(font)


def theirs(face, folder, units):
    font = fontforge.open(str(face))
    font.selection.none()
    for letter in ALL:
        glyph = font[ord(letter)]
        glyph.unlinkRef()
        glyph.changeWeight(units, "LCG", 0, 0, "retain")
        glyph.round()
    file = folder / "theirs.ttf"
    font.generate(str(file))
    font.close()
    return TTFont(file)


class Score:
    """How far letters are from what was asked for."""

    def __init__(self):
        self.height = self.counter = self.stem = self.letters = 0
        self.corners = self.points = self.turns = 0
        self.slanted = dict.fromkeys(SLANTED, 0)

    def add(self, before, after, letter, units):
        pairs = list(zip(before.counters, after.counters))
        if letter in SLANTED:
            was, now = pairs[SLANTED[letter]]
            self.slanted[letter] = abs(now - was)
        if letter not in LETTERS:
            return
        self.letters += 1
        self.height = max(self.height, *(abs(a - b) for a, b in zip(
            before.height, after.height)))
        self.turns = max(self.turns, after.turns - before.turns)
        if letter in ROUND_LETTERS:
            self.counter = max([self.counter, *(abs(b - a)
                                                for a, b in pairs)])
        stems = list(zip(before.stems, after.stems))
        if letter in ROUND_LETTERS + "H":
            self.stem = max([self.stem, *(abs(b - a - units)
                                          for a, b in stems)])
        self.corners += before.corners != after.corners
        self.points += before.segments != after.segments

    def text(self):
        return (f"heights off by {self.height:.2f}, counters by "
                f"{self.counter:.1f}, those of "
                + ", ".join(f"{letter} by {units:.1f}" for letter, units in
                            self.slanted.items()) +
                f", stems by {self.stem:.1f} units; up to "
                f"{self.turns:.0f} degrees more of turns; of "
                f"{self.letters} letters {self.corners} with other corners, "
                f"{self.points} with other segments")


def main():
    design = pathlib.Path(sys.argv[1]).resolve()
    for face in FACES:
        source = TTFont(face)
        units = round(GROWTH_EM * source["head"].unitsPerEm)
        before = {c: Figures(source, c) for c in ALL}
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name)
            fonts = {"Inkcell": ours(design, face, folder, units)}
            if fontforge:
                fonts["FontForge"] = theirs(face, folder, units)
            for maker, font in fonts.items():
                score = Score()
                for letter in ALL:
                    after = Figures(font, letter)
                    score.add(before[letter], after, letter, units)
                    if "-v" in sys.argv:
                        was = before[letter]
                        print(maker, letter, "heights", was.height,
                              after.height, "stems",
                              *(f"{v:.0f}" for v in was.stems), ">",
                              *(f"{v:.0f}" for v in after.stems), "counters",
                              *(f"{v:.0f}" for v in was.counters), ">",
                              *(f"{v:.0f}" for v in after.counters),
                              "corners", was.corners, after.corners,
                              "segments", was.segments, after.segments,
                              "advance", was.advance, after.advance)
                print(f"{face.stem}, stems {units} units wider, {maker}: "
                      f"{score.text()}")
                if maker == "Inkcell":
                    expect(score.height <= 0.5 and score.counter <=
                           COUNTER_UNITS and score.stem <= COUNTER_UNITS and
                           score.corners <= OTHER_CORNERS and
                           max(score.slanted.values()) <= SLANTED_UNITS and
                           score.turns <= TURNS and
                           score.points == 0,
                           f"{face.stem}: {score.text()}")
    finish()


main()
