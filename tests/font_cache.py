#!/usr/bin/env python3
"""What ccache is for objects, for fonts: INKCELL_FONTGEN_LAUNCHER of tests/run.sh.

    font_cache.py <inkcell-fontgen> <option>...

Runs the generator, or copies what the same generator made from the same files and
options, into whatever folder. Fonts that nothing took for 30 days are removed from
$INKCELL_FONT_CACHE [~/.cache/inkcell-fonts].
"""

import fcntl
import hashlib
import os
import re
import shutil
import subprocess
import sys
import time
from pathlib import Path

KEPT_S = 30 * 24 * 3600
OUTPUTS = ("--out", "--header", "--depfile")
FOLDER = Path(
    os.environ.get("INKCELL_FONT_CACHE", "~/.cache/inkcell-fonts")
).expanduser()


class NotCached(Exception):
    """The font depends on more than files and options, or makes other files."""


def contents_of(path):
    """A file's bytes, or the names and bytes of the files of a folder."""
    if path.is_file():
        return {path: path.read_bytes()}
    if not path.is_dir():
        raise NotCached
    files = sorted(file for file in path.iterdir() if file.is_file())
    return {path: b"", **{file: file.read_bytes() for file in files}}


def libraries_of(program):
    """What tells the versions of a program's shared libraries."""
    said = subprocess.run(["ldd", program], stdout=subprocess.PIPE,
                          stderr=subprocess.DEVNULL, text=True).stdout
    for library in map(Path, re.findall(r" (/\S+) \(", said)):
        status = library.stat()
        yield f"{library.resolve()} {status.st_size} {status.st_mtime_ns}"


def look_at(command):
    """The key of a font, the files that it is made from, and its outputs."""
    key = hashlib.sha256(Path(command[0]).read_bytes())
    key.update("\n".join(libraries_of(command[0])).encode())
    inputs, outputs = set(), {}
    for option in command[1:]:
        name, _, value = option.partition("=")
        if name in OUTPUTS:
            outputs[name] = Path(value)
            option = name + Path(value).name
        elif name in ("--built", "--part", "--preview", "--report"):
            raise NotCached
        key.update(b"\0option\0")
        # --merge=<file>:<setting>,...=<list>: the folder of a file tells nothing.
        for part in re.split("([=:,])", option):
            if not part.startswith("/"):
                key.update(part.encode())
                continue
            for file, content in contents_of(Path(part)).items():
                inputs.add(str(file))
                key.update(b"\0file\0" + file.name.encode() + b"\0")
                key.update(hashlib.sha256(content).digest())
    if "--out" not in outputs or "--depfile" not in outputs:
        raise NotCached
    if re.search(r"[^\w./+-]", "".join([str(outputs["--out"]), *inputs])):
        raise NotCached  # a depfile would need escapes
    return key.hexdigest(), sorted(inputs), outputs


def make(command, inputs, outputs, kept):
    """Runs the generator; keeps its font if `inputs` are all that it read."""
    made = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
    sys.stdout.buffer.write(made.stdout)
    if made.returncode != 0:
        return made.returncode
    depfile = outputs["--depfile"]
    read = depfile.read_text().split("\n")[0].split()[1:] if depfile.exists() else []
    if sorted(set(read)) != inputs:
        return 0
    part = kept.with_suffix(".part")
    shutil.rmtree(part, ignore_errors=True)
    part.mkdir()
    (part / "said").write_bytes(made.stdout)
    for name, path in outputs.items():
        if name != "--depfile":
            shutil.copyfile(path, part / name)
    part.rename(kept)
    for old in FOLDER.glob("?" * 64):
        if time.time() - old.stat().st_mtime > KEPT_S:
            shutil.rmtree(old, ignore_errors=True)
    return 0


def copy(kept, inputs, outputs):
    os.utime(kept)
    sys.stdout.buffer.write((kept / "said").read_bytes())
    for name, path in outputs.items():
        if name != "--depfile":
            shutil.copyfile(kept / name, path)
    rules = [f"{outputs['--out']}: {' '.join(inputs)}", *(f"{i}:" for i in inputs)]
    outputs["--depfile"].write_text("\n".join(rules) + "\n")


def main():
    command = sys.argv[1:]
    try:
        key, inputs, outputs = look_at(command)
    except NotCached:
        return subprocess.run(command).returncode
    FOLDER.mkdir(parents=True, exist_ok=True)
    kept = FOLDER / key
    # Builds side by side wait for the first that makes a font.
    with open(FOLDER / "lock", "a") as locks:
        byte = int(key[:8], 16)
        fcntl.lockf(locks, fcntl.LOCK_EX, 1, byte)
        if not kept.is_dir():
            return make(command, inputs, outputs, kept)
        copy(kept, inputs, outputs)
    return 0


if __name__ == "__main__":
    sys.exit(main())
