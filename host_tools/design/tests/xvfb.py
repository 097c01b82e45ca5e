"""A display server without a screen, and a pointer and keys for it."""
import os
import pathlib
import struct
import subprocess
import time

WAIT_S = 600  # ends what hangs


def wait(condition, what):
    """Returns what `condition` does as soon as it is true."""
    end = time.monotonic() + WAIT_S
    pause_s = 0.02
    while time.monotonic() < end:
        value = condition()
        if value:
            return value
        time.sleep(pause_s)
        pause_s = min(1.2 * pause_s, 0.5)  # others may have the processor
    raise AssertionError(f"after {WAIT_S} s: {what}")


class Display:
    """Xvfb; its screen is read from the file that it keeps it in."""

    def __init__(self, folder, width, height):
        self.width = width
        self.file = pathlib.Path(folder) / "Xvfb_screen0"
        number, name = os.pipe()
        self.server = subprocess.Popen(
            ["Xvfb", "-displayfd", str(name), "-fbdir", str(folder),
             "-screen", "0", f"{width}x{height}x24", "-nocursor", "-noreset",
             "-nolisten", "tcp", "-r"],
            pass_fds=(name,), stderr=subprocess.DEVNULL)
        os.close(name)
        with os.fdopen(number) as pipe:
            line = pipe.readline().strip()
        if not line:
            raise AssertionError("Xvfb did not start")
        # The same renderer as without a display, so that pixels are equal.
        self.environment = dict(os.environ, DISPLAY=f":{line}",
                                SDL_VIDEODRIVER="x11",
                                SDL_RENDER_DRIVER="software")

    def close(self):
        self.server.terminate()
        self.server.wait()

    def pixels(self):
        """Red, green, blue of all pixels."""
        data = self.file.read_bytes()
        head = struct.unpack(">25I", data[:100])
        start = head[0] + 12 * head[19]
        width, height, pitch = head[4], head[5], head[12]
        rows = (data[start + y * pitch:start + y * pitch + 4 * width]
                for y in range(height))
        flat = b"".join(rows)
        rgb = bytearray(3 * width * height)
        for channel in range(3):  # stored as blue, green, red, nothing
            rgb[channel::3] = flat[2 - channel::4]
        return bytes(rgb)

    def send(self, *words):
        """Events, as xdotool names them."""
        subprocess.run(["xdotool", *map(str, words)], check=True,
                       env=self.environment, stdout=subprocess.DEVNULL)

    def geometry(self, title):
        """Place and size of the window of this title, as xdotool prints it."""
        return subprocess.run(
            ["xdotool", "search", "--name", title, "getwindowgeometry"],
            check=True, env=self.environment, text=True,
            capture_output=True).stdout

    def focus(self, title):
        """Gives the keyboard to the window of this title, once it is there."""
        self.send("search", "--sync", "--onlyvisible", "--name", title,
                  "windowfocus", "--sync")
