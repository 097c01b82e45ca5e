# Text on an OLED of 128 x 64 pixels, with the driver ssd1306 of micropython-lib.
import framebuf
import inkcell
from machine import I2C, Pin
from ssd1306 import SSD1306_I2C

oled = SSD1306_I2C(128, 64, I2C(0, sda=Pin(4), scl=Pin(5)))
sans = inkcell.Font(open("dejavu_sans_latin1.bin", "rb").read())
sans.text(oled.buffer, 128, 64, framebuf.MONO_VLSB, "21.5 \u00B0C", 0, 40, 24, 1)
oled.show()
