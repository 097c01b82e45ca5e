"""PlatformIO: library.json, and its script in an environment that is played."""
import json
import types

from packages.consumer import FONT_OPTIONS
from toolchains import FONT, MADE, ROOT, finish


class Environment:
    """What the script asks of PlatformIO."""

    def __init__(self, folder, options):
        self.folder = folder
        self.options = options
        self.includes = []

    def GetProjectOption(self, name, default):
        return self.options.get(name, default)

    def subst(self, text):
        return text.replace("$BUILD_DIR", str(self.folder / "build")).replace(
            "$PROJECT_DIR", str(self.folder))

    def Append(self, CPPPATH):
        self.includes += CPPPATH


def run_script(script, folder, fontgen):
    """Ends the test unless the script makes the font that a project names."""
    folder.mkdir()
    environment = Environment(folder, {
        "custom_inkcell_fontgen": str(fontgen),
        "custom_inkcell_lvgl": "yes",
        "custom_inkcell_fonts": "\n" + " ".join(
            [f"--font={FONT}", "--name=dejavu_sans", *FONT_OPTIONS])})
    made = folder / "build/inkcell_fonts"
    times = []
    for _ in range(2):  # the second time there is nothing to do
        exec(compile(script.read_text(), str(script), "exec"),
             {"Import": lambda *names: None, "env": environment,
              "pio_lib_builder": types.SimpleNamespace(path=str(ROOT))})
        times.append((made / "fonts/dejavu_sans.hpp").stat().st_mtime_ns)
    if times[0] != times[1] or environment.includes[:2] != [
            str(MADE / "include"), str(made)]:
        finish(0, ["PlatformIO: the font is made twice, or not found"])


def sources(folder, fontgen):
    manifest = json.loads((ROOT / "library.json").read_text())
    build = manifest["build"]
    includes = [flag[3:] for flag in build["flags"] if flag.startswith("-I ")]
    for path in [build["includeDir"], *includes]:
        if not (ROOT / path).is_dir():
            finish(0, [f"library.json: no folder {path}"])
    header = ROOT / build["includeDir"] / manifest["headers"]
    if not header.exists() or build["srcFilter"][0] != "-<*>":
        finish(0, [f"library.json: {header}, {build['srcFilter']}"])
    run_script(ROOT / build["extraScript"], folder, fontgen)
    return [str(path) for word in build["srcFilter"][1:]
            for path in (ROOT / build["srcDir"] / word[2:-1]).rglob("*.cpp")]
