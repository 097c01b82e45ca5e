"""Prints the sources of what runs on the device, one a line."""
import pathlib

ROOT = pathlib.Path(__file__).resolve().parents[2]
for folder in ("core/src", "core/kinetic/src", "port/pixel/src",
               "port/display/src", "port/c/src"):
    for path in sorted((ROOT / folder).rglob("*.cpp")):
        print(path)
