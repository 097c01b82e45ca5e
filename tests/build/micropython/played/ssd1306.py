# The driver ssd1306 of micropython-lib, without its display.
import framebuf


class SSD1306_I2C(framebuf.FrameBuffer):
    def __init__(self, width, height, i2c):
        self.buffer = bytearray(width * height // 8)
        super().__init__(self.buffer, width, height, framebuf.MONO_VLSB)

    def show(self):
        print("ink", sum(self.pixel(x, y) for y in range(64) for x in range(128)))
