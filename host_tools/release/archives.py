"""Archives that are the same bytes wherever they are made: sorted, and of one time."""
import time
import zipfile


def contents(folder):
    """Of each file of a folder, sorted: its name in the archive, mode and bytes."""
    for path in sorted(folder.rglob("*")):
        if path.is_file():
            mode = 0o755 if path.stat().st_mode & 0o100 else 0o644
            yield path.relative_to(folder).as_posix(), mode, path.read_bytes()


def write_zip(archive, folder, seconds):
    """A zip of what lies in the folder, all of it of that time."""
    with zipfile.ZipFile(archive, "w") as packed:
        for name, mode, data in contents(folder):
            entry = zipfile.ZipInfo(name, time.gmtime(seconds)[:6])
            entry.create_system = 3  # Unix, which has modes
            entry.external_attr = (0o100000 | mode) << 16
            packed.writestr(entry, data, zipfile.ZIP_DEFLATED, 9)
