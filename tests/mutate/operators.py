"""Mistakes that can be made in a line of C++, one at a time."""
import re

# Kind, what is replaced, by what. The formatter puts spaces around binary
# operators, so that templates and pointers are not meant.
OPERATORS = (
    ("border", r" <(?= )", " <="),
    ("border", r" <=(?= )", " <"),
    ("border", r" >(?= )", " >="),
    ("border", r" >=(?= )", " >"),
    ("equality", r" ==(?= )", " !="),
    ("equality", r" !=(?= )", " =="),
    ("sum", r" \+(?= )", " -"),
    ("sum", r" -(?= )", " +"),
    ("sum", r" \+=(?= )", " -="),
    ("sum", r" -=(?= )", " +="),
    ("product", r" \*(?= \w)", " +"),
    ("shift", r" >>(?= )", " <<"),
    ("shift", r" <<(?= )", " >>"),
    ("bits", r" &(?= )", " |"),
    ("bits", r" \|(?= )", " &"),
    ("logic", r" &&(?= )", " ||"),
    ("logic", r" \|\|(?= )", " &&"),
    ("logic", r"(?<=[( ])!(?=\w)", ""),
    ("truth", r"\btrue\b", "false"),
    ("truth", r"\bfalse\b", "true"),
    ("number", r"(?<![\w.])\d+(?![\w.])", lambda m: str(int(m[0]) + 1)),
)
# Lines that say nothing that runs.
LEFT_OUT = re.compile(r"\s*(#|//|namespace\b|using\b|template\b|static_assert|"
                      r"INKCELL_ASSERT)|.*\boperator\b")


def code_of(line):
    """A line with comments and strings blanked, of the same length."""
    line = re.sub(r'"(\\.|[^"\\])*"', lambda m: '"' * len(m[0]), line)
    line = re.sub(r"'(\\.|[^'\\])'", lambda m: "'" * len(m[0]), line)
    return re.sub(r"//.*", lambda m: " " * len(m[0]), line)


def mutants_of(text):
    """(number of the line, kind, the line that replaces it) of each."""
    for number, line in enumerate(text.splitlines(), 1):
        if LEFT_OUT.match(line):
            continue
        code = code_of(line)
        for kind, pattern, replacement in OPERATORS:
            for match in re.finditer(pattern, code):
                new = (replacement(match) if callable(replacement)
                       else replacement)
                yield number, kind, line[:match.start()] + new + line[
                    match.end():]
