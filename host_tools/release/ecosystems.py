"""Ready fonts, and archives of the library for ecosystems, which hold them.

An archive is files of the checkout and the fonts in the form that its users include.
Its README is that of port/NAME: <!-- cpp: FILE --> stands for a file of the archive.
"""
import functools
import hashlib
import json
import pathlib
import re
import shutil
import subprocess
import sys
import typing

import archives
import fonts
import spdx

ROOT = pathlib.Path(__file__).resolve().parents[2]
TOOLS = ROOT / "build/demo-host"
READY = ROOT / "build/release-fonts"
TABLE = json.loads((ROOT / "host_tools/release/fonts.json").read_text())

DEVICE = ("LICENSE", "core", ":(glob)port/c/*.*", "port/display/c_api.txt",
          *(f"port/{part}/{kind}" for part in ("display", "lvgl", "pixel")
            for kind in ("include", "src")))
OF_CMAKE = (*DEVICE, "port/libraries.cmake", "port/libraries.kconfig",
            "fonts_gen/cmake")
OF_PLATFORMIO = (*DEVICE, "library.json", "port/arduino/InkcellPrint.h",
                 "port/platformio")
# What all archives but that of all fonts leave out: the longest sets.
LEFT_OUT = ("european",)
# What a reader of the table wants to know.
SETS = """
`digits` has a space and `{digits}`; `ascii` has U+0020 to U+007E, without the degree sign; `latin1`
has that and U+00A0 to U+00FF, with the degree sign. The euro sign is in none of them, but in the set
`european` of `inkcell-fonts`, a file of the release of its own. Faces of segments lack some signs.

An icon is a character: `"\\uE2BD"` is the cloud of `material_icons_weather`, `"\\U0001F525"` a fire
in `noto_emoji_signs`, a font of one colour. [FONTS.md](FONTS.md) has the codes of all.
"""
# What makes the font of an example where none is ready.
MAKING = re.compile(r"\ninkcell_add_font\([^)]*\).*|(?s:\n; inkcell-fontgen is .*)")


class Archive(typing.NamedTuple):
    title: str
    top: str  # the folder in the archive
    files: tuple  # of the checkout; no files: port/arduino/pack.py makes the folder
    form: str  # of fonts
    fonts: str  # their folder
    for_c: bool = False  # with the interface for C as it is made


ARCHIVES = {
    "library": Archive("CMake, Make and Meson", "inkcell", (
        *OF_CMAKE, "CMakeLists.txt", "meson.build", "meson_options.txt", "fonts_gen",
        "port/CMakeLists.txt", "port/pixel", "port/display", "port/c", "port/lvgl",
        "port/make", "port/meson", "port/rust"), "hpp", "core/include/fonts", True),
    "arduino": Archive("Arduino", "Inkcell", (), "hpp", "src/fonts"),
    "platformio": Archive("PlatformIO", "Inkcell", OF_PLATFORMIO, "hpp",
                          "core/include/fonts"),
    "esp_idf": Archive("ESP-IDF", "inkcell", (
        *OF_CMAKE, "CMakeLists.txt", "idf_component.yml", "port/esp_idf"), "hpp",
        "core/include/fonts"),
    "zephyr": Archive("Zephyr", "inkcell", (*OF_CMAKE, "zephyr", "port/zephyr"), "hpp",
                      "core/include/fonts"),
    "esphome": Archive("ESPHome", "inkcell", (*OF_PLATFORMIO, "port/esphome"), "bin",
                       "fonts"),
    "micropython": Archive("MicroPython", "inkcell", (
        *OF_CMAKE, "port/make/inkcell.mk", "port/micropython"), "bin", "fonts"),
}


def run(*command):
    subprocess.run([str(word) for word in command], check=True, cwd=ROOT,
                   stdout=sys.stderr)


@functools.cache
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


def faces():
    """The faces as parts of a list of SPDX."""
    for face in TABLE["faces"]:
        package = face["package"]
        version = (package.rpartition("@")[2] if package.startswith(fonts.NPM) else
                   fonts.call("dpkg-query", "-W", "-f", "${Version}", package))
        yield spdx.Part(face["face"], version, face["licence"])


def add_fonts(form, folder, licences):
    """Copies fonts of one form, with FONTS.md. Lines of a table of them."""
    ready = ready_fonts()
    source = ready / form / ("fonts" if form != "bin" else "")
    folder.mkdir(parents=True, exist_ok=True)
    shutil.copytree(ready / "licences", licences)
    lines = ["| face | kind | sets | licence |", "| --- | --- | --- | --- |"]
    for face in TABLE["faces"]:
        sets = [name for name in TABLE["kinds"][face["kind"]] if name not in LEFT_OUT]
        for name in sets:
            shutil.copy(source / f"{face['face']}_{name}.{form}", folder)
        lines.append(f"| `{face['face']}` | {face['kind']} | "
                     f"{', '.join(f'`{name}`' for name in sets)} | "
                     f"[{face['licence']}](licences/{face['face']}.txt) |")
    digits = TABLE["sets"]["digits"]["options"][0].partition("=")[2]
    lines.append(SETS.format(digits=digits.strip()))
    codes = [line for line in (ready / "FONTS.md").read_text().splitlines()
             if line.startswith("`")]
    (licences.parent / "FONTS.md").write_text(
        "\n\n".join(["# Codes of icons and emoji", *codes, ""]))
    return "\n".join(lines).rstrip()


def add_files(top, patterns):
    """Copies files that git knows. Examples take a font that is ready."""
    for name in fonts.call("git", "ls-files", "--", *patterns,
                           cwd=ROOT).splitlines():
        (top / name).parent.mkdir(parents=True, exist_ok=True)
        shutil.copy(ROOT / name, top / name)
        if name.endswith(("CMakeLists.txt", ".ini")):
            path = top / name
            path.write_text(MAKING.sub("\n", path.read_text()))


def fonts_of_strikes():
    """Characters and names of the fonts that an example of Arduino has made."""
    sketch = ROOT / "port/arduino/examples/Adafruit_SSD1306_Strikes"
    return re.findall(r"--chars (\S+)[^-]*--strike \S+ --strike-only --name (\S+)",
                      (sketch / f"{sketch.name}.ino").read_text())


def make_archive(release, name):
    archive = ARCHIVES[name]
    work = release.work / name
    top = work / archive.top
    if archive.files:
        add_files(top, archive.files)
    else:
        run(sys.executable, "-B", "port/arduino/pack.py", top)
        ready_fonts()  # has the generator built
        for chars, font in fonts_of_strikes():
            run(TOOLS / "fonts_gen/inkcell-fontgen", "--quiet", f"--chars={chars}",
                "--font=/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf",
                "--strike-only", f"--strike={font[-2:]}:1", f"--name={font}",
                "--format=hpp",
                f"--out={top}/examples/Adafruit_SSD1306_Strikes/{font}.h")
    if archive.for_c:
        run(sys.executable, "-B", "port/c/make_api.py", top / "port/c")
    table = add_fonts(archive.form, top / archive.fonts, top / "licences")
    readme = re.sub(r"<!-- (\w+): (\S+) -->", lambda found:
                    f"```{found[1]}\n{(top / found[2]).read_text()}```",
                    (ROOT / f"port/{name}/README.md").read_text())
    (top / "README.md").write_text(readme.replace("<!-- fonts -->", table))
    release.add_listing(work, f"inkcell-{name}", top / "inkcell.spdx.json",
                        list(faces()))
    archives.write_zip(release.folder / f"inkcell-{name}-{release.version}.zip", work,
                       release.seconds)


def make_fonts(release):
    """inkcell-fonts-VERSION.zip: fonts of 24 faces in all forms"""
    work = release.work / "fonts"
    top = work / f"inkcell-fonts-{release.version}"
    shutil.copytree(ready_fonts(), top)
    shutil.copy(ROOT / "LICENSE", top)
    release.add_listing(work, "inkcell-fonts", top / "inkcell.spdx.json", list(faces()))
    archives.write_zip(release.folder / f"inkcell-fonts-{release.version}.zip", work,
                       release.seconds)


def maker_of(name):
    def make(release):
        make_archive(release, name)
    make.__doc__ = (f"inkcell-{name}-VERSION.zip: the library and ready fonts for "
                    f"{ARCHIVES[name].title}")
    return make


PIECES = {"fonts": make_fonts, **{name: maker_of(name) for name in ARCHIVES}}
