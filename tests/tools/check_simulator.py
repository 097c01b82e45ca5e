#!/usr/bin/env python3
"""Compares what inkcell-simulator shows with what other programs draw.

Usage: check_simulator.py --fontgen PROGRAM --simulator PROGRAM
         --render PROGRAM --animate PROGRAM [--screens screens.json]

With --screens: the boards' scenes against those that the tests of screens draw;
without: everything else.
"""
import argparse
import json
import pathlib
import sys
import tempfile
import unittest

from programs import PROGRAMS, SANS, finished as run

WIDTH, HEIGHT = 128, 64
# The window of a screenshot, and its panels.
WINDOW = 1280, 800
SIDE, BAR, STATUS, ROOM = 352, 46, 30, 26


def read_pnm(path):
    """Width, height and pixels as tuples of a PGM or PPM."""
    kind, size, _, data = path.read_bytes().split(b"\n", 3)
    width, height = map(int, size.split())
    channels = {b"P5": 1, b"P6": 3}[kind]
    pixels = [tuple(data[i:i + channels]) * (3 // channels)
              for i in range(0, len(data), channels)]
    assert len(pixels) == width * height
    return width, height, pixels


def memory_of(picture, kind):
    """The bytes that a display of a format needs to show a picture."""
    width, height, pixels = picture
    if kind == "xrgb8888":
        return b"".join(bytes((b, g, r, 255)) for r, g, b in pixels)
    if kind == "rgb565":
        return b"".join((r >> 3 << 11 | g >> 2 << 5 | b >> 3)
                        .to_bytes(2, "little") for r, g, b in pixels)
    levels = [r for r, _, _ in pixels]
    if kind == "grey4":
        return bytes(levels[i] // 17 << 4 | levels[i + 1] // 17
                     for i in range(0, len(levels), 2))
    assert kind == "mono_pages"
    return bytes(sum((levels[(page + bit) * width + x] == 255) << bit
                     for bit in range(8))
                 for page in range(0, height, 8) for x in range(width))


class Case(unittest.TestCase):
    ROM_FONT = None  # SANS, converted once for all

    def setUp(self):
        # pylint: disable-next=consider-using-with
        self.temporary = tempfile.TemporaryDirectory()
        self.addCleanup(self.temporary.cleanup)
        self.folder = pathlib.Path(self.temporary.name)

    def script(self, *lines, font=(), code=0):
        """`font`: a file and options, if not the font that is converted."""
        file = self.folder / "script.txt"
        file.write_text("\n".join(lines) + "\n")
        return run("simulator", "--font", *(font or [self.ROM_FONT]),
                   "--script", file, code=code)

    def saved(self, *lines, name="shown.ppm", font=()):
        """What the display shows, and what the script prints."""
        file = self.folder / name
        done = self.script(*lines, f"save {file}", "print", font=font)
        content = (file.read_bytes() if name.endswith(".bin")
                   else read_pnm(file))
        return content, json.loads(done.stdout)


class Text(Case):
    """Text is what inkcell-render draws with the same settings."""

    def compare(self, display, settings, options):
        shown, report = self.saved(
            f"display {display}", "text Hamburg 012\\nScale",
            *(f"{name} {value}" for name, value in settings.items()))
        drawn = self.folder / ("drawn.ppm" if display == "lcd" else "drawn.pgm")
        x, y = report["origin"]
        run("render", "--font", self.ROM_FONT, "--text", "Hamburg 012\nScale",
            "--width", WIDTH, "--height", HEIGHT, f"--ox={x}", f"--oy={y}",
            "--wrap", WIDTH - 4, "--align", "centre", "--out", drawn,
            *options,
            *(f"--{name}={value}"
              for name, value in {"hint": "display", **settings}.items()))
        expected = read_pnm(drawn)
        self.assertIn((255, 255, 255), expected[2])
        self.assertEqual(shown, expected, f"{display} {settings}")

    def test_displays(self):
        for display, options in (("mono", ("--levels", 2)),
                                 ("mono_pages", ("--levels", 2)),
                                 ("grey2", ("--levels", 4, "--filter", "text")),
                                 ("grey8", ()),
                                 ("xrgb8888", ()),
                                 ("lcd", ("--lcd", "rgb"))):
            for px in (13, 20.5):
                self.compare(display, {"px": px}, options)

    def test_styles(self):
        for settings in ({"weight": 0.4}, {"weight": -0.25, "px": 24},
                         {"filter": "motion"}, {"filter": "paper_body"},
                         {"filter": "area"}, {"hint": "both", "px": 11},
                         {"hint": "vertical"}, {"angle": 17.5},
                         {"angle": -90, "filter": "area"}):
            self.compare("grey8", {"px": 16, **settings}, ())
        self.compare("mono", {"px": 11, "hint": "both"}, ("--levels", 2))

    def test_shift(self):
        still, before = self.saved("display grey8", "px 18")
        moved, after = self.saved("display grey8", "px 18", "shift 0.25,-1")
        self.assertEqual(after["origin"], [before["origin"][0] + 0.25,
                                           before["origin"][1] - 1])
        self.assertNotEqual(still, moved)

    def test_theme(self):
        dark, _ = self.saved("display mono", "text H", "theme dark")
        light, _ = self.saved("display mono", "text H", "theme light")
        self.assertEqual([tuple(255 - v for v in p) for p in dark[2]],
                         light[2])


class Scenes(Case):
    """Scenes are what inkcell-animate plays."""

    def test_frames(self):
        for scene in ("path", "clock", "particles", "figure13", "figure15"):
            frames = self.folder / scene
            run("animate", scene, "--font", self.ROM_FONT, "--size", "96x64",
                "--from", 40 / 30, "--seconds", 0, "--format", "frames",
                "--out", frames)
            shown = self.folder / "shown.png"
            self.script(f"scene {scene}", "display xrgb8888", "size 96x64",
                        "frame 40", f"save {shown}")
            self.assertEqual(shown.read_bytes(),
                             (frames / "00040.png").read_bytes(), scene)

    def test_recording(self):
        """A recording is the GIF of inkcell-animate."""
        played = self.folder / "played.gif"
        recorded = self.folder / "recorded.gif"
        run("animate", "clock", "--font", self.ROM_FONT, "--size", "96x64",
            "--fps", 30, "--seconds", 10, "--zoom", 2, "--format", "gif",
            "--out", played)
        done = self.script("scene clock", "display xrgb8888", "size 96x64",
                           "zoom 2", "frame 40", f"record {recorded}", "print")
        self.assertEqual(recorded.read_bytes(), played.read_bytes())
        self.assertEqual(json.loads(done.stdout)["frame"], 40)
        run("simulator", "--font", self.ROM_FONT, "--scene", "clock",
            "--display", "mono", "--size", "32x16", "--record", recorded)
        self.assertEqual(recorded.read_bytes()[:10],
                         b"GIF89a" + bytes((32, 0, 16, 0)))
        for line, said in ((f"record {recorded}", "does not move"),
                           ("record x.png", ".gif"),
                           ("record nowhere/a.gif", "nowhere")):
            lines = [] if "move" in said else ["scene clock"]
            done = self.script(*lines, line, code=1)
            self.assertIn(said, done.stderr)

    def test_strips(self):
        """The picture is the same for every height of a strip."""
        for lines in (("display grey4", "angle 30"),
                      ("display mono_pages", "px 24"),
                      ("board lm3s6965evb_grey4", "scene demo", "frame 77"),
                      ("scene clock", "display rgb565", "frame 50")):
            whole, _ = self.saved(*lines, "rows 64", name="whole.bin")
            for rows in (8, 24):
                part, report = self.saved(*lines, f"rows {rows}",
                                          name="part.bin")
                self.assertEqual(part, whole, f"{lines} {rows}")
                self.assertEqual(report["strips"], -(-64 // rows))
                self.assertEqual(report["strip_bytes"],
                                 len(whole) * rows // 64)


class Window(Case):
    def screenshot(self, *lines, font=()):
        file = self.folder / "window.ppm"
        self.script(*lines, f"screenshot {file}", font=font)
        return read_pnm(file)

    def test_display(self):
        """The window shows the display's pixels as squares."""
        lines = ("display rgb565", "px 20", "grid off")
        (_, _, pixels), _ = self.saved(*lines)
        width, height, shown = self.screenshot(*lines)
        self.assertEqual((width, height), WINDOW)
        room = WINDOW[0] - SIDE, WINDOW[1] - BAR - STATUS
        zoom = min((room[0] - 2 * ROOM) // WIDTH, (room[1] - 2 * ROOM) // HEIGHT)
        left = room[0] // 2 - zoom * WIDTH // 2
        top = room[1] // 2 - zoom * HEIGHT // 2
        for y in range(zoom * HEIGHT):
            row = shown[(top + y) * width + left:][:zoom * WIDTH]
            expected = [pixels[y // zoom * WIDTH + x // zoom]
                        for x in range(zoom * WIDTH)]
            self.assertEqual(row, expected, f"row {y}")

    def test_overlay(self):
        letters = SANS, "--symbols", "Og"

        def pixels(*lines):
            """All but the last rows, which tell how long a frame took."""
            width, height, shown = self.screenshot(*lines, font=letters)
            return shown[:width * (height - STATUS)]

        plain = pixels("text Og", "px 40", "grid off")
        self.assertTrue(plain == pixels("text Og", "px 40", "grid off"))
        self.assertFalse(plain == pixels("text Og", "px 40"))
        for coding, what in (("outline", "points"), ("field", "leaves")):
            lines = f"coding {coding}", "text Og", "px 40", "grid off"
            _, report = self.saved(*lines, font=letters)
            self.assertGreater(report[what], 20, coding)
            self.assertEqual(report[{"points": "leaves",
                                     "leaves": "points"}[what]], 0)
            self.assertFalse(pixels(*lines) == pixels(*lines, "overlay on"))


class Interface(Case):
    def test_help(self):
        words = run("simulator", "--help").stdout
        for word in ("--board", "--rows", "--script", "screenshot FILE.png"):
            self.assertIn(word, words)
        self.assertRegex(run("simulator", "--version").stdout,
                         r"^inkcell-simulator \d+\.\d+\.\d+, font format")

    def test_errors(self):
        for line, words in (("dance", "command 'dance' is not known"),
                            ("scene dance", "there are text demo path"),
                            ("board mouse", "lm3s6965evb_grey4"),
                            ("display paper", "there are: mono"),
                            ("size 100x64", "multiples of 8"),
                            ("px many", "a number from 4 to 1024"),
                            ("rows 1.5", "a whole number"),
                            ("grid maybe", "one of on off"),
                            ("save picture.doc", ".doc"),
                            ("save nowhere/a.png", "nowhere")):
            done = self.script("# a comment", line, code=1)
            self.assertIn("script.txt:2: ", done.stderr)
            self.assertIn(words, done.stderr)
        for lines in (("hint both", "angle 30"), ("filter area", "display lcd"),
                      ("display mono", "weight 1")):
            self.script(*lines, "print", code=1)
        done = run("simulator", "--px", "2", "--save", "x.png", code=1)
        self.assertIn("--px: ", done.stderr)
        run("simulator", "--dance", code=1)

    def test_options(self):
        """Options are the commands of scripts."""
        file = self.folder / "a.bin"
        run("simulator", "--scene", "path", "--board", "versatilepb_rgb565",
            "--frame", 30, "--save", file)
        by_script, report = self.saved(
            "board versatilepb_rgb565", "scene path", "frame 30", name="b.bin")
        self.assertEqual(file.read_bytes(), by_script)
        self.assertEqual((report["width"], report["height"], report["rows"]),
                         (320, 240, 16))


class Boards(Case):
    """The boards' scenes, as the tests of screens draw them."""
    SCREENS = None

    def check(self, screen, scene, frame, *command):
        drawn = self.folder / "drawn.ppm"
        run(*command, drawn)
        width, height, pixels = read_pnm(drawn)
        board, kind = screen["board"], screen["format"]
        memory, report = self.saved(f"board {board}_{kind}", f"scene {scene}",
                                    f"frame {frame}", name="memory.bin")
        scale = width // report["width"]
        small = [pixels[y * width + x] for y in range(0, height, scale)
                 for x in range(0, width, scale)]
        expected = memory_of((report["width"], report["height"], small), kind)
        self.assertGreater(len(set(small)), 1)
        self.assertEqual(memory, expected, f"{board} {kind} {scene} {frame}")

    def test_boards(self):
        for screen in json.loads(pathlib.Path(self.SCREENS).read_text()):
            for frame in (0, 5, 1000):
                self.check(screen, "demo", frame, screen["host"], "scene",
                           frame)
            for scene, program in screen["motion_hosts"].items():
                if scene != "values":  # sends rectangles: tests/screens
                    self.check(screen, scene, 57, program, 57)


def main():
    parser = argparse.ArgumentParser()
    for program in ("fontgen", "simulator", "render", "animate"):
        parser.add_argument(f"--{program}", required=True)
    parser.add_argument("--screens")
    arguments = vars(parser.parse_args())
    Boards.SCREENS = arguments.pop("screens")
    PROGRAMS.update(arguments)
    cases = [Boards] if Boards.SCREENS else [Text, Scenes, Window, Interface]
    suite = unittest.TestSuite(
        unittest.defaultTestLoader.loadTestsFromTestCase(case)
        for case in cases)
    with tempfile.TemporaryDirectory() as folder:
        Case.ROM_FONT = pathlib.Path(folder) / "sans.bin"
        run("fontgen", "--font", SANS, "--quiet", "--out", Case.ROM_FONT)
        result = unittest.TextTestRunner().run(suite)
    sys.exit(not result.wasSuccessful())


main()
