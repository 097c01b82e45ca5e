# Draws into buffers of framebuf and writes them, format by format.
import framebuf
import inkcell
import sys

sans = inkcell.Font(open(sys.argv[1], "rb").read())
TEXT = "21.5 \u00b0C"
KINDS = (
    ("mono_pages", framebuf.MONO_VLSB, 120 * 5, 1),
    ("rgb565", framebuf.RGB565, 120 * 40 * 2, 0xFFE0),
    ("grey4", framebuf.GS4_HMSB, 60 * 40, 15),
    ("mono_rows", framebuf.MONO_HLSB, 15 * 40, 1),
    ("grey2", framebuf.GS2_HMSB, 30 * 40, 3),
    ("grey8", framebuf.GS8, 120 * 40, 255),
)
with open(sys.argv[2], "wb") as out:
    for name, kind, size, colour in KINDS:
        pixels = bytearray(size)
        paper = framebuf.FrameBuffer(pixels, 120, 40, kind)
        sans.text(pixels, 120, 40, kind, TEXT, 4, 30, 24, colour)
        out.write(pixels)
        # framebuf sees what was drawn: as many pixels of the colour as bytes say.
        print(name, sum(paper.pixel(x, y) == colour
                        for y in range(40) for x in range(120)))
print("width", sans.width("21.5", 24), sans.width(text="21.5", size=12.5))


def ink(kind, size, text, **more):
    """Columns and rows of a text of many pixels, to the last of its ink."""
    pixels = bytearray(240 * 60)
    paper = framebuf.FrameBuffer(pixels, 240, 60, kind)
    sans.text(pixels, 240, 60, kind, text, 0, 24, size, 1, **more)
    drawn = [(x, y) for y in range(60) for x in range(240) if paper.pixel(x, y)]
    return [max(at) + 1 for at in zip(*drawn)] if drawn else [0, 0]


# Measured as drawn, in every format: 1 bit has whole advances.
for kind in (framebuf.MONO_VLSB, framebuf.MONO_HMSB, framebuf.GS8):
    for fit in (True, False):
        long = "11111" * 4
        width = sans.width(long, 18, kind, fit=fit)
        end = ink(kind, 18, long, fit=fit)[0]
        print("ends in" if width - 4 <= end <= width else "ends beyond", width, end)

lines = sans.wrap("21 22 23\n24 25", 60, 20, framebuf.MONO_VLSB)
print("lines", lines, all(sans.width(line, 20, framebuf.MONO_VLSB) <= 60
                          for line in lines))
print("below", ink(framebuf.GS8, 20, "1\n1")[1] - ink(framebuf.GS8, 20, "1")[1],
      sans.height(20), 0 < sans.ascent(20) < sans.height(20),
      sans.width("1\n1", 20) == sans.width("1", 20))
print("color", ink(framebuf.GS8, 20, "1", color=7) == ink(framebuf.GS8, 20, "1"))

# At any address, as of frozen bytes; of a bytearray, as long as it stays.
data = open(sys.argv[1], "rb").read()
moved = [inkcell.Font(memoryview(b"." * skip + data)[skip:]) for skip in range(5)]
print("moved", {font.width("21.5", 24) for font in moved})
growing = bytearray(data)
grown = inkcell.Font(growing)
growing.extend(bytes(100000))
help(inkcell)
help(inkcell.Font)

nan = float("nan")
eight = bytearray(64)
for wrong in (lambda: inkcell.Font(b"no font"),
              lambda: sans.text(bytearray(9), 120, 40, framebuf.GS8, TEXT, 0, 9, 24),
              lambda: sans.text(bytearray(9), 1, 1, 77, TEXT, 0, 9, 24),
              lambda: sans.width("A", 2000),
              lambda: sans.width("A", 2**26 + 20),
              lambda: sans.width("A", nan),
              lambda: sans.text(eight, 2**32 + 8, 8, framebuf.GS8, TEXT, 0, 9, 24),
              lambda: sans.text(eight, 8, 8, framebuf.GS8, TEXT, 1e12, 9, 24),
              lambda: sans.text(eight, 8, 8, framebuf.GS8, TEXT, 0, -nan, 24),
              lambda: grown.width("A", 20)):
    try:
        wrong()
        print("no error")
    except (ValueError, OverflowError) as error:
        print("refused:", error)
