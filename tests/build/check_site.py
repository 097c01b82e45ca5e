"""Makes the documents as a site, and follows its links: each leads to a file of the
site, to a part of a page that is there, or to another site by https.

Usage: check_site.py WORK_FOLDER
"""
import html.parser
import re
import sys
import urllib.parse

from toolchains import ROOT, arguments, call, finish

# Loaded when a page is shown; only links may lead elsewhere.
LOADED = {("link", "href"), ("script", "src"), ("img", "src")}


class Page(html.parser.HTMLParser):
    """Names and links of a page."""

    def __init__(self, text):
        super().__init__()
        self.names, self.links = set(), []
        self.feed(text)

    def handle_starttag(self, tag, attributes):
        for name, value in attributes:
            if name == "id" or (tag == "a" and name == "name"):
                self.names.add(value)
            elif name in ("href", "src") and value:
                self.links.append((tag, name, value))


def problem_with(link, path, pages):
    """What is wrong with a link of a page."""
    tag, attribute, target = link
    parts = urllib.parse.urlsplit(target)
    if parts.scheme or parts.netloc:
        return ("loads from elsewhere" if (tag, attribute) in LOADED else
                "" if parts.scheme in ("https", "mailto") else "not by https")
    place = (path.parent / urllib.parse.unquote(parts.path)).resolve()
    if not parts.path:
        place = path
    if not place.is_file():
        return "no such file"
    name = urllib.parse.unquote(parts.fragment)
    if name and place in pages and name not in pages[place].names:
        return "no such part"
    return ""


def main():
    work, = arguments()
    site = work / "site"
    call(sys.executable, "-B", ROOT / "host_tools/release/documents.py", site, work / "work")
    pages = {path: Page(path.read_text()) for path in site.rglob("*.html")}
    problems, count = set(), 0
    for path, page in pages.items():
        for link in page.links:
            # Doxygen names a part for classes of a class though all are private.
            if re.match("javascript:|data:|#nested-classes", link[2]):
                continue
            count += 1
            wrong = problem_with(link, path, pages)
            if wrong:
                problems.add(f"{path.relative_to(site)}: {link[2]}: {wrong}")
    finish(count, sorted(problems))


main()
