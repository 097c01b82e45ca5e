#!/usr/bin/env python3
"""Draws icons with the device's code and with librsvg, and compares pixels."""

import json
import pathlib

from png import read_png
from programs import SANS, SERIF, FolderCase, main, run

# The font's own tolerance, and 1/255 for the samples that stand for an area.
LIMIT = 16 + 1
SIZES = (16, 32)

# Samples of the reference along each side of a pixel.
SAMPLES = 8

# Drawings of one colour, each of which needs another rule of SVG.
ICONS = {
    "wifi": """<svg viewBox="0 0 24 24" fill="none" stroke="currentColor"
        stroke-width="2" stroke-linecap="round" stroke-linejoin="round">
        <path d="M5 12.55a11 11 0 0 1 14.08 0M1.42 9a16 16 0 0 1 21.16 0
        M8.53 16.11a6 6 0 0 1 6.95 0"/><path d="M12 20h.01"/></svg>""",
    "home": """<svg viewBox="0 0 24 24" fill="none" stroke="#333"
        stroke-width="2"><path d="M3 10l9-8 9 8v11H3z"/>
        <path d="M9 21v-8h6v8" stroke-linejoin="bevel"/></svg>""",
    "ring": """<svg viewBox="0 0 100 100"><path fill-rule="evenodd" d="M50 5
        a45 45 0 1 0 .01 0zM50 25a25 25 0 1 0 .01 0z"/>
        <circle cx="50" cy="50" r="12"/></svg>""",
    "star": """<svg viewBox="0 0 100 100"><path style="fill-rule: evenodd"
        d="M50 2L80 95 2 38h96L20 95z"/></svg>""",
    "heart": """<svg viewBox="0 0 32 32"><path d="M16 29C-9 12 8-4 16 8
        24-4 41 12 16 29z"/></svg>""",
    "battery": """<svg viewBox="10 20 120 60"><g transform="translate(12 24)
        scale(2)"><rect width="50" height="25" rx="4" fill="none" stroke="#000"
        stroke-width="3"/><rect x="5" y="5" width="25" height="15" ry="2"/>
        <polygon points="52,8 57,8 57,17 52,17"/></g></svg>""",
    "caps": """<svg viewBox="0 0 24 24" stroke="black" stroke-width="3">
        <line x1="4" y1="5" x2="20" y2="5" stroke-linecap="square"/>
        <line x1="4" y1="11" x2="20" y2="11"/>
        <polyline fill="none" stroke-miterlimit="2"
        points="3,21 7,15 10,21 21,15"/></svg>""",
    "tight": """<svg viewBox="0 0 40 40" fill="none" stroke="#000"
        stroke-width="10"><path d="M6 34C6 0 14 0 14 30"/>
        <path d="M22 30q12-4 12 4" stroke-linecap="round"/></svg>""",
    "slanted": """<svg viewBox="0 0 60 40"><g transform="skewX(-20)
        rotate(8 20 20)"><ellipse cx="30" cy="18" rx="14" ry="9" fill="none"
        stroke="#000" stroke-width="4" transform="scale(1.4 .8)"/>
        </g></svg>""",
    "opposed": """<svg viewBox="0 0 20 20"><path d="M1 1h8v8h-8zM11 11v8h8v-8z
        M13 13h4v4h-4z"/><path d="M6 6v9h9v-9z"/></svg>""",
    "hidden": """<svg viewBox="0 0 16 16"><path fill="none"
        d="M0 0h16v16H0z"/><g opacity="0" fill="red"><path d="M0 0h9v9z"/></g>
        <g display="none"><text>no</text></g>
        <path d="M2 14L8 3l6 11z" fill="#000"/></svg>""",
}


def opacity_rows(path):
    """The alpha channel of a picture."""
    _, _, channels, rows = read_png(path.read_bytes())
    return [row[channels - 1::channels] for row in rows]


def averaged(rows, size):
    """Means of squares of SAMPLES pixels; rows of `size` columns."""
    means = []
    for y in range(0, len(rows), SAMPLES):
        block = rows[y:y + SAMPLES]
        means.append([sum(sum(row[x * SAMPLES:(x + 1) * SAMPLES])
                          for row in block) / SAMPLES ** 2
                      for x in range(size)])
    return means


class Icons(FolderCase):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        icons = cls.path / "icons"
        icons.mkdir()
        for name, text in ICONS.items():
            (icons / f"{name}.svg").write_text(text.replace(
                "<svg ", "<svg xmlns='http://www.w3.org/2000/svg' ", 1))
        cls.font = cls.path / "icons.bin"
        report = cls.path / "icons.json"
        run("fontgen", "--svg-dir", icons, "--svg-baseline", "bottom",
            "--min-px", SIZES[0], "--max-px", SIZES[-1], "--report", report,
            "--out", cls.font, "--quiet")
        cls.report = json.loads(report.read_text())

    def drawn(self, name, px, width):
        """The icon by the device's code, its viewBox as the picture."""
        out = self.path / "drawn.png"
        code = self.report["icons"][name.capitalize()]
        run("render", "--font", self.font, "--text", chr(code), "--px", px,
            "--filter", "area", "--width", width, "--height", px, "--ox", 0,
            "--oy", px, "--out", out)
        _, _, channels, rows = read_png(out.read_bytes())
        return [row[::channels] for row in rows]

    def reference(self, name, px, width):
        out = self.path / "reference.png"
        run("rsvg", "--width", width * SAMPLES, "--height", px * SAMPLES,
            "--output", out, self.path / "icons" / f"{name}.svg")
        return averaged(opacity_rows(out), width)

    def test_pixels_are_those_of_librsvg(self):
        for name, text in ICONS.items():
            box = text.split('viewBox="')[1].split('"')[0].split()
            for px in SIZES:
                width = px * int(box[2]) // int(box[3])
                drawn = self.drawn(name, px, width)
                wanted = self.reference(name, px, width)
                worst = max(abs(a - b) for row, line in zip(drawn, wanted)
                            for a, b in zip(row, line))
                print(f"{name} {px} px: worst {worst:.1f}/255")
                with self.subTest(icon=name, px=px):
                    self.assertLessEqual(worst, LIMIT)
                    self.assertGreater(max(map(max, wanted)), 200)

    def test_merged_faces_draw_as_their_own_fonts(self):
        merged = self.path / "merged.bin"
        run("fontgen", "--font", SANS, "--chars", "A-M", "--merge",
            f"{SERIF}=N-Z", "--svg", f"{self.path}/icons/heart.svg=0x2665",
            "--out", merged, "--quiet")
        for face, text in ((SANS, "ABGKM"), (SERIF, "NOQTVWXYZ")):
            own = self.path / "own.bin"
            run("fontgen", "--font", face, "--chars", f"{text[0]}-{text[-1]}",
                "--out", own, "--quiet")
            pictures = []
            for font in (merged, own):
                out = self.path / "text.png"
                run("render", "--font", font, "--text", text, "--px", 21,
                    "--filter", "area", "--width", 300, "--height", 30,
                    "--ox", 3, "--oy", 24, "--out", out)
                pictures.append(out.read_bytes())
            with self.subTest(face=face):
                self.assertEqual(*pictures)

    def test_thin_round_lines_take_few_points(self):
        """Beside text as alone: 193 and 43 points before care was taken at the
        border that a pixel of 8 px/em shows, instead of at its centre."""
        icon = pathlib.Path(__file__).parents[1] / "icons/wifi.svg"
        points = []
        for face in ((), ("--font", SANS, "--chars", "A")):
            report = self.path / "wifi.json"
            run("fontgen", *face, "--svg", f"{icon}=0xE001", "--out",
                self.path / "wifi.bin", "--report", report, "--quiet")
            points.append(
                json.loads(report.read_text())["points_per_glyph"]["\ue001"])
        self.assertLessEqual(max(points), 60, points)

    def test_code_points_follow_names(self):
        codes = [self.report["icons"][name.capitalize()]
                 for name in sorted(ICONS)]
        self.assertEqual(codes, list(range(0xE000, 0xE000 + len(ICONS))))


main("fontgen", "render", "rsvg")
