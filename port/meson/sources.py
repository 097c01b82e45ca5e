"""Prints the sources below src/ of the folders that are named, one a line."""
import pathlib
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
for folder in sys.argv[1:]:
    for path in sorted((ROOT / folder / "src").rglob("*.cpp")):
        print(path)
