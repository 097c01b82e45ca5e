"""No build system: the compiler and the folders that docs/BUILD.md names."""
from packages.consumer import COMPILE, LINK, size_of, write_sources
from toolchains import DEVICE_FLAGS, ROOT, call, in_parallel, make_font


def compile_all(folder, sources, options):
    """Compiles the sources as C++ and returns their objects."""
    folder.mkdir(parents=True, exist_ok=True)
    objects = [folder / f"{i}.o" for i in range(len(sources))]
    in_parallel(call, [
        ("arm-none-eabi-g++", *COMPILE, *options, "-x", "c++", "-c", source, "-o",
         out) for source, out in zip(sources, objects)])
    return objects


def link(program, objects):
    call("arm-none-eabi-gcc", *LINK, *objects, "-o", program)
    return size_of(program)


def build(work, _, fontgen):
    folder = work / "files"
    write_sources(folder)
    make_font(fontgen, folder / "fonts/dejavu_sans.hpp")
    sources = [*ROOT.glob("core/src/*/*.cpp"),
               *ROOT.glob("core/layout/src/*.cpp"),
               *ROOT.glob("port/pixel/src/*.cpp"),
               folder / "main.cpp", folder / "readme.cpp"]
    includes = [f"-I{path}" for path in
                (ROOT / "core/include", ROOT / "core/src",
                 ROOT / "core/layout/include",
                 ROOT / "port/pixel/include", folder)]
    objects = compile_all(folder / "objects", sources,
                          [*DEVICE_FLAGS, *includes])
    return {"files": link(folder / "app", objects)}
