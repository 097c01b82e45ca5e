"""docs/figures.json: what was measured by night, and the tables drawn from it.

README.md, docs/DISPLAY.md and docs/DRAW.md have tables between the lines `<!-- figures: NAME -->`
and `<!-- end of figures -->`: NAME is a function of TABLES. Nobody writes them by
hand.

Usage: figures.py [PART FILE]...    stores the JSON of each file as a part of
                                    figures.json, and draws the tables again
       figures.py --check           fails if a table is not what figures.json says
"""
import json
import re
import sys
from pathlib import Path

DOCS = Path(__file__).resolve().parents[2] / "docs"
FILE = DOCS / "figures.json"
DOCUMENTS = (DOCS.parent / "README.md", DOCS / "DISPLAY.md", DOCS / "DRAW.md")
DRAWN = re.compile(r"(<!-- figures: (\w+) -->\n).*?(?=<!-- end of figures -->)",
                   re.S)
SIZES = (12, 24, 48)
# Cores at speeds that they are sold with. [MHz]
CLOCKS = {"m0": ("Cortex-M0", 48), "m3": ("Cortex-M3", 100),
          "rv32": ("RV32IMC", 160)}


def instructions(rows):
    return {str(r["px"]): r["instructions_mean"] for r in rows
            if r["px"] in SIZES}


def of_strikes(others, font):
    """The parts "strike", of 4 bits on a Cortex-M3 at -Os, and "strike, 1 bit": a
    glyph of 12 px into pages of a display on a Cortex-M0 at -Os."""
    def some(**wanted):
        return [f for f in others if f.get("font", font) == font and
                all(f.get(key) == value for key, value in wanted.items())]

    alone = some(figure="strike", cpu="m3", opt="Os", bits=4, way="alone")
    one_bit = some(figure="strike", cpu="m0", opt="Os", bits=1, px=12)
    code, = some(figure="strike_code", cpu="m3", opt="Os")
    return {
        "strike": {"code": code["glyphs"],
                   "font": {str(f["px"]): f["font_bytes"] for f in alone
                            if f["px"] in SIZES},
                   "stack": max(f["stack"] for f in alone), "heap": 0,
                   "lent": 0, "instructions": instructions(alone)},
        "strike, 1 bit": {f["way"]: f["instructions_mean"] for f in one_bit}}


def of_bench(results, others, smallest, versions):
    """The part "bench": figures of the first font, in outlines."""
    font = results[0]["font"]

    def some(rows, **wanted):
        return [r for r in rows if r.get("font") == font and
                all(r.get(key) == value for key, value in wanted.items())]

    def about(engine, **wanted):
        """Of a Cortex-M3 at -Os; the stack of 48 px, as far as others go."""
        rows = some(results, engine=engine, cpu="m3", opt="Os", **wanted)
        return {"code": rows[0]["code"] + rows[0]["libraries"],
                "font": rows[0]["font_bytes"],
                "stack": max(r["stack"] for r in results if r["px"] <= 48 and
                             (r["engine"], r["cpu"], r["opt"], r.get("coding"))
                             == (engine, "m3", "Os", wanted.get("coding"))),
                "heap": max(r["heap"] for r in rows),
                "lent": max(r.get("workspace", 0) for r in rows),
                "instructions": instructions(rows)}

    def kept(cpu):
        return next(f for f in smallest["outline"][1]
                    if f["figure"] == "code" and f["cpu"] == cpu)

    inkcell = about("inkcell", coding="outline", way="upright")
    figures = {
        "versions": versions,
        "font": {coding: some(results, coding=coding)[0]["font_bytes"]
                 for coding in ("outline", "field")},
        "glyph code, Cortex-M0": {"own": kept("m0")["glyphs"],
                                  "libgcc": kept("m0")["libraries"]},
        "stack": {"nothing lent": max(
            f["stack"] for f in others if f["figure"] == "stack" and
            (f["cpu"], f["opt"]) == ("m3", "O2")), "lent": max(
                r["stack"] for r in results if r.get("coding") == "outline" and
                (r["cpu"], r["opt"]) == ("m3", "O2"))},
        "area": {cpu: instructions(some(
            results, engine="inkcell", coding="outline", way="area", cpu=cpu,
            opt="O2")) for cpu in CLOCKS},
        "inkcell": {**inkcell, "code": kept("m3")["glyphs"]},
        "freetype": about("freetype"),
        **of_strikes(others, font),
    }
    lvgl = some(others, figure="lvgl_glyph", way="rle", opt="Os")
    if lvgl:
        cached = instructions(some(others, figure="cache", cpu="m3", opt="Os"))
        figures["lvgl"] = {
            "code": lvgl[0]["code"],
            "font": {str(f["px"]): f["font_bytes"] for f in lvgl
                     if f["px"] in SIZES},
            "stack": max(f["stack"] for f in lvgl if f["px"] == 48),
            "heap": max(f["heap"] for f in lvgl if f["px"] == 48), "lent": 0,
            "instructions": instructions(lvgl), "cached": cached}
    return figures


def table(head, rows):
    lines = [head, ["---"] * len(head), *rows]
    return "".join("| " + " | ".join(map(str, line)) + " |\n" for line in lines)


def kilobytes(size, places=1):
    return f"{size / 1000:.{places}f}"


def thousands(instructions):
    return [f"{instructions[str(px)] / 1000:.1f}" for px in SIZES]


def takes(figures):
    """Bytes of flash and RAM."""
    bench, readme = figures["bench"], figures["readme"]
    code, stack = bench["glyph code, Cortex-M0"], bench["stack"]
    return table(["KB", ""], [
        ["code of the first program, -Os, with libgcc, without start-up code",
         f"{kilobytes(readme['text, Cortex-M0'])} on Cortex-M0, "
         f"{kilobytes(readme['text, Cortex-M3'])} on Cortex-M3"],
        ["all that it takes of flash: code, tables, font",
         f"{kilobytes(readme['all, Cortex-M0'])} on Cortex-M0"],
        ["code of glyphs alone: outlines, one pixel format, -Os",
         f"{kilobytes(code['own'])} on Cortex-M0, and "
         f"{kilobytes(code['libgcc'])} of libgcc"],
        ["font: 95 characters, 8 to 64 px, 16/255, kerning, hints",
         f"{kilobytes(bench['font']['outline'])}; as a field "
         f"{kilobytes(bench['font']['field'], 0)}"],
        ["RAM of a glyph of up to 32 px",
         f"{kilobytes(stack['nothing lent'])} of stack; or "
         f"{kilobytes(stack['lent'])} of stack and "
         f"{kilobytes(bench['inkcell']['lent'])} that you lend"]])


def times(figures):
    """Milliseconds for 20 characters."""
    return table(["", *(f"{px} px" for px in SIZES)], [
        [f"{name} at {mhz} MHz",
         *(f"{20 * figures['bench']['area'][cpu][str(px)] / 1000 / mhz:.1f} ms"
           for px in SIZES)] for cpu, (name, mhz) in CLOCKS.items()])


def beside(figures):
    """Inkcell beside FreeType and LVGL."""
    bench = figures["bench"]

    def row(engine, name, font, rom):
        mine = bench[engine]
        return [name, mine["code"], font, rom,
                f"{mine['stack']} + {mine['heap']} + {mine['lent']}",
                *thousands(mine["instructions"])]

    def scalable(engine, name, more):
        code, font = bench[engine]["code"], bench[engine]["font"]
        return row(engine, name, f"{font}, any size{more}",
                   "; ".join(3 * [str(code + font)]))

    def sized(engine, name):
        code, fonts = bench[engine]["code"], bench[engine]["font"]
        return row(
            engine, name,
            f"{fonts['12']} at 12 px, {fonts['24']} at 24, {fonts['48']} at 48",
            f"{code + fonts['12']} at 12 px; {code + sum(fonts.values())}; none")

    rows = [scalable("inkcell", "Inkcell, outlines, filter `text`",
                     ", kerning, hints"),
            sized("strike", "Inkcell, strikes alone, 4 bits, fitted"),
            scalable("freetype", f"FreeType {bench['versions']['freetype']}, "
                     "unhinted", "")]
    lvgl = bench.get("lvgl")
    if lvgl:
        rows.append(sized("lvgl", f"LVGL {bench['versions']['lvgl']}, 4-bit "
                          "bitmaps, compressed, light autohint"))
        rows.append(["Inkcell, glyphs that a cache holds", "", "", "", "",
                     *thousands(lvgl["cached"])])
    return table(["", "code", "font", "ROM for 1 size; for 3; for all",
                  "stack + heap + lent", *(f"{px} px" for px in SIZES)], rows)


def bits(figures):
    """The smallest programs of 1 bit, with outlines, strikes and both."""
    speeds = figures["bench"]["strike, 1 bit"]

    def row(name, program, speed):
        sizes = figures["programs"][program]
        return [f"{name}, `{program}`", sizes["code"], sizes["constants"],
                sizes["code"] + sizes["constants"], f"{speed / 1000:.1f}"]

    return table(
        ["", "code", "constants, font included", "flash",
         "thousand instructions a glyph"],
        [row("outlines", "least_oled.cpp", speeds["outline"]),
         row("outlines and a strike", "least_both.cpp", speeds["both"]),
         row("strikes alone", "least_strike.cpp", speeds["alone"])])


def programs(figures):
    """The complete programs of port/display/examples."""
    columns = ("code", "constants", "RAM", "stack")
    return table(["program", *columns], [
        [f"`{name}`", *(sizes.get(column, "") for column in columns)]
        for name, sizes in sorted(figures["programs"].items())])


def lent(figures):
    """Stack of a glyph, with and without lent RAM."""
    stack = figures["bench"]["stack"]
    return table(["lent", "stack of a glyph, Cortex-M3", "when"], [
        ["nothing, the default", f"{kilobytes(stack['nothing lent'])} KB",
         "any text: a line costs at most 1.92 times as much"],
        [f"{figures['bench']['inkcell']['lent']:,} bytes, at a multiple of 4",
         f"{kilobytes(stack['lent'])} KB", "large digits and headlines"],
        ["the same, with a `PreparedGlyph`", "likewise",
         "large glyphs in low strips: points are decoded once"]])


TABLES = {function.__name__: function
          for function in (takes, times, beside, bits, programs, lent)}


def store(part, values):
    """Renews a part of figures.json, and the tables."""
    figures = json.loads(FILE.read_text())
    figures[part] = values
    FILE.write_text(json.dumps(figures, indent=1, sort_keys=True) + "\n")
    draw(figures)


def draw(figures, check=False):
    """Draws the tables; with `check` says which are drawn otherwise."""
    problems = []
    for document in DOCUMENTS:
        text = document.read_text(encoding="utf-8")
        drawn = DRAWN.sub(
            lambda found: found[1] + TABLES[found[2]](figures), text)
        if drawn != text and check:
            problems.append(f"{document.name}: a table is not what "
                            "docs/figures.json says; run tests/bench/figures.py")
        elif drawn != text:
            document.write_text(drawn, encoding="utf-8")
    return problems


def main():
    if sys.argv[1:] == ["--check"]:
        sys.exit("\n".join(draw(json.loads(FILE.read_text()), True)) or 0)
    if len(sys.argv) % 2 == 0:
        sys.exit(__doc__)
    for part, name in zip(sys.argv[1::2], sys.argv[2::2]):
        store(part, json.loads(Path(name).read_text()))
    draw(json.loads(FILE.read_text()))


if __name__ == "__main__":
    main()
