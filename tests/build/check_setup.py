"""Checks how host_tools/setup.sh installs packages, with stand-ins for the programs
that it calls: as root, through sudo, and where neither is allowed.

Usage: check_setup.py <work folder>
"""
import os

from toolchains import ROOT, arguments, finish, run

PROGRAMS = {
    # Only git is installed.
    "dpkg-query": 'case "$*" in *" git") echo installed ;; *) exit 1 ;; esac',
    "id": 'echo "$WHO"',
    # As sudo does by default, without the environment; never with a password.
    "sudo": '[ "$MAY" = yes ] || exit 1; [ "$1" != -n ] || shift; '
            'exec env -i PATH="$PATH" LOG="$LOG" SUDO=yes "$@"',
    "apt-get": 'echo "${SUDO-}" "${DEBIAN_FRONTEND-}" "$@" >>"$LOG"',
}
WANTED = "debootstrap debian-archive-keyring"


def set_up(work, who, may):
    """How inkcell_setup ended, and what apt-get was told."""
    log = work / "log"
    log.write_text("")
    done = run(["/bin/sh", "-euc", '. "$1"; inkcell_setup bare; echo continued',
                "sh", ROOT / "host_tools/setup.sh"],
               env={"PATH": f"{work}:/usr/bin:/bin", "WHO": who, "MAY": may,
                    "LOG": str(log)})
    return done, log.read_text().split("\n")[:-1]


def main():
    work, = arguments()
    for name, text in PROGRAMS.items():
        (work / name).write_text(f"#!/bin/sh\n{text}\n")
        os.chmod(work / name, 0o755)
    problems = []
    for who, may, by in (("0", "no", ""), ("1000", "yes", "yes")):
        done, told = set_up(work, who, may)
        expected = [f"{by}  -qq update",
                    f"{by} noninteractive -qq install -y "
                    f"--no-install-recommends {WANTED}"]
        if (done.returncode != 0 or "continued" not in done.stdout or
                told != expected):
            problems.append(f"user {who}: {told}, not {expected}\n{done.stdout}")
    done, told = set_up(work, "1000", "no")
    if (done.returncode != 1 or told or "continued" in done.stdout or
            "  apt-get update\n  apt-get install --no-install-recommends "
            f"{WANTED}\n" not in done.stdout):
        problems.append(f"without rights: {done.returncode}, {told}\n"
                        f"{done.stdout}")
    finish(3 - len(problems), problems)


if __name__ == "__main__":
    main()
