"""Works in inkcell-editor's window with a pointer and keys, in Xvfb, and
compares each picture, byte for byte, with that of a script doing the same.

Usage: check_window.py INKCELL_EDITOR INKCELL_RENDER
       check_window.py INKCELL_EDITOR --letters FOLDER

The second writes only the font of eight letters, Letters.ttf, and letters.png,
the window with it.
"""
import json
import pathlib
import shutil
import subprocess
import sys
import tempfile
import time
import unittest

from xvfb import Display, wait

FONT = "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf"
CHARS = "A,a,H,O"
PROGRAM = str(pathlib.Path(sys.argv[1]).resolve())
WIDTH, HEIGHT = 1440, 900
CANVAS = 284, 23          # upper left corner, at scale 1
REST = 600, 850           # a place of the canvas where nothing is [px]
MONO = 1100, 44           # the button of the display of 1 bit [px]
SIZE = 1140, 74           # the field of the glyph's size [px]
TEXT = 1300, 74           # the field of the preview's text [px]
OPERATOR = 1120, 703      # the field of a tree's operator [px]
BLEND = 1120, 826         # its item Blend [px]
SAMPLE = 676, 398         # the button that opens the sample [px]
# The font of eight letters: FreeType's coverage against Inkcell's. Edges are off
# by 16/255 px at most, the font's tolerance, across a pixel up to 1.41 px long;
# FreeType rounds points to 1/64 px, 4 on an edge's pixel.
SIZES_PX = 12, 24, 32, 48
MOST_OF_255 = 26
PICTURE = 494, 381        # of the first glyph in Add component [px]
PICTURES = 49             # from one to the next one [px]
GLYPH_MENU = 105, 12      # the menu, and its item Curves from the field [px]
FIELD_CURVES = 180, 224
SMALL = 1024, 600         # of a screen [px]
SMALL_ADVANCE = 765, 405  # the field of the advance on it [px]
SELECTED_TEXT = bytes((173, 203, 239))  # behind selected text


def run_script(folder, *lines, scale=1):
    """What the lines print."""
    script = pathlib.Path(folder) / "script.txt"
    script.write_text("\n".join(lines) + "\n")
    done = subprocess.run([PROGRAM, "--script", script, "--scale", str(scale)],
                          cwd=folder, text=True, capture_output=True,
                          check=False)
    if done.returncode != 0:
        raise AssertionError(f"{lines}: {done.stderr}")
    return [json.loads(line) for line in done.stdout.splitlines()]


def picture(path):
    """The pixels of a PPM."""
    return path.read_bytes().split(b"\n", 3)[3]


def drawn_by_inkcell(font, char, px):
    """Greys of a glyph by their place, as the device covers pixels."""
    reach = 2 * px
    with tempfile.TemporaryDirectory() as folder:
        out = pathlib.Path(folder) / "glyph.pgm"
        subprocess.run([sys.argv[2], "--font", font, "--text", char, "--px",
                        str(px), "--filter", "area", "--ox", str(px), "--oy",
                        str(px), "--width", str(reach), "--height", str(reach),
                        "--out", out], check=True, capture_output=True)
        greys = picture(out)
    return {(i % reach - px, i // reach - px): grey
            for i, grey in enumerate(greys) if grey}


def worst_coverage(font, chars):
    """The largest difference between FreeType's pixels and Inkcell's."""
    import freetype  # --letters does without
    from freetype_glyph import picture as drawn_by_freetype
    from freetype_glyph import worst_difference
    face = freetype.Face(str(font))
    worst = 0
    for px in SIZES_PX:
        face.set_pixel_sizes(px, px)
        for char in chars:
            theirs = drawn_by_freetype(face, face.get_char_index(char))
            worst = max(worst, worst_difference(
                theirs, drawn_by_inkcell(font, char, px)))
    return worst


def canvas_place(report, point):
    """The pixel next to a point, and the point where this pixel is."""
    view = report["view"]
    scale, half = view["scale"], (view["width"] / 2, view["height"] / 2)
    x = round(CANVAS[0] + half[0] + (point[0] - view["x"]) * scale)
    y = round(CANVAS[1] + half[1] - (point[1] - view["y"]) * scale)
    return (x, y), (view["x"] + (x - CANVAS[0] - half[0]) / scale,
                    view["y"] - (y - CANVAS[1] - half[1]) / scale)


class Session:
    """The same steps by a script and by events."""

    def __init__(self, font):
        self.opening = [f"open {FONT} P.ufo {CHARS}", "screenshot 0.ppm"]
        self.steps = []  # name, lines of the script, events
        self.font = font

    def add(self, name, lines, *events):
        self.steps.append((name, lines, events))

    def drag(self, name, report, places):
        """Presses at the first place, moves to the others, releases."""
        places = [canvas_place(report, place) for place in places]
        (x, y), at = places[0]
        self.add(f"{name}: press", [f"press {at[0]!r} {at[1]!r}"],
                 ("mousemove", x, y), ("mousedown", 1))
        for i, ((x, y), at) in enumerate(places[1:]):
            self.add(f"{name}: move {i}", [f"move {at[0]!r} {at[1]!r}"],
                     ("mousemove", x, y))
        self.add(f"{name}: release", [f"release {at[0]!r} {at[1]!r}"],
                 ("mouseup", 1))

    def key(self, name, key, line):
        self.add(name, [f"key {line}"], ("key", key))

    def mono_12px(self):
        self.add("1 bit, 12 px", ["preview 12 mono dark", "hover -9e4 -9e4"],
                 ("mousemove", *MONO), ("click", 1), ("mousemove", *SIZE),
                 ("keydown", "ctrl"), ("click", 1), ("keyup", "ctrl"),
                 ("type", "12"), ("key", "Return"), ("mousemove", *REST))

    def run_script(self, folder):
        lines = list(self.opening)
        for i, (_, more, _) in enumerate(self.steps):
            lines += more + [f"screenshot {i + 1}.ppm"]
        return run_script(folder, *lines, *self.font)


class Letters(Session):
    """A font of eight letters from nothing: i and l of boxes and curves, o of
    two ellipses, n, u and h of strokes, b and d of others, blended."""

    NAME = "Letters.ufo"
    CHARS = "0x20,b,d,h,i,l,n,o,u"  # in the order of the font
    LETTERS = "bdhilnou"
    TEXT = "hound blind"

    def __init__(self, font):
        super().__init__(font)
        self.opening = [f"new {self.NAME} {self.CHARS} Untitled 1000 800 -200 "
                        "500 700", "screenshot 0.ppm"]
        self.shown = "b"
        self.drawn = set()

    def report(self):
        """The glyph after all steps so far."""
        lines = list(self.opening)  # with a picture, which sizes the canvas
        for _, more, _ in self.steps:
            lines += more
        with tempfile.TemporaryDirectory() as folder:
            return run_script(folder, *lines, "print")[-1]

    def go_to(self, glyph):
        order = self.CHARS.split(",")
        by = order.index(glyph) - order.index(self.shown)
        self.shown = glyph
        key, line = ("Next", "pagedown") if by > 0 else ("Prior", "pageup")
        self.add(f"to {glyph}", [f"key {line}"] * abs(by),
                 *[("key", key)] * abs(by))

    def draw(self, tool, *places):
        self.key(f"tool {tool}", tool, tool)
        self.drag(f"{self.shown}: {tool}", self.view, places)
        self.drawn.add(self.shown)

    def add_part(self, base, *events):
        self.add(f"{self.shown}: part {base}",
                 [f'do {{"do": "add_component", "base": "{base}"}}'],
                 ("key", "ctrl+shift+c"), *events)
        self.drawn.add(self.shown)

    def pick_part(self, base):
        """By its picture; empty glyphs have none."""
        pictures = [c for c in self.CHARS.split(",") if c in self.drawn]
        x = PICTURE[0] + PICTURES * pictures.index(base)
        self.add_part(base, ("mousemove", x, PICTURE[1]), ("click", 1),
                      ("mousemove", *REST))

    def type_part(self, base):
        self.add_part(base, ("type", base), ("key", "Return"))

    def blend(self, add_part, *bases):
        for base in bases:
            add_part(base)
        self.key("combine", "ctrl+shift+u", "ctrl+shift+u")
        tree = {"op": "blend", "radius": 60,
                "parts": [{"glyph": base, "matrix": [1, 0, 0, 1, 0, 0]}
                          for base in bases]}
        self.add("blend", [f'do {json.dumps({"do": "set_tree", "tree": tree})}'],
                 ("mousemove", *OPERATOR), ("click", 1),
                 ("mousemove", *BLEND), ("click", 1))

    def make(self):
        self.view = self.report()
        self.add("text", [f"text {self.TEXT}", "hover -9e4 -9e4"],
                 ("mousemove", *TEXT), ("click", 1),
                 ("type", self.TEXT), ("key", "Return"), ("mousemove", *REST))
        self.go_to("l")
        self.draw("r", (80, 0), (120, 500), (160, 700))
        self.go_to("i")
        self.draw("r", (80, 0), (160, 500))
        self.draw("o", (65, 590), (175, 700))
        self.go_to("o")
        self.draw("o", (50, -10), (550, 510))
        self.draw("o", (132, 65), (468, 435))
        self.key("a hole", "ctrl+shift+d", "ctrl+shift+d")
        self.go_to("n")
        arch = [(120, 300), (150, 400), (210, 455), (290, 470), (370, 450),
                (420, 390), (440, 300), (440, 250), (440, 20)]
        self.draw("b", (120, 480), (120, 250), (120, 20))
        self.draw("b", *arch)
        self.go_to("u")
        self.draw("b", *((560 - x, 500 - y) for x, y in arch))
        self.draw("b", (440, 480), (440, 250), (440, 20))
        self.go_to("h")
        self.draw("b", (120, 680), (120, 250), (120, 20))
        self.draw("b", *arch)
        self.go_to("b")
        self.blend(self.pick_part, "l", "o")
        self.draw("v", (120, 600), (100, 600), (60, 600))
        self.go_to("d")
        self.blend(self.type_part, "l", "o")
        self.draw("v", (120, 600), (300, 600), (500, 600))
        self.key("spacing", "t", "t")
        line = self.report()
        self.drag("kerning", line, [(900, 250), (880, 250), (860, 250)])
        for letter, edge in (("l", 4418), ("i", 4668)):
            self.drag(f"right of {letter}", line, [(edge - 10, 250),
                                                   (edge - 360, 250)])


def is_asleep(process):
    """Whether all threads of a process wait for something to come."""
    try:
        return all(path.read_text().rpartition(")")[2].split()[0] == "S" for path
                   in pathlib.Path(f"/proc/{process}/task").glob("*/stat"))
    except FileNotFoundError:  # a thread has ended meanwhile
        return False


class Window:
    def __init__(self, display, folder, *arguments):
        self.display = display
        self.process = subprocess.Popen([PROGRAM, *arguments], cwd=folder,
                                        env=display.environment)
        display.focus("Inkcell")
        self.send("mousemove", *REST)

    def send(self, *event):
        """Until it is answered: server and window sleep, which they do not where
        the machine is busy and they wait for it; or the window is closed."""
        self.display.send(*event)
        asleep = 0
        while asleep < 5 and self.process.poll() is None:
            asleep = asleep + 1 if all(
                is_asleep(process.pid) for process in
                (self.display.server, self.process)) else 0
            time.sleep(0.01)

    def read_import(self):
        """Ends the dialog of what an import left out."""
        shown = self.display.pixels()
        self.send("key", "Return")
        wait(lambda: self.display.pixels() != shown, "the dialog stays")

    def play(self, session, folder):
        """The steps of a session, each compared with its picture."""
        self.wait_for(picture(folder / "0.ppm"), "opened")
        for i, (name, _, events) in enumerate(session.steps):
            for event in events:
                self.send(*event)
            self.wait_for(picture(folder / f"{i + 1}.ppm"), name)

    def new_font(self, name, chars):
        """Answers the dialog New font; Tab goes from field to field."""
        self.send("key", "ctrl+n")
        wait(lambda: SELECTED_TEXT in self.display.pixels(),
             "the name that New font proposes is not selected")
        self.send("type", name)
        for _ in range(7):
            self.send("key", "Tab")
        self.send("type", chars)
        self.send("key", "Return")

    def wait_for(self, expected, name):
        """Until the screen is this picture."""
        try:
            wait(lambda: self.display.pixels() == expected, name)
        except AssertionError as error:
            raise AssertionError(f"{error}: {self.difference(expected)}"
                                 ) from None

    def difference(self, expected):
        seen = self.display.pixels()
        wrong = [i // 3 for i in range(0, len(expected), 3)
                 if seen[i:i + 3] != expected[i:i + 3]]
        width = self.display.width
        columns = [i % width for i in wrong]
        return (f"{len(wrong)} pixels differ, in columns {min(columns)} to "
                f"{max(columns)}, rows {wrong[0] // width} to "
                f"{wrong[-1] // width}")

    def export(self, folder, name):
        """Types a name over the one that the dialog proposes."""
        self.send("key", "ctrl+e")
        wait(lambda: SELECTED_TEXT in self.display.pixels(),
             "the name that Export proposes is not selected")
        self.send("type", name)
        self.send("key", "Return")
        wait((folder / name).exists, f"{name} is not there")


class WindowTest(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        root = pathlib.Path(temporary.name)
        self.scripted, self.live, self.screen = (
            root / name for name in ("scripted", "live", "screen"))
        for folder in (self.scripted, self.live, self.screen):
            folder.mkdir()

    def start(self, *arguments, scale=1, size=(WIDTH, HEIGHT)):
        self.display = Display(self.screen, *(scale * side for side in size))
        self.addCleanup(self.display.close)
        return self.window(*arguments)

    def window(self, *arguments):
        window = Window(self.display, self.live, *arguments)
        self.addCleanup(window.process.wait)
        self.addCleanup(window.process.kill)
        return window

    def reports(self):
        """The glyphs a and O as the window shows them first."""
        with tempfile.TemporaryDirectory() as folder:
            return run_script(folder, f"open {FONT} P.ufo {CHARS}",
                              "screenshot 0.ppm", "glyph a", "print",
                              "glyph O", "print")

    def test_font_is_edited_saved_and_exported(self):
        letter, empty = self.reports()
        steps = Session(["export Mine.ttf", "export Mine.bin"])
        for glyph in "HOa":
            steps.key(f"glyph {glyph}", "Next", "pagedown")
        x, y = letter["contours"][0][3][:2]
        steps.drag("point", letter, [(x, y), (x - 20, y + 10), (x - 60, y)])
        steps.key("undo", "ctrl+z", "ctrl+z")
        steps.key("redo", "ctrl+y", "ctrl+y")
        steps.add("menu Glyph", ["action Curves from the field"],
                  ("mousemove", *GLYPH_MENU), ("click", 1),
                  ("mousemove", *FIELD_CURVES), ("click", 1))
        steps.key("curves undone", "ctrl+z", "ctrl+z")
        steps.key("stroke tool", "b", "b")
        steps.drag("stroke", letter, [(300, 900), (600, 1000), (900, 1200)])
        steps.key("select tool", "v", "v")
        steps.drag("knot", letter, [(300, 900), (250, 850), (200, 800)])
        steps.mono_12px()
        steps.key("glyph O", "Prior", "pageup")
        steps.key("all points", "ctrl+a", "ctrl+a")
        steps.key("no points", "Delete", "delete")
        steps.key("stroke tool", "b", "b")
        steps.drag("stroke", empty, [(300, 100), (500, 700), (800, 900),
                                     (1100, 300)])
        steps.key("save", "ctrl+s", "ctrl+s")
        steps.run_script(self.scripted)
        window = self.start(FONT, "--project", "P.ufo", "--chars", CHARS)
        window.read_import()
        window.play(steps, self.scripted)
        for name in ("Mine.ttf", "Mine.bin"):
            window.export(self.live, name)
            self.assertEqual((self.live / name).read_bytes(),
                             (self.scripted / name).read_bytes(), name)
        window.send("key", "ctrl+q")
        self.assertEqual(window.process.wait(timeout=600), 0)

    def test_new_font_is_made_and_quitting_asks(self):
        steps = Session([])
        steps.opening = ["new Mine.ufo 0x20-0x7E Untitled 1000 800 -200 500 "
                         "700", "screenshot 0.ppm"]
        with tempfile.TemporaryDirectory() as folder:
            report, = run_script(folder, *steps.opening, "print")
        steps.key("rectangle tool", "r", "r")
        steps.drag("box", report, [(100, 0), (180, 300), (200, 700)])
        steps.run_script(self.scripted)
        window = self.start()
        send = window.send
        send("key", "ctrl+n")
        wait(lambda: SELECTED_TEXT in self.display.pixels(),
             "the name that New font proposes is not selected")
        send("type", "Mine.ufo")
        send("key", "Return")
        window.wait_for(picture(self.scripted / "0.ppm"), "a new font")
        for i, (name, _, events) in enumerate(steps.steps):
            for event in events:
                send(*event)
            shown = picture(self.scripted / f"{i + 1}.ppm")
            window.wait_for(shown, name)
        send("key", "ctrl+q")
        wait(lambda: self.display.pixels() != shown, "quitting does not ask")
        send("key", "Escape")
        window.wait_for(shown, "back from the question")
        self.assertIsNone(window.process.poll())
        send("key", "ctrl+s")
        wait(lambda: "<contour>" in
             (self.live / "Mine.ufo/glyphs/exclam.glif").read_text(),
             "the drawing was not saved")
        send("key", "ctrl+q")
        self.assertEqual(window.process.wait(timeout=600), 0)

    def test_killed_window_loses_nothing(self):
        letter, _ = self.reports()
        steps = Session(("print",))
        for glyph in "HOa":
            steps.key(f"glyph {glyph}", "Next", "pagedown")
        x, y = letter["contours"][0][3][:2]
        for _ in range(3):
            steps.drag("point", letter, [(x, y), (x - 40, y)])
            x -= 40
        expected, = steps.run_script(self.scripted)
        run_script(self.live, f"open {FONT} P.ufo {CHARS}")
        window = self.start("P.ufo")
        for _ in "HOa":
            window.send("key", "Next")
        journal = self.live / "P.ufo.journal"
        size = wait(lambda: journal.exists() and journal.stat().st_size,
                    "there is no journal")
        for name, _, events in steps.steps[3:]:
            for event in events:
                window.send(*event)
            if name.endswith("release"):
                size = wait(lambda: journal.stat().st_size > size and
                            journal.stat().st_size,
                            "a drag is not in the journal")
        # A fourth drag has begun.
        (x, y), _ = canvas_place(letter, (x, y))
        for event in (("mousemove", x, y), ("mousedown", 1),
                      ("mousemove", x + 90, y)):
            window.send(*event)
        window.process.kill()
        window.process.wait()
        report, = run_script(self.live, "open P.ufo", "glyph a", "print")
        self.assertIn("Recovered 3 changes", report["message"])
        self.assertEqual(report["contours"], expected["contours"])
        self.assertNotEqual(report["contours"], letter["contours"])

    def test_eight_letters_are_made_from_nothing(self):
        letters = Letters(["save", "export Letters.ttf"])
        letters.make()
        letters.mono_12px()
        letters.run_script(self.scripted)
        window = self.start()
        window.new_font(letters.NAME, letters.CHARS)
        window.play(letters, self.scripted)
        window.process.kill()  # nothing is saved
        window.process.wait()
        again = self.screen / "again"
        shutil.copytree(self.live, again)
        run_script(again, f"open {letters.NAME}", "screenshot 0.ppm")
        window = self.window(letters.NAME)
        window.wait_for(picture(again / "0.ppm"), "opened after the crash")
        window.export(self.live, "Letters.ttf")
        font = self.live / "Letters.ttf"
        self.assertEqual(font.read_bytes(),
                         (self.scripted / "Letters.ttf").read_bytes())
        window.send("key", "ctrl+s")
        kerning = self.live / letters.NAME / "kerning.plist"
        wait(kerning.exists, "the kerning is not saved")
        worst = worst_coverage(font, letters.LETTERS)
        print(f"Letters.ttf: FreeType's pixels and Inkcell's differ by {worst} "
              f"of 255 at {SIZES_PX} px")
        self.assertLessEqual(worst, MOST_OF_255)

    def test_sample_is_opened_by_a_click(self):
        run_script(self.scripted, "sample", "screenshot 0.ppm")
        window = self.start()
        for event in (("mousemove", *SAMPLE), ("click", 1), ("mousemove", *REST)):
            window.send(*event)
        window.wait_for(picture(self.scripted / "0.ppm"), "the sample")

    def test_small_screen_has_room_for_all_panels(self):
        window = self.start(FONT, "--project", "P.ufo", "--chars", CHARS,
                            size=SMALL)
        geometry = self.display.geometry("Inkcell")
        self.assertIn("Position: 0,0 ", geometry)
        self.assertIn("Geometry: 1024x600", geometry)
        journal = self.live / "P.ufo.journal"
        wait(journal.exists, "there is no journal")
        window.read_import()
        for event in (("mousemove", *SMALL_ADVANCE), ("keydown", "ctrl"),
                      ("click", 1), ("keyup", "ctrl"), ("type", "1234"),
                      ("key", "Return")):
            window.send(*event)
        wait(lambda: '"width":1234' in journal.read_text(),
             "the field of the advance is out of reach")

    def test_widgets_are_scaled(self):
        run_script(self.scripted, f"open {FONT} P.ufo {CHARS}",
                   "screenshot 2.ppm", scale=2)
        window = self.start(FONT, "--project", "P.ufo", "--chars", CHARS,
                            "--scale", "2", scale=2)
        window.read_import()
        window.wait_for(picture(self.scripted / "2.ppm"), "at scale 2")


def draw_letters(folder):
    """The font of eight letters, and the window with it, in a folder."""
    letters = Letters([])
    letters.make()
    lines = [line for _, more, _ in letters.steps for line in more]
    run_script(folder, *letters.opening, *lines, "save",
               "screenshot letters.png", "export Letters.ttf")


if __name__ == "__main__":
    if len(sys.argv) == 4 and sys.argv[2] == "--letters":
        draw_letters(sys.argv[3])
    else:
        unittest.main(argv=sys.argv[:1])
