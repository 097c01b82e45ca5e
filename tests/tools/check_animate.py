#!/usr/bin/env python3
"""Plays scenes with inkcell-animate, and looks at what it writes.

Usage: check_animate.py --animate PROGRAM --fontgen PROGRAM
"""
import collections
import json
import os
import struct

from png import chunks, read_png, unfilter
from programs import INTER, SANS, FolderCase, main, run

ITALIC = "/usr/share/fonts/truetype/liberation/LiberationSerif-Italic.ttf"
# Scenes that repeat without a seam.
LOOPS = ("count", "ticker", "typewriter", "wipe", "bounce", "pulse", "splash",
         "charge", "clock", "path", "particles", "figure13", "figure14")
SCENES = LOOPS + ("figure15", "print", "melt")


def pixels_of(file):
    """The bytes of the pixels of a PNG file."""
    return b"".join(read_png(file.read_bytes())[3])


def frames_of(apng):
    """Every frame of an animated PNG as the bytes of its pixels."""
    canvas, frames, part = None, [], None
    for kind, data in chunks(apng):
        if kind == b"IHDR":
            width, height = struct.unpack(">II", data[:8])
            canvas = [bytearray(width * 3) for _ in range(height)]
        elif kind == b"acTL":
            count, = struct.unpack(">I", data[:4])
        elif kind == b"fcTL":
            part = struct.unpack(">IIII", data[4:20])
        elif kind in (b"IDAT", b"fdAT"):
            w, h, x, y = part
            pixels = unfilter(data if kind == b"IDAT" else data[4:], w, h, 3)
            for i, row in enumerate(pixels):
                canvas[y + i][3 * x:3 * (x + w)] = row
            frames.append(b"".join(canvas))
    assert len(frames) == count
    return frames


def palettes_of(gif):
    """The palette of each part of a GIF, as colours."""
    def palette(flags, at):
        size = 2 << (flags & 7)
        return list(zip(*[iter(gif[at:at + 3 * size])] * 3))
    found = [palette(gif[10], 13)]
    at = 13 + 3 * len(found[0])
    while gif[at] != 0x3B:
        if gif[at] == 0x2C:  # a frame
            if gif[at + 9] & 128:
                part = palette(gif[at + 9], at + 10)
                if part != found[-1]:
                    found.append(part)
                at += 3 * len(part)
            at += 11
        else:
            at += 2
        while gif[at]:
            at += gif[at] + 1
        at += 1
    return found


def pieces_of(frame, width):
    """How many pieces of 6 px or more the light pixels form."""
    left = {i for i in range(len(frame) // 3) if frame[3 * i] >= 128}
    count = 0
    while left:
        found = [left.pop()]
        for i in found:
            for near in (i - 1, i + 1, i - width, i + width):
                if near in left:
                    left.remove(near)
                    found.append(near)
        count += len(found) >= 6
    return count


class Animate(FolderCase):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.font = cls.path / "font.bin"
        run("fontgen", "--font", SANS, "--quiet", "--out", cls.font)

    def play(self, scene, name, *options, size="128x64", frames=20):
        """What was written, and its stats."""
        out = self.path / name
        stats = out.with_suffix(".json")
        run("animate", scene, "--font", self.font, "--size", size, "--seconds",
            frames / 30, "--out", out, "--stats", stats, *options)
        return out, json.loads(stats.read_text())

    def test_same_bytes_every_time(self):
        for scene in SCENES:
            for kind in ("apng", "gif"):
                first, _ = self.play(scene, "first.png", "--format", kind)
                second, _ = self.play(scene, "second.png", "--format", kind)
                self.assertEqual(first.read_bytes(), second.read_bytes())
                gif = first.read_bytes()[:6] == b"GIF89a"
                self.assertEqual(gif, kind == "gif")

    def test_gif_is_small_and_can_be_read(self):
        """Its mode follows umask."""
        os.umask(0o022)
        gif, _ = self.play("figure15", "g.gif", "--format", "gif",
                           size="320x240", frames=60)
        self.assertEqual(gif.stat().st_mode & 0o777, 0o644)
        self.assertLess(gif.stat().st_size, 1000000)

    def test_formats_hold_the_same_frames(self):
        for scene in SCENES:
            apng, _ = self.play(scene, "a.png", frames=12)
            folder, _ = self.play(scene, "frames", "--format", "frames",
                                  frames=12)
            files = sorted(folder.glob("*.png"))
            self.assertEqual(len(files), 12)
            frames = frames_of(apng.read_bytes())
            for file, frame in zip(files, frames):
                self.assertEqual(pixels_of(file), frame)

    def test_seek_is_play(self):
        for scene in SCENES:
            played, _ = self.play(scene, "p", "--format", "frames", frames=62)
            sought, _ = self.play(scene, "s", "--format", "frames", "--from",
                                  50 / 30, frames=12)
            for file in sought.glob("*.png"):
                self.assertEqual(file.read_bytes(),
                                 (played / file.name).read_bytes(), file.name)

    def test_fewer_frames_a_second(self):
        all_of, _ = self.play("clock", "p", "--format", "frames", frames=13)
        some, _ = self.play("clock", "e.png", "--fps", 5, frames=18)
        frames = frames_of(some.read_bytes())
        for i, frame in enumerate(frames):
            self.assertEqual(pixels_of(all_of / f"{6 * i:05d}.png"), frame)

    def test_loops_begin_and_end_with_ink(self):
        """And after ten seconds they are where they began."""
        for scene in LOOPS:
            apng, stats = self.play(scene, "l.png", frames=301)
            frames = frames_of(apng.read_bytes())
            self.assertEqual(frames[300], frames[0], scene)
            for frame in (frames[0], frames[299]):
                pixels = [frame[i:i + 3] for i in range(0, len(frame), 3)]
                paper = max(set(pixels), key=pixels.count)
                self.assertGreater(len(pixels) - pixels.count(paper), 250,
                                   scene)
            self.assertLess(stats["still_frames"], 250, scene)

    def test_icons_morph_from_drawings(self):
        """The pairs of --svg and --morph, from files to frames."""
        out = self.path / "icons.png"
        stats = out.with_suffix(".json")
        run("animate", "icons", "--size", "128x64", "--out", out, "--stats",
            stats)
        frames = frames_of(out.read_bytes())
        self.assertGreater(len(set(frames)), 60)
        changes = json.loads(stats.read_text())
        self.assertEqual(changes["missed_pixels"], 0)
        # None at rest.
        self.assertLess(changes["dirty_pixels_mean"], 128 * 64 / 3)
        drawings = [self.path / name
                    for name in ("a.svg", "b.svg")]
        for drawing, path in zip(drawings, ("M4 4h16v16H4z", "M4 4h16v4H4z")):
            drawing.write_text('<svg xmlns="http://www.w3.org/2000/svg" '
                               f'viewBox="0 0 24 24"><path d="{path}"/></svg>')
        run("animate", "icons", "--size", "64x64", "--out", out, "--seconds", 5,
            "--svg", f"{drawings[0]}=0xE010", "--svg", f"{drawings[1]}=0xE011",
            "--text", "\ue010\ue011", "--morph", "\ue010\ue011")
        # A square becomes a bar: its ink shrinks steadily, and grows again.
        ink = [sum(frame) - 64 * 64 * min(sum(frame[i:i + 3]) for i in
                                          range(0, 300, 3))
               for frame in frames_of(out.read_bytes())]
        low = ink.index(min(ink))
        turn = ink.index(max(ink))
        self.assertLess(min(ink), max(ink) // 3)
        for before, after in zip(ink[turn:low], ink[turn + 1:low]):
            self.assertGreaterEqual(before, after)
        message = run("animate", "icons", "--text", "\ue010", "--out", out,
                      code=1)
        self.assertIn("icons takes one to four pairs", message)

    def test_weight_runs_along_by_masters(self):
        for scene in ("path", "pulse"):
            out = self.path / f"{scene}.png"
            stats = out.with_suffix(".json")
            run("animate", scene, "--font", INTER, "--axis", "wght=300..800",
                "--text", "heart", "--size", "128x64", "--seconds", 301 / 30,
                "--out", out, "--stats", stats)
            frames = frames_of(out.read_bytes())
            self.assertEqual(frames[300], frames[0])
            self.assertEqual(json.loads(stats.read_text())["missed_pixels"], 0)
        # The first letter is half as heavy again, and the next ones give way.
        paper = min(frames[0][i:i + 3] for i in range(0, len(frames[0]), 3))
        ink = [sum(frame) - 128 * 64 * sum(paper) for frame in frames]
        self.assertGreater(max(ink), 1.3 * min(ink))
        rows = [frame[384 * y:384 * (y + 1)] for frame in (frames[0], frames[14])
                for y in range(64)]
        right = [max((x for x in range(128) for row in half
                      if row[3 * x:3 * x + 3] != paper), default=0)
                 for half in (rows[:64], rows[64:])]
        self.assertGreater(right[1], right[0])

    def test_bodies_fall_from_the_first_frame_on(self):
        out, _ = self.play("figure13", "b.png")
        for frame in frames_of(out.read_bytes()):
            self.assertGreater(len(set(frame[i:i + 3] for i in
                                       range(0, len(frame), 3))), 1)
        message = run("animate", "figure13", "--text", "nineBodys", "--out",
                      out, code=1)
        self.assertIn("figure13 takes up to 8 letters", message)
        # Eight that are tall and wide.
        self.play("figure13", "b.png", "--text", "MW8@Q%G&")

    def test_bodies_pile_up_and_keep_their_ink(self):
        """Until the floor opens: at least two layers, nothing pushed through."""
        for size in ("320x240", "128x64"):
            _, stats = self.play("figure13", "h.png", size=size, frames=272)
            self.assertGreaterEqual(stats["resting_off_floor"], 2, size)
            self.assertEqual(stats["worst_penetration_px"], 0, size)
            self.assertLessEqual(stats["worst_rigid_penetration_px"], 0.5)
            self.assertGreater(stats["worst_squash"], 0.15)
            self.assertLess(stats["worst_squash"], 0.25)
            for what, most in (("ink_of_a_frame", 0.02),
                               ("ink_of_a_letter", 0.06)):
                least, greatest = stats[what]
                self.assertGreater(least, 1 - most, (size, what))
                self.assertLess(greatest, 1 + most, (size, what))

    def test_words_of_a_wipe_do_not_overlap(self):
        """No pixel has light of both inks, beyond an edge of 2 px."""
        out, _ = self.play("wipe", "w.png", "--from", 16 / 30, size="320x240",
                           frames=1)
        frame, = frames_of(out.read_bytes())
        pixels = [frame[i:i + 3] for i in range(0, len(frame), 3)]
        warm = [i % 320 for i, (r, _, b) in enumerate(pixels) if r > b + 20]
        cold = [i % 320 for i, (r, _, b) in enumerate(pixels) if b > r + 40]
        self.assertLessEqual(max(cold), min(warm) + 2)

    def test_a_wipe_leaves_no_sliver(self):
        """The old word is seen with strong ink, or not at all."""
        for size in ("320x240", "240x120"):
            out, _ = self.play("wipe", "w.png", size=size,
                               frames=40)
            warmth = [max(frame[i] - frame[i + 2] for i in
                          range(0, len(frame), 3))
                      for frame in frames_of(out.read_bytes())]
            self.assertLess(warmth[-1], 0)
            for warm in warmth:
                self.assertTrue(warm < 0 or warm > warmth[0] * 2 // 3, warmth)

    def test_splash_begins_in_motion(self):
        """And moves for more than half of the time."""
        out, stats = self.play("splash", "s.png", frames=301)
        frames = frames_of(out.read_bytes())
        self.assertNotEqual(frames[0], frames[1])
        self.assertLess(stats["still_frames"], 150)

    def test_the_vortex_stays_on_the_screen(self):
        """Its ground as well, on screens of any size."""
        for text, width, height in (("eg", 160, 120), ("S", 640, 480)):
            out, _ = self.play("figure15", "v.png", "--text", text, "--fps", 5,
                               size=f"{width}x{height}", frames=300)
            for frame in frames_of(out.read_bytes()):
                self.assertEqual(len(frame), 3 * width * height)
                rows = [frame[:3 * width], frame[-3 * width:]]
                columns = [frame[3 * x::3 * width] for x in (0, width - 1)]
                for edge in rows:
                    self.assertEqual(edge, edge[:3] * width)
                self.assertEqual([set(edge) for edge in columns],
                                 [{frame[0]}, {frame[0]}])

    def test_the_vortex_tears_the_letter(self):
        """One piece becomes several; most of the ink is there all the time."""
        out, _ = self.play("figure15", "t.png", "--fps", 5, size="320x240",
                           frames=300)
        frames = frames_of(out.read_bytes())
        pieces = [pieces_of(frame, 320) for frame in frames]
        self.assertEqual(pieces[0], 1)
        self.assertEqual(pieces[-1], 1)
        self.assertEqual(frames[-1], frames[0])
        self.assertGreaterEqual(max(pieces), 3)
        light = [sum(red >= 128 for red in frame[::3]) for frame in frames]
        self.assertGreater(min(light), light[0] * 0.7)

    def test_the_vortex_leaves_the_letter_whole(self):
        """Of an italic as well, part of which nothing reaches."""
        self.font = ITALIC
        out, _ = self.play("figure15", "i.png", "--fps", 1, size="320x240",
                           frames=300)
        frames = frames_of(out.read_bytes())
        self.assertEqual(frames[-1], frames[0])

    def test_the_letter_comes_back_with_clean_edges(self):
        """Few pixels are between inks with all that surround them: edges are
        a pixel wide, and no layer fades as a whole."""
        out, _ = self.play("figure15", "c.png", "--from", 170 / 30, size="320x240",
                           frames=68)
        inks = [bytes(ink) for ink in ((0x0c, 0x10, 0x18), (0x1a, 0x38, 0x54),
                                       (0xf2, 0xe6, 0xcf), (0xd9, 0x76, 0x3f))]
        for number, frame in enumerate(frames_of(out.read_bytes())):
            pure = [frame[i:i + 3] in inks for i in range(0, len(frame), 3)]
            rows = [sum(pure[i - 1:i + 2]) for i in range(1, len(pure) - 1)]
            between = sum(rows[i - 320] + rows[i] + rows[i + 320] == 0
                          for i in range(320, len(rows) - 320))
            self.assertLess(between, 160, number)

    def test_the_vortex_is_printed(self):
        plain, _ = self.play("figure15", "p.png", "--from", 3, frames=3)
        seen = {plain.read_bytes()}
        for style in ("rings", "engraving", "hatching", "halftone", "relief"):
            out, _ = self.play("figure15", "p.png", "--from", 3, "--print",
                               style, frames=3)
            seen.add(out.read_bytes())
        self.assertEqual(len(seen), 6)
        message = run("animate", "path", "--print", "rings", "--out", plain,
                      code=1)
        self.assertIn("path is not printed; figure15 is", message)

    def test_far_particles_follow_the_field(self):
        """After 40 frames 9 of 10 are near an edge, not at a box around all."""
        width, height = 320, 240
        out, _ = self.play("figure14", "f.png", "--from", 40 / 30,
                           size=f"{width}x{height}", frames=1)
        frame = frames_of(out.read_bytes())[0]
        away = {}
        found = []
        blue = []
        for i in range(width * height):
            r, g, b = frame[3 * i:3 * i + 3]
            if r >= 224 and g >= 208 and b < 240:  # the letters
                away[i] = 0
                found.append(i)
            elif r < 208 and b >= 224:
                blue.append(i)
        for i in found:
            for near in (i - 1, i + 1, i - width, i + width):
                if 0 <= near < width * height and near not in away:
                    away[near] = away[i] + 1
                    found.append(near)
        self.assertGreater(len(blue), 400)
        self.assertLessEqual(sorted(away[i] for i in blue)[len(blue) * 9 // 10],
                             24)

    def test_melting_has_no_seam(self):
        """It ends as it began, and keeps its ink within a tenth."""
        out, stats = self.play("melt", "m.png", frames=301)
        frames = frames_of(out.read_bytes())
        self.assertEqual(frames[0], frames[300])
        self.assertEqual(frames[140], frames[150])  # the second word rests
        # It is as wide as what melted.
        wide = [[x for x in range(128) if any(
            frame[384 * y + 3 * x:384 * y + 3 * x + 3] != frame[:3]
            for y in range(64))] for frame in frames[10:58]]
        for before, after in zip(wide, wide[1:]):
            self.assertLessEqual(after[0], before[0])
            self.assertGreaterEqual(after[-1], before[-1])
        # The puddle is level: its upper edge is one row, but for its ends.
        rows = [[frames[57][384 * y + 3 * x:384 * y + 3 * x + 3] != frames[0][:3]
                 for x in range(24, 104)] for y in range(64)]
        self.assertTrue(any(map(all, rows)))
        self.assertLessEqual(sum(any(r) and not all(r) for r in rows), 1)
        self.assertNotEqual(frames[0], frames[150])
        self.assertEqual(stats["missed_pixels"], 0)
        self.assertGreater(stats["still_frames"], 50)

        def ink(frame):
            red = frame[::3]
            return (sum(red) - len(red) * red[0]) / (max(red) - red[0])
        # Both words have as much.
        for frame in frames:
            self.assertLess(abs(ink(frame) / ink(frames[0]) - 1), 0.1)

    def test_melting_letters_keep_their_corners(self):
        """Where text becomes a grid, and a grid text, no more changes than in
        frames beside them."""
        out, _ = self.play("melt", "k.png", size="240x240", frames=96)
        frames = frames_of(out.read_bytes())
        changes = {i: sum(abs(a - b) for a, b in
                          zip(frames[i - 1][::3], frames[i][::3]))
                   for i in (4, 5, 6, 92, 93, 94)}
        self.assertGreater(changes[4], 0)
        self.assertLessEqual(changes[4], max(changes[5], changes[6]))
        self.assertLessEqual(changes[94], max(changes[92], changes[93]))

    def test_charge_takes_a_percentage(self):
        for text in ("0%", "101%", "72", "%", "7a%"):
            out = run("animate", "charge", "--text", text, "--out",
                      self.path / "c.png", code=1)
            self.assertIn("charge takes 1% to 100%", out)
        self.play("charge", "c.png", "--text", "100%", frames=2)

    def test_typewriter_takes_what_can_be_read(self):
        out = self.path / "t.png"
        for text, code in (("x" * 40, 0), ("x" * 80, 1)):
            said = run("animate", "typewriter", "--text", text, "--seconds",
                       0, "--out", out, code=code)
            self.assertEqual("takes a line that fits" in said, code == 1)

    def test_reel(self):
        """Six seconds of a word on a watch and on e-paper."""
        out = self.path / "reel.gif"
        run("animate", "reel", "--font", self.font, "--out", out)
        self.assertLess(out.stat().st_size, 1000000)
        palettes = palettes_of(out.read_bytes())
        self.assertEqual(len(palettes), 12)
        run("animate", "reel", "--font", self.font, "--format", "apng",
            "--fps", 15, "--out", out)
        frames = frames_of(out.read_bytes())
        self.assertEqual(len(frames), 6 * 15)

        def changes(i):
            pairs = zip(frames[i - 1], frames[i])
            return sum(abs(a - b) for a, b in pairs)
        # The first frame follows the last: the scene goes on.
        self.assertLessEqual(changes(0), max(changes(-1), changes(1)))
        self.assertGreater(changes(0), 0)
        # It moves within half a second, and eleven effects are on the e-paper.
        self.assertGreater(max(map(changes, range(1, 7))), 1.5 * changes(0))
        paper = [b"".join(frame[3 * (656 * y + 326):3 * (656 * y + 622)]
                          for y in range(36, 164)) for frame in frames]
        cuts = [i for i in range(90) if paper[i] != paper[i - 1]]
        self.assertEqual(len(cuts), 11)
        self.assertEqual(len(set(paper)), 11)
        for cut, following in zip(cuts, cuts[1:]):
            self.assertTrue(0.5 <= (following - cut) / 15 <= 0.8, cuts)
        # Colours of each effect are in the palette of its part.
        for cut, palette in zip(cuts, palettes[1:]):
            pixels = collections.Counter(zip(*[iter(frames[cut + 1])] * 3))
            for colour, _ in pixels.most_common(8):
                off = min(max(abs(a - b) for a, b in zip(colour, each))
                          for each in palette)
                self.assertLessEqual(off, 4, (cut, colour))
        # What is shown of the next loop is the same.
        run("animate", "reel", "--font", self.font, "--format", "frames",
            "--from", 7, "--seconds", 0, "--out", self.path / "again")
        self.assertEqual(pixels_of(self.path / "again/00210.png"), frames[15])
        self.refused("--size: the reel plays", "animate", "reel", "--size",
                     "800x160", "--out", out)

    def test_classic_reel(self):
        out = self.path / "reel.gif"
        run("animate", "reel", "--classic", "--format", "gif", "--fps", 5,
            "--seconds", 2, "--out", out)
        self.assertEqual(out.read_bytes()[6:10],
                         struct.pack("<HH", 800, 160))
        # Each tile has a ground of its own, which the palette keeps.
        gif = out.read_bytes()
        palette = gif[13:13 + 3 * (2 << (gif[10] & 7))]
        run("animate", "reel", "--classic", "--format", "frames", "--from", 1,
            "--seconds", 0, "--out", out.with_suffix(""))
        pixels = pixels_of(out.with_suffix("") / "00030.png")
        # Its tiles are the scenes.
        for tile, scene in ((1, "count"), (5, "wipe"), (9, "splash")):
            alone = self.path / scene
            run("animate", scene, "--size", "160x80", "--format", "frames",
                "--from", 1, "--seconds", 0, "--out", alone)
            start = tile // 5 * 80 * 800 + tile % 5 * 160
            self.assertEqual(pixels_of(alone / "00030.png"), b"".join(
                pixels[3 * i:3 * (i + 160)]
                for i in range(start, start + 80 * 800, 800)), scene)
        found = collections.Counter(zip(*[iter(pixels)] * 3))
        grounds = [ground for ground, count in found.items()
                   if count > 800 * 160 // 50]
        self.assertGreater(len(grounds), 5)
        for ground in grounds:
            off = min(max(abs(a - b) for a, b in zip(ground, colour))
                      for colour in zip(*[iter(palette)] * 3))
            self.assertLessEqual(off, 4, ground)  # of colours of 5 bits
        self.refused("takes 320x64 to 2048x2048 px", "animate", "reel",
                     "--classic", "--size", "319x64", "--out", out)
        self.refused("--classic: is of the reel", "animate", "wipe",
                     "--classic", "--out", out)
        self.refused("--text: the reel plays", "animate", "reel", "--classic",
                     "--text", "x", "--out", out)

    def test_strips_make_no_difference(self):
        for scene in SCENES:
            hashes = {self.play(scene, "r.png", "--from", 4 / 3, "--rows", rows)
                      [1]["sha256"] for rows in (1, 7, 16, 64)}
            self.assertEqual(len(hashes), 1)

    def test_what_changes_is_known_and_due(self):
        for scene in SCENES:
            for size, frames in (("320x240", 120), ("128x64", 300),
                                 ("96x16", 300)):
                _, stats = self.play(scene, "d.png", size=size, frames=frames)
                self.assertEqual(stats["missed_pixels"], 0, (scene, size))
                self.assertEqual(stats["missed_frames"], 0, (scene, size))
                self.assertGreater(stats["changed_pixels_mean"], 0)
                if scene == "figure13":  # drawn, soft bodies never overlap
                    self.assertLessEqual(stats["worst_penetration_px"], 0.5)
        # What rests costs nothing.
        _, stats = self.play("clock", "d.png", frames=300)
        self.assertGreater(stats["still_frames"], 100)

    def test_mistakes_are_explained(self):
        out = self.path / "x.png"
        for arguments, words in (
                (("nothing", "--out", out), "no such scene"),
                (("path", "--out", out, "--size", "320"), "WIDTHxHEIGHT"),
                (("path", "--out", out, "--size", "9x9"), "16x8"),
                (("clock", "--out", out, "--text", "25:00"),
                 "'25:00' on 320x240 px: clock takes a time, H:MM or HH:MM"),
                (("particles", "--out", out, "--text", "one"),
                 "particles takes two words"),
                (("path", "--out", out, "--text", 25 * "i"),
                 "path takes a line of up to 24 letters"),
                (("path", "--out", out, "--fps", 7), "{1,2,3,5,6,10,15,30}"),
                (("path", "--out", out, "--format", "mp4"), "mp4")):
            message = run("animate", *arguments, "--font", self.font, code=1)
            self.assertIn(words, message)


main("animate", "fontgen")
