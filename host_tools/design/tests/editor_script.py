"""Runs inkcell-editor by scripts, without a display."""
import json
import pathlib
import subprocess
import sys
import tempfile

from problems import finish


class Editor:
    """Runs scripts in a folder, without a display."""

    def __init__(self, program, folder):
        self.program = program
        self.folder = folder

    def run(self, *lines):
        """What the script printed, as a list of reports."""
        result = self.start(*lines)
        if result.returncode != 0:
            sys.exit(f"{lines}: {result.stderr.strip()}")
        return [json.loads(line) for line in result.stdout.splitlines()]

    def start(self, *lines):
        script = self.folder / "script.txt"
        script.write_text("\n".join(lines) + "\n")
        return subprocess.run([self.program, "--script", script], text=True,
                              cwd=self.folder, capture_output=True,
                              check=False)


def points_of(report):
    return [point for contour in report["contours"] for point in contour]


def run_checks(*checks):
    """Calls each with one editor, the first argument. Ends the program."""
    with tempfile.TemporaryDirectory() as name:
        editor = Editor(str(pathlib.Path(sys.argv[1]).resolve()),
                        pathlib.Path(name))
        for check in checks:
            check(editor)
    finish()
