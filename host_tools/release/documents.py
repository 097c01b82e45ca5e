"""The documents as a site: pages by MkDocs, and below api/ the public headers by
Doxygen. It needs no server: pages link files.

Usage: documents.py FOLDER WORK_FOLDER
"""
import os
import pathlib
import re
import shutil
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
PAGES = {
    "Use": ["docs/BUILD.md", "docs/DISPLAY.md", "docs/DRAW.md", "docs/API.md",
            "docs/TASKS.md", "docs/LAYOUT.md", "docs/STRINGS.md",
            "docs/ANIMATING.md"],
    "Tools": ["docs/BOARD.md", "docs/SIMULATOR.md", "docs/PLAYGROUND.md",
              "host_tools/design/README.md", "host_tools/design/docs/EDITING.md"],
    "Inside": ["docs/DESIGN.md", "docs/FORMAT.md", "docs/BENCHMARKS.md",
               "CONTRIBUTING.md", "SECURITY.md", "docs/CHANGELOG.md"],
}
# Packages whose files are part of the pages.
SHOWN_BY = ("mkdocs", "doxygen", "fonts-font-awesome", "libjs-bootstrap4",
            "libjs-jquery", "libjs-lunr")
LINK = re.compile(r"\]\(([^)\s#]+)([^)\s]*)\)")
# Types and functions have a comment; what a name tells may do without: members,
# constants, operators.
PLAIN = re.compile(r"Member (operator|.*(\((variable|friend)\)|of (class|struct|union)))"
                   ".* is not documented")


def stop(problems):
    sys.exit("\n".join(["the site:", *problems]))


def make_api(folder, work):
    """The pages of Doxygen. Ends where it warns, or a symbol has no comment."""
    subprocess.run([sys.executable, "-B", ROOT / "port/c/make_api.py",
                    ROOT / "build/port/c"], check=True)
    warnings = work / "warnings.txt"
    settings = (ROOT / "docs/Doxyfile").read_text()
    folder.mkdir(parents=True)
    subprocess.run(["doxygen", "-"], cwd=ROOT, check=True, text=True,
                   input=f"{settings}\nOUTPUT_DIRECTORY={work}\nHTML_OUTPUT={folder}\n"
                         f"GENERATE_XML=NO\nWARN_LOGFILE={warnings}\n")
    problems = [line for line in warnings.read_text().splitlines()
                if "warning:" in line and not PLAIN.search(line)]
    if problems:
        stop(problems)


def page_of(header):
    """The name that Doxygen gives to the page of a header."""
    return header.name.replace("_", "__").replace(".", "_8") + "_source.html"


def stage(name, folder, api):
    """Copies a page with what it links; returns the pages that it links."""
    path = ROOT / name
    pages = []

    def link(found):
        target = (path.parent / found.group(1)).resolve()
        if re.match("[a-z]+:", found.group(1)):
            return found.group(0)
        if target.suffix == ".md":
            pages.append(target.relative_to(ROOT).as_posix())
            return found.group(0)
        if (api / page_of(target)).exists():
            place = os.path.relpath(api / page_of(target), (folder / name).parent)
            return f"]({place})"
        copy = folder / target.relative_to(ROOT)
        copy.parent.mkdir(parents=True, exist_ok=True)
        shutil.copy(target, copy)
        return found.group(0)

    text = LINK.sub(link, path.read_text())
    text = re.sub(r"^<!--.*-->\n", "\n", text, flags=re.M)
    (folder / name).parent.mkdir(parents=True, exist_ok=True)
    (folder / name).write_text(text)
    return pages


def make(folder, work, version, seconds):
    """Makes the site, of that time since 1970, in a folder that is not there."""
    shutil.rmtree(work, ignore_errors=True)
    pages = work / "pages"
    make_api(pages / "api", work)
    names = ["README.md", *(name for part in PAGES.values() for name in part)]
    linked = {link for name in names for link in stage(name, pages, pages / "api")}
    if not linked <= set(names):
        stop([f"{name} is linked, and not in PAGES" for name in linked - set(names)])
    (pages / "wide.css").write_text("table { display: block; overflow-x: auto; }\n")
    (work / "mkdocs.yml").write_text("\n".join([
        f"site_name: Inkcell {version}", f"docs_dir: {pages}", f"site_dir: {folder}",
        "use_directory_urls: false", "strict: true",
        "theme: {name: mkdocs, highlightjs: false}", "extra_css: [wide.css]",
        "markdown_extensions:",
        "  - codehilite: {noclasses: true, guess_lang: false}",
        "nav:", "  - Inkcell: README.md",
        *(line for part, names in PAGES.items() for line in
          [f"  - {part}:", *(f"    - {name}" for name in names)]),
        "  - Reference: api/index.html", ""]))
    (pages / "licences").mkdir()
    for package in SHOWN_BY:
        shutil.copy(f"/usr/share/doc/{package}/copyright",
                    pages / f"licences/{package}.txt")
    subprocess.run(["mkdocs", "build", "--quiet", "--config-file", work / "mkdocs.yml"],
                   check=True, env={**os.environ, "SOURCE_DATE_EPOCH": str(seconds)})
    for name in ("404.html", "sitemap.xml", "sitemap.xml.gz"):  # of a server
        (folder / name).unlink()


if __name__ == "__main__":
    make(*map(pathlib.Path, sys.argv[1:3]), version="of a checkout", seconds=0)
