"""Programs as check_commands.py has them called. What takes minutes, installs, opens
a window, or needs a board or a network is checked as far as it can be.

Usage: stand_in.py PROGRAM ARGUMENT...
"""
import os
import pathlib
import re
import subprocess
import sys

# The one program that documents build and run.
BUILT = "build/app"
# The next in PATH, which begins with the stand-ins.
ELSEWHERE = {**os.environ, "PATH": os.environ["PATH"].partition(":")[2]}


def stop(problem):
    sys.exit(f"{' '.join(sys.argv[1:])}: {problem}")


def call(*words):
    result = subprocess.run(words, env=ELSEWHERE, text=True, stdout=subprocess.PIPE,
                            stderr=subprocess.STDOUT)
    if result.returncode != 0:
        stop(f"{' '.join(words)}:\n{result.stdout}")
    return result.stdout


def become(name, *words):
    os.execvpe(name, [name, *words], ELSEWHERE)


def check_words(words, known):
    """Options and their values are words of a script or of a help."""
    for word in words:
        for part in re.split("[,=]", word):
            if part and not part[0].isupper() and not re.search(
                    rf"(?<![\w-]){re.escape(part)}(?![\w-])", known):
                stop(f"it has no '{part}'")


def check_files(*words):
    """What looks like a path is there."""
    for word in words:
        path = word.rpartition("=")[2]
        if re.search(r"\w/\w|\w\.bin$", path) and not os.path.exists(path):
            stop(f"{path}: no such file")


def script(name, *words):
    """Takes minutes: a step of tests/run.sh or tests/night.sh."""
    if name == "-c":
        become("sh", name, *words)
    call("sh", "-n", name)
    path = pathlib.Path(name)
    text = path.read_text()
    for other in re.findall(r"[\w./-]+\.py\b", text):
        for place in (path.parent / other.lstrip("/"), pathlib.Path(other)):
            if place.is_file():
                text += place.read_text()
    check_words(words, text)


def python(*words):
    """Takes minutes, or needs firmware of boards: screens.*, design.figures, and
    release of the night."""
    long = ("host_tools/screens/screens.py", "host_tools/release/fonts.py",
            "host_tools/design/tests/figures.py")
    if words[0] not in long:
        become(sys.executable, *words)
    said = call(sys.executable, "-B", words[0], "--help")
    check_words([word for word in words[1:] if word.startswith("-")], said)


def cmake(*words):
    """Takes minutes, but for one program: projects are configured, in folders of
    their own, and of builds the targets are looked up."""
    words = list(words)
    if words[0] == "--preset":
        words += ["-B", f"build/{words[1]}"]
    for i, word in enumerate(words):
        if word in ("--build", "-B", "--install") and words[i + 1] != BUILT:
            words[i + 1] += "-checked"
    if words[0] == "--install":
        check_files(f"{words[1]}/CMakeCache.txt")
    elif words[0] == "--build" and words[1] != BUILT:
        targets = call("cmake", "--build", words[1], "--target", "help")
        check_words(words[3:] if "--target" in words else [], targets)
    else:
        become("cmake", *words)


def ctest(*words):
    """Takes minutes: the tests that a line names are counted."""
    folder = words[1] if os.path.exists(words[1]) else words[1] + "-checked"
    if "Total Tests: 0" in call("ctest", "-N", "--test-dir", folder, *words[2:]):
        stop("no such test")


def fontgen(*words):
    """All hanzi take minutes: a few."""
    become("inkcell-fontgen",
           *(word.replace("0x4E00-0x9FFF", "0x4E00-0x4E1F") for word in words))


def simulator(*words):
    """Opens a window: a picture instead."""
    shown = {"--save", "--screenshot", "--script"} & set(words)
    become("inkcell-simulator", *words, *([] if shown else ["--save", "shown.png"]))


def qemu(*words):
    """Opens a window: the firmware is one of the board."""
    if "gtk" not in words:
        become("qemu-system-arm", *words)
    firmware = pathlib.Path(words[words.index("-kernel") + 1])
    board = words[words.index("-M") + 1]
    made = pathlib.Path(f"boards/{board}/board.cmake").read_text()
    if not firmware.exists() and (firmware.parts[1] != board or
                                  firmware.stem.partition("_")[2] not in made):
        stop(f"{firmware}: no firmware of {board}")


def nothing(*_):
    """Has no file of the project."""


# Each: what it does instead of what a reader would get.
STAND_INS = {
    "sh": script, "python3": python, "cmake": cmake, "ctest": ctest,
    "inkcell-fontgen": fontgen, "inkcell-simulator": simulator,
    "qemu-system-arm": qemu,
    # All packages are installed.
    "dpkg-query": lambda *_: print("installed"),
    # Not of Debian, or for a board or another system.
    "idf.py": check_files, "west": check_files, "mpremote": check_files,
    "openocd": nothing, "brew": nothing, "pacman": nothing,
    # tests/web.sh installs the package and runs it.
    "npm": nothing,
    "npx": lambda _, *words: fontgen(*words),
}

if __name__ == "__main__":
    STAND_INS[sys.argv[1]](*sys.argv[2:])
