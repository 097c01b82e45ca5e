"""The generator for each desk: programs that need nothing else, packages of them for
npm and pip, the page; and Debian's packages of the tools and the library."""
import base64
import functools
import hashlib
import os
import pathlib
import platform
import shutil

import archives
import ecosystems
import fonts
import spdx

ROOT = pathlib.Path(__file__).resolve().parents[2]
WEB = ROOT / "build/web"
NAME = "inkcell-fontgen"
# Of inkcell-tools.
PROGRAMS = (NAME, "inkcell-render", "inkcell-inspect", "inkcell-accuracy",
            "inkcell-specimen")
FACE = "fonts-dejavu-core"  # in the page
# Licences of what fonts_gen/web compiles; of Debian's headers; of what compilers add.
SOURCES = {"brotli": "MIT", "freetype": "FTL", "harfbuzz": "MIT-Modern-Variant",
           "fribidi": "LGPL-2.1-or-later", "libpolyclipping": "BSL-1.0",
           "pugixml": "MIT"}
HEADERS = {"libcli11-dev": "BSD-3-Clause", "nlohmann-json3-dev": "MIT"}
GCC = "GPL-3.0-or-later WITH GCC-exception-3.1"
RUNTIMES = {
    "linux": {"libc6-dev": "LGPL-2.1-or-later", "libstdc++-12-dev": GCC},
    "windows": {"mingw-w64-common": "ZPL-2.1",
                "gcc-mingw-w64-x86-64-posix-runtime": GCC},
    "generator": {"emscripten": "MIT OR NCSA"},
}
# Processors, and where a wheel runs: a static program on each distribution.
MACHINES = {"linux": platform.machine(), "windows": "x86_64"}
TAGS = {"linux": "py3-none-manylinux2014_{0}.musllinux_1_1_{0}".format(
            MACHINES["linux"]),
        "windows": "py3-none-win_amd64"}


@functools.cache
def built(kind):
    """The folder of what build.sh makes: linux, windows, or generator for the web."""
    option = {"generator": ()}.get(kind, (f"--{kind}",))
    ecosystems.run("sh", "fonts_gen/web/build.sh", *option)
    return WEB / kind


def parts(kind):
    """What is linked into a program."""
    versions = dict(line.split() for line in
                    (WEB / "sources/versions.txt").read_text().splitlines())
    for name, licence in SOURCES.items():
        yield spdx.Part(name, versions[name], licence)
    for name, licence in {**HEADERS, **RUNTIMES[kind]}.items():
        yield spdx.Part(name, fonts.call("dpkg-query", "-W", "-f", "${Version}", name),
                        licence)


def add_texts(kind, release, folder):
    """The licences of a program, and of what is in it."""
    (folder / "licences").mkdir(parents=True)
    for part in parts(kind):
        own = WEB / "sources" / part.name / "debian/copyright"
        shutil.copy(own if own.exists() else f"/usr/share/doc/{part.name}/copyright",
                    folder / f"licences/{part.name}.txt")
    shutil.copy(ROOT / "LICENSE", folder)


def readme(kind, release):
    text = (ROOT / "fonts_gen/web/wheel/README.md").read_text()
    return text.replace("{VERSION}", release.version).replace(
        "{LIBRARIES}", ", ".join(f"{part.name} {part.version}" for part in parts(kind)))


def program_of(kind):
    return built(kind) / (NAME + (".exe" if kind == "windows" else ""))


def make_program(release, kind):
    name = f"{NAME}-{release.version}-{kind}-{MACHINES[kind]}"
    work = release.work / name
    top = work / name
    program = program_of(kind)
    add_texts(kind, release, top)
    shutil.copy(program, top)
    (top / "README.md").write_text(readme(kind, release))
    release.add_listing(work, NAME, top / "inkcell.spdx.json", list(parts(kind)))
    archives.write_zip(release.folder / f"{name}.zip", work, release.seconds)


def make_wheel(release, kind):
    """As PEP 427 and 491 have it: files, and a RECORD of their sums."""
    package = f"inkcell_fontgen-{release.version}"
    top = release.work / f"wheel-{kind}"
    folder = top / "inkcell_fontgen"
    info = top / f"{package}.dist-info"
    folder.mkdir(parents=True)
    program = program_of(kind)
    for path in (program, *(ROOT / "fonts_gen/web/wheel").glob("*.py")):
        shutil.copy(path, folder)
    add_texts(kind, release, info)
    (info / "METADATA").write_text(
        f"Metadata-Version: 2.1\nName: {NAME}\nVersion: {release.version}\n"
        "Summary: Fonts for microcontrollers, of any size\nLicense: MIT\n"
        "Requires-Python: >=3.7\nDescription-Content-Type: text/markdown\n\n"
        f"{readme(kind, release)}")
    (info / "WHEEL").write_text(
        "Wheel-Version: 1.0\nGenerator: inkcell-release\nRoot-Is-Purelib: false\n" +
        "".join(f"Tag: py3-none-{system}\n"
                for system in TAGS[kind].removeprefix("py3-none-").split(".")))
    (info / "entry_points.txt").write_text(
        f"[console_scripts]\n{NAME} = inkcell_fontgen:main\n")
    release.add_listing(top, NAME, info / "inkcell.spdx.json", list(parts(kind)))
    record = "".join(
        f"{name},sha256={base64.urlsafe_b64encode(digest).decode().rstrip('=')},"
        f"{len(data)}\n" for name, _, data in archives.contents(top)
        for digest in [hashlib.sha256(data).digest()])
    (info / "RECORD").write_text(f"{record}{info.name}/RECORD,,\n")
    archives.write_zip(release.folder / f"{package}-{TAGS[kind]}.whl", top,
                       release.seconds)


def make_linux(release):
    """inkcell-fontgen-VERSION-linux-x86_64.zip, and a wheel for pip of the same"""
    make_program(release, "linux")
    make_wheel(release, "linux")


def make_windows(release):
    """inkcell-fontgen-VERSION-windows-x86_64.zip, and a wheel for pip of the same"""
    make_program(release, "windows")
    make_wheel(release, "windows")


def make_npm(release):
    """inkcell-fontgen-VERSION.tgz: the same as WebAssembly, for npm on any system"""
    built("generator")
    ecosystems.run("sh", "fonts_gen/web/pack.sh")
    work = release.work / "npm"
    shutil.copytree(WEB / NAME, work / "package")
    add_texts("generator", release, work / "package")
    release.add_listing(work, NAME, work / "package/inkcell.spdx.json",
                        list(parts("generator")))
    archives.write_tgz(release.folder / f"{NAME}-{release.version}.tgz", work,
                       release.seconds)


def make_page(release):
    """inkcell-page-VERSION.zip: inkcell.html, and the same for a web server"""
    os.environ["SOURCE_DATE_EPOCH"] = str(release.seconds)
    ecosystems.run("sh", "host_tools/playground/build.sh")
    name = f"inkcell-page-{release.version}"
    work = release.work / "page"
    top = work / name
    face = spdx.Part(FACE, fonts.call("dpkg-query", "-W", "-f", "${Version}", FACE),
                     "Bitstream-Vera")
    shutil.copytree(WEB / "site", top / "site")
    for file in ("inkcell.html", f"inkcell-{release.version}.tar.gz"):  # it links this
        shutil.copy(WEB / file, top)
    add_texts("generator", release, top)
    shutil.copy(f"/usr/share/doc/{FACE}/copyright",
                top / f"licences/{FACE}.txt")
    release.add_listing(work, "inkcell-page", top / "inkcell.spdx.json",
                        [*parts("generator"), face])
    archives.write_zip(release.folder / f"{name}.zip", work, release.seconds)


def make_deb(release):
    """inkcell-tools and libinkcell-dev, packages of Debian"""
    work = release.work / "deb"
    work.mkdir()
    ecosystems.run("sh", "-c", ". host_tools/setup.sh && inkcell_setup deb")
    ecosystems.run("cmake", "--preset", "demo-host")
    ecosystems.run("cmake", "--build", ecosystems.TOOLS, "--target", "inkcell_port_c",
                   *PROGRAMS)
    ecosystems.run("env", f"SOURCE_DATE_EPOCH={release.seconds}", "cpack", "-G", "DEB",
                   "--config", ecosystems.TOOLS / "CPackConfig.cmake", "-B", work)
    shutil.rmtree(work / "_CPack_Packages")
    release.add_listing(work, "inkcell-deb", release.folder /
                        f"inkcell-deb-{release.version}.spdx.json")
    shutil.copytree(work, release.folder, dirs_exist_ok=True)


PIECES = {"linux": make_linux, "windows": make_windows, "npm": make_npm,
          "page": make_page, "deb": make_deb}
