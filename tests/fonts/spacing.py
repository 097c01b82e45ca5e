"""Judges the spacing of fitted text in faces of Debian.

Prints a row a face and mode, separated by tabs, of all sizes:

  face      its file; those of fixed pitch first
  mode      grey: kGridFit across; two_fit, four_fit: the same with 2 and 4
            levels; two, four: what canvases of 1 and 2 bits do by themselves
  advances  at most so many different ones of ASCII at one size; digits: of
            those alone. Faces of fixed pitch must have one, all others one of
            the digits
  closed    share of the pairs of letters and digits that touch, fitted, of those
            whose ink is half a pixel apart or more unfitted [1/1000]
  least, most   how much longer lines are than unfitted [1/1000]
  mean      of the magnitudes

Exits with 1 if a face of fixed pitch has a second advance.
"""
import argparse
import collections
import fnmatch
import pathlib
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
LINES = ROOT / "tests/bench/reading_lines.txt"
FOLDER = pathlib.Path("/usr/share/fonts")

FIXED = {
    "fonts-anonymous-pro": ["truetype/anonymous-pro/Anonymous Pro.ttf"],
    "fonts-courier-prime": ["opentype/courier-prime/Courier Prime.otf"],
    "fonts-dejavu-core": ["truetype/dejavu/DejaVuSansMono.ttf",
                          "truetype/dejavu/DejaVuSansMono-Bold.ttf"],
    "fonts-firacode": ["truetype/firacode/FiraCode-Regular.ttf"],
    "fonts-hack": ["truetype/hack/Hack-Regular.ttf"],
    "fonts-hermit": ["truetype/hermit/Hermit-medium.otf"],
    "fonts-inconsolata": ["truetype/inconsolata/Inconsolata.otf"],
    "fonts-jetbrains-mono":
        ["truetype/jetbrains-mono/JetBrainsMono-Regular.ttf"],
    "fonts-league-mono": ["opentype/league-mono/LeagueMono-Condensed.otf"],
    "fonts-liberation": ["truetype/liberation/LiberationMono-Regular.ttf"],
    "fonts-monoid": ["truetype/monoid/Monoid-Regular.ttf"],
    "fonts-mononoki": ["truetype/mononoki/mononoki-Regular.ttf"],
    "fonts-noto-mono": ["truetype/noto/NotoMono-Regular.ttf",
                        "truetype/noto/NotoSansMono-Regular.ttf"],
    "fonts-urw-base35": ["opentype/urw-base35/NimbusMonoPS-Regular.otf"],
}
OTHERS = {
    "fonts-comfortaa": ["truetype/comfortaa/Comfortaa-Regular.ttf"],
    "fonts-crosextra-caladea": ["truetype/crosextra/Caladea-Regular.ttf"],
    "fonts-crosextra-carlito": ["truetype/crosextra/Carlito-Regular.ttf"],
    "fonts-dejavu-core": ["truetype/dejavu/DejaVuSans.ttf",
                          "truetype/dejavu/DejaVuSans-Bold.ttf",
                          "truetype/dejavu/DejaVuSerif.ttf"],
    "fonts-ebgaramond": ["opentype/ebgaramond/EBGaramond12-Regular.otf"],
    "fonts-inter": ["opentype/inter/Inter-Regular.otf"],
    "fonts-lato": ["truetype/lato/Lato-Regular.ttf"],
    "fonts-liberation": ["truetype/liberation/LiberationSans-Regular.ttf",
                         "truetype/liberation/LiberationSans-Italic.ttf",
                         "truetype/liberation/LiberationSerif-Regular.ttf"],
    "fonts-noto-core": ["truetype/noto/NotoSans-Regular.ttf",
                        "truetype/noto/NotoSerif-Regular.ttf"],
    "fonts-open-sans": ["truetype/open-sans/OpenSans-Regular.ttf"],
    "fonts-quicksand": ["truetype/quicksand/Quicksand-Regular.ttf"],
    "fonts-roboto-unhinted":
        ["truetype/roboto/unhinted/RobotoTTF/Roboto-Regular.ttf",
         "truetype/roboto/unhinted/RobotoCondensed-Regular.ttf",
         "truetype/roboto/unhinted/RobotoTTF/RobotoCondensed-Regular.ttf"],
    "fonts-urw-base35": ["opentype/urw-base35/NimbusSans-Regular.otf",
                         "opentype/urw-base35/C059-Roman.otf",
                         "opentype/urw-base35/P052-Roman.otf"],
}


def arguments():
    parser = argparse.ArgumentParser(
        prog="spacing.sh", description=__doc__,
        formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--faces", default="*", metavar="GLOB",
                        help="only files whose name is like this")
    parser.add_argument("--first", type=int, default=8, help="size [8]")
    parser.add_argument("--last", type=int,
                        help="size [40 of fixed pitch, 24 of others]")
    parser.add_argument("--build", type=pathlib.Path,
                        default=ROOT / "build/host",
                        help="where the programs are [build/host]")
    parser.add_argument("--judge", type=pathlib.Path,
                        help="the program of spacing.cpp, of another core")
    parser.add_argument("--packages", action="store_true",
                        help="print Debian's packages of the faces")
    return parser.parse_args()


def files(packages, pattern):
    return [FOLDER / name for names in packages.values() for name in names
            if (FOLDER / name).is_file() and
            fnmatch.fnmatch(pathlib.Path(name).name, pattern)]


def judge(options, file, is_fixed, folder):
    """Rows of a face by mode."""
    font = folder / "font.bin"
    subprocess.run([options.build / "fonts_gen/inkcell-fontgen", "--quiet",
                    "--best-effort", "--font", file, "--out", font],
                   check=True, stderr=subprocess.DEVNULL)
    program = options.judge or options.build / "tests/fonts/inkcell_spacing"
    # Pairs of faces whose columns stand are apart as those of others.
    command = [program, font, str(options.first),
               str(options.last or (40 if is_fixed else 24)), LINES]
    command += ["nHWmw01"] if is_fixed else []
    text = subprocess.run(command, check=True, text=True,
                          stdout=subprocess.PIPE).stdout
    modes = collections.defaultdict(list)
    for line in text.splitlines():
        mode, _, advances, *numbers = line.split()
        modes[mode].append([*map(int, advances.split(",")),
                            *map(float, numbers)])
    for mode, sizes in modes.items():
        columns = list(zip(*sizes))
        yield [file.name, mode, max(columns[0]), max(columns[1]),
               1000 * sum(columns[3]) / max(1, sum(columns[2])),
               min(columns[4]), max(columns[5]),
               sum(columns[6]) / len(sizes)]


def main():
    options = arguments()
    if options.packages:
        print(" ".join(sorted({*FIXED, *OTHERS})))
        return 0
    failed = 0
    print("face\tmode\tadvances\tdigits\tclosed\tleast\tmost\tmean")
    with tempfile.TemporaryDirectory() as folder:
        for packages, is_fixed in ((FIXED, True), (OTHERS, False)):
            for file in files(packages, options.faces):
                for row in judge(options, file, is_fixed,
                                 pathlib.Path(folder)):
                    failed += is_fixed and row[2] != 1
                    print("\t".join(f"{cell:.1f}" if isinstance(cell, float)
                                    else str(cell) for cell in row),
                          flush=True)
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
