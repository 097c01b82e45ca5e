"""Runs inkcell-editor by scripts, without a display."""
import json
import subprocess
import sys

PROBLEMS = []


def expect(condition, what):
    if not condition:
        PROBLEMS.append(what)


def finish():
    """Ends the program."""
    for problem in PROBLEMS:
        print(problem)
    sys.exit(1 if PROBLEMS else 0)


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
