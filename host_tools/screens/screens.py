#!/usr/bin/env python3
"""Compares what the display boards show in QEMU with this machine's rendering.

Builds the firmware of each board, starts it, waits until it says READY, takes a
screendump and compares every pixel with that of scene_host. The exit code is
the number of pictures that differ.

    screens.py <host build>/host_tools/screens/screens.json [--save DIR]
"""

import argparse
import contextlib
import json
import os
import pathlib
import select
import shutil
import socket
import subprocess
import sys
import tempfile
import time

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "host_tools/common"))
from png_bytes import png  # noqa: E402

# Ends a firmware that hangs before its first frame. [s]
READY_TIMEOUT = 1200
RUNNER = ROOT / "boards/common/qemu_run.sh"
NOTICES = ROOT / "host_tools/screens/notices.txt"


class Failure(Exception):
    """A picture that is wrong, or that there is none."""


class Picture:
    """RGB pixels, three bytes each, row by row from the top."""

    def __init__(self, path):
        data = pathlib.Path(path).read_bytes()
        magic, size, depth, self.pixels = data.split(b"\n", 3)
        if magic != b"P6" or depth != b"255":
            raise Failure(f"{path} is not an 8-bit PPM")
        self.width, self.height = (int(word) for word in size.split())
        if len(self.pixels) != self.width * self.height * 3:
            raise Failure(f"{path} is truncated")

    def at(self, index):
        return tuple(self.pixels[3 * index:3 * index + 3])

    def save_png(self, path):
        pathlib.Path(path).write_bytes(png(self.width, 3, self.pixels))


def compare(shown, expected):
    """Raises Failure unless the pictures are equal and show something."""
    if (shown.width, shown.height) != (expected.width, expected.height):
        raise Failure(f"the screen is {shown.width} x {shown.height}, not "
                      f"{expected.width} x {expected.height}")
    count = shown.width * shown.height
    if shown.pixels != expected.pixels:
        wrong = [i for i in range(count) if shown.at(i) != expected.at(i)]
        first = wrong[0]
        raise Failure(
            f"{len(wrong)} of {count} points differ, the first at "
            f"({first % shown.width}, {first // shown.width}): shown "
            f"{shown.at(first)}, expected {expected.at(first)}")
    colours = {}
    for i in range(count):
        colours[shown.at(i)] = colours.get(shown.at(i), 0) + 1
    ink = count - max(colours.values())
    if ink < count // 50:
        raise Failure(f"only {ink} of {count} points are not background")
    return f"{count} points equal, {len(colours)} colours"


def firmware(screen, picture):
    """The name of the program that shows a picture on a board."""
    name = {"scene": "demo", "pattern": "pattern", "page": "page",
            "unifont": "page", "face": "face", "notice": "notice"}.get(
                picture, f"motion_{picture}")
    return f"{name}_{screen['format']}"


def build(screen, programs):
    """Builds some programs of a board; configures a tree of its own, with this
    machine's fonts.
    """
    source = pathlib.Path(screen["source"])
    toolchain = source / "boards" / screen["board"] / "toolchain.cmake"
    if screen["is_own"]:
        subprocess.run(
            ["cmake", "-S", source, "-B", screen["build"], "-G", "Ninja",
             f"-DCMAKE_TOOLCHAIN_FILE={toolchain}",
             "-DCMAKE_BUILD_TYPE=Release", "-DINKCELL_TESTS=OFF",
             "-DINKCELL_JOIN_FOLDERS=ON",
             f"-DINKCELL_FONTGEN={screen['fontgen']}",
             f"-DINKCELL_DEMO_FONT={screen['font']}"],
            check=True, stdout=subprocess.DEVNULL)
    subprocess.run(
        ["cmake", "--build", screen["build"], "--target", *programs],
        check=True, stdout=subprocess.DEVNULL)


def wait_until_ready(process):
    """Reads the firmware's console until READY; returns what came before."""
    output = b""
    end = time.monotonic() + READY_TIMEOUT
    while b"READY" not in output:
        if not select.select([process.stdout], [], [],
                             max(0, end - time.monotonic()))[0]:
            raise Failure(f"not READY after {READY_TIMEOUT} s: {output!r}")
        data = os.read(process.stdout.fileno(), 4096)
        if not data:
            raise Failure(f"QEMU ended with {process.wait()}: {output!r}")
        output += data
    return output.split(b"READY")[0].decode(errors="replace").strip()


def screendump(monitor_path, path):
    """Has QEMU write its screen to `path`, and ends it."""
    with socket.socket(socket.AF_UNIX) as connection:
        connection.settimeout(READY_TIMEOUT)
        connection.connect(monitor_path)
        stream = connection.makefile("rw")

        def command(name, **arguments):
            json.dump({"execute": name, "arguments": arguments}, stream)
            stream.write("\n")
            stream.flush()
            while True:
                answer = json.loads(stream.readline())
                if "error" in answer:
                    raise Failure(f"{name}: {answer['error']['desc']}")
                if "return" in answer:
                    return

        stream.readline()  # QEMU's greeting
        command("qmp_capabilities")
        command("screendump", filename=str(path))
        command("quit")


def insert_card(font, folder):
    """QEMU's options for a card that holds a font."""
    card = f"{folder}/card.img"
    shutil.copy(font, card)
    # QEMU wants a power of two.
    size = max(os.path.getsize(card), 1 << 20)
    os.truncate(card, 1 << (size - 1).bit_length())
    return f"-drive if=sd,format=raw,file={card}"


def notices(frame):
    """Lines for the serial line: notices in some scripts."""
    lines = NOTICES.read_text(encoding="utf-8").split("\n\n")
    return [line + "\n" for line in lines[frame].splitlines()]


def send(lines):
    """Sends lines to the firmware, each when it is READY."""
    def wait(process):
        output = wait_until_ready(process)
        for line in lines:
            process.stdin.write(line.encode())
            process.stdin.flush()
            output += wait_until_ready(process)
        return output
    return wait


def shoot(screen, picture, frame, folder):
    """Runs the firmware in QEMU; returns its screen and its console output."""
    program = pathlib.Path(
        screen["build"],
        f"boards/common/demo/{firmware(screen, picture)}.elf")
    flags = screen["flags"]
    if picture in screen["cards"]:
        flags += " " + insert_card(screen["cards"][picture][-1], folder)
    wait = send(notices(frame)) if picture == "notice" else wait_until_ready
    return run_and_shoot([screen["board"], program, f"frame={frame}"], flags,
                         wait, folder)


def run_and_shoot(words, flags, wait, folder):
    """The screen of qemu_run.sh with these words, and what `wait` returns, which
    waits until there is something to see.
    """
    monitor = f"{folder}/monitor"
    flags = f"-qmp unix:{monitor},server=on,wait=off {flags}"
    with subprocess.Popen(
            [RUNNER, *words], env={**os.environ, "INKCELL_QEMU_FLAGS": flags},
            stdin=subprocess.PIPE, stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT) as process:
        try:
            output = wait(process)
            screendump(monitor, f"{folder}/shown.ppm")
            process.stdout.read()
            process.wait(60)
        finally:
            with contextlib.suppress(ProcessLookupError):
                process.kill()
    return Picture(f"{folder}/shown.ppm"), output


def render(screen, picture, frame, folder):
    path = f"{folder}/expected.ppm"
    if picture in screen["motion_hosts"]:
        command = [screen["motion_hosts"][picture], str(frame)]
    elif picture == "notice":
        text = pathlib.Path(folder, "notices.txt")
        text.write_text("".join(notices(frame)), encoding="utf-8")
        command = [screen["notice_host"], text]
    elif picture in screen["cards"]:
        command = [*screen["cards"][picture][:2], str(frame)]
    else:
        frames = [str(frame)] if picture == "scene" else []
        command = [screen["host"], picture, *frames]
    subprocess.run([*command, path], check=True)
    return Picture(path)


def check(screen, picture, frame, save):
    """Compares one picture; returns whether it is right."""
    name = f"{screen['board']}_{screen['format']}_{picture}"
    if picture != "pattern":
        name += f"_{frame}"
    with tempfile.TemporaryDirectory(prefix="inkcell") as folder:
        try:
            shown, output = shoot(screen, picture, frame, folder)
            if save:
                shown.save_png(save / f"{name}.png")
            result = compare(shown, render(screen, picture, frame, folder))
        except (Failure, subprocess.CalledProcessError) as failure:
            print(f"FAILED  {name}: {failure}", flush=True)
            return False
    costs = [line.strip() for line in output.splitlines()
             if "instructions" in line or "bytes" in line]
    print("ok     ", "; ".join([f"{name}: {result}", *costs]), flush=True)
    return True


def pictures(screen):
    """The names of the pictures that a display shows."""
    notice = ["notice"] if screen["notice_host"] else []
    return ["scene", *screen["motion_hosts"], *screen["cards"], *notice,
            "pattern"]


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("list", type=pathlib.Path,
                        help="screens.json in the build folder")
    parser.add_argument("--board", help="only this one")
    parser.add_argument("--format", help="only displays of this format")
    parser.add_argument("--picture",
                        help="scene, pattern, page, unifont, face, notice, or a "
                        "scene that moves")
    parser.add_argument("--frame", type=int, action="append",
                        help="of the scene; may be repeated [0]")
    parser.add_argument("--save", type=pathlib.Path, metavar="DIR",
                        help="keep the screenshots here, as PNG")
    parser.add_argument("--build-only", action="store_true")
    parser.add_argument("--no-build", action="store_true",
                        help="the firmware is up to date")
    options = parser.parse_args()

    screens = [screen for screen in json.loads(options.list.read_text())
               if options.board in (None, screen["board"])
               and options.format in (None, screen["format"])]
    if not screens:
        parser.error("there is no such display")
    wanted = [(screen, picture) for screen in screens
              for picture in pictures(screen)
              if options.picture in (None, picture)]
    if not wanted:
        parser.error(f"--picture {options.picture}: there are " + ", ".join(
            sorted({picture for screen in screens
                    for picture in pictures(screen)})))
    if not options.no_build:
        builds = {}
        for screen, picture in wanted:
            builds.setdefault(screen["build"], (screen, []))[1].append(
                firmware(screen, picture))
        for screen, programs in builds.values():
            build(screen, programs)
    if options.build_only:
        return 0
    if options.save:
        options.save.mkdir(parents=True, exist_ok=True)
    results = [check(screen, picture, frame, options.save)
               for screen, picture in wanted
               for frame in (options.frame or [0] if picture != "pattern"
                             else [0])]
    print(f"{results.count(True)} passed, {results.count(False)} failed")
    return min(results.count(False), 255)


if __name__ == "__main__":
    sys.exit(main())
