"""Makes the interface for C, include/ and src/ of a folder, from its tables: api.txt,
and port/display/c_api.txt for drivers of displays. mirror.hpp and painter_of.cpp,
which are written by hand, go to src/, too. rust/sys.rs declares the same for Rust.

Usage: make_api.py FOLDER

A file that is the same is left alone, one that was made before and is not made any
more is removed.
"""
import fnmatch
import os
import pathlib
import re
import sys
import textwrap

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parents[1]
WIDTH = 80
TABLES = ("port/c/api.txt", "port/display/c_api.txt")
BY_HAND = ("mirror.hpp", "painter_of.cpp")
MADE = "// Made by port/c/make_api.py from {}: edit that instead.\n"
SOURCE = f"""// clang-format off
{MADE}#include "mirror.hpp"

using namespace inkcell;
using namespace inkcell::c;
"""
# Some types have private members: only GCC and Clang know the places of others.
CHECKS = """
#pragma GCC diagnostic ignored "-Winvalid-offsetof"
#define SAME_VALUE(c, cpp) \\
  static_assert(static_cast<int>(c) == static_cast<int>(cpp))
#define SAME_FIELD(c, member, cpp, twin)                \\
  static_assert(offsetof(c, member) == offsetof(cpp, twin) && \\
                sizeof(c::member) == sizeof(cpp::twin))
"""
TWINS = ("// What types of C stand for.\n" + MADE.format("its tables") +
         "#pragma once\n\n")
FUNCTION = r"(\w[\w ]*\*? )(inkcell_[\w{}]+)\(([^()]*)\)(?: (:?)= (.*))?"


def joined(head, tail):
    """A line and indented ones, the former up to the end of what it begins."""
    while tail and (re.match("    :?= ", tail[0]) or len(
            re.findall(r"[({]", head)) > len(re.findall(r"[)}]", head))):
        head, tail = head + " " + tail[0].strip(), tail[1:]
    return head.replace("( ", "("), tail


def signature(result, name, parameters, end):
    """A declaration as clang-format lays it out."""
    begin = f"{result}{name}("
    for first, between in ((begin, ", "),
                           (begin, ",\n" + " " * len(begin)),
                           (begin + "\n    ", ", "),
                           (begin + "\n    ", ",\n    ")):
        text = first + between.join(parameters) + ")" + end
        if max(map(len, text.split("\n"))) <= WIDTH:
            break
    return text + "\n"


def wrapped(line, indent):
    """A line, in pieces if it is too long."""
    return "\n".join(textwrap.wrap(line, WIDTH, subsequent_indent=indent,
                                   break_long_words=False,
                                   break_on_hyphens=False)) + "\n"


def filled(text):
    """Text in which paragraphs of comments are as wide as a source."""
    return re.sub(r"(?m)^(///?) (?! |- ).*\n(?:\1 (?! |- ).*\n)*",
                  lambda m: wrapped(m[0].replace(f"\n{m[1]}", ""), f"{m[1]} "),
                  text)


# Types of C in Rust, and names of C that Rust keeps for itself.
RUST = {"char": "u8", "size_t": "usize", "uint8_t": "u8", "uint16_t": "u16",
        "uint32_t": "u32", "uint64_t": "u64", "int8_t": "i8", "int16_t": "i16",
        "int32_t": "i32", "int64_t": "i64", "void": "core::ffi::c_void"}
RESERVED = ("box", "loop", "in", "ref", "type", "move")


def rust_type(text):
    """A type of C, with its asterisks."""
    base, stars = re.fullmatch(r"((?:const )?(?:struct )?\w+) ?(\**)",
                               text.strip()).groups()
    name = base.split()[-1]
    kind = RUST.get(name, name)
    for _ in stars:
        kind = f"*{'const' if base.startswith('const') else 'mut'} {kind}"
        base = ""
    return kind


def rust_member(text):
    """A member, a parameter or a constant: its name and its type."""
    function = re.fullmatch(r"(.*)\(\*(\w+)\)\((.*)\)", text)
    if function:
        result, name, parameters = function.groups()
        kind = f"Option<unsafe extern \"C\" fn{rust_signature(result, parameters)}>"
    else:
        base, name, count = re.fullmatch(r"(.*\W)(\w+)(?:\[(\w+)\])?", text).groups()
        kind = f"[{rust_type(base)}; {count}]" if count else rust_type(base)
    return f"{'r#' * (name in RESERVED)}{name}: {kind}"


def rust_signature(result, parameters):
    parts = parameters.split(", ") if parameters != "void" else []
    returns = "" if result.strip() == "void" else f" -> {rust_type(result)}"
    return f"({', '.join(map(rust_member, parts))}){returns}"


def rust(headers):
    """What headers of C declare."""
    text = re.sub(r"//.*|(?m:^#(?:.*\\\n)*.*)", "", headers).replace('extern "C" {', "")
    types = functions = ""
    for part in re.findall(r"[^;{}]*(?:\{[^}]*\}[^;]*)?;", text):
        part = re.sub(r"\( | (?=\))", lambda m: m[0].strip(), " ".join(part.split()))
        part = part.lstrip("} ")
        struct = re.fullmatch(r"typedef struct (?:INKCELL_SHARED )?(\w+) \{ (.*); \} \w+;",
                              part)
        if struct:
            members = "".join(f"    pub {rust_member(member)},\n"
                              for member in struct[2].split("; "))
            types += (f"#[repr(C)]\n#[derive(Clone, Copy, Debug)]\npub struct {struct[1]} "
                      f"{{\n{members}}}\n")
        elif part.startswith("typedef "):
            _, kind, name = part[:-1].split()
            types += f"pub type {name} = {RUST[kind]};\n"
        elif part.startswith("enum "):
            types += "".join(f"pub const {name}: u8 = {value};\n" for name, value in
                             re.findall(r"(\w+) = (\w+)", part))
        elif part.startswith("extern "):
            functions += f"    pub static {rust_member(part[7:-1])};\n"
        else:
            result, name, parameters = re.fullmatch(r"(.*\W)(\w+)\((.*)\);",
                                                    part).groups()
            functions += f"    pub fn {name}{rust_signature(result, parameters)};\n"
    return f'{types}extern "C" {{\n{functions}}}\n'


class Api:
    """What has been made of the table so far."""

    def __init__(self):
        self.headers = {}     # by their names: includes, and the rest
        self.sources = {}
        self.includes = []    # of C++
        self.twins = ""       # what types of C stand for
        self.checks = ""      # that they are alike, and constants equal
        self.parameters = []  # patterns of names, and their types
        self.words = []       # patterns of $words, and what they stand for
        self.each = ["{}"]

    def declare(self, text):
        self.headers[self.header][2] += text

    def define(self, text):
        self.sources.setdefault(self.source, SOURCE.format(self.table))
        self.sources[self.source] += "\n" + text

    def read(self, head, tail):
        word, _, rest = head.partition(" ")
        function = re.fullmatch(FUNCTION, joined(head, tail)[0])
        if word in ("parameters", "words"):
            for line in tail:
                value, names = line.strip().split(": ")
                getattr(self, word).extend((name, value)
                                           for name in names.split())
        elif word == "header":
            self.begin_header(rest + "".join(tail))
        elif word == "source" and not tail:
            self.source = f"{rest}.cpp"
        elif word == "each":
            self.each = rest.split()
        elif word in ("struct", "shared", "opaque"):
            self.read_type(word, *joined(rest, tail))
        elif word == "enum":
            self.read_enum(*joined(rest, tail))
        elif word == "extern":
            text, value = rest.split(" = ")
            self.declare(f"extern {text};\n")
            self.define(f"{text} = {value};\n")
        elif function:
            for name in self.each:
                parts = [part and part.replace("{Type}", name.capitalize())
                         .replace("{}", name) for part in function.groups()]
                self.read_function(*parts, joined(head, tail)[1])
            self.each = ["{}"]
        elif self.headers:
            before = self.headers[self.header][2].rpartition("\n")[0]
            if head.startswith("//") and re.search(r"(?:^|\n)(?!//).+$", before):
                self.declare("\n")
            self.declare("\n".join([head, *tail]) + "\n")

    def begin_header(self, text):
        self.header, c, cpp = re.fullmatch(r"(\S+): (.*?); *(.*)",
                                           text).groups()
        self.source = pathlib.Path(self.header).stem + ".cpp"
        self.headers[self.header] = [self.table, "".join(
            f"#include <{name}>\n" if name.startswith("std")
            else f'#include "inkcell/{name}"\n' for name in c.split()), ""]
        self.includes += cpp.split()

    def read_type(self, word, head, members):
        name, cpp, others, short = re.fullmatch(
            r"(\w+)(?: = ([\w:]+))?(?: \((.*)\))?(?: \{ (.*) \})?",
            head).groups()
        members = ("  " + short.replace("; ", ";\n  ") if short
                   else "\n".join(members))
        kind = "struct" if word == "struct" else "struct INKCELL_SHARED"
        self.declare(f"typedef {kind} {name} {{\n{members}\n}} {name};\n")
        if cpp:
            self.twins += (f"template <>\nstruct CppOf<{name}> {{\n"
                           f"  using Type = {cpp};\n}};\n")
        if cpp and word == "shared":
            twins = dict(re.findall(r"(\w+): ([\w.]+)", others or ""))
            for member in re.findall(
                    r"(?m)^  \w[^/(;\n]*?\(?\*?(\w+)(?:;|\)\()", members):
                twin = twins.get(member, member.removesuffix("_q6"))
                self.checks += wrapped(
                    f"SAME_FIELD({name}, {member}, {cpp}, {twin});", "    ")

    def read_enum(self, head, constants):
        cpp, prefix, short = re.fullmatch(r"([\w:]+) ?(\w*)(?: \{ (.*) \})?",
                                          head).groups()
        text = f"enum {{ {short} }};\n"
        if not short or len(text) > WIDTH + 1:
            text = "\n".join(["enum {", *(constants or textwrap.indent(
                short.replace(", ", ",\n"), "  ").split("\n")), "};\n"])
        self.declare(text)
        for name in re.findall(r"INKCELL_(\w+) =", text):
            twin = name.removeprefix(prefix).lower()
            self.checks += wrapped(
                f"SAME_VALUE(INKCELL_{name}, {cpp}::{twin});", "    ")

    def parameter(self, text):
        if " " in text:
            return text
        for pattern, kind in self.parameters:
            if fnmatch.fnmatch(text, pattern):
                return f"{kind} {text}"
        if f"inkcell_{text}_t>" in self.twins:
            return f"const inkcell_{text}_t* {text}"
        sys.exit(f"api.txt: the parameter {text} has no type: write it, or add "
                 "the name to `parameters`")

    def in_cpp(self, match):
        """What a $word stands for."""
        return next(value.replace("*", match[1]) for name, value in self.words
                    if fnmatch.fnmatch(match[1], name))

    def read_function(self, result, name, parameters, empty, expression, body):
        listed = [self.parameter(text) for text in parameters.split(", ")]
        self.declare(signature(result, name, listed, ";"))
        if expression:
            begin, end = {"void ": ("", ""), "inkcell_status_t ": (
                "return code(", ")")}.get(result, ("return ", ""))
            if result == "void " and listed[-1].endswith("* out"):
                begin = "$out = "
            body = [*["  $out = {};"] * (empty == ":"),
                    f"  {begin}{expression}{end};"]
        text = "".join(wrapped(re.sub(r"\$(\w+)", self.in_cpp, line), "      ")
                       for line in body)
        self.define(f"{signature(result, name, listed, ' {')}{text}}}\n")

    def header_text(self, table, includes, text):
        comment, _, rest = text.partition("\n\n")
        comment = filled(comment.strip() + "\n")
        begin = f"{comment}//\n{MADE.format(table)}#pragma once\n\n{includes}"
        return begin if not rest else (
            f'{begin}\n#ifdef __cplusplus\nextern "C" {{\n#endif\n\n'
            f"{filled(rest)}#ifdef __cplusplus\n}}\n#endif\n")

    def files(self):
        """The text of each file."""
        includes = "".join(f'#include "{name}"\n' for name in
                           sorted(["inkcell/inkcell.h", *self.includes]))
        return {**{f"include/inkcell/{name}": self.header_text(*header)
                   for name, header in self.headers.items()},
                **{f"src/{name}": text for name, text in self.sources.items()},
                **{f"src/{name}": MADE.format(f"port/c/{name}") +
                   (HERE / name).read_text() for name in BY_HAND},
                "rust/sys.rs": MADE.format("its tables") + rust("".join(
                    text for _, _, text in self.headers.values())),
                "src/checks.cpp":
                    SOURCE.format("its tables") + CHECKS + self.checks,
                "src/twins.hpp":
                    f"{TWINS}{includes}\nnamespace inkcell {{\nnamespace c {{\n"
                    "\n/// What a type of C stands for: `Type`.\n"
                    f"template <typename C>\nstruct CppOf;\n{self.twins}\n"
                    "}  // namespace c\n}  // namespace inkcell\n"}


def write(path, text):
    """Writes a file if it differs; whoever reads it meanwhile reads all of it."""
    if path.exists() and path.read_text() == text:
        return
    path.parent.mkdir(parents=True, exist_ok=True)
    new = path.with_suffix(f".{os.getpid()}")
    new.write_text(text)
    new.replace(path)


def main():
    if len(sys.argv) != 2:
        sys.exit("usage: make_api.py FOLDER")
    folder = pathlib.Path(sys.argv[1])
    api = Api()
    # Lines that are indented belong to the one before them.
    for api.table in TABLES:
        for head, tail in re.findall(r"(?m)^(|[^# ].*|#\w.*)\n((?: .*\n)*)",
                                     (ROOT / api.table).read_text()):
            api.read(head, tail.splitlines())
    files = {folder / name: text for name, text in api.files().items()}
    for path, text in files.items():
        write(path, text)
    for path in [*folder.glob("include/inkcell/**/*.h"), *folder.glob("src/*.?pp")]:
        if path not in files and MADE.split("{")[0] in path.read_text():
            path.unlink()


main()
