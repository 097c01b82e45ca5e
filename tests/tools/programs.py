"""Runs programs under test by their names."""
import subprocess

PROGRAMS = {}  # their paths; a test fills it from its arguments


def run(program, *arguments, code=0):
    """Runs a program; returns what it printed, its errors last."""
    done = subprocess.run(
        [PROGRAMS[program], *map(str, arguments)], stdout=subprocess.PIPE,
        stderr=subprocess.PIPE, text=True, check=False)
    if done.returncode != code:
        raise AssertionError(f"{program} {arguments}: {done.returncode}, not "
                             f"{code}\n{done.stdout}{done.stderr}")
    return done.stdout + done.stderr
