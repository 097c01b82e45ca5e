"""The compilers that the build tests try, and what they all are told."""
import concurrent.futures
import os
import pathlib
import shutil
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tests"))  # of limits.py

# The interface for C, where PlatformIO and Meson make it, too.
MADE = ROOT / "build/port/c"
MAKE_API = [sys.executable, "-B", ROOT / "port/c/make_api.py"]
subprocess.run([*MAKE_API, MADE], check=True)

# The folders of core that are libraries of their own, each before those that use it.
LIBRARIES = ("cache", "field", "layout", "motion", "figures", "layers", "shaping",
             "simulation", "stored", "strike", "truetype")

# What most tests make fonts of.
FONTS = pathlib.Path("/usr/share/fonts")
FONT = FONTS / "truetype/dejavu/DejaVuSans.ttf"

# What the device library is compiled with: core/CMakeLists.txt.
DEVICE_FLAGS = [
    "-std=c++17", "-ffreestanding", "-fno-exceptions", "-fno-rtti",
    "-fno-threadsafe-statics", "-ffunction-sections", "-fdata-sections",
]
WARNINGS = [
    "-Wall", "-Wextra", "-Wpedantic", "-Wconversion", "-Wsign-conversion",
    "-Wshadow", "-Wold-style-cast", "-Wundef", "-Werror",
]
C_WARNINGS = [
    "-std=c99", "-pedantic", "-Wall", "-Wextra", "-Wconversion",
    "-Wsign-conversion", "-Wshadow", "-Wundef", "-Wstrict-prototypes", "-Werror",
]
INCLUDES = ["-I" + str(path) for path in
            [ROOT / "core/include", ROOT / "core/src",
             *(ROOT / f"core/{name}/include" for name in LIBRARIES),
             *sorted(ROOT.glob("port/*/include")), MADE / "include"]]

# Name, compiler with its flags, prefix of the binary tools.
ARM = "arm-none-eabi-"
RISCV = "riscv64-unknown-elf-"
COMPILERS = {
    "Cortex-M0": ([ARM + "g++", "-mcpu=cortex-m0", "-mthumb"], ARM),
    "Cortex-M3": ([ARM + "g++", "-mcpu=cortex-m3", "-mthumb"], ARM),
    "RV32": ([RISCV + "g++", "-march=rv32imc", "-mabi=ilp32"], RISCV),
    "host": (["g++", "-fno-pie"], ""),
    "host clang": (["clang++"], ""),
}


# What CMake, too, is told to call compilers by: a cache of objects, or nothing.
LAUNCHER = os.environ.get("CMAKE_CXX_COMPILER_LAUNCHER", "").split()


def c_compiler(machine):
    """The compiler of a machine for C, with its flags."""
    command, _ = COMPILERS[machine]
    return [command[0].replace("clang++", "clang").replace("g++", "gcc"),
            *command[1:]]


def device_sources():
    """Sources of everything that runs on a device: core, its libraries and port,
    but for what needs the headers of LVGL or HarfBuzz."""
    return sorted([*ROOT.glob("core/src/**/*.cpp"),
                   *(path for name in LIBRARIES
                     for path in ROOT.glob(f"core/{name}/src/*.cpp")),
                   *(path for path in ROOT.glob("port/*/src/*.cpp")
                     if path.parts[-3] not in ("harfbuzz", "lvgl")),
                   *MADE.glob("src/*.cpp")])


def device_headers():
    """Public headers, as a program includes them."""
    roots = [ROOT / "core/include",
             *(ROOT / f"core/{name}/include" for name in LIBRARIES),
             *(path for path in sorted(ROOT.glob("port/*/include"))
               if path.parent.name != "harfbuzz")]
    return sorted(str(path.relative_to(root))
                  for root in roots for path in root.glob("**/*.hpp"))


def c_headers():
    """Public headers of the C interface, likewise."""
    root = MADE / "include"
    return sorted(str(path.relative_to(root)) for path in root.glob("**/*.h"))


def archives(build):
    """The libraries of a build for the host, in the order in which they are linked."""
    return [build / f"{folder}/{name}/libinkcell_{prefix}{name}.a"
            for folder, prefix, names in (
                ("port", "port_", ("c", "display", "pixel")),
                ("core", "", reversed(LIBRARIES)))
            for name in names] + [build / "core/libinkcell_core.a"]


def arguments():
    """Arguments of the test as paths. The first is its work folder, now empty."""
    paths = [pathlib.Path(word).resolve() for word in sys.argv[1:]]
    shutil.rmtree(paths[0], ignore_errors=True)
    paths[0].mkdir(parents=True)
    return paths


def require(programs):
    """Ends the test if a program is missing: a skipped check is no check."""
    missing = [name for name in programs if shutil.which(name) is None]
    if missing:
        sys.exit("missing: " + ", ".join(missing) +
                 " (host_tools/setup.sh says how to install them)")


def run(command, **options):
    """Runs a command and returns it finished, its output as text."""
    return subprocess.run([str(word) for word in command], text=True,
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                          **options)


def call(*command, **options):
    """Output of a command, which must work or ends the test."""
    result = run(command, **options)
    if result.returncode != 0:
        finish(0, [" ".join(map(str, command)) + "\n" + result.stdout])
    return result.stdout


def make_font(fontgen, header, chars="0x20-0x7E", *options):
    """Makes a header of C++; its array has the header's name."""
    header.parent.mkdir(parents=True, exist_ok=True)
    call(fontgen, f"--font={FONT}", f"--chars={chars}", f"--name={header.stem}",
         "--quiet", "--format=hpp", f"--out={header}", *options)


def compile_object(machine, flags, source, target, **options):
    """Compiles a source of a device. With a launcher, no files are written but
    the object and what -fstack-usage asks for."""
    return run([*LAUNCHER, *COMPILERS[machine][0], *DEVICE_FLAGS, *INCLUDES,
                *flags, "-c", source, "-o", target], **options)


def in_parallel(function, arguments):
    """[function(*a) for a in arguments], on all cores, in order."""
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        return list(pool.map(lambda a: function(*a), arguments))


def finish(passed, problems):
    """Prints the problems and the closing line, and ends the program."""
    for problem in problems:
        print(problem)
    print(f"{passed} passed, {len(problems)} failed")
    sys.exit(1 if problems or passed == 0 else 0)
