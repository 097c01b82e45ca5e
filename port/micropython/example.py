# Text in a buffer of framebuf. The font is a file on the board.
import framebuf
import inkcell

pixels = bytearray(240 * 60 * 2)
paper = framebuf.FrameBuffer(pixels, 240, 60, framebuf.RGB565)
paper.fill(0x000F)
sans = inkcell.Font(open("dejavu_sans_latin1.bin", "rb").read())
sans.text(pixels, 240, 60, framebuf.RGB565, "21.5 \u00B0C", 4, 44, 40, 0xFFFF)
paper.rect(0, 0, 8 + sans.width("21.5 \u00B0C", 40), 60, 0xFFE0)
