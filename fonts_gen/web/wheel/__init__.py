"""inkcell-fontgen, the generator of fonts for Inkcell, as a package of Python."""
import os
import pathlib
import subprocess
import sys

PROGRAM = pathlib.Path(__file__).with_name(
    "inkcell-fontgen.exe" if os.name == "nt" else "inkcell-fontgen")


def main():
    """Runs the program with the arguments of this one."""
    command = [str(PROGRAM), *sys.argv[1:]]
    if os.name == "nt":
        sys.exit(subprocess.call(command))
    os.execv(PROGRAM, command)
