"""Shapes all of Unicode's emoji by the device's code.

Each emoji of emoji-test.txt, with a drawing of its own in a folder, is one
glyph, which shows its drawing: with, without and with some of its variation
selectors; alone and behind another one. Clusters are those of hb-shape.

Usage: shaped_emoji.py FONTGEN INSPECT FOLDER
"""
import json
import pathlib
import shutil
import subprocess
import sys

TEST = pathlib.Path("/usr/share/unicode/emoji/emoji-test.txt")
DEJAVU = "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf"
SQUARE = ('<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 8 8">'
          '<path d="M1 1h6v6h-6z"/></svg>')
STYLES = "\ufe0e\ufe0f"
SKIN_TONES = [chr(code) for code in range(0x1f3fb, 0x1f400)]


def emoji_of(file):
    """All that it lists, as text."""
    lines = file.read_text(encoding="utf-8").splitlines()
    codes = [line.split(";")[0].split() for line in lines
             if ";" in line and not line.startswith("#")]
    return ["".join(chr(int(code, 16)) for code in one) for one in codes]


def without_style(text):
    return "".join(c for c in text if c not in STYLES)


def by_device(inspect, font, folder, lines):
    file = folder / "lines.txt"
    file.write_text("\n".join(lines) + "\n", encoding="utf-8")
    out = subprocess.run([inspect, font, "--run-file", file], check=True,
                         capture_output=True, text=True).stdout.splitlines()
    return [json.loads(line) for line in out]


def clusters_of_harfbuzz(lines, folder):
    file = folder / "lines.txt"
    file.write_text("\n".join(lines) + "\n", encoding="utf-8")
    out = subprocess.run(
        ["hb-shape", "--shaper=ot", "--no-glyph-names",
         "--output-format=json", "--script=Zyyy", DEJAVU,
         f"--text-file={file}"],
        check=True, capture_output=True, text=True).stdout.splitlines()
    return [sorted({g["cl"] for g in json.loads(line)}) for line in out]


def main():
    fontgen, inspect, folder = sys.argv[1:4]
    folder = pathlib.Path(folder)
    drawings = folder / "drawings"
    shutil.rmtree(drawings, ignore_errors=True)
    drawings.mkdir(parents=True)
    emoji = emoji_of(TEST)
    names = {without_style(one) for one in emoji}
    # (c) and (r) are of the font.
    own = {one for one in names if len(one) > 1 or one > "\xff"}
    for one in own:
        name = "-".join(f"{ord(c):04x}" if ord(c) > 127 else f"{ord(c):02x}"
                        for c in one)
        (drawings / f"{name}.svg").write_text(SQUARE, encoding="utf-8")
    font = folder / "emoji.bin"
    subprocess.run([fontgen, "--font", DEJAVU, "--chars", "0x20-0x7e,0xa9,0xae",
                    "--shape", "emoji", "--svg-dir", drawings, "--min-px", "16", "--max-px", "16",
                    "--out", font], check=True, capture_output=True)
    lines = [one for one in emoji if without_style(one) in own]
    space = by_device(inspect, font, folder, [" "])[0][0]["glyph"]
    glyphs = {}
    failed = 0
    alone = by_device(inspect, font, folder, lines)
    for line, shaped in zip(lines, alone):
        shown = [g["glyph"] for g in shaped
                 if (g["glyph"], g["advance"]) != (space, 0)]
        good = (len(shown) == 1 and shown[0] != 0 and
                {g["cluster"] for g in shaped} == {0} and
                glyphs.setdefault(without_style(line), shown[0]) == shown[0])
        if not good and failed < 10:
            print("alone", [f"{ord(c):04x}" for c in line], shaped)
        failed += not good
    if len(set(glyphs.values())) != len(glyphs):
        print("two emoji have one glyph")
        failed += 1
    pairs = [a + b for a, b in zip(lines, lines[1:] + lines[:1])]
    for shaped, pair, own_, next_ in zip(
            by_device(inspect, font, folder, pairs), pairs, lines,
            lines[1:] + lines[:1]):
        shown = [(g["glyph"], g["cluster"]) for g in shaped
                 if (g["glyph"], g["advance"]) != (space, 0)]
        # A skin tone belongs to whatever is before it.
        begin = 0 if next_ in SKIN_TONES else len(own_)
        wanted = [(glyphs[without_style(own_)], 0),
                  (glyphs[without_style(next_)], begin)]
        if shown != wanted and failed < 10:
            print("pair", [f"{ord(c):04x}" for c in pair], shown, wanted)
        failed += shown != wanted
    clusters = clusters_of_harfbuzz(pairs, folder)
    device = [sorted({g["cluster"] for g in shaped})
              for shaped in by_device(inspect, font, folder, pairs)]
    wrong = [pair for pair, a, b in zip(pairs, device, clusters) if a != b]
    for pair in wrong[:5]:
        print("clusters", [f"{ord(c):04x}" for c in pair])
    print(f"{len(lines)} emoji and as many pairs, {failed} wrong, "
          f"{len(wrong)} with other clusters than HarfBuzz; "
          f"{len(glyphs)} drawings")
    return failed + len(wrong) != 0


sys.exit(main())
