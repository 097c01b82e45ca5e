//! Compiles the device library and its interface for C.
//!
//! They are two folders up, or where INKCELL_DIR says. PYTHON names another
//! Python than python3, which makes the interface where nobody has made it.
use std::path::{Path, PathBuf};
use std::{env, fs, process};

/// What the interface for C needs besides the core.
const PARTS: &str = "core/cache core/field core/figures core/layers core/layout core/motion \
                     core/shaping core/strike core/truetype port/display port/pixel";
const FLAGS: [&str; 5] =
    ["-std=c++17", "-ffreestanding", "-fno-exceptions", "-fno-rtti", "-fno-threadsafe-statics"];

fn main() {
    println!("cargo:rerun-if-env-changed=INKCELL_DIR");
    println!("cargo:rerun-if-env-changed=PYTHON");
    let out = PathBuf::from(env::var("OUT_DIR").unwrap());
    let here = PathBuf::from(env::var("CARGO_MANIFEST_DIR").unwrap());
    let root = env::var("INKCELL_DIR").map_or_else(|_| here.join("../.."), Into::into);
    for part in ["core", "port/c", "port/display", "port/pixel"] {
        println!("cargo:rerun-if-changed={}", root.join(part).display());
    }
    let c = interface(&root, &out);
    fs::copy(c.join("rust/sys.rs"), out.join("sys.rs")).unwrap();

    let mut build = cc::Build::new();
    for part in PARTS.split(' ').map(|part| root.join(part)).chain([c]) {
        build.include(part.join("include")).files(sources(&part.join("src")));
    }
    let rooms = root.join("core/src");
    build.include(root.join("core/include")).include(&rooms);
    for room in listed(&rooms) {
        build.files(sources(&room));
    }
    for flag in FLAGS {
        build.flag(flag);
    }
    build.cpp(true).cpp_link_stdlib(None).warnings(false);
    build.compile("inkcell_c");
}

/// The folder of the interface for C: include/, src/ and rust/.
fn interface(root: &Path, out: &Path) -> PathBuf {
    let port = root.join("port/c");
    if port.join("rust/sys.rs").exists() {
        return port;
    }
    let made = out.join("c");
    let python = env::var("PYTHON").unwrap_or_else(|_| "python3".into());
    let mut make = process::Command::new(python);
    make.arg("-B").arg(port.join("make_api.py")).arg(&made);
    let ended = make.status();
    if !matches!(&ended, Ok(status) if status.success()) {
        panic!(
            "{make:?} makes the interface for C: {ended:?}. Install Python \
             3.9 or newer, or name it by PYTHON; INKCELL_DIR names the folder \
             of Inkcell"
        );
    }
    made
}

/// What is in a folder, in the same order everywhere.
fn listed(folder: &Path) -> Vec<PathBuf> {
    let entries = fs::read_dir(folder)
        .unwrap_or_else(|error| panic!("{}: {error}: INKCELL_DIR names Inkcell", folder.display()));
    let mut paths: Vec<_> = entries.map(|entry| entry.unwrap().path()).collect();
    paths.sort();
    paths
}

/// Sources of a room, or none of a file.
fn sources(folder: &Path) -> Vec<PathBuf> {
    let mut files = if folder.is_dir() { listed(folder) } else { Vec::new() };
    files.retain(|path| path.extension().map_or(false, |end| end == "cpp"));
    files
}
