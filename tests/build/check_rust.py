"""Checks port/rust with Debian's cargo, or else that of PATH, without a network.

Its examples and a program of the test, neither of which has an `unsafe`, draw byte
for byte what C++ draws. Types of the bindings lie in memory as those of C. Programs
that use memory which is gone do not compile. The documents have no warnings. States
what a label takes on Cortex-M0, with a core of rust-src.

Crates come from Debian's librust-*-dev. What the test needs of embedded-graphics is
played; INKCELL_RUST_CRATES names a folder with its sources and those of what it
needs, a folder for each, such as `cargo vendor` makes.

Usage: check_rust.py WORK_FOLDER BUILD_FOLDER FONTGEN
"""
import json
import os
import pathlib
import re
import shutil

from toolchains import (ARM, DEVICE_FLAGS, INCLUDES, MADE, ROOT, archives, arguments,
                        call, finish, require, run)

HERE = ROOT / "tests/build/rust"
PORT = ROOT / "port/rust"
DEBIAN = pathlib.Path("/usr/share/cargo/registry")
REFUSED = ("gone_font", "gone_pixels", "gone_fit", "gone_text", "two_sinks")
# What the test's program says of refusals and of embedded-graphics.
SAID = """font Some(bad_magic)
sink Some(buffer_small) Some(bad_argument)
style Some(bad_argument)
cache Some(buffer_small)
missing 1 Some('\u0416') Err(no_glyph)
has true false
advance 14 of 13
lines Some(buffer_small)
"""
SAID_GRAPHICS = """tiles equal true
not filled 0
line 35 35
"""
THUMB = "thumbv6m-none-eabi"
# A program of Rust on a device, and the same of C, both started by C.
THUMB_MANIFEST = f"""[package]
name = "thumb"
version = "0.0.0"
edition = "2021"
[lib]
crate-type = ["staticlib"]
[dependencies]
inkcell-example = {{ path = "{PORT}/example" }}
[profile.release]
opt-level = "s"
lto = true
panic = "abort"
codegen-units = 1
"""
THUMB_LIBRARY = """#![no_std]
#[panic_handler]
fn stop(_: &core::panic::PanicInfo) -> ! {
    loop {}
}
#[no_mangle]
pub extern "C" fn label(pages: &mut [u8; 192]) -> u8 {
    inkcell_example::label("23.5", pages).map_or_else(|status| status.code(), |()| 0)
}
"""
THUMB_C = """#include "examples.h"
extern const uint32_t rom[];
int label(uint8_t* pages);
int label(uint8_t* pages) { return draw_label(rom, ROM_SIZE, "23.5", pages); }
"""
THUMB_START = """#include <stdint.h>
int label(uint8_t* pages);
int start(void);
int start(void) { static uint8_t pages[192]; return label(pages) + pages[5]; }
"""
# What the program of Rust may take on top of that of C. [bytes]
THUMB_MORE = 512


def make_registry(folder):
    """Crates of Debian and given or played ones, as cargo takes them."""
    given = pathlib.Path(os.environ.get("INKCELL_RUST_CRATES", HERE / "played"))
    for crate in [*DEBIAN.glob("*/"), *given.glob("*/")]:
        copy = folder / crate.name
        shutil.rmtree(copy, ignore_errors=True)
        shutil.copytree(crate, copy)
        if not (copy / ".cargo-checksum.json").exists():
            (copy / ".cargo-checksum.json").write_text('{"files": {}}')
    print(f"embedded-graphics: {given}")


def structs():
    """Types of the bindings, and their members."""
    text = (MADE / "rust/sys.rs").read_text()
    return {name: re.findall(r"pub (?:r#)?(\w+):", members) for name, members in
            re.findall(r"pub struct (\w+) \{\n(.*?)\n\}", text, re.S)}


def write_layouts(work):
    """Programs of both languages that tell sizes and places of all members."""
    lines_c, lines_rust = [], []
    for name, members in structs().items():
        lines_c.append(f'  printf("{name} %zu %zu\\n", sizeof({name}), _Alignof({name}));')
        lines_rust.append(f'    println!("{name} {{}} {{}}", size_of::<sys::{name}>(), '
                          f"align_of::<sys::{name}>());")
        for member in members:
            lines_c.append(f'  printf("{name}.{member} %zu\\n", offsetof({name}, {member}));')
            lines_rust.append(f'    println!("{name}.{member} {{}}", '
                              f"offset!({name} r#{member}));")
    (work / "layout.c").write_text(
        "#include <stddef.h>\n#include <stdio.h>\n#include <inkcell/inkcell.h>\n"
        "int main(void) {\n" + "\n".join(lines_c) + "\n}\n")
    return """//! Made by check_rust.py.
use inkcell::sys;
use std::mem::{align_of, size_of, MaybeUninit};

macro_rules! offset {
    ($name:ident $member:ident) => {{
        let object = MaybeUninit::<sys::$name>::uninit();
        let base = object.as_ptr();
        unsafe { std::ptr::addr_of!((*base).$member) as usize - base as usize }
    }};
}

pub fn print() {
""" + "\n".join(lines_rust) + "\n}\n"


class Cargo:
    """Cargo on a copy of the test's package."""

    def __init__(self, work, fontgen):
        self.folder = work / "check"
        shutil.copytree(HERE / "src", self.folder / "src")
        manifest = (HERE / "Cargo.toml").read_text()
        (self.folder / "Cargo.toml").write_text(
            manifest.replace("inkcell/port", f"{ROOT}/port"))
        text = write_layouts(work)
        (self.folder / "src/layout.rs").write_text(text)
        main = self.folder / "src/main.rs"
        main.write_text(main.read_text().replace("#![forbid(unsafe_code)]\n", ""))
        make_registry(work / "registry")
        self.config = work / "cargo.toml"
        self.config.write_text(
            '[source.crates-io]\nreplace-with = "given"\n'
            f'[source.given]\ndirectory = "{work / "registry"}"\n')
        self.environment = {**os.environ, "INKCELL_FONTGEN": str(fontgen),
                            "CARGO_TARGET_DIR": str(work / "target"),
                            "CARGO_HOME": str(work / "home")}

    def run(self, *words, folder=None, **more):
        command = ["cargo", "--config", self.config, *words, "--offline"]
        return run(command, cwd=folder or self.folder,
                   env={**self.environment, **more})


def check_pictures(cargo, work, build):
    """The program's pictures and what it says."""
    built = cargo.run("build", "--features=embedded-graphics")
    if built.returncode != 0:
        finish(0, [built.stdout[-5000:]])
    drawn, wanted = work / "drawn", work / "wanted"
    said = call(work / "target/debug/inkcell-check", drawn)
    font, = (work / "target/debug/build").glob("inkcell-example-*/out/sans.bin")
    expected = work / "expected"
    call("g++", *DEVICE_FLAGS[:1], *INCLUDES, HERE / "expected.cpp", *archives(build),
         "-o", expected)
    call(expected, font, wanted)
    problems = []
    a, b = drawn.read_bytes(), wanted.read_bytes()
    print(f"pictures: {len(b)} bytes, {sum(byte != 0 for byte in b)} of them not 0")
    if a != b or len(b) < 50000:
        first = next((i for i, (x, y) in enumerate(zip(a, b)) if x != y), min(len(a), len(b)))
        problems.append(f"Rust draws {len(a)} bytes, which differ from C++'s {len(b)} at "
                        f"{first}")
    problems += [f"the program does not say {line!r}: {said[:800]}" for line in
                 (SAID + SAID_GRAPHICS).splitlines() if line not in said]
    layout = work / "layout"
    call("gcc", "-std=c11", f"-I{MADE / 'include'}", work / "layout.c", "-o", layout)
    places = call(layout)
    print(f"layouts: {len(places.splitlines())} sizes and places")
    if places not in said or len(places.splitlines()) < 300:
        missing = set(places.splitlines()) - set(said.splitlines())
        problems.append(f"types of the bindings lie otherwise: {sorted(missing)[:5]}")
    return problems


def check_refused(cargo):
    """What must not compile does, without its mistake."""
    problems = []
    for name in REFUSED:
        good = cargo.run("check", f"--features={name}")
        bad = cargo.run("check", f"--features={name},mistake")
        if good.returncode != 0:
            problems.append(f"{name}: {good.stdout[-2000:]}")
        if bad.returncode == 0 or not re.search(r"error\[E0(499|505|506)\]", bad.stdout):
            problems.append(f"{name} compiles with its mistake: {bad.stdout[-2000:]}")
    return problems


def check_documents(cargo, work):
    """Documents without warnings, whose programs compile. Of a copy: cargo writes
    beside the manifest."""
    problems = []
    copy = work / "copy"
    shutil.copytree(PORT, copy)
    cargo.environment["INKCELL_DIR"] = str(ROOT)
    for folder, words in ((copy, ["--features=embedded-graphics"]), (copy / "fonts", [])):
        made = cargo.run("doc", "--no-deps", *words, folder=folder,
                         RUSTDOCFLAGS="-D warnings")
        if made.returncode != 0 or "warning" in made.stdout:
            problems.append(made.stdout[-3000:])
        tested = cargo.run("test", *words, folder=folder)
        if tested.returncode != 0 or "1 passed" not in tested.stdout:
            problems.append(tested.stdout[-3000:])
    return problems


def make_sysroot(folder):
    """A folder with the core for Cortex-M0 of rust-src, and what stands for the
    functions of compiler_builtins, which libgcc has."""
    library = folder / "lib/rustlib" / THUMB / "lib"
    library.mkdir(parents=True)
    source = pathlib.Path(call("rustc", "--print", "sysroot").strip(),
                          "lib/rustlib/src/rust/library/core/src/lib.rs")
    if not source.exists():
        finish(0, [f"there is no {source}: install rust-src"])
    builtins = folder / "builtins.rs"
    builtins.write_text("#![feature(compiler_builtins)]\n#![compiler_builtins]\n"
                        "#![no_std]\n")
    for name, file in (("core", source), ("compiler_builtins", builtins)):
        call("rustc", "--edition=2021", f"--crate-name={name}", "--crate-type=rlib",
             f"--target={THUMB}", "-O", "-Cpanic=abort", "-Cembed-bitcode=yes",
             "--cap-lints=allow", f"--sysroot={folder}", "-o",
             library / f"lib{name}.rlib", file,
             env={**os.environ, "RUSTC_BOOTSTRAP": "1"})


def check_thumb(cargo, work):
    """What a label takes on Cortex-M0 in Rust, and in C by the same library."""
    folder = work / "thumb"
    (folder / "src").mkdir(parents=True)
    make_sysroot(work / "sysroot")
    for name, text in (("Cargo.toml", THUMB_MANIFEST), ("src/lib.rs", THUMB_LIBRARY),
                       ("start.c", THUMB_START), ("label.c", THUMB_C)):
        (folder / name).write_text(text)
    built = cargo.run("build", "--release", f"--target={THUMB}", folder=folder,
                      RUSTFLAGS=f"--sysroot={work / 'sysroot'}")
    if built.returncode != 0:
        return [built.stdout[-5000:]]
    made = work / "target" / THUMB / "release"
    library, = made.glob("build/inkcell-*/out/libinkcell_c.a")
    font, = made.glob("build/inkcell-example-*/out/sans.bin")
    rom = font.read_bytes()
    (folder / "rom.c").write_text(
        "#include <stdint.h>\nconst uint8_t __attribute__((aligned(4))) rom[] = {" +
        ",".join(map(str, rom)) + "};\n")
    compiler = [f"{ARM}gcc", "-mcpu=cortex-m0", "-mthumb", "-Os", "-ffunction-sections",
                "-nostartfiles", "-Wl,--gc-sections", "-Wl,-e,start",
                f"-I{MADE / 'include'}", f"-I{ROOT / 'port/c/examples'}",
                f"-DROM_SIZE={len(rom)}", folder / "start.c"]
    sizes = {}
    for name, files in (("Rust", [made / "libthumb.a"]),
                        ("C", [folder / "label.c", folder / "rom.c",
                               ROOT / "port/c/examples/label.c", library])):
        call(*compiler, *files, "-o", folder / f"{name}.elf")
        sizes[name] = int(call(f"{ARM}size", folder / f"{name}.elf").split()[6])
    print(f"a label on Cortex-M0: {sizes['Rust']} bytes, {len(rom)} of them the font; "
          f"in C {sizes['C']}")
    if not 10000 < sizes["C"] < sizes["Rust"] + THUMB_MORE or (
            sizes["Rust"] > sizes["C"] + THUMB_MORE):
        return [f"Rust takes {sizes['Rust'] - sizes['C']} bytes more than C, and may "
                f"take {THUMB_MORE}"]
    return []


def take_debian(folder):
    """Debian's programs come first in PATH, before others of their names."""
    folder.mkdir()
    for name in ("cargo", "rustc", "rustdoc"):
        if os.access(f"/usr/bin/{name}", os.X_OK):
            (folder / name).symlink_to(f"/usr/bin/{name}")
    os.environ["PATH"] = f"{folder}:{os.environ['PATH']}"


def main():
    work, build, fontgen = arguments()
    take_debian(work / "bin")
    require(["cargo", "rustc", "rustdoc", "gcc", "g++", f"{ARM}gcc"])
    print(call("cargo", "--version").strip())
    cargo = Cargo(work, fontgen)
    problems = check_pictures(cargo, work, build)
    problems += check_refused(cargo)
    problems += check_documents(cargo, work)
    problems += check_thumb(cargo, work)
    finish(5 + len(REFUSED), problems)


main()
