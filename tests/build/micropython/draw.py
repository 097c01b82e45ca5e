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
print("width", sans.width("21.5", 24), sans.width("21.5", 12.5))
for wrong in (lambda: inkcell.Font(b"no font"),
              lambda: sans.text(bytearray(9), 120, 40, framebuf.GS8, TEXT, 0, 9, 24),
              lambda: sans.text(bytearray(9), 1, 1, 77, TEXT, 0, 9, 24),
              lambda: sans.width("A", 2000)):
    try:
        wrong()
        print("no error")
    except ValueError as error:
        print(error)
