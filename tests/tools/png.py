"""Reads PNG files, without a library."""
import struct
import zlib


def chunks(png):
    """Kind and data of each chunk; their checksums must fit."""
    assert png[:8] == b"\x89PNG\r\n\x1a\n"
    at = 8
    while at < len(png):
        size, = struct.unpack(">I", png[at:at + 4])
        kind, data = png[at + 4:at + 8], png[at + 8:at + 8 + size]
        checksum, = struct.unpack(">I", png[at + 8 + size:at + 12 + size])
        assert checksum == zlib.crc32(kind + data)
        yield kind, data
        at += 12 + size


def nearest(left, up, corner):
    """The neighbour that is nearest to left + up - corner (Paeth)."""
    to_left = abs(up - corner)
    to_up = abs(left - corner)
    to_corner = abs(left + up - 2 * corner)
    if to_left <= to_up and to_left <= to_corner:
        return left
    return up if to_up <= to_corner else corner


def mean(left, up, _):
    return (left + up) // 2


def unfilter(data, width, height, channels):
    """Rows of a picture of 8 bits a channel."""
    raw, rows = zlib.decompress(data), []
    stride = width * channels
    up = bytes(stride)
    for y in range(height):
        at = y * (stride + 1)
        kind, row = raw[at], bytearray(raw[at + 1:at + 1 + stride])
        if kind == 1:
            for i in range(channels, stride):
                row[i] = (row[i] + row[i - channels]) & 255
        elif kind == 2:
            row = bytearray((a + b) & 255 for a, b in zip(row, up))
        elif kind > 2:
            predict = mean if kind == 3 else nearest
            for i in range(stride):
                left, corner = ((row[i - channels], up[i - channels])
                                if i >= channels else (0, 0))
                row[i] = (row[i] + predict(left, up[i], corner)) & 255
        up = bytes(row)
        rows.append(up)
    return rows


def read_png(png):
    """Width, height, channels and rows of a picture that is not animated."""
    data = b""
    for kind, body in chunks(png):
        if kind == b"IHDR":
            width, height, depth, colour, _, _, interlaced = struct.unpack(
                ">IIBBBBB", body)
            assert depth == 8 and not interlaced
            channels = {0: 1, 2: 3, 4: 2, 6: 4}[colour]
        elif kind == b"IDAT":
            data += body
    return width, height, channels, unfilter(data, width, height, channels)
