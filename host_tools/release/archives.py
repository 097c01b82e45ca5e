"""Archives that are the same bytes wherever they are made: sorted, and of one time."""
import gzip
import io
import tarfile
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


def write_tgz(archive, folder, seconds):
    """The same as a tar file, packed by gzip."""
    with open(archive, "wb") as file, gzip.GzipFile(
            "", "wb", 9, file, seconds) as packed, tarfile.open(
            fileobj=packed, mode="w") as tar:
        for name, mode, data in contents(folder):
            entry = tarfile.TarInfo(name)
            entry.mode, entry.mtime, entry.size = mode, seconds, len(data)
            tar.addfile(entry, io.BytesIO(data))
