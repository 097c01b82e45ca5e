"""Compares the API with that of the last release, api.txt: what is gone or changed is
named by docs/CHANGELOG.md in a part that is newer. What is new is told, and fine.

The list has a line a function, a type and its members, a constant. --write makes it,
for a release.

Usage: check_api.py WORK_FOLDER [--write]
"""
import pathlib
import re
import sys
from xml.etree import ElementTree

from toolchains import ROOT, arguments, finish, run

LIST = ROOT / "tests/build/api.txt"
# May change with any version (docs/API.md).
FREE = "inkcell::simulation"


def text_of(element, name):
    found = element.find(name)
    return "" if found is None else " ".join("".join(found.itertext()).split())


def function(scope, member):
    """Names of parameters may change."""
    parameters = ", ".join(
        text_of(parameter, "type") + text_of(parameter, "array") +
        (" = " + text_of(parameter, "defval") if parameter.find("defval") is not None
         else "") for parameter in member.findall("param"))
    words = [text_of(member, "type"),
             *(word for word in ("static", "const", "explicit")
               if member.get(word) == "yes")]
    return f"{scope}{text_of(member, 'name')}({parameters}) {' '.join(words)}".strip()


def enumeration(scope, member):
    values = ", ".join(f"{text_of(value, 'name')} {text_of(value, 'initializer')}"
                       .strip() for value in member.findall("enumvalue"))
    name = re.sub("^@.*", "", text_of(member, "name"))  # C's have none
    head = f"{scope}{name} enum {text_of(member, 'type')}".strip()
    return f"{head} {{ {values} }}"


def symbols_of(compound):
    """Lines of a class, of a namespace, or of what a file has in none."""
    kind, name = compound.get("kind"), text_of(compound, "compoundname")
    scope = "" if kind == "file" else name + "::"
    fields = []
    for member in compound.iter("memberdef"):
        what = member.get("kind")
        if member.get("prot") != "public" or what == "friend":
            continue
        if what == "function":
            yield function(scope, member)
        elif what == "enum":
            yield enumeration(scope, member)
        elif what == "define":
            arguments_of = ", ".join(text_of(one, "defname")
                                     for one in member.findall("param"))
            yield f"{text_of(member, 'name')}({arguments_of}) macro"
        elif what == "typedef":
            yield f"{scope}{text_of(member, 'name')} = {text_of(member, 'type')}"
        elif kind in ("class", "struct", "union"):
            fields.append(f"{text_of(member, 'type')} {text_of(member, 'name')}"
                          f"{text_of(member, 'argsstring')}")
        else:
            yield f"{scope}{text_of(member, 'name')} {text_of(member, 'type')}"
    if kind in ("class", "struct", "union"):
        bases = ", ".join(base.text for base in compound.findall("basecompoundref")
                          if "detail::" not in base.text)
        yield f"{name} {kind} : {bases}".rstrip(" :") + f" {{ {'; '.join(fields)} }}"


def read_api(work):
    settings = (ROOT / "docs/Doxyfile").read_text()
    result = run(["doxygen", "-"], cwd=ROOT, input=settings +
                 f"OUTPUT_DIRECTORY={work}\nGENERATE_HTML=NO\nWARNINGS=NO\n")
    if result.returncode != 0:
        finish(0, [result.stdout])
    lines = set()
    for path in (work / "xml").glob("*.xml"):
        for compound in ElementTree.parse(path).getroot().findall("compounddef"):
            name = text_of(compound, "compoundname")
            if "<" not in name and not name.startswith(FREE):
                lines |= set(symbols_of(compound))
    return sorted(lines)


def name_of(line):
    """What a changelog calls a symbol: the name, behind that of its type. Of an enum
    without a name its first value."""
    found = re.match(r"(?:[a-z]\w*::)*((?:\w+::)?(?:operator[^(]+|[\w~]+))", line)
    return found.group(1) if found.group(1) != "enum" else line.split()[2]


def extends(line, other):
    """Whether a type has its members or values of before, and others behind them."""
    return line.endswith("}") and other.startswith(line.removesuffix("}").rstrip())


def changelog_since(version):
    """The names that it has of versions that are newer."""
    text = (ROOT / "docs/CHANGELOG.md").read_text()
    found = re.search(rf"^## {re.escape(version)}\b", text, re.M)
    if not found:
        finish(0, [f"docs/CHANGELOG.md: no version {version}, which {LIST.name} has"])
    return " ".join(re.findall("`([^`]+)`", text[:found.start()]))


def main():
    write = sys.argv[-1] == "--write"
    if write:
        sys.argv.pop()
    work, = arguments()
    api = read_api(work)
    if write:
        version = re.search(r"inkcell VERSION ([\d.]+)",
                            (ROOT / "CMakeLists.txt").read_text()).group(1)
        head = f"API of {version}, by check_api.py --write"
        LIST.write_text("\n".join([head, *api, ""]))
        return
    head, *released = LIST.read_text().splitlines()
    version = head.removeprefix("API of ").partition(",")[0]
    since = changelog_since(version)
    names = set(map(name_of, api))
    problems = []
    for line in sorted(set(released) - set(api)):
        name = name_of(line)
        now = [other for other in api if name_of(other) == name]
        owner = name.partition("::")[0]  # one that is gone speaks for its members
        said = name if owner in names else owner
        if not (any(extends(line, other) for other in now) or
                re.search(rf"(?<![\w:]){re.escape(said)}(?!\w)", since)):
            problems.append(
                f"{line}\n  is {'now ' + now[0] if now else 'gone'} since {version}: "
                f"name `{said}` in docs/CHANGELOG.md and say what to write instead, or "
                "bring it back")
    new = sorted(set(api) - set(released))
    print("".join(f"new since {version}: {line}\n" for line in new), end="")
    finish(len(api), problems)


main()
