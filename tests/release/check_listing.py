"""Checks an unpacked piece of a release: it has LICENSE, and a list of SPDX that
names every other file with its sums, once, but RECORD of a wheel, which names it.
Licences are expressions of SPDX. Packages of Debian have copyright, as lintian asks.

Usage: /usr/bin/python3 check_listing.py FOLDER
"""
import hashlib
import json
import pathlib
import sys

from license_expression import ExpressionError, get_spdx_licensing


def main():
    folder = pathlib.Path(sys.argv[1])
    listing, = folder.rglob("*.spdx.json")
    if not any(folder.rglob("LICENSE")) and not any(folder.glob("*.deb")):
        sys.exit(f"{folder}: no LICENSE")
    document = json.loads(listing.read_text())
    named = sorted((entry["fileName"],
                    *(one["checksumValue"] for one in entry["checksums"]))
                   for entry in document["files"])
    there = sorted((f"./{path.relative_to(folder).as_posix()}",
                    hashlib.sha1(path.read_bytes()).hexdigest(),
                    hashlib.sha256(path.read_bytes()).hexdigest())
                   for path in folder.rglob("*")
                   if path.is_file() and path != listing and
                   not (path.name == "RECORD" and path.parent == listing.parent))
    if named != there:
        sys.exit(f"{listing} and the files differ in {set(named) ^ set(there)}")
    ids = {one["SPDXID"] for one in (document, *document["packages"],
                                     *document["files"])}
    for relation in document["relationships"]:
        if not {relation["spdxElementId"], relation["relatedSpdxElement"]} <= ids:
            sys.exit(f"{listing}: {relation} of what is not there")
    licensing = get_spdx_licensing()
    for package in document["packages"]:
        for kind in ("licenseConcluded", "licenseDeclared"):
            try:
                licensing.parse(package[kind], validate=True, strict=True)
            except ExpressionError as error:
                sys.exit(f"{listing}: {kind} of {package['name']}: {error}")
    print(f"{folder.name}: {len(there)} files")


main()
