"""Lists of what a file of a release holds, in SPDX 2.3."""
import hashlib
import json
import re
import time
import typing


class Part(typing.NamedTuple):
    """What is linked into a piece, or a face in it."""
    name: str
    version: str
    licence: str


def relationship(one, how, other):
    return {"spdxElementId": one, "relationshipType": how,
            "relatedSpdxElement": other}


def reference(name):
    return "SPDXRef-" + re.sub(r"[^\w.-]", "-", name)


def package(name, version, licence, **more):
    return {"SPDXID": reference(name), "name": name, "versionInfo": version,
            "downloadLocation": "NOASSERTION", "filesAnalyzed": False,
            "licenseConcluded": licence, "licenseDeclared": licence,
            "copyrightText": "NOASSERTION", **more}


def listing(name, version, files, seconds, parts=()):
    """The list of a piece as JSON. `files`: names in the piece and their bytes;
    `parts` are each there once."""
    entries = [{"SPDXID": f"SPDXRef-file-{i}", "fileName": f"./{path}",
                "checksums": [{"algorithm": kind.upper(), "checksumValue":
                               hashlib.new(kind, data).hexdigest()}
                              for kind in ("sha1", "sha256")],
                "licenseConcluded": "NOASSERTION",
                "licenseInfoInFiles": ["NOASSERTION"],
                "copyrightText": "NOASSERTION"}
               for i, (path, data) in enumerate(files)]
    sums = sorted(entry["checksums"][0]["checksumValue"] for entry in entries)
    code = hashlib.sha1("".join(sums).encode()).hexdigest()
    piece = reference(name)
    return json.dumps({
        "spdxVersion": "SPDX-2.3", "dataLicense": "CC0-1.0",
        "SPDXID": "SPDXRef-DOCUMENT", "name": f"{name}-{version}",
        # Not a page: a name that no other list has.
        "documentNamespace": f"https://inkcell.invalid/spdx/{name}-{version}-{code}",
        "creationInfo": {
            "created": time.strftime("%Y-%m-%dT%H:%M:%SZ", time.gmtime(seconds)),
            "creators": ["Tool: inkcell-release"]},
        "packages": [
            package(name, version, " AND ".join(sorted(
                {"MIT", *(f"({part.licence})" if " OR " in part.licence else
                          part.licence for part in parts)})), filesAnalyzed=True,
                packageVerificationCode={"packageVerificationCodeValue": code},
                licenseDeclared="MIT", licenseInfoFromFiles=["NOASSERTION"]),
            *(package(part.name, part.version, part.licence) for part in parts)],
        "files": entries,
        "relationships": [
            relationship("SPDXRef-DOCUMENT", "DESCRIBES", piece),
            *(relationship(piece, "CONTAINS", entry["SPDXID"])
              for entry in entries),
            *(relationship(piece, "STATIC_LINK", reference(part.name))
              for part in parts)]}, indent=1) + "\n"
