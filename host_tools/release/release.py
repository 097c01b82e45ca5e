"""Makes the files of a release in build/release, the same bytes of the same commit:
all times are SOURCE_DATE_EPOCH, by default that of the commit.

Each piece has LICENSE, a list of what it holds (SPDX 2.3) and a line in SHA256SUMS.
The folder is emptied first. Fonts are kept in build/release-fonts until what makes
them changes, and take many minutes else. So does compiling the generator for each
system, in build/web, the first time; the rest takes a minute.

{pieces}
"""
import argparse
import hashlib
import os
import pathlib
import re
import shutil
import subprocess
import sys
import time

import archives
import documents
import ecosystems
import generator
import spdx

ROOT = pathlib.Path(__file__).resolve().parents[2]


class Release:
    """What pieces are made of, and where they go."""

    def __init__(self, version, seconds):
        self.version = version
        self.seconds = seconds  # since 1970
        self.folder = ROOT / "build/release"
        self.work = ROOT / "build/release-work"
        for folder in (self.folder, self.work):
            shutil.rmtree(folder, ignore_errors=True)
            folder.mkdir(parents=True)

    def add_listing(self, top, name, path, parts=()):
        """Writes the list of a piece, all of whose other files are below `top`, and
        into which `parts` (spdx.listing) are linked."""
        files = [(file, data) for file, _, data in archives.contents(top)]
        path.write_text(spdx.listing(name, self.version, files, self.seconds,
                                     parts))


def make_two_files(release):
    """inkcell-VERSION.zip: the library as two files"""
    name = f"inkcell-{release.version}"
    top = release.work / "two_files"
    folder = top / name
    subprocess.run([sys.executable, "-B", ROOT / "port/two_files/pack.py", folder],
                   check=True, stdout=sys.stderr)
    shutil.copy(ROOT / "LICENSE", folder)
    release.add_listing(top, "inkcell", folder / "inkcell.spdx.json")
    archives.write_zip(release.folder / f"{name}.zip", top, release.seconds)


def make_site(release):
    """inkcell-documents-VERSION.zip: the documents, index.html first"""
    name = f"inkcell-documents-{release.version}"
    top = release.work / "site"
    folder = top / name
    documents.make(folder, release.work / "site-work", release.version,
                   release.seconds)
    shutil.copy(ROOT / "LICENSE", folder)
    release.add_listing(top, "inkcell-documents", folder / "inkcell.spdx.json")
    archives.write_zip(release.folder / f"{name}.zip", top, release.seconds)


# A further piece is a function here.
PIECES = {"two_files": make_two_files, "site": make_site, **generator.PIECES,
          **ecosystems.PIECES}


def output(*command):
    return subprocess.run(command, check=True, stdout=subprocess.PIPE, text=True,
                          cwd=ROOT).stdout.strip()


def read_arguments():
    pieces = "\n".join(f"  {name:11} {make.__doc__}" for name, make in
                       PIECES.items())
    parser = argparse.ArgumentParser(
        prog="release.sh", description=__doc__.format(pieces=pieces),
        formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("version", metavar="VERSION",
                        help="that of CMakeLists.txt")
    parser.add_argument("--draft", action="store_true",
                        help="of a checkout with changes, to try")
    parser.add_argument("--only", nargs="+", choices=PIECES, metavar="NAME",
                        default=list(PIECES), help="these pieces")
    arguments = parser.parse_args()
    version = re.search(r"inkcell VERSION ([\d.]+)",
                        (ROOT / "CMakeLists.txt").read_text()).group(1)
    if arguments.version != version:
        parser.error(f"VERSION is {arguments.version}, and {version} in "
                     "CMakeLists.txt: give that, or change it there first")
    changed = output("git", "status", "--porcelain")
    if changed and not arguments.draft:
        parser.error("the checkout has changes: commit them, or try with --draft\n"
                     f"{changed}")
    return arguments


def main():
    arguments = read_arguments()
    os.umask(0o022)  # cpack writes modes of its own files, too
    release = Release(arguments.version,
                      int(os.environ.get("SOURCE_DATE_EPOCH") or
                          output("git", "log", "-1", "--format=%ct")))
    for name, make in PIECES.items():
        if name in arguments.only:
            begun = time.monotonic()
            make(release)
            print(f"{name}: {time.monotonic() - begun:.0f} s", flush=True)
    made = sorted(release.folder.iterdir())
    (release.folder / "SHA256SUMS").write_text("".join(
        f"{hashlib.sha256(path.read_bytes()).hexdigest()}  {path.name}\n"
        for path in made))
    for path in made:
        print(f"{path.relative_to(ROOT)}: {path.stat().st_size} bytes")


if __name__ == "__main__":
    main()
