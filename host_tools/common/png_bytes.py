"""Pictures as PNG, for scripts."""
import struct
import zlib


def png(width, channels, pixels):
    """The bytes of a PNG. `channels`: 1, grey, or 3, RGB, of a byte each; `pixels`:
    whole rows, one after the other."""
    def chunk(kind, data):
        return (struct.pack(">I", len(data)) + kind + data +
                struct.pack(">I", zlib.crc32(kind + data)))

    stride = width * channels
    rows = [pixels[at:at + stride] for at in range(0, len(pixels), stride)]
    header = struct.pack(">IIBBBBB", width, len(rows), 8, {1: 0, 3: 2}[channels],
                         0, 0, 0)
    data = zlib.compress(b"".join(b"\0" + row for row in rows), 9)
    return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) +
            chunk(b"IDAT", data) + chunk(b"IEND", b""))
