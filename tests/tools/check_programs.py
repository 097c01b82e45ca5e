#!/usr/bin/env python3
"""Runs the host tools as a person would, and looks at what they write."""

import itertools
import json
import pathlib
import re
import subprocess
import sys

from programs import INTER, PROGRAMS, SANS, SERIF, FolderCase, main, run

TOOLS = pathlib.Path(__file__).resolve().parents[2] / "host_tools"

# Every coding, and the options that choose it.
CODINGS = {"outline": (), "field": ("--coding", "field")}


class Pgm:
    MAGIC = b"P5"
    CHANNELS = 1

    def __init__(self, path):
        data = pathlib.Path(path).read_bytes()
        magic, size, depth, self.pixels = data.split(b"\n", 3)
        assert magic == self.MAGIC and depth == b"255"
        self.width, self.height = map(int, size.split())
        assert len(self.pixels) == self.width * self.height * self.CHANNELS

    def ink(self):
        return sum(self.pixels)

    def row_ink(self, y):
        return sum(self.pixels[y * self.width:(y + 1) * self.width])

    def column_ink(self, x):
        return sum(self.pixels[x::self.width])


class Ppm(Pgm):
    MAGIC = b"P6"
    CHANNELS = 3

    def channel(self, i):
        return self.pixels[i::3]


class Tools(FolderCase):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.fonts = {}
        for name, options in CODINGS.items():
            cls.fonts[name] = cls.path / f"{name}.bin"
            run("fontgen", "--font", SANS, "--symbols", "AVToal.", "--max-px",
                "32", *options, "--quiet", "--out", cls.fonts[name])
        cls.font = cls.fonts["field"]

    def render(self, *arguments, font=None):
        out = self.path / "out.pgm"
        run("render", "--font", font or self.font, "--out", out, *arguments)
        return Pgm(out)

    def test_converts_in_memory(self):
        rom = self.render("--text", "AVa.", "--px", 24)
        ttf = self.render("--text", "AVa.", "--px", 24, "--max-px", 32,
                          *CODINGS["field"], font=SANS)
        self.assertEqual(rom.pixels, ttf.pixels)
        self.assertGreater(rom.ink(), 255 * 100)

    def test_draws_truetype_files_as_they_are(self):
        options = ("--text", "AVToal.", "--px", 32, "--hint", "none",
                   "--filter", "area")
        rom = self.render(*options, font=self.fonts["outline"])
        out = self.path / "run_time.pgm"
        run("render", "--run-time", SANS, "--out", out, *options)
        drawn = Pgm(out)
        self.assertEqual(len(rom.pixels), len(drawn.pixels))
        # The generator moves outlines within 16/255, this draws the file's.
        self.assertLessEqual(max(abs(a - b) for a, b in
                                 zip(rom.pixels, drawn.pixels)), 24)
        draw = ("--text", "a", "--px", 12, "--out", out)
        self.refused("draws exact coverage", "render", "--run-time",
                     SANS, "--filter", "text", *draw)
        self.refused("takes no --max-px", "render", "--run-time", SANS,
                     "--max-px", 20, *draw)
        self.refused("no whole TrueType file", "render", "--run-time",
                     self.font, *draw)

    def test_strips_do_not_show(self):
        for coding, angle in itertools.product(CODINGS, (0, 30)):
            pictures = {
                self.render("--text", "To\nAV", "--px", "21.5", "--angle", angle,
                            "--rows", rows, font=self.fonts[coding]).pixels
                for rows in (1, 2, 7, 8, 32, 1000)
            }
            self.assertEqual(len(pictures), 1)

    def test_codings_draw_about_the_same(self):
        pictures = {}
        for coding, font in self.fonts.items():
            for angle in (0, 30):
                pictures[coding, angle] = self.render(
                    "--text", "AVToal.", "--px", 19, "--angle", angle, "--hint",
                    "none", font=font)
            said = run("render", "--font", font, "--text", "a", "--px", 12,
                       "--stats", "--out", self.path / "a.pgm")
            self.assertIn(f"10 glyphs, coding {coding}\n", said)
        for angle in (0, 30):
            one, other = (pictures[coding, angle].pixels for coding in CODINGS)
            self.assertEqual(len(one), len(other))
            self.assertNotEqual(one, other)
            # Upright each is within 16/255 of the truth.
            if angle == 0:
                self.assertLessEqual(
                    max(abs(a - b) for a, b in zip(one, other)), 33)

    def test_converts_to_any_coding_in_memory(self):
        for coding, options in CODINGS.items():
            converted = self.render("--text", "AVToal.", "--px", 24, "--max-px",
                                    32, "--symbols", "AVToal.", *options,
                                    font=SANS)
            opened = self.render("--text", "AVToal.", "--px", 24,
                                 font=self.fonts[coding])
            self.assertEqual(converted.pixels, opened.pixels)

    def test_picture_holds_the_ink_with_a_margin(self):
        for angle in (0, 45, 90, 180, 200):
            picture = self.render("--text", "AVToal.", "--px", 20, "--angle",
                                  angle, "--filter", "paper_display")
            self.assertEqual(picture.row_ink(0), 0)
            self.assertEqual(picture.row_ink(picture.height - 1), 0)
            self.assertEqual(picture.column_ink(0), 0)
            self.assertEqual(picture.column_ink(picture.width - 1), 0)

    def test_picture_holds_motion_blur(self):
        out = self.path / "blurred.pgm"
        for motion in ("6,0", "-20,20", "0.5,32"):
            run("render", "--font", self.font, "--text", "AVT", "--px", 24,
                "--motion", motion, "--out", out)
            picture = Pgm(out)
            self.assertEqual([0, 0, 0, 0], [
                picture.row_ink(0), picture.row_ink(picture.height - 1),
                picture.column_ink(0), picture.column_ink(picture.width - 1)])

    def test_empty_values_are_values(self):
        out = self.path / "empty.pgm"
        run("render", f"--font={self.font}", "--text=", "--invert", "--px=9",
            f"--out={out}")
        self.assertEqual(Pgm(out).ink(), 255 * len(Pgm(out).pixels))
        self.refused("--symbols: it is empty", "fontgen", "--font", SANS,
                     "--symbols=", "--quiet", "--out", self.path / "empty.bin")

    def test_quarter_turn_turns_the_pixels(self):
        # With the origin on a pixel corner a quarter turn moves centres onto
        # centres.
        box = ("--width", 60, "--height", 60, "--ox", 30, "--oy", 30, "--hint",
               "none")
        flat = self.render("--text", "Va", "--px", 20, *box)
        turned = self.render("--text", "Va", "--px", 20, "--angle", 90, *box)
        for y in range(60):
            for x in range(60):
                # (x, y) goes to (y, 59 - x).
                self.assertLessEqual(
                    abs(flat.pixels[y * 60 + x]
                        - turned.pixels[(59 - x) * 60 + y]), 1)

    def test_hints_make_edges_sharp(self):
        # At 12 px the capitals of this font are 8.75 px high, its bars 1 px:
        # unfitted they lie across two rows.
        def draw(*arguments):
            return self.render("--text", "TTTT", "--px", 12, "--width", 40,
                               "--height", 20, "--ox", 4, "--oy", 15,
                               *arguments, font=self.fonts["outline"])

        plain = draw("--hint", "none")
        fitted = draw("--hint", "auto")
        self.assertEqual(fitted.row_ink(5), 0)
        self.assertGreater(fitted.row_ink(6), 1.2 * plain.row_ink(6))
        self.assertLess(fitted.row_ink(7), 0.7 * plain.row_ink(7))
        self.assertEqual(draw("--hint", "vertical").pixels, fitted.pixels)
        both = draw("--hint", "both")
        self.assertNotEqual(both.pixels, fitted.pixels)
        self.assertEqual(both.row_ink(5), 0)
        # What is turned is not fitted.
        self.assertEqual(draw().pixels, plain.pixels)
        self.assertEqual(draw("--angle", 1, "--hint", "auto").pixels,
                         draw("--angle", 1).pixels)
        self.assertEqual(draw("--angle", 360, "--hint", "both").pixels,
                         both.pixels)

    def test_hints_suit_the_size_and_the_display(self):
        def draw(px, *arguments):
            return self.render("--text", "Val", "--px", px, "--width", 60,
                               "--height", 30, "--ox", 4, "--oy", 20,
                               *arguments, font=self.fonts["outline"]).pixels

        for px, levels, hint in ((11, 256, "both"), (12, 256, "vertical"),
                                 (14, 2, "both"), (14, 4, "both")):
            auto = draw(px, "--levels", levels, "--hint", "auto")
            self.assertEqual(auto, draw(px, "--levels", levels, "--hint",
                                        hint))
        self.assertNotEqual(draw(11, "--hint", "both"),
                            draw(11, "--hint", "vertical"))

    def test_weight_and_outlines_come_from_the_same_font(self):
        box = ("--text", "Vol", "--px", 30, "--width", 70, "--height", 40,
               "--ox", 4, "--oy", 30, "--hint", "none")
        plain = self.render(*box)
        bold = self.render(*box, "--weight", 0.5)
        light = self.render(*box, "--weight", -0.5)
        self.assertGreater(bold.ink(), 1.2 * plain.ink())
        self.assertLess(light.ink(), 0.8 * plain.ink())
        outlines = {
            place: self.render(*box, "--outline", 1, "--outline-place", place)
            for place in ("inner", "centred", "outer")}
        # What lies inside, outside, and on both sides of the edge.
        pairs = list(zip(plain.pixels, outlines["inner"].pixels))
        # Two steps of a band that reaches 1.5 px, in 127ths: 3 levels each.
        self.assertTrue(all(line <= whole + 6 for whole, line in pairs))
        self.assertGreater(outlines["outer"].ink(), outlines["inner"].ink())
        self.assertEqual(self.render(*box, "--outline", 1).pixels,
                         outlines["centred"].pixels)

    def test_few_levels(self):
        box = ("--text", "Vol", "--px", 11)
        self.assertEqual(set(self.render(*box, "--levels", 2).pixels), {0, 255})
        self.assertEqual(set(self.render(*box, "--levels", 4).pixels),
                         {0, 85, 170, 255})
        self.assertNotEqual(
            *(self.render(*box, "--levels", 4, "--filter", name).pixels
              for name in ("text", "paper_body")))
        inks = [self.render("--text", "AVToal.", "--px", 13, "--levels", 2,
                            "--weight", weight).ink()
                for weight in (-0.4, -0.2, 0, 0.2, 0.35, 0.5)]
        self.assertEqual(inks, sorted(set(inks)))

    def test_fonts_of_pictures(self):
        font = self.path / "pictures.bin"
        run("fontgen", "--font", SANS, "--symbols", "Vol", "--strike", "12:1",
            "--strike-only", "--quiet", "--out", font)
        out = self.path / "pictures.pgm"
        draw = ("render", "--font", font, "--text", "Vol", "--out", out)
        self.assertEqual(run(*draw, "--px", 12), "")
        pixels = Pgm(out).pixels
        self.assertEqual(set(pixels), {0, 255})
        for hint in (), ("--hint", "display"), ("--hint", "auto"):
            run(*draw, "--px", 12, "--levels", 2, *hint)
            self.assertEqual(Pgm(out).pixels, pixels)
        self.assertEqual(run(*draw, "--px", 24), "")
        self.assertEqual(Pgm(out).ink(), 4 * sum(pixels))
        for said, *options in (
                ("alone: take --px 12 or a multiple\n", "--px", 18),
                ("alone: leave out --angle, --filter\n", "--px", 12,
                 "--levels", 2, "--angle", 9, "--filter", "text"),
                ("multiple; leave out --outline\n", "--px", 8, "--outline", 2),
                ("this font has pictures: leave it out\n", "--px", 12,
                 "--hint", "both")):
            self.refused(said, *draw, *options)

    def test_sub_pixels(self):
        out = self.path / "out.ppm"
        box = ("--font", self.font, "--text", "Vol", "--px", 13.3, "--width",
               40, "--height", 24, "--ox", 3, "--oy", 18, "--out", out)

        def draw(*options):
            run("render", *box, *options)
            return Ppm(out)
        rgb, bgr = draw("--lcd", "rgb"), draw("--lcd", "bgr")
        for i in range(3):
            self.assertEqual(rgb.channel(i), bgr.channel(2 - i))
        inks = [sum(rgb.channel(i)) for i in range(3)]
        self.assertGreater(min(inks), 0.99 * max(inks))
        self.assertNotEqual(rgb.channel(0), rgb.channel(2))
        # l, whose left edge is farther from red stripes than from blue ones.
        line = [rgb.pixels[3 * (12 * 40 + x):][:3] for x in range(40)]
        first = next(x for x in range(39, 0, -1)
                     if any(line[x]) and not any(line[x - 1]))
        self.assertLess(line[first][0], line[first][2])
        self.assertNotIn(draw("--lcd", "rgb_vertical").pixels,
                         (rgb.pixels, draw("--lcd", "bgr_vertical").pixels))
        grey = draw("--lcd", "rgb", "--lcd-colour", 0)
        self.assertEqual(grey.channel(0), grey.channel(2))
        self.assertEqual(rgb.pixels, draw("--lcd", "rgb", "--rows", 5,
                                          "--stats").pixels)

    def test_stats_count_samples(self):
        def samples(*options):
            said = run("render", "--font", self.font, "--text", "Vol", "--px",
                       20, "--stats", "--out", self.path / "a.pgm", *options)
            found = re.search(r"samples +([\d.]+) a pixel", said)
            return found and float(found.group(1))
        self.assertEqual(samples(), 1)
        self.assertGreater(samples("--samples", "adaptive"), 1.5)
        self.assertGreater(samples("--samples", "adaptive", "--radius", 1.3),
                           samples("--samples", "adaptive", "--radius", 0.5))
        self.assertIsNone(samples("--rules", "all"))

    def test_area_is_exact(self):
        font = self.fonts["outline"]

        def inks(name):
            pictures = [self.render("--text", "Val", "--px", 12, "--hint",
                                    "none", "--filter", name, "--dx", dx,
                                    "--dy", dx // 2, font=font)
                        for dx in range(0, 64, 16)]
            return [picture.ink() for picture in pictures]
        area, text = inks("area"), inks("text")
        self.assertLess(max(area) - min(area), 0.01 * min(area))
        self.assertLess(max(area) - min(area), max(text) - min(text))
        draw = ("--text", "a", "--px", 12, "--filter", "area", "--out",
                self.path / "no.png")
        self.refused("--coding outline", "render", "--font", self.font, *draw)
        self.refused("take a filter of distance", "render", "--font", font,
                     *draw, "--weight", 0.25)
        self.refused("use --samples adaptive", "render", "--font", font, *draw,
                     "--samples", "paper")

    def test_effects_change_pictures(self):
        for coding, font in self.fonts.items():
            looks = [(), ("--samples", "adaptive"), ("--motion", "2,0"),
                     ("--rules", "edges"), ("--rules", "thin")]
            looks += [(*look, "--filter", "area") for look in looks
                      if coding == "outline"]
            pictures = {tuple(self.render(
                "--text", "Va", "--px", 12, "--width", 30, "--height", 20,
                "--ox", 5, "--oy", 15, *look, font=font).pixels)
                for look in looks}
            self.assertEqual(len(pictures), len(looks))

    def test_kerning_draws_closer(self):
        kerned = self.render("--text", "AVAV", "--px", 32)
        plain = self.render("--text", "AVAV", "--px", 32, "--kerning", "off")
        self.assertLess(kerned.width, plain.width - 2)

    def test_shift_by_a_pixel_moves_by_a_pixel(self):
        box = ("--width", 80, "--height", 40, "--ox", 5, "--oy", 30)
        still = self.render("--text", "Va", "--px", 20, *box)
        moved = self.render("--text", "Va", "--px", 20, *box, "--dx", 64,
                            "--dy", -128)
        for y in range(2, 40):
            self.assertEqual(still.pixels[y * 80:y * 80 + 79],
                             moved.pixels[(y - 2) * 80 + 1:(y - 1) * 80])

    def test_picture_holds_text_that_was_shifted_far(self):
        still = self.render("--text", "Va", "--px", 20)
        for dx, dy in [(6400, 0), (-6400, 0), (0, 6400), (64, -6400)]:
            moved = self.render("--text", "Va", "--px", 20, "--dx", dx, "--dy",
                                dy)
            self.assertEqual(moved.ink(), still.ink())
            self.assertEqual(moved.width - still.width,
                             100 if abs(dx) > 64 else 0)
            self.assertEqual(moved.height - still.height,
                             100 if abs(dy) > 64 else 0)
            for edge in (moved.row_ink(0), moved.row_ink(moved.height - 1),
                         moved.column_ink(0),
                         moved.column_ink(moved.width - 1)):
                self.assertEqual(edge, 0)

    def test_ink_does_not_depend_on_position(self):
        inks = [self.render("--text", "a", "--px", 24, "--dx", dx, "--dy",
                            dx // 2).ink() for dx in range(0, 64, 16)]
        self.assertLess(max(inks) - min(inks), 0.03 * min(inks))

    def test_inverted_and_enlarged(self):
        plain = self.render("--text", "a", "--px", 12)
        black = self.render("--text", "a", "--px", 12, "--invert", "--zoom", 2)
        self.assertEqual(black.width, 2 * plain.width)
        self.assertEqual(plain.pixels[0], 255 - black.pixels[0])
        self.assertEqual(4 * (255 * len(plain.pixels) - plain.ink()),
                         black.ink())

    def test_jobs_draw_what_single_calls_draw(self):
        jobs = []
        for i, (text, angle) in enumerate([("AV", 0), ("To", 20), ("", 0)]):
            jobs.append({"font": str(self.font), "text": text, "size": 18.5,
                         "ox": 10, "oy": 40, "dx": 3 * i, "dy": 5, "w": 70,
                         "h": 60, "angle": angle, "kind": "anim",
                         "out": str(self.path / f"job{i}.pgm")})
        jobs.append(dict(jobs[0], font=SANS, out=str(self.path / "job3.pgm")))
        listed = self.path / "jobs.jsonl"
        listed.write_text("\n".join(map(json.dumps, jobs)) + "\n\n")
        run("render", "--jobs", listed, "--max-px", 32, *CODINGS["field"])
        moving = ("--hint", "none", "--filter", "motion", "--samples",
                  "adaptive", "--radius", 0.75)
        for i, job in enumerate(jobs[:3]):
            single = self.render(
                "--text", job["text"], "--px", job["size"], "--kerning", "off",
                *moving,
                "--ox", 10, "--oy", 40, "--dx", job["dx"], "--dy", 5, "--width",
                70, "--height", 60, "--angle", job["angle"])
            self.assertEqual(single.pixels,
                             Pgm(self.path / f"job{i}.pgm").pixels)
        self.assertEqual(Pgm(self.path / "job0.pgm").pixels,
                         Pgm(self.path / "job3.pgm").pixels)

    def test_jobs_are_fitted_where_one_is_upright(self):
        drawn = self.path / "fitted.pgm"
        jobs = [{"font": str(self.fonts["outline"]), "text": "T",
                 "size": 12, "w": 20, "h": 20, "ox": 4, "oy": 15,
                 "angle": angle, "out": str(out)}
                for angle, out in [(0, drawn), (30, self.path / "no.pgm")]]
        listed = self.path / "angles.jsonl"
        listed.write_text("\n".join(map(json.dumps, jobs)))
        run("render", "--jobs", listed, "--hint", "both")
        self.assertEqual(Pgm(drawn).row_ink(5), 0)
        listed.write_text(json.dumps(jobs[1]))
        pathlib.Path(jobs[1]["out"]).unlink()
        self.assertIn("--hint both fits upright text only, and the angle of "
                      "every job turns it",
                      run("render", "--jobs", listed, "--hint", "both",
                          code=1))
        self.assertFalse(pathlib.Path(jobs[1]["out"]).exists())
        run("render", "--jobs", listed)

    def test_refusals_say_why(self):
        out = self.path / "no.png"
        text = ("--text", "a", "--px", 12, "--out", out)
        for said, *options in [
                ("full not in", "--hint", "full"),
                ("is unknown", "--filter", "x"),
                ("beyond 32767 px", "--ox", "1e12"),
                ("beyond 32767 px", "--dy", "nan"),
                ("16777215 px", "--ox", "1e12", "--width", 9),
                ("16777215 px", "--oy", "-1e12"),
                ("give the font a --band-px", "--outline", 4),
                ("exclude each other", "--levels", 2, "--samples", "adaptive"),
                ("exclude each other", "--levels", 2, "--lcd", "rgb"),
                ("exclude each other", "--motion", "1,0", "--rules", "all"),
                ("--samples adaptive", "--radius", 1),
                ("-0.5 to 0.5", "--levels", 2, "--weight", 0.6),
                *(("leave out --filter, or use --levels 4", "--levels", 2,
                   "--filter", name) for name in ("text", "motion")),
                ("--lcd-colour", "--lcd-colour", 0.5),
                ("--zoom", "--width", 2000, "--zoom", 64),
                ("degrees", "--angle", "nan"),
                *((f"--hint {hint} fits upright text only, and --angle turns it",
                   "--hint", hint, "--angle", angle)
                  for hint in ("vertical", "both") for angle in (1, 90, -180)),
                *((f"--hint {hint} moves points of outlines", "--hint", hint)
                  for hint in ("vertical", "both")),
                ("--outline-place is for --outline", "--outline-place",
                 "inner"),
                *(("nan is no number", option, "nan") for option in
                  ("--weight", "--outline", "--radius", "--lcd-colour"))]:
            self.refused(said, "render", "--font", self.font, *text, *options)
        for said, *arguments in [
                ("4 to 1024", self.font, "--text", "a", "--px", 3, "--out",
                 out),
                ("--px is missing", self.font, "--text", "a", "--out", out),
                (".png or .ppm", self.font, *text[:-1], self.path / "no.pgm",
                 "--lcd", "rgb"),
                *(("make it by inkcell-fontgen --coding field",
                   self.fonts["outline"], *text, "--samples", kind)
                  for kind in ("paper", "splats")),
                ("no folder /nowhere", self.font, *text[:-1],
                 "/nowhere/a.png"),
                ("end in .png or .pgm", SANS, *text[:-1],
                 self.path / "a.jpg"),
                ("is a folder; name a file", self.path, *text),
                ("nowhere", "/nowhere.ttf", *text)]:
            self.refused(said, "render", "--font", *arguments)
        self.assertFalse(out.exists())
        still = self.path / "still.jsonl"
        still.write_text(json.dumps({
            "font": str(self.font), "text": "a", "size": 12, "w": 9, "h": 9,
            "out": str(self.path / "still.pgm")}))
        self.refused("--samples adaptive", "render", "--jobs", still,
                     "--radius", 1)
        for option in ("--font", "--text", "--px", "--out", "--dx", "--dy",
                       "--angle", "--width", "--height", "--ox", "--oy",
                       "--zoom", "--rows"):
            self.refused(f"--jobs takes no {option}:", "render", "--jobs",
                         still, option, 5)
        odd = self.path / "odd.jsonl"
        odd.write_text(still.read_text().replace("{", '{"kind": "move",'))
        self.assertIn("odd.jsonl:1: key 'kind' must be \"static\" or \"anim\", "
                      "not \"move\"",
                      run("render", "--jobs", odd, code=1))
        self.refused("is a folder", "render", "--jobs", self.path)
        cut = self.path / "cut.bin"
        cut.write_bytes(self.font.read_bytes()[:500])
        self.refused("corrupt", "render", "--font", cut, *text)

    def job(self, **values):
        """A job of the fewest keys; one that is None is left out."""
        job = {"font": str(self.font), "text": "a", "size": 12, "w": 9, "h": 9,
               "out": str(self.path / "refused.pgm"), **values}
        return {key: value for key, value in job.items() if value is not None}

    def refuse_jobs(self, *lines, at=None, options=()):
        """Runs jobs, or lines as they are, that must not draw anything. Returns
        what is wrong in the line that `at` counts, the last one if there is
        none."""
        listed = self.path / "refused.jsonl"
        listed.write_bytes(b"\n".join(
            line if isinstance(line, bytes) else
            (line if isinstance(line, str) else json.dumps(line)).encode()
            for line in lines))
        before = sorted(self.path.iterdir())
        printed = run("render", "--jobs", listed, *options, code=1)
        self.assertEqual(sorted(self.path.iterdir()), before)
        start = f"error: {listed}:{at or len(lines)}: "
        self.assertEqual(printed[:len(start)], start)
        self.assertEqual(printed.count("\n"), 1)
        return printed[len(start):-1]

    JOB_KEYS = ("font", "text", "size", "w", "h", "out", "ox", "oy", "dx", "dy",
                "angle", "kind")

    def test_jobs_have_known_keys(self):
        job = self.job()

        def refusal(second):
            return self.refuse_jobs(job, "", second)
        there_are = "there are: " + " ".join(self.JOB_KEYS)
        for key, meant in [("siez", "size"), ("szie", "size"), ("Text", "text"),
                           ("angl", "angle"), ("kinds", "kind"), ("px", None),
                           ("width", None), ("", None), ("hint", None)]:
            hint = f", '{meant}' may be meant" if meant else ""
            self.assertEqual(refusal(dict(job, **{key: 1})),
                             f"key '{key}' is unknown{hint}; {there_are}")
        for key in job:
            others = {k: job[k] for k in job if k != key}
            self.assertEqual(refusal(others), f"key '{key}' is missing")
            # One that is misspelt is said to be unknown, not missing.
            self.assertIn(f"key '{key}_' is unknown",
                          refusal(dict(others, **{key + "_": 1})))
        for key in job:
            twice = json.dumps(job)[:-1] + f', "{key}": {json.dumps(job[key])}}}'
            self.assertEqual(refusal(twice), f"key '{key}' stands twice")

    def test_keys_of_jobs_are_listed(self):
        listed = run("render", "--help").split("--jobs FILE.jsonl")[1]
        listed = listed.split("--out")[0].replace("\n", " ")
        for word in (*self.JOB_KEYS, "px/em", "1/64 px", "degrees", "static", "anim"):
            self.assertRegex(listed, rf"\b{word}\b")

    def test_values_of_jobs_are_not_bent(self):
        for value, shown in [
                (4294967316, "4294967316"), (20.9, "20.9"), (True, "true"),
                (1e10, "10000000000.0"), (0, "0"), (-1, "-1"), (0.5, "0.5"),
                (32768, "32768"), ("9", '"9"'), ([1], "an array"),
                ({"a": 1}, "an object"), (10 ** 400, "one beyond 1e308")]:
            for key in ("w", "h"):
                self.assertEqual(
                    self.refuse_jobs(self.job(), self.job(**{key: value})),
                    f"key '{key}' must be a whole number of 1 to 32767 px, not "
                    + shown)
        for key, unit in [("size", "px/em"), ("ox", "px"), ("oy", "px"),
                          ("dx", "1/64 px"), ("dy", "1/64 px"),
                          ("angle", "degrees")]:
            for value, shown in [(False, "false"), ("12", '"12"'),
                                 ([1], "an array")]:
                self.assertEqual(
                    self.refuse_jobs(self.job(**{key: value})),
                    f"key '{key}' must be a number of {unit}, not {shown}")
            self.assertEqual(
                self.refuse_jobs(json.dumps(self.job(**{key: -77})).replace(
                    "-77", "1e999")),
                f"key '{key}' must be a number of {unit}, not one beyond 1e308")
        for key in ("font", "out"):
            for value, shown in [(5, "5"), ("", '""'),
                                 ("a\0.pgm", '"a\\u0000.pgm"')]:
                self.assertEqual(
                    self.refuse_jobs(self.job(**{key: value})),
                    f"key '{key}' must be the name of a file in double quotes, "
                    f"not {shown}")
        self.assertEqual(self.refuse_jobs(self.job(text={"a": 1})),
                         "key 'text' must be a text in double quotes, not an "
                         "object")
        for kind in (1, "move", "", True):
            self.assertEqual(
                self.refuse_jobs(self.job(kind=kind)),
                'key \'kind\' must be "static" or "anim", not '
                + json.dumps(kind))
        # A whole number may be written as others are.
        whole = self.path / "whole.jsonl"
        out = self.path / "whole.pgm"
        whole.write_text(json.dumps(self.job(w=20.0, out=str(out))).replace(
            '"h": 9', '"h": 1e1'))
        run("render", "--jobs", whole)
        self.assertEqual((Pgm(out).width, Pgm(out).height), (20, 10))

    def test_jobs_that_are_no_json(self):
        job = json.dumps(self.job(font="a.bin"))
        one_line = "write each job as one {...} on one line"
        for line in ("[1]", "[", "5", "1e999", "font", '"a"', "]"):
            self.assertEqual(self.refuse_jobs("", line),
                             "is no JSON object; " + one_line)
        for line, column in [
                ("{", 2), (job[:-1], len(job)), (job + ",", len(job) + 1),
                (job + job, len(job) + 1), ("{'font': 1}", 2),
                ('{"text" "a"}', 11), ('{"text": "a\tb"}', 12),
                (r'{"font": "C:\Users"}', 14), (b'{"text": "caf\xe9"}', 15),
                ('{"size": +5}', 10), ('{"size": NaN}', 10)]:
            said = self.refuse_jobs(line)
            self.assertRegex(said, f"^column {column}: ")
            self.assertIn("; " + one_line, said)
            self.assertNotIn("exception", said)

    def test_jobs_fail_at_their_lines(self):
        job = self.job(out=str(self.path / "first.pgm"))
        self.assertIn("first.pgm: cannot be written: the name must end in .png "
                      "or .ppm", self.refuse_jobs(job, options=("--lcd",
                                                                "rgb")))
        nowhere = self.path / "nowhere.bin"
        for values, said in [
                ({"size": 3}, "sizes go from 4 to 1024 px"),
                ({"ox": 1e9}, "positions lie within 16777215 px"),
                ({"angle": 1e308}, "not a number of degrees"),
                ({"font": str(nowhere)}, f"{nowhere}: No such file"),
                ({"font": str(self.path)}, f"{self.path}: is a folder"),
                ({"out": "/nowhere/a.png"}, "no folder /nowhere"),
                ({"out": "a.jpg"}, "must end in .png or .pgm")]:
            self.assertIn(said, self.refuse_jobs("", "", self.job(**values)))
        cut = self.path / "cut_job.bin"
        cut.write_bytes(self.font.read_bytes()[:500])
        self.assertIn(f"{cut}: an offset", self.refuse_jobs(
            "", self.job(font=str(cut)),
            self.job(font=str(cut), out=str(self.path / "second.pgm")), at=2))

    def test_job_files_hold_jobs(self):
        empty = self.path / "empty.jsonl"
        for text in ("", "\n \r\n\t\n"):
            empty.write_text(text)
            self.assertEqual(
                f"error: {empty}: holds no jobs; write each as a JSON object "
                "on one line, with the keys that --help lists\n",
                run("render", "--jobs", empty, code=1))

    def test_jobs_do_not_replace_files(self):
        listed = self.path / "refused.jsonl"
        listed.touch()
        drawn = self.path / "drawn.pgm"
        linked = self.path / "linked.pgm"
        drawn.write_text("old")
        linked.symlink_to(drawn)
        font = self.path / "font.pgm"
        font.write_bytes(self.font.read_bytes())
        hard = self.path / "hard.pgm"
        hard.hardlink_to(font)
        other = self.job(out=str(self.path / "other.pgm"))
        for first, second, use in [
                ({"out": "new.pgm"}, {"out": "./x/../new.pgm"},
                 "picture of {}:1"),
                ({"out": str(drawn)}, {"out": str(drawn)}, "picture of {}:1"),
                ({"out": str(drawn)}, {"out": str(linked)}, "picture of {}:1"),
                (other, {"out": str(listed)}, "file of the jobs"),
                (dict(other, font=str(font)), {"out": str(font)},
                 "font of {}:1"),
                (dict(other, font=str(font)), {"out": str(hard)},
                 "font of {}:1"),
                (other, {"font": str(font), "out": str(font)},
                 "font of {}:3")]:
            said = (f"key 'out': {second['out']} is the {use.format(listed)}; "
                    "name another file")
            self.assertEqual(self.refuse_jobs(self.job(**first), "",
                                              self.job(**second)), said)
        self.assertEqual(drawn.read_text(), "old")
        self.assertEqual(font.read_bytes(), self.font.read_bytes())
        # Several jobs may read one font, by several names.
        several = self.path / "several.jsonl"
        several.write_text("\n".join(
            json.dumps(self.job(font=str(name), out=str(self.path / out)))
            for name, out in [(font, "1.pgm"), (font, "2.pgm"),
                              (hard, "3.pgm")]))
        run("render", "--jobs", several)

    def test_nothing_is_written_over_what_is_read(self):
        font = self.path / "font.png"
        font.write_bytes(self.font.read_bytes())
        link = self.path / "link.png"
        link.symlink_to(font)
        truth = self.path / "truth.ttf"
        truth.write_bytes(pathlib.Path(SANS).read_bytes())
        accuracy = ("accuracy", "--font", font, "--truth", truth)
        for failed, arguments in (
                (1, ("render", "--font", font, "--text", "a", "--px", 9,
                     "--out", font)),
                (1, ("inspect", font, "--cells", link)),
                (1, ("specimen", link, "--draw-body", font)),
                (1, ("paper-table", "--font", truth, "--report", truth)),
                (1, (*accuracy, "--report", truth)),
                (1, (*accuracy, "--picture", link))):
            self.assertIn("is read, too; name another file",
                          run(*arguments, code=failed))
        self.assertEqual(font.read_bytes(), self.font.read_bytes())
        self.assertEqual(truth.read_bytes(), pathlib.Path(SANS).read_bytes())
        out = self.path / "twice.png"
        for failed, arguments in (
                (1, ("inspect", font, "--cells", out, "--sheet", out)),
                (1, ("specimen", font, "--draw-sizes", out, "--draw-body", out)),
                (1, (*accuracy, "--report", out, "--picture", out))):
            self.assertIn("would be written twice",
                          run(*arguments, code=failed))
        self.assertFalse(out.exists())

    def test_damaged_fonts_are_refused(self):
        for coding, font in self.fonts.items():
            damaged = self.path / "damaged.bin"
            data = bytearray(font.read_bytes())
            data[-9] ^= 1
            damaged.write_bytes(data)
            out = self.path / "damaged.png"
            for failed, arguments in (
                    (1, ("render", "--font", damaged, "--text", "a", "--px", 9,
                         "--out", out)),
                    (1, ("specimen", damaged, "--draw-body", out)),
                    (1, ("accuracy", "--font", damaged, "--truth", SANS))):
                self.assertIn("damaged.bin: it is damaged; regenerate it",
                              run(*arguments, code=failed), coding)
            self.assertFalse(out.exists())
            seen = run("inspect", damaged, code=1)
            self.assertIn("corrupt", seen)
            self.assertIn("it is damaged", seen)

    def test_fonts_of_edges_are_refused(self):
        """Coding 1, which only earlier versions made."""
        old = self.path / "old.bin"
        data = bytearray(self.font.read_bytes())
        data[39] = 1
        old.write_bytes(data)
        out = self.path / "old.png"
        for program, *arguments in (
                ("render", "--font", old, "--text", "a", "--px", 9, "--out",
                 out),
                ("specimen", old, "--draw-body", out),
                ("accuracy", "--font", old, "--truth", SANS),
                ("inspect", old)):
            self.assertIn("old.bin: it is a font of edges, which this version "
                          "cannot read; make it again by inkcell-fontgen "
                          "--coding outline (unsupported)",
                          run(program, *arguments, code=1))
        self.assertFalse(out.exists())

    def test_rom_fonts_take_no_conversion_options(self):
        out = self.path / "no.png"
        job = self.path / "rom.jsonl"
        job.write_text(json.dumps({
            "font": str(self.font), "text": "a", "size": 12, "w": 9, "h": 9,
            "out": str(out)}))
        draw = ("--text", "a", "--px", 12, "--out", out)
        for program, *arguments in [
                ("render", "--font", self.font, *draw, "--chars", "A-Z"),
                ("render", "--font", self.font, *draw, "--max-px", 64),
                ("render", "--jobs", job, "--hints", "off"),
                ("inspect", self.font, "--coding", "field"),
                ("inspect", self.font, "--effort", 5),
                ("specimen", self.font, "--draw-sizes", out, "--band-px", 1)]:
            printed = run(program, *arguments, code=1)
            self.assertIn(f"{self.font}: is a ROM font, which "
                          f"{arguments[-2]} cannot change", printed)
        self.assertFalse(out.exists())

    def test_options_mean_one_thing(self):
        # An option of several programs takes the same kind of value in all.
        values = {}
        for program in PROGRAMS:
            for option, value in re.findall(
                    r"^  (?:-\w,)?(--[\w-]+)(?: ([^\s=:]+))?",
                    run(program, "--help"), re.M):
                value = value if value and value[0].isupper() else (
                    value if "|" in value else "")
                values.setdefault(option, {}).setdefault(
                    value, []).append(program)
        shared = [option for option, kinds in values.items()
                  if sum(map(len, kinds.values())) > 1]
        self.assertGreater(len(shared), 15)
        self.assertEqual([], [f"{option}: {values[option]}"
                              for option in shared if len(values[option]) > 1])

    def test_nothing_is_written_among_fonts_of_the_system(self):
        fonts = pathlib.Path(SANS).parent
        mine = self.path / "mine.ttf"
        mine.write_bytes(pathlib.Path(SERIF).read_bytes())
        names = [("x.png", "would lie among the fonts of the system"),
                 ("mine.ttf", "is a font file, which would be replaced")]
        web = self.path / "mine.woff2"
        web.write_bytes(b"wOF2 and so on")
        for out, said in [(fonts / names[0][0], names[0][1]),
                          (mine, names[1][1]), (web, names[1][1])]:
            self.refused(said, "fontgen", "--font", SANS, "--out", out)
        out = fonts / "x.png"
        for arguments in (
                ("render", "--font", self.font, "--text", "a", "--px", 9,
                 "--out", out),
                ("inspect", self.font, "--sheet", out),
                ("specimen", self.font, "--draw-body", out),
                ("accuracy", "--font", self.font, "--truth", SANS,
                 "--picture", out)):
            self.refused(names[0][1], *arguments)
        self.assertFalse(out.exists())
        self.assertEqual(mine.read_bytes(), pathlib.Path(SERIF).read_bytes())

    def test_jobs_can_kern(self):
        listed = self.path / "kerned.jsonl"
        out = self.path / "kerned.pgm"
        box = {"text": "AVAV", "size": 32, "w": 120, "h": 50, "ox": 4, "oy": 40}
        listed.write_text(json.dumps(
            {"font": str(self.font), "out": str(out), **box}))
        for options, kerning in [((), "off"), (("--kerning", "on"), "on")]:
            run("render", "--jobs", listed, *options)
            self.assertEqual(Pgm(out).pixels, self.render(
                "--text", "AVAV", "--px", 32, "--width", 120, "--height", 50,
                "--ox", 4, "--oy", 40, "--kerning", kerning).pixels)

    def test_wrong_arguments_fail_alike(self):
        for program in PROGRAMS:
            for said, arguments in [("--nope is not expected", ("--nope", 1)),
                                    ("-j is not expected", ("-j",))]:
                printed = run(program, *arguments, code=1)
                self.assertRegex(printed, r"^error: .*; see --help\n$")
                self.assertIn(said, printed)
            self.assertRegex(
                run(program, "--version"),
                rf"^inkcell-{program} \d+\.\d+\.\d+, font format \d+\.\d+\n$")
            self.assertIn("Usage: ", run(program, "--help"))

    def test_inspect_counts_what_the_generator_counted(self):
        report = self.path / "report.json"
        run("fontgen", "--font", SERIF, "--symbols", "aD", "--coding", "field",
            "--predicate", "fixed", "--quiet", "--out", self.path / "serif.bin", "--report",
            report)
        generated = json.loads(report.read_text())
        seen = json.loads(run("inspect", self.path / "serif.bin", "--json"))
        self.assertEqual(seen["verify"], "ok")
        self.assertEqual(seen["predicate"], "fixed")
        self.assertEqual(seen["cells"],
                         sum(generated["cells_per_glyph"].values()))
        self.assertEqual(seen["bytes"], generated["bytes"]["total"])
        for glyph in seen["glyphs"]:
            if glyph["name"] in ("a", "D"):
                self.assertEqual(glyph["cells"],
                                 generated["cells_per_glyph"][glyph["name"]])
                self.assertEqual(sum(glyph["cells_by_size_u"].values()),
                                 glyph["cells"])
                self.assertTrue(350 <= glyph["cells"] <= 550, glyph)

    def test_inspect_counts_points(self):
        report = self.path / "report.json"
        rom = self.path / "points.bin"
        run("fontgen", "--font", SANS, "--symbols", "aDi\u00e4\u00ec",
            "--quiet", "--out", rom, "--report", report)
        generated = json.loads(report.read_text())
        seen = json.loads(run("inspect", rom, "--json"))
        self.assertEqual(seen["verify"], "ok")
        self.assertEqual(seen["points"], generated["point_count"])
        self.assertEqual(seen["composites"], generated["composite_count"])
        self.assertEqual(generated["composite_bytes"],
                         sum(generated["bytes_per_glyph"][glyph["name"]]
                             for glyph in seen["glyphs"]
                             if glyph["components"]))
        self.assertLess(0, generated["composite_bytes"])
        self.assertLess(generated["composite_bytes"],
                        generated["composite_simple_bytes"])
        self.assertEqual(sum(word["uses"] for word in seen["code"]),
                         seen["points"] + sum(
                             glyph["contours"] for glyph in seen["glyphs"]
                             if not glyph["components"]))
        for glyph in seen["glyphs"]:
            self.assertEqual(glyph["points"], glyph["corners"] +
                             glyph["smooth"] + glyph["off_curve"])
            self.assertLessEqual(glyph["points"] + glyph["contours"],
                                 seen["max_points"])
        said = run("inspect", rom, "--glyph", "D")
        self.assertRegex(said, r"points +\d+ in 2 contours")
        self.assertRegex(run("inspect", rom), r"code tables +\d+, \d+ words")

    def test_inspect_tells_of_masters(self):
        rom = self.path / "masters.bin"
        said = run("fontgen", "--font", INTER, "--symbols", "ABC", "--axis",
                   "wght=300..800", "--out", rom)
        self.assertRegex(said, r"second masters +6 glyphs, \d\d+ bytes\n")
        said = run("inspect", rom)
        self.assertRegex(said, r"morphs +6 pairs\n")  # with ' ', '.' and '-'
        self.assertRegex(said, r"second masters +6 glyphs\n")
        seen = json.loads(run("inspect", rom, "--json"))
        self.assertEqual((seen["morph_pairs"], seen["masters"]), (6, 6))
        wide = [glyph["advance"] for glyph in seen["glyphs"]]
        self.assertLess(wide[4], wide[10])  # A, and its second master
        self.assertEqual(seen["glyphs"][10]["code_points"], [])
        self.assertNotIn("second masters", run("inspect", self.font))

    def test_inspect_counts_cells(self):
        report = self.path / "report.json"
        rom = self.path / "coding.bin"
        run("fontgen", "--font", SERIF, "--symbols", "a%", *CODINGS["field"],
            "--quiet", "--out", rom, "--report", report)
        generated = json.loads(report.read_text())
        seen = json.loads(run("inspect", rom, "--json"))
        self.assertEqual(seen["verify"], "ok")
        self.assertEqual(seen["coding"], "field")
        self.assertEqual(generated["coding"], "field")
        self.assertEqual(seen["cells"], generated["cell_count"])
        self.assertEqual(seen["nodes"], generated["node_count"])
        for glyph in seen["glyphs"]:
            self.assertEqual(glyph["bytes"],
                             sum(glyph["record_bytes"].values()))
        self.assertRegex(run("inspect", rom), r"coding +field\n")

    def test_inspect_shows_hints(self):
        font = self.fonts["outline"]
        seen = json.loads(run("inspect", font, "--glyph", "T", "--json"))
        zones = seen["hints"]["zones"]
        self.assertEqual((zones[0]["flat_u"], zones[0]["side"]), (0, "bottom"))
        # An em of 2048 units; x.5 may go up or down.
        cap_height = seen["metrics"]["cap_height"] / 2
        capitals = min((zone["flat_u"] for zone in zones),
                       key=lambda u: abs(u - cap_height))
        self.assertLess(abs(capitals - cap_height), 1)
        hints = seen["glyphs"][0]["hints"]
        self.assertTrue(hints["symmetric"])
        foot, bar = hints["heights"]
        self.assertEqual((foot["kind"], foot["low_u"]), ("edge", 0))
        self.assertEqual((bar["kind"], bar["high_u"]), ("bar", capitals))
        self.assertEqual(zones[bar["zone"]]["side"], "top")
        stem, = hints["stems"]
        middle = sum(seen["glyphs"][0]["box"][::2]) / 4
        self.assertLess(abs((stem["left_u"] + stem["right_u"]) / 2 - middle), 4)
        said = run("inspect", font, "--glyph", "T")
        self.assertRegex(said, r"edge +0 u, zone 0")
        self.assertRegex(said, r"bar +\d+ u to \d+ u, zone")
        bare = self.path / "bare.bin"
        run("fontgen", "--font", SANS, "--symbols", "T", "--hints", "off",
            "--quiet", "--out", bare)
        for bare in (bare, self.fonts["field"]):
            self.assertRegex(run("inspect", bare), r"hints +none")

    def test_inspect_draws(self):
        for coding in CODINGS:
            own = "points.png" if coding == "outline" else "cells.png"
            pictures = [self.path / name for name in
                        (own, "field.png", "sheet.png")]
            self.assertIn("glyph", run(
                "inspect", self.fonts[coding], "--glyph", "A",
                *(x for out in pictures for x in (f"--{out.stem}", out))))
            self.assertNotEqual(pictures[0].read_bytes(),
                                pictures[1].read_bytes())
            for picture in pictures:
                self.assertEqual(picture.read_bytes()[:4], b"\x89PNG")
                picture.unlink()
        out = self.path / "no.png"
        self.refused("use --points or --field", "inspect",
                     self.fonts["outline"], "--cells", out)
        self.refused("use --cells or --field", "inspect", self.font,
                     "--points", out)
        self.assertFalse(out.exists())
        # Progress of the conversion follows, from standard error.
        converted, _ = json.JSONDecoder().raw_decode(
            run("inspect", SANS, "--symbols", "o", "--coding", "field",
                "--json"))
        self.assertEqual(converted["coding"], "field")
        self.refused("no glyph", "inspect", self.font, "--glyph", "Z")
        self.refused("4 to 1024 px", "inspect", self.font, "--sheet",
                     self.path / "no.png", "--px", 1e9)

    def test_size_table_reads_the_reports(self):
        """The table that the demo prints has a column for each coding."""
        for coding, options in CODINGS.items():
            font = self.path / "made.bin"
            run("fontgen", "--font", SANS, "--symbols", "A", "--max-px", "32",
                *options, "--quiet", "--out", font, "--report",
                self.path / f"{coding}.json")
            run("accuracy", "--font", font, "--truth", SANS, "--sizes", "12",
                "--report", self.path / f"{coding}_accuracy.json")
        table = subprocess.run(
            [sys.executable, TOOLS / "size_table.py", self.path, *CODINGS],
            stdout=subprocess.PIPE, text=True, check=True).stdout
        self.assertRegex(table, r"^ +outline +field\n")
        self.assertRegex(table, r"\ncells +0 +[1-9]\d*\n")

    def test_accuracy_finds_the_wrong_truth(self):
        for font in self.fonts.values():
            run("accuracy", "--font", font, "--truth", SANS, "--sizes", "12,32",
                "--angle", 30)
        wrong = ("--font", self.font, "--truth", SERIF, "--sizes", "24")
        self.assertIn("24 px: beyond the font's tolerance of 16/255",
                      run("accuracy", *wrong, code=2))
        run("accuracy", *wrong, "--no-check")
        # Nothing is promised to other filters and sizes.
        run("accuracy", *wrong, "--filter", "motion")
        run("accuracy", *wrong[:4], "--sizes", "23.5,33")
        # Outlines promise areas, and have distances beside them.
        table = self.path / "table.json"
        outline = ("--font", self.fonts["outline"], "--sizes", "24", "--truth")
        run("accuracy", *outline, SANS, "--report", table)
        self.assertEqual([row["filter"] for row in
                          json.loads(table.read_text())["rows"]],
                         ["area"] * 2 + ["text"] * 2)
        self.assertIn("beyond", run("accuracy", *outline, SERIF, code=2))
        run("accuracy", *outline, SERIF, "--filter", "text")

    def test_accuracy_lists_what_was_asked_for(self):
        table, picture = self.path / "table.json", self.path / "worst.png"
        printed = run(
            "accuracy", "--font", self.font, "--truth", SANS, "--sizes",
            "10-12,15.5", "--filter", "all", "--symbols", "To", "--report", table,
            "--picture", picture, "--worst", 1)
        size = self.font.stat().st_size
        self.assertIn(f"the font has {size} bytes", printed)
        listed = json.loads(table.read_text())
        self.assertEqual(listed["font_bytes"], size)
        self.assertEqual(listed["coding"], "field")
        self.assertEqual(listed["characters"], 2)
        rows = listed["rows"]
        filters = ("text", "motion", "paper_display", "paper_body")
        self.assertEqual(
            [(row["filter"], row.get("px")) for row in rows],
            [(name, px) for name in filters for px in (10, 11, 12, 15.5, None)])
        for first in range(0, len(rows), 5):
            sizes, total = rows[first:first + 4], rows[first + 4]
            self.assertEqual(total["max"], max(row["max"] for row in sizes))
            self.assertEqual(total["max_mean"],
                             max(row["max_mean"] for row in sizes))
            self.assertAlmostEqual(total["mean"],
                                   sum(row["mean"] for row in sizes) / 4)
            for row in sizes:
                self.assertTrue(0 < row["mean"] <= row["max_mean"] <= row["max"]
                                <= 16, row)
                self.assertIn(row["worst"]["char"], "To")
        self.assertEqual(picture.read_bytes()[:4], b"\x89PNG")
        self.assertIn("beyond", run(
            "accuracy", "--font", self.font, "--truth", SANS, "--mean-limit",
            0.01, "--sizes", 12, code=2))
        limit = ("--font", self.font, "--truth", SANS, "--sizes", 12,
                 "--byte-limit")
        run("accuracy", *limit, size)
        self.assertIn(f"more than {size - 1} bytes",
                      run("accuracy", *limit, size - 1, code=2))
        for said, arguments in [("no glyph for 'Z'", ("--symbols", "Z")),
                                ("no folder", ("--report", "/nowhere/a.json")),
                                ("name a file", ("--report", "-")),
                                ("no folder", ("--picture", "/nowhere/a.png")),
                                (".png or .ppm", ("--picture", "a.jpg")),
                                ("--threads", ("--threads", 100000)),
                                ("--mean-limit", ("--mean-limit", -1)),
                                ("is no size", ("--sizes", "8-")),
                                ("is unknown", ("--filter", "x"))]:
            self.refused(said, "accuracy", "--font", self.font, "--truth",
                         SANS, *arguments)

    def test_accuracy_draws_at_random_positions(self):
        """Positions that the generator does not try, and the same again."""
        table = self.path / "table.json"
        options = ("accuracy", "--font", self.font, "--truth", SANS,
                   "--symbols", "To", "--sizes", "11,12,24", "--report", table)
        worst = {}
        for seed in ("1", "1 again", "2"):
            self.assertIn("2 characters, 3 positions a size", run(
                *options, "--positions", 3, "--seed", seed[0]))
            listed = json.loads(table.read_text())
            self.assertEqual(listed["positions"], 3)
            worst[seed] = [row["worst"] for row in listed["rows"]]
            for place in worst[seed]:
                x, y = place["offset"]
                self.assertTrue(0 <= x < 64 and 0 <= y < 64, place)
                self.assertTrue(x % 8 or y % 8, place)
        self.assertEqual(worst["1"], worst["1 again"])
        self.assertNotEqual(worst["1"], worst["2"])
        for arguments in (("--positions", 0), ("--positions", 4097),
                          ("--positions", 3, "--phases", 3), ("--seed", 2)):
            run(*options, *arguments, code=1)

    def test_render_warns_of_what_looks_wrong(self):
        out = self.path / "warned.png"
        for said, text, px in [("U+6F22", "a\u6f22\n", 12),
                               ("8 to 32 px", "a", 7.9),
                               ("8 to 32 px", "a", 33)]:
            printed = run("render", "--font", self.font, "--text", text, "--px",
                          px, "--out", out)
            self.assertIn("warning: ", printed)
            self.assertIn(said, printed)
        for text in ("A\nV", "A\tV\u00ad"):
            self.assertEqual("", run("render", "--font", self.font, "--text",
                                     text, "--px", 32, "--out", out))

    def test_specimen_refuses(self):
        out = self.path / "no.png"
        self.refused("no picture", "specimen", self.font)
        self.refused("no picture", "specimen", self.font, "--width", 500)
        self.refused("a TTF or OTF", "specimen", self.font,
                     "--draw-compare-body", out)
        self.assertFalse(out.exists())

    def test_specimen_draws(self):
        pictures = {}
        for coding, options in CODINGS.items():
            out = self.path / f"{coding}.png"
            run("specimen", SANS, "--draw-sizes", out, "--max-px", 16, "--symbols",
                "Onefotvrysizikcl,", *options)
            pictures[coding] = out.read_bytes()
            self.assertEqual(pictures[coding][:4], b"\x89PNG")
        self.assertEqual(len(set(pictures.values())), len(CODINGS))

    def test_specimen_draws_styles(self):
        of_all = ["filters", "lcd", "levels", "maps", "star", "compare-body",
                  "compare-display", "contrast", "motion"]
        own = {"field": [], "outline": ["fitting"]}
        for coding, others in own.items():
            pictures = [self.path / f"{name}.png" for name in of_all + others]
            options = [x for out in pictures for x in (f"--draw-{out.stem}", out)]
            # Few characters: others show .notdef, which is drawn as well.
            run("specimen", SANS, "--symbols", "Sphinx of quartz, 1958",
                "--max-px", 16, *CODINGS[coding], *options)
            for out in pictures:
                self.assertEqual(out.read_bytes()[:4], b"\x89PNG")
                out.unlink()
        out = self.path / "no.png"
        self.refused("points of outlines", "specimen", self.font,
                     "--draw-fitting", out)
        self.assertFalse(out.exists())
        run("specimen", SANS, "--symbols", "Efcts", "--max-px", 16,
            "--draw-effects", self.path / "effects.png")
        out = self.path / "effects.png"
        self.refused("--band-px", "specimen", self.font, "--draw-effects", out)
        run("specimen", SANS, "--symbols", "Efcts", *CODINGS["field"],
            "--band-px", 2, "--min-px", 12, "--max-px", 32, "--draw-effects", out)
        self.assertEqual(out.read_bytes()[:4], b"\x89PNG")

    def test_paper_table_refuses(self):
        for said, out in [("no folder /nowhere", "/nowhere/a.json"),
                          ("-: cannot be written: it is not standard output "
                           "here; name a file", "-")]:
            self.refused(said, "paper-table", "--chars", "a", "--report", out)

    def test_paper_table_counts_in_the_paper_s_range(self):
        out = self.path / "table.json"
        run("paper-table", "--chars", "a,D", "--report", out)
        glyphs = json.loads(out.read_text())["glyphs"]
        for name in "aD":
            counts = glyphs[name]
            self.assertTrue(350 <= counts["cells"] <= 550)
            self.assertEqual(counts["leaf_list_bytes"], 15 * counts["cells"])
            self.assertLess(counts["zlib_bytes"], counts["leaf_list_bytes"])
            for condition in ("edge", "band", "intensity"):
                self.assertGreater(counts[condition]["bilinear"],
                                   counts[condition]["biquadratic"])
            self.assertGreater(counts["three_colour_edge"],
                               counts["edge"]["bilinear"])


main("fontgen", "render", "inspect", "specimen", "accuracy", "paper-table")
