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

`id(large)` goes to `print`, `printf`, `strftime` and other functions of a display.
Fonts of one file and the same glyphs share one array. `levels: 2` is for displays of
two colours: text is fitted to the grid of pixels, and no colours are mixed. It is the
default where all displays of the configuration are of platforms that have two.
inkcell-fontgen is found in PATH, or named by `fontgen`. Where there is none, as on
Home Assistant OS, `file` is a font that it made elsewhere by --format bin, `sans.bin`;
its characters are in it. `esphome config` makes or reads each font, and refuses one
that lacks a character, is not whole, or is not of outlines.
"""
import pathlib
import re
import shutil
import struct
import subprocess
import tempfile
import zlib

import esphome.codegen as cg
import esphome.config_validation as cv
from esphome.const import CONF_FILE, CONF_GLYPHS, CONF_ID, CONF_RAW_DATA_ID, CONF_SIZE
from esphome.core import CORE, HexInt

DEPENDENCIES = ["display"]
MULTI_CONF = True
CONF_FONTGEN = "fontgen"
CONF_LEVELS = "levels"
LIBRARY = pathlib.Path(__file__).resolve().parents[4]
DEFAULT_GLYPHS = "".join(map(chr, [*range(0x20, 0x7f), 0xb0]))
OUTLINES = 2  # of a font's header, as docs/FORMAT.md has it
# Platforms of displays of two colours.
TWO_COLOURS = ("max7219digit", "pcd8544", "ssd1306_i2c", "ssd1306_spi", "ssd1325_spi",
               "st7567_i2c", "st7567_spi", "st7920", "waveshare_epaper")

InkcellFont = cg.esphome_ns.namespace("inkcell_font").class_("InkcellFont")

_fonts = {}  # by program, file and glyphs: bytes
_arrays = {}  # likewise, in the program


def key_of(config):
    """What fonts of one array have in common."""
    return (config[CONF_FONTGEN], str(CORE.relative_config_path(config[CONF_FILE])),
            config.get(CONF_GLYPHS, DEFAULT_GLYPHS))


def made(config):
    """A configuration whose font is made, or the reason why it is not."""
    if pathlib.Path(config[CONF_FILE]).suffix == ".bin" and CONF_GLYPHS in config:
        raise cv.Invalid(f"{config[CONF_FILE]} has its characters already: leave "
                         "`glyphs` out, or name the TTF", [CONF_GLYPHS])
    key = key_of(config)
    if key not in _fonts:
        try:
            _fonts[key] = make_font(*key)
        except OSError as error:
            raise cv.Invalid(str(error), [CONF_FILE]) from error
    return config


# A string, or a list of strings as fonts of ESPHome have it.
GLYPHS = cv.All(cv.ensure_list(cv.string), "".join)
CONFIG_SCHEMA = cv.All(cv.Schema({
    cv.Required(CONF_ID): cv.declare_id(InkcellFont),
    cv.Required(CONF_FILE): cv.file_,
    cv.Required(CONF_SIZE): cv.float_range(min=4, max=1024),
    cv.Optional(CONF_GLYPHS): GLYPHS,
    cv.Optional(CONF_LEVELS): cv.one_of(2, 256, int=True),
    cv.Optional(CONF_FONTGEN, default="inkcell-fontgen"): cv.string,
    cv.GenerateID(CONF_RAW_DATA_ID): cv.declare_id(cg.uint8),
}), made)


def read_font(file):
    """The bytes of a font that was made before, whole."""
    rom = pathlib.Path(file).read_bytes()
    if len(rom) < 64 or rom[:4] != b"INKC":
        raise cv.Invalid(f"{file} is no font of inkcell-fontgen --format bin")
    header, size, _, checksum = struct.unpack_from("<xxxxxxHIII", rom)
    if len(rom) < size or zlib.crc32(rom[header:size]) != checksum:
        raise cv.Invalid(f"{file} has {len(rom)} bytes, and the font {size}: it is "
                         "cut short or changed; copy it again")
    version = (LIBRARY / "core/include/inkcell/version.hpp").read_text()
    reads = [int(re.search(rf"kFormat{part} = (\d+)", version)[1])
             for part in ("Major", "Minor")]
    if [rom[5], rom[4]] != reads:
        raise cv.Invalid(f"{file} has format {rom[5]}.{rom[4]}, and this Inkcell reads "
                         f"{reads[0]}.{reads[1]}: make it by the inkcell-fontgen of the "
                         "same release")
    if rom[39] != OUTLINES:
        raise cv.Invalid(f"{file} has no outlines, of which any size is made: make it "
                         "without --strike-only and --coding")
    return rom


def make_font(fontgen, file, glyphs):
    """The bytes of a font."""
    if pathlib.Path(file).suffix == ".bin":
        return read_font(file)
    program = shutil.which(fontgen)  # on Windows npm's is a .cmd
    if program is None:
        raise cv.Invalid(f"there is no program {fontgen}: unpack the release's "
                         "inkcell-fontgen zip, or build Inkcell, and put it into PATH "
                         "or name it by `fontgen`; a .bin needs none")
    with tempfile.TemporaryDirectory() as folder:
        symbols = pathlib.Path(folder) / "glyphs.txt"
        symbols.write_text(glyphs, encoding="utf-8")
        out = pathlib.Path(folder) / "font.bin"
        result = subprocess.run(
            [program, f"--font={file}", f"--text-file={symbols}", "--name=font",
             "--format=bin", "--quiet", "--strict", f"--out={out}"],
            text=True, stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
        if result.returncode != 0:
            raise cv.Invalid(f"{file}: {result.stdout}")
        return out.read_bytes()


def has_two_colours(config):
    """Whether text is fitted to a display of two colours."""
    platforms = [display.get("platform") for display in
                 CORE.config.get("display", [])]
    if CONF_LEVELS in config or not platforms:
        return config.get(CONF_LEVELS) == 2
    return all(platform in TWO_COLOURS for platform in platforms)


async def to_code(config):
    cg.add_library("Inkcell", None, f"symlink://{LIBRARY}")
    key = key_of(made(config))
    if key not in _arrays:
        rom = _fonts[key]
        _arrays[key] = (cg.progmem_array(config[CONF_RAW_DATA_ID],
                                         [HexInt(byte) for byte in rom]), len(rom))
    array, size = _arrays[key]
    cg.new_Pvariable(config[CONF_ID], array, size,
                     round(config[CONF_SIZE] * 64), has_two_colours(config))
