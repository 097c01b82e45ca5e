"""What identifies the core that docs/BENCHMARKS.md describes.

The objects of the library as the bench draws with it, for Cortex-M0 and
Cortex-M3 at -O2, and of the smallest builds for Cortex-M0: comments and names
do not change them. The room that lays out boxes of text is left out: no figure
of the document has it. Another compiler makes other objects; where there is one,
sources are compared, without comments and white space.
"""
import hashlib
import pathlib
import re
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent / "build"))
from toolchains import (COMPILERS, ROOT,  # noqa: E402
                        compile_object, in_parallel, run)

DOCUMENT = ROOT / "docs/BENCHMARKS.md"
COMMAND = "sh tests/bench/run.sh --write-docs"
BUILDS = {
    "m0": ("Cortex-M0", ["-O2"]),
    "m3": ("Cortex-M3", ["-O2"]),
    "outlines": ("Cortex-M0", ["-Os"]),
}
SINKS = ["a8", "rgb565", "canvas"]


def measured_sources():
    core = [*ROOT.glob("core/src/**/*.cpp"), *ROOT.glob("core/cache/src/*.cpp")]
    return sorted(core) + [ROOT / f"port/pixel/src/{name}.cpp" for name in SINKS]


def compiler():
    """Name and version of the compiler for Arm."""
    version = run([COMPILERS["Cortex-M0"][0][0], "--version"]).stdout
    return version.splitlines()[0]


def objects_hash():
    """SHA-256 over all objects."""
    def compile_source(build, source, target):
        machine, flags = BUILDS[build]
        done = compile_object(machine, [*flags, "-DNDEBUG"],
                              source.relative_to(ROOT), target, cwd=ROOT)
        if done.returncode != 0:
            sys.exit(done.stdout)
        return target.read_bytes()

    with tempfile.TemporaryDirectory() as folder:
        jobs = [(build, source,
                 pathlib.Path(folder) / f"{build}-{source.stem}.o")
                for build in BUILDS for source in measured_sources()]
        result = hashlib.sha256()
        for content in in_parallel(compile_source, jobs):
            result.update(content)
    return result.hexdigest()


def sources_hash():
    """SHA-256 over sources and headers without comments and white space."""
    headers = sorted([*ROOT.glob("core/include/**/*.hpp"),
                      *ROOT.glob("core/src/**/*.hpp"),
                      *ROOT.glob("core/cache/**/*.hpp"),
                      *ROOT.glob("port/pixel/**/*.hpp")])
    result = hashlib.sha256()
    for path in measured_sources() + headers:
        text = re.sub(r"//.*|/\*.*?\*/", "", path.read_text(encoding="utf-8"))
        result.update("".join(text.split()).encode())
    return result.hexdigest()


def lines():
    """What the document says of the core that it describes."""
    return [f"- compiler: {compiler()}",
            f"- objects: SHA-256 {objects_hash()}",
            f"- sources: SHA-256 {sources_hash()}"]


def problem():
    """What is wrong with the document, or None."""
    if not DOCUMENT.exists():
        return f"there is no docs/BENCHMARKS.md; run {COMMAND}"
    said = dict(re.findall(r"^- (compiler|objects|sources): (.+)$",
                           DOCUMENT.read_text(encoding="utf-8"), re.M))
    if len(said) != 3:
        return f"docs/BENCHMARKS.md does not say what it describes: {said}"
    by_objects = said["compiler"] == compiler()
    now = objects_hash() if by_objects else sources_hash()
    if said["objects" if by_objects else "sources"] != "SHA-256 " + now:
        return ("docs/BENCHMARKS.md describes another core than this one; "
                f"measure again: {COMMAND}")
    return None
