"""Pictures in files, as bytes."""
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "common"))
from png_bytes import png  # noqa: E402,F401 for tests


def pixels(file):
    """Size and bytes of a PGM or PPM; three bytes a pixel."""
    data = file.read_bytes()
    magic, width, height = data[:20].split()[:3]
    size = (int(width), int(height))
    data = data[-size[0] * size[1] * (3 if magic == b"P6" else 1):]
    if magic == b"P5":
        data = bytes(value for value in data for _ in range(3))
    return size, data
