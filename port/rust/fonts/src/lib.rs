//! Makes fonts of Inkcell from `build.rs`, by `inkcell-fontgen`.
//!
//! ```no_run
//! // build.rs
//! fn main() {
//!     inkcell_fonts::make("sans", "DejaVuSans.ttf", &["--chars=0x20-0x7E"]);
//! }
//! ```
//!
//! The program then has the font by
//! `inkcell::include_font!(concat!(env!("OUT_DIR"), "/sans.bin"))`. It is made
//! anew when a file changes that it is made of. INKCELL_FONTGEN names the
//! generator where it is not in `PATH`.
#![forbid(unsafe_code)]
#![warn(missing_docs)]
use std::path::{Path, PathBuf};
use std::{env, fs, process};

/// Makes `NAME.bin` in `OUT_DIR` from a font file, whose path is relative to
/// the package, with more options of `inkcell-fontgen`. Returns its path.
///
/// # Panics
///
/// If the generator is not there, or refuses: with what it says.
pub fn make(name: &str, font: impl AsRef<Path>, options: &[&str]) -> PathBuf {
    let folder = env::var("OUT_DIR").expect("make() is for build.rs");
    let out = Path::new(&folder).join(name).with_extension("bin");
    let files = out.with_extension("d");
    println!("cargo:rerun-if-env-changed=INKCELL_FONTGEN");
    println!("cargo:rerun-if-changed=build.rs");
    println!("cargo:rerun-if-changed={}", font.as_ref().display());
    let generator = env::var("INKCELL_FONTGEN");
    let generator = generator.unwrap_or_else(|_| "inkcell-fontgen".into());
    let mut command = process::Command::new(generator);
    command.arg("--font").arg(font.as_ref()).args(options);
    command.args(["--format=bin", "--quiet", "--name", name]);
    command.arg("--out").arg(&out).arg("--depfile").arg(&files);
    match command.output() {
        Ok(ended) if ended.status.success() => {}
        Ok(ended) => {
            let said = String::from_utf8_lossy(&ended.stderr);
            panic!("{command:?}: {}\n{said}", ended.status)
        }
        Err(error) => panic!(
            "{command:?}: {error}. INKCELL_FONTGEN names inkcell-fontgen, which \
             makes fonts"
        ),
    }
    for file in sources(&fs::read_to_string(files).expect("a depfile")) {
        println!("cargo:rerun-if-changed={file}");
    }
    out
}

/// The files behind the colon of the first rule of Make.
fn sources(rule: &str) -> Vec<String> {
    let rule = rule.replace("\\\n", " ").replace("\\ ", "\0");
    let first = rule.lines().next().unwrap_or("");
    let list = first.split_once(": ").map_or("", |(_, list)| list);
    list.split_whitespace().map(|file| file.replace('\0', " ")).collect()
}
