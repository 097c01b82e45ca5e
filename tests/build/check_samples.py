"""Runs the examples of ESP-IDF and Zephyr on the host, with headers that are
played: the panel must show the picture of the whole screen. So must boards/example
and the complete file of docs/ANIMATING.md.

Where INKCELL_IDF_DIR names ESP-IDF's sources, its example is compiled with their
headers for ESP32-S3, too; FreeRTOS stays played.

Usage: check_samples.py WORK_FOLDER BUILD_FOLDER FONTGEN
"""
import os
import pathlib
import re

from toolchains import (INCLUDES, ROOT, archives, arguments, finish, make_font,
                        run)

HERE = ROOT / "tests/build"
SAMPLES = {"esp_idf": ROOT / "port/esp_idf/example/main",
           "zephyr": ROOT / "port/zephyr/sample/src",
           "board": ROOT / "boards/example",
           "animating": HERE / "animating"}


def check_sample(name, work, build):
    folder = SAMPLES[name]
    program = work / name
    result = run(["g++", "-std=gnu++17", "-Wall", "-Wextra", "-Werror",
                  f"-I{work}", f"-I{folder}", f"-I{HERE}",
                  f"-I{HERE / name / 'played'}",
                  *INCLUDES, f"-I{ROOT / 'boards/common'}", HERE / name / "run.cpp",
                  *archives(build), "-o", program])
    if result.returncode == 0:
        result = run([program])
        print(f"{name}:\n{result.stdout}", end="")
    return [f"{name}: {result.stdout}"] if result.returncode != 0 else []


def check_idf(idf, work):
    """Problems of ESP-IDF's example with its headers."""
    (work / "sdkconfig.h").write_text("#define CONFIG_IDF_TARGET_ESP32S3 1\n")
    folders = [path for part in sorted((idf / "components").iterdir())
               for path in (part / "include", part / "esp32s3/include")
               if path.is_dir() and part.name not in ("freertos", "linux")]
    result = run(["g++", "-std=gnu++17", "-w", "-fsyntax-only", "-DESP_PLATFORM",
                  "-include", work / "sdkconfig.h", f"-I{work}", *INCLUDES,
                  *(f"-I{path}" for path in folders),
                  f"-I{idf / 'components/soc/esp32s3/register'}",
                  f"-I{HERE / 'esp_idf/played'}",
                  SAMPLES["esp_idf"] / "main.cpp"])
    return [result.stdout[:3000]] if result.returncode != 0 else []


def check_zephyr():
    """Problems of what the sample's configuration names: its options are those of
    the module's Kconfig and of Zephyr's README line, and the overlay chooses the
    display that it describes."""
    folder = SAMPLES["zephyr"].parent
    options = set(re.findall(r"^(CONFIG_\w+)=y$",
                             (folder / "prj.conf").read_text(), re.M))
    problems = [f"prj.conf lacks {option}=y" for option in
                ("CONFIG_INKCELL", "CONFIG_CPP", "CONFIG_STD_CPP17",
                 "CONFIG_DISPLAY") if option not in options]
    for overlay in (folder / "boards").iterdir():
        text = overlay.read_text()
        chosen = re.search(r"zephyr,display = &(\w+);", text)
        if chosen is None or f"{chosen.group(1)}: " not in text:
            problems.append(f"{overlay} chooses no display of its own")
        if text.count("{") != text.count("}"):
            problems.append(f"{overlay}: braces do not match")
    return problems


def main():
    work, build, fontgen = arguments()
    for name in ("dejavu_sans_latin1", "sans"):
        make_font(fontgen, work / f"fonts/{name}.hpp")
    problems = check_zephyr()
    for name in SAMPLES:
        problems += check_sample(name, work, build)
    given = os.environ.get("INKCELL_IDF_DIR")
    if given is None:
        print("headers of ESP-IDF: played (INKCELL_IDF_DIR names its sources)")
    else:
        print(f"headers of ESP-IDF: played, and {given}")
        problems += check_idf(pathlib.Path(given), work)
    finish(len(SAMPLES) + 1 + (given is not None), problems)


main()
