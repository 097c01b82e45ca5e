"""Makes the interface for C, in build/port/c of the library: PlatformIO compiles what
lies there. And makes the fonts of a project: each line of custom_inkcell_fonts in its
environment is the arguments of one call of inkcell-fontgen, without --out.

    custom_inkcell_fonts =
        --font=fonts/DejaVuSans.ttf --name=dejavu_sans --chars=0x20-0x7E

`custom_inkcell_lvgl = yes` compiles fonts for LVGL 9, too, which lib_deps names.

The sources include <fonts/dejavu_sans.hpp>. The program is found in PATH, or is
named by custom_inkcell_fontgen.
"""
import pathlib
import re
import shlex
import shutil
import subprocess
import sys

Import("env", "pio_lib_builder")  # of the library, from PlatformIO

library = pathlib.Path(pio_lib_builder.path)
made = library / "build/port/c"
subprocess.run([sys.executable, "-B", library / "port/c/make_api.py", made], check=True)

# Fonts for LVGL, whose headers a project has or has not.
for path in library.glob("port/lvgl/src/*"):
    copy = made.parent / "lvgl/src" / path.name
    if env.GetProjectOption("custom_inkcell_lvgl", "no") == "yes":
        copy.parent.mkdir(parents=True, exist_ok=True)
        shutil.copy(path, copy)
    else:
        copy.unlink(missing_ok=True)

fontgen = env.GetProjectOption("custom_inkcell_fontgen", "inkcell-fontgen")
fontgen = shutil.which(fontgen) or fontgen  # on Windows npm's is a .cmd
include = pathlib.Path(env.subst("$BUILD_DIR")) / "inkcell_fonts"
(include / "fonts").mkdir(parents=True, exist_ok=True)
for line in env.GetProjectOption("custom_inkcell_fonts", "").splitlines():
    arguments = shlex.split(line)
    if not arguments:
        continue
    name = re.search(r"--name[= ](\w+)", line)
    if name is None:
        raise SystemExit(f"custom_inkcell_fonts: --name is missing in: {line}")
    header = include / "fonts" / f"{name.group(1)}.hpp"
    recipe = header.with_suffix(".txt")
    if header.exists() and recipe.exists() and recipe.read_text() == line:
        continue
    print(f"Making fonts/{header.name}", flush=True)
    subprocess.run([fontgen, *arguments, "--quiet", f"--out={header}"],
                   check=True, cwd=env.subst("$PROJECT_DIR"))
    recipe.write_text(line)
env.Append(CPPPATH=[str(made / "include"), str(include)])
