r"""An external component of ESPHome: fonts of any size from one array.

    external_components:
      - source: {type: local, path: inkcell/port/esphome/components}

    inkcell:
      - id: large
        file: DejaVuSans.ttf
        size: 80.5
        glyphs: "0123456789.:-\u00B0C "
      - id: small
        file: DejaVuSans.ttf
        size: 14
        glyphs: "0123456789.:-\u00B0C "

    display:
      - platform: ...
        lambda: |-
          it.printf(0, 0, id(large), "%.1f", id(temperature).state);

`id(large)` goes wherever a font of ESPHome does. Fonts of one file and the same
glyphs share one array. `levels: 2` is for displays of two colours: text is fitted
to the grid of pixels, and no colours are mixed. inkcell-fontgen is found in PATH,
or named by `fontgen`. Where there is none, as on Home Assistant OS, `file` is a font
that it made elsewhere by --format bin, `sans.bin`.
"""
import pathlib
import shutil
import subprocess
import tempfile

import esphome.codegen as cg
import esphome.config_validation as cv
from esphome.const import CONF_FILE, CONF_GLYPHS, CONF_ID, CONF_RAW_DATA_ID, CONF_SIZE
from esphome.core import CORE, HexInt

DEPENDENCIES = ["display"]
MULTI_CONF = True
CONF_FONTGEN = "fontgen"
CONF_LEVELS = "levels"
LIBRARY = pathlib.Path(__file__).resolve().parents[4]
ASCII = "".join(map(chr, range(0x20, 0x7f)))

InkcellFont = cg.esphome_ns.namespace("inkcell_font").class_("InkcellFont")

CONFIG_SCHEMA = cv.Schema({
    cv.Required(CONF_ID): cv.declare_id(InkcellFont),
    cv.Required(CONF_FILE): cv.file_,
    cv.Required(CONF_SIZE): cv.float_range(min=4, max=1024),
    cv.Optional(CONF_GLYPHS, default=ASCII): cv.string,
    cv.Optional(CONF_LEVELS, default=256): cv.one_of(2, 256, int=True),
    cv.Optional(CONF_FONTGEN, default="inkcell-fontgen"): cv.string,
    cv.GenerateID(CONF_RAW_DATA_ID): cv.declare_id(cg.uint8),
})
_arrays = {}  # by program, file and glyphs


def make_font(fontgen, file, glyphs):
    """The bytes of a font."""
    if pathlib.Path(file).suffix == ".bin":
        return pathlib.Path(file).read_bytes()
    if shutil.which(fontgen) is None:
        raise cv.Invalid(f"there is no program {fontgen}: build Inkcell, and put "
                         "inkcell-fontgen into PATH or name it by `fontgen`")
    with tempfile.TemporaryDirectory() as folder:
        symbols = pathlib.Path(folder) / "glyphs.txt"
        symbols.write_text(glyphs, encoding="utf-8")
        made = pathlib.Path(folder) / "font.bin"
        result = subprocess.run(
            [fontgen, f"--font={file}", f"--text-file={symbols}", "--name=font",
             "--format=bin", "--quiet", f"--out={made}"],
            text=True, stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
        if result.returncode != 0:
            raise cv.Invalid(f"{file}: {result.stdout}")
        return made.read_bytes()


async def to_code(config):
    cg.add_library("Inkcell", None, f"symlink://{LIBRARY}")
    file = CORE.relative_config_path(config[CONF_FILE])
    key = (config[CONF_FONTGEN], str(file), config[CONF_GLYPHS])
    if key not in _arrays:
        rom = make_font(*key)
        _arrays[key] = (cg.progmem_array(config[CONF_RAW_DATA_ID],
                                         [HexInt(byte) for byte in rom]), len(rom))
    array, size = _arrays[key]
    cg.new_Pvariable(config[CONF_ID], array, size,
                     round(config[CONF_SIZE] * 64), config[CONF_LEVELS] == 2)
