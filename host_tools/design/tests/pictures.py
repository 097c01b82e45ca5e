"""Pictures in files, as bytes."""
import struct
import zlib


def pixels(file):
    """Size and bytes of a PGM or PPM; three bytes a pixel."""
    data = file.read_bytes()
    magic, width, height = data[:20].split()[:3]
    size = (int(width), int(height))
    data = data[-size[0] * size[1] * (3 if magic == b"P6" else 1):]
    if magic == b"P5":
        data = bytes(value for value in data for _ in range(3))
    return size, data


def png(width, height, rows):
    """The bytes of a PNG of greys."""
    def chunk(kind, data):
        return (struct.pack(">I", len(data)) + kind + data +
                struct.pack(">I", zlib.crc32(kind + data)))
    head = struct.pack(">IIBBBBB", width, height, 8, 0, 0, 0, 0)
    data = zlib.compress(b"".join(b"\0" + bytes(row) for row in rows))
    return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", head) +
            chunk(b"IDAT", data) + chunk(b"IEND", b""))
