"""Checks an unpacked piece of a release: it has LICENSE, and a list of SPDX that
names every other file with its sums, once.

Usage: check_listing.py FOLDER
"""
import hashlib
import json
import pathlib
import sys


def main():
    folder = pathlib.Path(sys.argv[1])
    listing, = folder.rglob("*.spdx.json")
    if not any(folder.rglob("LICENSE")):
        sys.exit(f"{folder}: no LICENSE")
    document = json.loads(listing.read_text())
    named = sorted((entry["fileName"],
                    *(one["checksumValue"] for one in entry["checksums"]))
                   for entry in document["files"])
    there = sorted((f"./{path.relative_to(folder).as_posix()}",
                    hashlib.sha1(path.read_bytes()).hexdigest(),
                    hashlib.sha256(path.read_bytes()).hexdigest())
                   for path in folder.rglob("*")
                   if path.is_file() and path != listing)
    if named != there:
        sys.exit(f"{listing} and the files differ in {set(named) ^ set(there)}")
    ids = {one["SPDXID"] for one in (document, *document["packages"],
                                     *document["files"])}
    for relation in document["relationships"]:
        if not {relation["spdxElementId"], relation["relatedSpdxElement"]} <= ids:
            sys.exit(f"{listing}: {relation} of what is not there")
    print(f"{folder.name}: {len(there)} files")


main()
