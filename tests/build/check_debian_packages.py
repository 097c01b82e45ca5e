"""Checks the lists of Debian's packages in host_tools/setup.sh.

A file that the demo or the tests find on this machine must belong to a package of
their list, to one that a listed package depends on, or to a minimal Debian with
git. Files are found in CMake's caches, in what ninja knows of headers and
libraries, below /usr/share where sources name them, and in scripts: programs that
they start, modules that they import.

Then each package is taken out of its list, and a file must be missed.

Usage: check_debian_packages.py <work folder> <build folder of the host>
       check_debian_packages.py --web <folder that the page was built in>

Exits with 77 where there is no dpkg.
"""
import ast
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys

from toolchains import ROOT, finish, run

# Packages that no file is found of, and what needs them.
TRACELESS = {
    "aspell-fa": "aspell dumps its words for tests/gen/shaped_words.py",
    "aspell-hi": "aspell dumps its words for tests/gen/shaped_words.py",
    "aspell-mr": "aspell dumps its words for tests/gen/shaped_words.py",
    "ccache": "tests/run.sh calls compilers by it",
    "fonts-noto-core": "faces of tests/gen/shaped_words.py, in a folder of it",
    "libclang-rt-dev": "clang links it for sanitizers and the fuzzer",
    "libnewlib-arm-none-eabi": "hosted C in tests/build/packages, tests/bench",
    "librust-cc-dev": "cargo compiles it for port/rust in tests/build/check_rust.py",
    "picolibc-riscv64-unknown-elf": "hosted C in tests/bench",
    "python3-pygments": "MkDocs colours code by it",
    "rust-src": "tests/build/check_rust.py compiles the core of Rust for Cortex-M0",
    "zopfli": "host_tools/playground/build.mjs packs the page by it",
}
BASE = ("apt", "git")
SCRIPT = re.compile(r"[\w./-]+\.(?:py|sh)\b")
NAMED_COMPILER = re.compile(
    r'CMAKE_\w*(?:COMPILER|EMULATOR)"?:? "?([\w.+-]+)')
COMMAND = re.compile(
    r"(?:^|[;&|(!]|\b(?:then|do|else|if|elif|while|exec|set --|command -v|step "
    r"\S+)(?= ))(?=\s*(?:\w+=\S* +)*([\w.+-]+))", re.M)


class Packages:
    """The packages of this machine."""

    def __init__(self):
        self.essential = set(BASE)
        self.depends, self.providers = {}, {}
        fields = ("Package", "db:Status-Status", "Essential", "Priority",
                  "Pre-Depends", "Depends", "Provides")
        listing = run(["dpkg-query", "-W", "-f",
                       "\t".join(f"${{{f}}}" for f in fields) + "\n"]).stdout
        for line in listing.splitlines():
            name, status, essential, priority, before, others, provides = (
                line.split("\t"))
            if status != "installed":
                continue
            self.depends[name] = [
                [re.match(r"[^\s:(]+", choice.strip()).group(0)
                 for choice in group.split("|")]
                for group in f"{before},{others}".split(",") if group.strip()]
            for virtual in re.findall(r"[^\s,(]+(?=\s*(?:\(|,|$))", provides):
                self.providers.setdefault(virtual, []).append(name)
            if essential == "yes" or priority == "required":
                self.essential.add(name)

    def closure(self, packages):
        """These, what they depend on, and a minimal Debian with git."""
        found, waiting = set(), [[name] for name in
                                 [*sorted(self.essential), *packages]]
        # From a choice apt-get takes what is there already, or else the first.
        while waiting:
            choice = waiting.pop(0)
            names = [name for word in choice for name in
                     ([word] if word in self.depends
                      else sorted(self.providers.get(word, [])))]
            if not names or found & set(names):
                continue
            found.add(names[0])
            waiting += self.depends[names[0]]
        return found


def spellings(path):
    """A path with and without /usr, where dpkg may know it by either."""
    path = str(path)
    if path.startswith("/usr/"):
        return [path, path[len("/usr"):]]
    return [path, "/usr" + path]


def steps(path):
    """The paths that a path leads to, link by link."""
    path = pathlib.Path(path)
    for _ in range(10):
        path = path.parent.resolve() / path.name
        yield path
        if not path.is_symlink():
            break
        path = path.parent / os.readlink(path)


def owners(paths):
    """For each path the packages that may have put it there."""
    wanted = sorted({spelling for path in paths for step in steps(path)
                     for spelling in spellings(step)})
    owned = {}
    for begin in range(0, len(wanted), 1000):
        done = subprocess.run(["dpkg-query", "-S", *wanted[begin:begin + 1000]],
                              stdout=subprocess.PIPE, text=True, check=False,
                              stderr=subprocess.DEVNULL,
                              env={**os.environ, "LC_ALL": "C"})
        for line in done.stdout.splitlines():
            names, _, path = line.partition(": ")
            if not line.startswith("diversion "):
                owned.setdefault(path, set()).update(
                    name.split(":")[0] for name in names.split(", "))
    result = {}
    for path in paths:
        # The first that a package has: links of alternatives are nobody's.
        result[path] = next((owned[spelling] for step in steps(path)
                             for spelling in spellings(step)
                             if spelling in owned), set())
    return result


def debian_path(path):
    """A path as Debian has it: a program of another place, or a link to ccache,
    stands for Debian's program of that name."""
    real = str(pathlib.Path(path).resolve())
    debian = (real.startswith(("/usr/", "/etc/", "/bin/", "/sbin/", "/lib"))
              and not real.startswith("/usr/local/"))
    name = os.path.basename(path)
    if not debian or os.path.basename(real) == "ccache" != name:
        return program(name) or path
    return path


def program(name):
    """Debian's program of a name, if it is on this machine."""
    for folder in ("/usr/bin", "/bin", "/usr/sbin", "/sbin"):
        if os.access(f"{folder}/{name}", os.X_OK):
            return f"{folder}/{name}"
    return None


class Evidence:
    """Files of Debian that are needed, and who said so."""

    def __init__(self, *ours):
        """`ours`: folders whose files nobody installs."""
        self.files = {}
        self.ours = tuple(f"{folder}/" for folder in (ROOT, *ours))

    def add(self, path, source):
        if path.startswith("/") and not f"{path}/".startswith(self.ours):
            self.files.setdefault(debian_path(path), source)

    def add_cache(self, folder):
        """What CMake found."""
        cache = (folder / "CMakeCache.txt").read_text()
        where = os.path.relpath(folder, ROOT)
        for name, kind, value in re.findall(r"^([\w.+-]+):(\w+)=(.+)$", cache,
                                            re.M):
            for path in value.split(";"):
                if kind != "STATIC" and os.path.exists(path):
                    self.add(path, f"{where}/CMakeCache.txt, {name}")

    def add_ninja(self, folder, targets=()):
        """What targets are made of, or all: libraries and headers."""
        where = os.path.relpath(folder, ROOT)
        inputs = set()
        for target in targets or ["all"]:
            listing = run(["ninja", "-C", folder, "-n", "-t", "inputs", target])
            if listing.returncode != 0:
                sys.exit(f"{where}: {listing.stdout}")
            inputs.update(listing.stdout.splitlines())
        for path in inputs:
            self.add(path, f"{where}/build.ninja")
        deps = run(["ninja", "-C", folder, "-n", "-t", "deps"]).stdout
        for part in deps.split("\n\n"):
            first, *headers = part.strip().split("\n")
            goal = first.partition(":")[0]
            if not targets or goal in inputs:
                for header in headers:
                    self.add(header.strip(), f"{where}, {goal}")

    def add_scripts(self, scripts):
        for script in scripts:
            source = str(script.relative_to(ROOT))
            words = (python_words if script.suffix == ".py"
                     else shell_words)(script.read_text())
            for word in words:
                if program(word):
                    self.add(program(word), source)

    def add_modules(self, scripts):
        """What scripts import of Debian's Python."""
        users = {}
        for script in scripts:
            if script.suffix == ".py":
                for name in imports(script.read_text()):
                    users.setdefault(name, str(script.relative_to(ROOT)))
        find = ("import importlib.util, json, sys; print(json.dumps({name: "
                "getattr(importlib.util.find_spec(name), 'origin', None) "
                "for name in sys.argv[1:]}))")
        found = run(["/usr/bin/python3", "-I", "-c", find, *users]).stdout
        for name, origin in json.loads(found).items():
            if origin and origin.startswith("/"):
                self.add(origin, f"{users[name]}, import {name}")

    def add_shared(self, texts):
        """Files below /usr/share that texts name, in one word or in two."""
        folders, words = {}, {}
        for source, text in texts.items():
            for path in re.findall(r"/usr/share/[\w./+-]*\w", text):
                if os.path.isdir(path):
                    folders.setdefault(path, source)
                else:
                    self.add(path, source)
            for word in re.findall(r"[\w+-][\w./+-]*\.\w+", text):
                words.setdefault(word, source)
        for folder in folders:
            for word, source in words.items():
                if os.path.isfile(f"{folder}/{word}"):
                    self.add(f"{folder}/{word}", source)


def without_comments(text):
    return re.sub(r"^\s*#.*$", "", text, flags=re.M)


def imports(text):
    """Modules that a script imports."""
    for node in ast.walk(ast.parse(text)):
        if isinstance(node, ast.Import):
            yield from (alias.name.split(".")[0] for alias in node.names)
        elif isinstance(node, ast.ImportFrom) and node.module:
            yield node.module.split(".")[0]


def python_words(text):
    """Programs that a script of Python may start: the first words of lists, and
    what is looked for."""
    for node in ast.walk(ast.parse(text)):
        if isinstance(node, ast.Call) and node.args:
            first = node.args[0]
            name = getattr(node.func, "attr", getattr(node.func, "id", ""))
            if isinstance(first, ast.List) and name == "require":
                yield from (e.value for e in first.elts
                            if isinstance(e, ast.Constant))
            elif name == "which" and isinstance(first, ast.Constant):
                yield first.value
        if isinstance(node, ast.List) and node.elts:
            if isinstance(node.elts[0], ast.Constant):
                yield str(node.elts[0].value)


def unquoted(text):
    """A shell script without comments and quotes, but with $(...) in them."""
    kept, open_quotes, i = [], [False], 0  # of the text and of each $(
    while i < len(text):
        here = text[i]
        if here == "\\":
            i += 1
        elif here == '"':
            open_quotes[-1] = not open_quotes[-1]
        elif here == "$" and text[i:i + 2] == "$(":
            open_quotes.append(False)
            kept.append("(")
            i += 1
        elif not open_quotes[-1]:
            if here == "'":
                i = text.find("'", i + 1)
            elif here == "#" and text[i - 1:i].strip() == "":
                i = text.find("\n", i) - 1
            elif here == ")" and len(open_quotes) > 1:
                open_quotes.pop()
            else:
                kept.append(here)
        i = i + 1 if i >= 0 else len(text)
    return "".join(kept)


def shell_words(text):
    """Programs that a shell script may start: words where a command begins."""
    return COMMAND.findall(unquoted(text))


def scripts_from(texts, modules, without=frozenset()):
    """The scripts of the project that texts name, and those that these name."""
    found, waiting = set(), [(ROOT, text) for text in texts]
    while waiting:
        folder, text = waiting.pop()
        names = set(SCRIPT.findall(without_comments(text)))
        if modules:
            names |= {name + ".py" for name in
                      re.findall(r"^\s*(?:import|from) (\w+)", text, re.M)}
        for name in names:
            for path in (folder / name.lstrip("./"), ROOT / name):
                path = pathlib.Path(os.path.normpath(path))
                if (path.is_file() and ROOT in path.parents and
                        path not in found | without):
                    found.add(path)
                    waiting.append((path.parent, path.read_text()))
    return sorted(found)


def packages_of(name):
    """A list of setup.sh."""
    done = run(["sh", "-c", f'. "$1"; echo $inkcell_packages_{name}', "sh",
                ROOT / "host_tools/setup.sh"])
    return list(dict.fromkeys(done.stdout.split()))


def demo_evidence(work, host):
    """What host_tools/demo.sh finds: of its own configuration, of the objects
    that the host's build shares with it, and of the boards' firmware."""
    found = Evidence(work, host)
    path = ":".join(folder for folder in os.environ["PATH"].split(":")
                    if not folder.endswith("/ccache"))
    own = {name: value for name, value in os.environ.items()
           if name not in ("CC", "CXX", "CMAKE_CXX_COMPILER_LAUNCHER")}
    shutil.rmtree(work / "demo", ignore_errors=True)
    done = run(["cmake", "-S", ROOT, "--preset", "demo-host", "-B",
                work / "demo"], env={**own, "PATH": path}, cwd=ROOT)
    if done.returncode != 0:
        sys.exit(done.stdout)
    screens = json.loads((host / "host_tools/screens/screens.json").read_text())
    boards = {screen["board"]: pathlib.Path(screen["build"])
              for screen in screens}
    targets = ["inkcell_demo", *(f"scene_hosts_{board}" for board in boards)]
    found.add_cache(work / "demo")
    found.add_ninja(host, targets)
    for board, folder in boards.items():
        if not (folder / "CMakeCache.txt").exists():
            sys.exit(f"{folder}: the firmware of {board} is not built; run the "
                     f"test screens.{board}.build first")
        found.add_cache(folder)
        found.add_ninja(folder, [f"demo_{screen['format']}" for screen in
                                 screens if screen["board"] == board])
    script = ROOT / "host_tools/demo.sh"
    scripts = [script, *scripts_from([script.read_text()], modules=False)]
    found.add_scripts(scripts)
    found.add_shared({"host_tools/demo.sh": script.read_text()})
    return found


def tests_evidence(host):
    found = Evidence(host)
    found.add_cache(host)
    found.add_ninja(host)
    tests = run(["ctest", "--test-dir", host, "--show-only=json-v1"]).stdout
    commands = {test["name"]: " ".join(test.get("command", []))
                for test in json.loads(tests)["tests"]}
    script = ROOT / "tests/run.sh"
    # With --here the first needs nothing, and says what it lacks; a folder that
    # the second made is used where a variable names it; build.fonts makes two faces
    # of the third, which other tests name, too; the last one installs what it needs.
    optional = {ROOT / "tests" / "web.sh", ROOT / "fonts_gen/web" / "build.sh",
                ROOT / "host_tools/release" / "fonts.json",
                ROOT / "tests" / "night.sh"}
    scripts = [script, *scripts_from([script.read_text(), *commands.values()],
                                     modules=True, without=optional)]
    found.add_scripts(scripts)
    found.add_modules(scripts)
    names = run(["git", "-C", ROOT, "ls-files", "-z"]).stdout.split("\0")
    texts = {name: (ROOT / name).read_text(errors="replace") for name in names
             if name.endswith((".txt", ".cmake", ".py", ".sh", ".cpp", ".hpp",
                               ".json")) and (ROOT / name).is_file()
             and ROOT / name not in optional}
    found.add_shared({**texts, **commands})
    for name, text in texts.items():
        for word in NAMED_COMPILER.findall(text):
            if program(word):
                found.add(program(word), name)
    return found


def web_evidence(folder):
    """What the build of the page finds."""
    found = Evidence(folder)
    for part in ("generator", "core"):
        found.add_cache(folder / part)
    # Where LLVM's tools have no links, CMake takes GNU's of these names.
    found.files = {re.sub(r"/bin/llvm-(\w+)$", r"/bin/\1", path): source
                   for path, source in found.files.items()}
    found.files.pop("/usr/bin/dlltool", None)  # of Windows
    found.add_ninja(folder / "generator", ["inkcell-fontgen"])
    found.add_ninja(folder / "core", ["inkcell_web"])
    for link in (folder / "generator/include").iterdir():
        found.add(str(link.resolve()), "fonts_gen/web/CMakeLists.txt")
    toolchain = ROOT / "port/web/toolchain.cmake"
    for word in re.findall(r"_COMPILER (\S+)\)", toolchain.read_text()):
        found.add(program(word), "port/web/toolchain.cmake")
    # In two words: tests/run.sh starts this check, and not that script.
    script = ROOT / "host_tools/playground" / "build.sh"
    scripts = [script, *scripts_from([script.read_text()], modules=False)]
    found.add_scripts(scripts)
    found.files.pop("/usr/bin/ccache", None)  # called where it is installed
    texts = {str(path.relative_to(ROOT)): path.read_text() for path in
             [*scripts, *(ROOT / "fonts_gen/web").glob("*.txt")]}
    found.add_shared(texts)
    return found


def missing(packages, owned, listed):
    """Packages of files that a list does not bring along, each with one file."""
    there = packages.closure(listed)
    lacking = {}
    for path, names in owned.items():
        if not names & there and not (os.path.isdir(path) and not names):
            lacking.setdefault(" or ".join(sorted(names)) or "a package", path)
    return lacking


def check(packages, name, evidence):
    listed = packages_of(name)
    problems = [f"inkcell_packages_{name}: {package} is not installed here: sh -c "
                f"'. host_tools/setup.sh && inkcell_setup {name}'"
                for package in listed if package not in packages.depends]
    owned = owners(evidence.files)
    for package, path in missing(packages, owned, listed).items():
        problems.append(
            f"host_tools/setup.sh: inkcell_packages_{name} lacks {package}, for "
            f"{path}, which {evidence.files[path]} needs")
    passed = 0
    for package in listed:
        less = [other for other in listed if other != package]
        if package in packages.closure(less):
            continue  # another one brings it along
        noticed = missing(packages, owned, less)
        if noticed or package in TRACELESS:
            passed += 1
            print(f"{name} without {package}: ", end="")
            print("; ".join(f"lacks {names}, for {path}" for names, path in
                            noticed.items()) or TRACELESS[package])
        else:
            problems.append(f"host_tools/setup.sh: nothing that is found is of "
                            f"{package} in inkcell_packages_{name}: take it out, "
                            "or say in TRACELESS what needs it")
    print(f"{name}: {len(owned)} files and folders")
    return passed, problems


def main():
    if shutil.which("dpkg-query") is None:
        print("skipped: there is no dpkg, whose packages would be checked")
        sys.exit(77)
    if sys.argv[1] == "--web":
        folder = pathlib.Path(sys.argv[2]).resolve()
        finish(*check(Packages(), "web", web_evidence(folder)))
        return
    work, host = (pathlib.Path(name).resolve() for name in sys.argv[1:])
    packages = Packages()
    passed, problems = check(packages, "demo", demo_evidence(work, host))
    more, others = check(packages, "tests", tests_evidence(host))
    finish(passed + more, problems + others)


if __name__ == "__main__":
    main()
