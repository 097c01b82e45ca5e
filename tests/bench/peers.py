"""Where the other engines come from: Debian's packages, unpacked into the build
folder without touching the system's own lists.
"""
import functools
import os
import re
import shutil
import subprocess
import sys
import tarfile
from pathlib import Path

KEYRING = Path("/usr/share/keyrings/debian-archive-keyring.gpg")


def say(text):
    print(text, file=sys.stderr, flush=True)


def run(*command, **options):
    """Runs a command quietly; its output is shown if it fails."""
    done = subprocess.run([str(part) for part in command], text=True,
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                          check=False, **options)
    if done.returncode != 0:
        sys.exit(f"{done.stdout[-4000:]}\nbench: failed: "
                 f"{' '.join(str(part) for part in command)}")
    return done.stdout


def source_lists():
    """Where the system gets Debian's packages from: (address, suite)."""
    listing = run("apt-get", "indextargets", "Created-By: Packages",
                  "Origin: Debian", "--format", "$(REPO_URI) $(RELEASE)")
    places = sorted({tuple(line.split()) for line in listing.splitlines()
                     if len(line.split()) == 2})
    if places:
        return places
    release = dict(line.split("=", 1) for line in
                   Path("/etc/os-release").read_text().splitlines()
                   if "=" in line)
    if release.get("ID") != "debian":
        sys.exit("bench: FreeType and stb_truetype are downloaded from Debian; "
                 "elsewhere use --freetype and --stb, or --engines inkcell")
    return [("http://deb.debian.org/debian", release["VERSION_CODENAME"])]


@functools.lru_cache(maxsize=None)
def apt(folder):
    """The options that make apt-get work in a folder of its own."""
    if shutil.which("apt-get") is None:
        sys.exit("bench: there is no apt-get to download FreeType and "
                 "stb_truetype with: use --freetype and --stb, or --engines "
                 "inkcell")
    (folder / "lists/partial").mkdir(parents=True, exist_ok=True)
    (folder / "cache/archives/partial").mkdir(parents=True, exist_ok=True)
    signed = f" [signed-by={KEYRING}]" if KEYRING.exists() else ""
    (folder / "sources.list").write_text("".join(
        f"{kind}{signed} {address} {suite} main\n"
        for address, suite in source_lists() for kind in ("deb", "deb-src")))
    options = []
    for name, value in {
            "Dir::Etc::SourceList": folder / "sources.list",
            "Dir::Etc::SourceParts": "/dev/null",
            "Dir::State::Lists": folder / "lists",
            "Dir::Cache": folder / "cache",
            "APT::Sandbox::User": ""}.items():
        options += ["-o", f"{name}={value}"]
    say("updating apt's lists for the other engines")
    run("apt-get", *options, "-qq", "update")
    return options


def unpacked_package(name, build):
    """The content of a binary package."""
    folder = build / "peers"
    content = folder / name
    if not content.exists():
        options = apt(folder)
        say(f"downloading {name}")
        for old in folder.glob(name + "_*.deb"):
            old.unlink()
        run("apt-get", *options, "-qq", "download", name, cwd=folder)
        package, = folder.glob(name + "_*.deb")
        run("dpkg-deb", "-x", package, content.with_suffix(".new"))
        content.with_suffix(".new").rename(content)
    return content


def freetype_sources(build):
    """FreeType as released, without Debian's changes to it."""
    folder = build / "peers"
    content = folder / "freetype"
    if not content.exists():
        options = apt(folder)
        say("downloading the sources of freetype")
        run("apt-get", *options, "-qq", "source", "--download-only",
            "freetype", cwd=folder)
        archive, = folder.glob("freetype_*.orig.tar.*z")
        with tarfile.open(archive) as tar:
            top = tar.getnames()[0].split("/")[0]
            tar.extractall(folder)
        (folder / top).rename(content)
    return content


def find_sources(arguments, build):
    """Folders of the other engines that are asked for."""
    sources = {}
    if "freetype" in arguments.engines:
        sources["freetype"] = (Path(arguments.freetype).resolve()
                               if arguments.freetype
                               else freetype_sources(build))
    if "stb" in arguments.engines:
        installed = Path("/usr/include/stb")
        if arguments.stb:
            installed = Path(arguments.stb).resolve()
        elif not installed.exists():
            installed = (unpacked_package("libstb-dev", build) /
                         "usr/include/stb")
        sources["stb"] = installed
    for name, file in (("freetype", "include/ft2build.h"),
                       ("stb", "stb_truetype.h")):
        if name in sources and not (sources[name] / file).exists():
            sys.exit(f"bench: there is no {file} in {sources[name]}")
    return sources


def freetype_version(folder):
    text = (folder / "include/freetype/freetype.h").read_text()
    return ".".join(
        next(line.split()[2] for line in text.splitlines()
             if line.startswith(f"#define FREETYPE_{part} "))
        for part in ("MAJOR", "MINOR", "PATCH"))


def stb_version(folder):
    first = (folder / "stb_truetype.h").read_text().splitlines()[0]
    return re.search(r"v([\d.]+)", first).group(1)


def fonttools(build):
    """A Python that has fontTools, and its environment."""
    for python in (sys.executable, "/usr/bin/python3"):
        if subprocess.run([python, "-c", "import fontTools"], check=False,
                          stderr=subprocess.DEVNULL).returncode == 0:
            return python, None
    library = (unpacked_package("python3-fonttools", build) /
               "usr/lib/python3/dist-packages")
    return sys.executable, {**os.environ, "PYTHONPATH": str(library)}


def make_subset(font, target, build):
    """A TTF of the 95 glyphs of ASCII, without hinting and kerning."""
    if target.exists() and target.stat().st_mtime > font.stat().st_mtime:
        return
    python, environment = fonttools(build)
    run(python, "-m", "fontTools.subset", font, "--unicodes=U+0020-007E",
        "--no-hinting", "--layout-features=", "--name-IDs=",
        "--no-glyph-names", "--notdef-outline",
        "--drop-tables+=FFTM,GDEF,GPOS,GSUB,kern,MATH,gasp,DSIG",
        f"--output-file={target}", env=environment)
