"""Lists of what a file of a release holds, in SPDX 2.3."""
import hashlib
import json
import time


def relationship(one, how, other):
    return {"spdxElementId": one, "relationshipType": how,
            "relatedSpdxElement": other}


def listing(name, version, files, seconds):
    """The list of a piece as JSON. `files`: names in the piece and their bytes."""
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
    piece = f"SPDXRef-{name}"
    return json.dumps({
        "spdxVersion": "SPDX-2.3", "dataLicense": "CC0-1.0",
        "SPDXID": "SPDXRef-DOCUMENT", "name": f"{name}-{version}",
        # Not a page: a name that no other list has.
        "documentNamespace": f"https://inkcell.invalid/spdx/{name}-{version}-{code}",
        "creationInfo": {
            "created": time.strftime("%Y-%m-%dT%H:%M:%SZ", time.gmtime(seconds)),
            "creators": ["Tool: inkcell-release"]},
        "packages": [{
            "SPDXID": piece, "name": name, "versionInfo": version,
            "downloadLocation": "NOASSERTION", "filesAnalyzed": True,
            "packageVerificationCode": {"packageVerificationCodeValue": code},
            "licenseConcluded": "MIT", "licenseDeclared": "MIT",
            "licenseInfoFromFiles": ["NOASSERTION"],
            "copyrightText": "NOASSERTION"}],
        "files": entries,
        "relationships": [
            relationship("SPDXRef-DOCUMENT", "DESCRIBES", piece),
            *(relationship(piece, "CONTAINS", entry["SPDXID"])
              for entry in entries)]}, indent=1) + "\n"
