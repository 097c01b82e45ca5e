"""Compares the advances of space_letters with those of five faces' designers.

Usage: check_letter_spacing.py INKCELL_DESIGN

n, o, H and O keep the designer's left bearings as the measure; the advances of
all letters a-z and A-Z are compared, in 1/1000 em.
"""
import pathlib
import plistlib
import subprocess
import sys
import tempfile
import xml.etree.ElementTree

from problems import expect, finish

FONTS = pathlib.Path("/usr/share/fonts/truetype")
# The mean difference that may not be exceeded, 1/1000 em.
FACES = {"dejavu/DejaVuSans.ttf": 20,
         "liberation/LiberationSerif-Regular.ttf": 20,
         "lato/Lato-Regular.ttf": 20,
         "roboto/unhinted/RobotoTTF/Roboto-Regular.ttf": 20,
         "open-sans/OpenSans-Regular.ttf": 22}


def advances(project):
    return {file.stem: float(xml.etree.ElementTree.parse(file).find(
        "advance").get("width")) for file in (project / "glyphs").glob("*.glif")
            if len(file.stem.strip("_")) == 1}


def main():
    design = pathlib.Path(sys.argv[1]).resolve()
    for face, most in FACES.items():
        with tempfile.TemporaryDirectory() as name:
            project = pathlib.Path(name) / "P.ufo"
            subprocess.run([design, "import", "--font", FONTS / face, "--chars",
                            "A-Z,a-z", "--out", project], check=True,
                           stdout=subprocess.DEVNULL)
            before = advances(project)
            subprocess.run([design, "replay", "--project", project, "--do",
                            '{"do": "space_letters"}'], check=True,
                           stdout=subprocess.DEVNULL)
            after = advances(project)
            info = plistlib.loads((project / "fontinfo.plist").read_bytes())
            off = [1000 * abs(after[key] - before[key]) / info["unitsPerEm"]
                   for key in before]
            mean = sum(off) / len(off)
            print(f"{pathlib.Path(face).stem}: advances of {len(off)} letters "
                  f"differ by {mean:.1f}/1000 em on average, "
                  f"{max(off):.0f} at most")
            expect(len(off) == 52 and mean <= most, f"{face}: {mean:.1f}")
    finish()


main()
