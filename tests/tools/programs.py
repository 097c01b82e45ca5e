"""Runs programs under test by their names, for tests in a folder of their own."""
import argparse
import pathlib
import subprocess
import sys
import tempfile
import unittest

SANS = "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf"
SERIF = "/usr/share/fonts/truetype/liberation/LiberationSerif-Regular.ttf"
INTER = "/usr/share/fonts/truetype/inter-vf/Inter.var.ttf"  # wght 100..900
PROGRAMS = {}  # their paths; main() fills it from the arguments


def finished(program, *arguments, code=0):
    """A program, or a path, that ended with `code`, and its outputs."""
    done = subprocess.run(
        [PROGRAMS.get(program, program), *map(str, arguments)],
        stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, check=False)
    if done.returncode != code:
        raise AssertionError(f"{program} {arguments}: {done.returncode}, not "
                             f"{code}\n{done.stdout}{done.stderr}")
    return done


def run(program, *arguments, code=0):
    """Runs a program; returns what it printed, its errors last."""
    done = finished(program, *arguments, code=code)
    return done.stdout + done.stderr


class FolderCase(unittest.TestCase):
    """Tests that share a folder, `path`."""

    @classmethod
    def setUpClass(cls):
        # pylint: disable-next=consider-using-with
        cls.folder = tempfile.TemporaryDirectory(prefix="inkcell")
        cls.addClassCleanup(cls.folder.cleanup)
        cls.path = pathlib.Path(cls.folder.name)

    def refused(self, said, program, *arguments):
        """Runs a program that must fail, and say this."""
        self.assertIn(said, run(program, *arguments, code=1))


def main(*programs):
    """Runs the tests of the script, whose options are paths of programs."""
    parser = argparse.ArgumentParser()
    for name in programs:
        parser.add_argument("--" + name, required=True)
    paths, rest = parser.parse_known_args()
    for name, path in vars(paths).items():
        PROGRAMS[name.replace("_", "-")] = path
    unittest.main(argv=[sys.argv[0], *rest], verbosity=1)
