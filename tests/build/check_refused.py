"""Compiles code that a type refuses, and the good form of it.

Usage: check_refused.py
"""
import re

from toolchains import (COMPILERS, INCLUDES, WARNINGS, finish, in_parallel, require,
                        run)

# What is refused; headers; what the compiler must complain about, so that it is
# refused for the reason that it is there for; the code, and what stands at @ in
# its good form and in its bad one.
CASES = {
    "pixels in read-only memory": (
        ["span.hpp"], "could not convert|no viable conversion",
        "Span<@ uint8_t> pixels(const uint8_t (&rows)[8]) { return rows; }",
        "const", ""),
    "a Status that nobody looks at": (
        ["font.hpp"], "nodiscard|unused-result",
        "Status open_font(Span<const uint8_t> rom, Font& font) { @ }",
        "return Font::open(rom, font);",
        "Font::open(rom, font); return Status::ok;"),
    "a whole number where 1/64 px are meant": (
        ["style.hpp"],
        "could not convert|no matching (function|constructor)|cannot convert",
        "Style make_style() { return Style(@, kFilterText); }",
        "Q26_6::from_int(16)", "16"),
    "one fixed-point format assigned to another": (
        ["fixed.hpp"],
        "conversion from|no viable conversion|could not convert",
        "Q16_16 widen(Q26_6 length) { return @; }",
        "Q16_16::from_raw(length.raw * 1024)", "length"),
    "an effect without its options, past whose end its mixer would read": (
        ["lcd.hpp", "style.hpp"], "protected",
        "void set_lcd(Style& style) { static constexpr Lcd kLcd; "
        "static constexpr @ kCopy = kLcd; style.set_effect(kCopy); }",
        "Lcd", "Effect"),
    "a style whose effect is gone before it is used": (
        ["stroke.hpp", "style.hpp"], "deleted (member )?function",
        "constexpr Stroke kStroke(kFilterText, Q6_10::from_int(1)); "
        "void set_stroke(Style& style) { style.set_effect(@); }",
        "kStroke", "Stroke(kFilterText, Q6_10::from_int(1))"),
    "a style whose filter is gone before it is used": (
        ["style.hpp"], "deleted (function|constructor)",
        "Style make_style(const FilterSpec& spec, Filter& filter) { "
        "filter = make_filter(spec); "
        "return Style(Q26_6::from_int(16), @); }",
        "filter", "make_filter(spec)"),
    "a box of text whose style is gone before it is drawn": (
        ["layout/text_box.hpp"], "deleted (function|constructor)",
        "TextBox make_box(const Font& font, const Style& style) { "
        "return TextBox(font, @, {0, 0, 90, 20}); }",
        "style", "Style(style)"),
    "a value whose style is gone before it is drawn": (
        ["value_label.hpp"], "deleted (function|constructor)",
        "ValueLabel make_value(const Font& font, const Style& style) { "
        "return ValueLabel(font, @, {4, 28}); }",
        "style", "Style(style)"),
}


def check_case(machine, name):
    headers, pattern, code, good, bad = CASES[name]
    includes = "".join(f'#include "inkcell/{header}"\n' for header in headers)
    command = [*COMPILERS[machine][0], "-std=c++17", "-ffreestanding", *WARNINGS,
               *INCLUDES, "-fsyntax-only", "-x", "c++", "-"]
    results = [run(command, input=f"{includes}using namespace inkcell;\n"
                   f"{code.replace('@', form)}\n") for form in (good, bad)]
    if results[0].returncode != 0:
        return f"{name} ({machine}): the good form:\n{results[0].stdout}"
    if results[1].returncode == 0:
        return f"{name} ({machine}): compiles, but must not"
    if not re.search(pattern, results[1].stdout):
        return f"{name} ({machine}): another reason:\n{results[1].stdout}"
    return None


def main():
    machines = ["Cortex-M0", "RV32", "host", "host clang"]
    require([COMPILERS[machine][0][0] for machine in machines])
    jobs = [(machine, name) for machine in machines for name in CASES]
    problems = [found for found in in_parallel(check_case, jobs) if found]
    finish(len(jobs) - len(problems), problems)


main()
