"""Ready fonts as a piece of a release."""
import hashlib
import json
import pathlib
import shutil
import subprocess
import sys
import typing

import archives
import fonts

ROOT = pathlib.Path(__file__).resolve().parents[2]
TOOLS = ROOT / "build/demo-host"
READY = ROOT / "build/release-fonts"
TABLE = json.loads((ROOT / "host_tools/release/fonts.json").read_text())


def run(*command):
    subprocess.run([str(word) for word in command], check=True, cwd=ROOT,
                   stdout=sys.stderr)


def ready_fonts():
    """The folder of fonts.py. It is made anew, in many minutes, if the generator, the
    table or a package changed."""
    run("sh", "-c", ". host_tools/setup.sh && inkcell_setup demo && inkcell_setup fonts")
    run("cmake", "--preset", "demo-host")
    run("cmake", "--build", TOOLS, "--target", "inkcell-fontgen", "inkcell-render")
    programs = [TOOLS / name for name in ("fonts_gen/inkcell-fontgen",
                                          "host_tools/inkcell-render")]
    names = [face["package"] for face in TABLE["faces"]
             if not face["package"].startswith(fonts.NPM)]
    key = hashlib.sha256(fonts.call("dpkg-query", "-W", *names).encode())
    for path in (*programs, pathlib.Path(fonts.__file__),
                 ROOT / "host_tools/release/fonts.json"):
        key.update(path.read_bytes())
    made_of = READY / "made_of"
    if not made_of.exists() or made_of.read_text() != key.hexdigest():
        shutil.rmtree(READY, ignore_errors=True)
        run(sys.executable, "-B", fonts.__file__, programs[0], READY / "fonts")
        made_of.write_text(key.hexdigest())
    return READY / "fonts"


class Part(typing.NamedTuple):
    name: str
    version: str
    licence: str


def faces():
    """The faces as parts of a list of SPDX."""
    for face in TABLE["faces"]:
        package = face["package"]
        version = (package.rpartition("@")[2] if package.startswith(fonts.NPM) else
                   fonts.call("dpkg-query", "-W", "-f", "${Version}", package))
        yield Part(face["face"], version, face["licence"])


def make_fonts(release):
    """inkcell-fonts-VERSION.zip: fonts of 24 faces in all forms"""
    work = release.work / "fonts"
    top = work / f"inkcell-fonts-{release.version}"
    shutil.copytree(ready_fonts(), top)
    shutil.copy(ROOT / "LICENSE", top)
    release.add_listing(work, "inkcell-fonts", top / "inkcell.spdx.json", list(faces()))
    archives.write_zip(release.folder / f"inkcell-fonts-{release.version}.zip", work,
                       release.seconds)


PIECES = {"fonts": make_fonts}
