# SPDX-License-Identifier: MIT
"""Builds the package, for pip: PEP 517 and 660.

One file is compiled, native.c: with the single header of the library, which
`make single` writes in a clone and which an sdist holds; or, if the environment
variable ROLLCOIN_SYSTEM is set, linked to the shared library that pkg-config
finds.  CC and CFLAGS are the compiler, cc, and its flags, -O2.
"""
import base64
import hashlib
import io
import os
import pathlib
import re
import shlex
import subprocess
import sysconfig
import tarfile
import tempfile
import zipfile

HERE = pathlib.Path(__file__).resolve().parent
PACKAGE = HERE / "src" / "rollcoin"
CLONE = (HERE / ".." / ".." / "..").resolve()
DATE = 315532800  # 1980, the first that a zip can hold: equal bytes

METADATA = """\
Metadata-Version: 2.1
Name: rollcoin
Version: {version}
Summary: The motion of a coin on a table: librollcoin in Python
License: MIT
Requires-Python: >=3.9
Provides-Extra: tables
Requires-Dist: numpy; extra == "tables"
Description-Content-Type: text/markdown

"""

WHEEL = """\
Wheel-Version: 1.0
Generator: rollcoin
Root-Is-Purelib: false
Tag: {tag}
"""


# --------------------------------------------------------------------- compiling
def run(*command):
    """What a command prints; it does not see the flags of an outer make.  Its
    own words are the error, if it fails."""
    environment = {name: value for name, value in os.environ.items()
                   if name not in ("MAKEFLAGS", "MAKELEVEL", "MFLAGS")}
    try:
        return subprocess.run(command, check=True, text=True, env=environment,
                              stdout=subprocess.PIPE).stdout
    except FileNotFoundError:
        raise SystemExit(f"rollcoin: needs {command[0]}") from None
    except subprocess.CalledProcessError as error:
        raise SystemExit(f"rollcoin: {command[0]} failed: "
                         f"{error.returncode}") from None


def single_header(folder):
    """The folder of the single header; made in `folder` if there is none."""
    if (HERE / "coin.h").exists():
        return HERE
    if not (CLONE / "lib" / "about" / "single.awk").exists():
        raise SystemExit(f"{HERE} is neither an sdist nor in a clone of "
                         "rollcoin: there is no library to build from")
    run("make", "-s", "-C", str(CLONE), f"O={folder}", "single")
    return pathlib.Path(folder) / "single"


def installed():
    """Flags for the library that pkg-config finds, and where it is."""
    found = shlex.split(run("pkg-config", "--cflags", "--libs", "rollcoin"))
    folder = run("pkg-config", "--variable=libdir", "rollcoin").strip()
    return ["-DROLLCOIN_SYSTEM", *found, f"-Wl,-rpath,{folder}"]


def compiled(target):
    """native.c, as the shared object that ctypes loads."""
    with tempfile.TemporaryDirectory() as folder:
        library = (installed() if os.environ.get("ROLLCOIN_SYSTEM")
                   else [f"-I{single_header(folder)}"])
        run(*shlex.split(os.environ.get("CC", "cc")), "-std=c99",
            *shlex.split(os.environ.get("CFLAGS", "-O2")), "-shared", "-fPIC",
            "-fvisibility=hidden", str(PACKAGE / "native.c"), "-o",
            str(target), *library, "-lm")


def version():
    for header in (HERE / "coin.h", CLONE / "include" / "coin.h"):
        if header.exists():
            return ".".join(re.findall(r"^#define COIN_VERSION_[MP]\w+ (\d+)",
                                       header.read_text(), re.M)[:3])
    raise SystemExit(f"{HERE} is neither an sdist nor in a clone of rollcoin")


# ------------------------------------------------------------------------ wheels
def tag(native=b""):
    """Any Python 3: what is compiled is loaded by ctypes.  It names the newest
    version of glibc whose symbols it needs, by which pip knows where it runs."""
    platform = re.sub(r"[-.]", "_", sysconfig.get_platform())
    glibc = [int(minor) for minor in re.findall(rb"GLIBC_2\.(\d+)", native)]
    if glibc and not os.environ.get("ROLLCOIN_SYSTEM"):
        platform = platform.replace("linux", f"manylinux_2_{max(17, *glibc)}")
    return f"py3-none-{platform}"


def info():
    return f"rollcoin-{version()}.dist-info"


def metadata(tagged):
    """{name: bytes} of what says what the package is."""
    readme = (HERE / "README.md").read_text()
    text = METADATA.format(version=version()) + readme
    return {f"{info()}/METADATA": text.encode(),
            f"{info()}/WHEEL": WHEEL.format(tag=tagged).encode()}


def prepare_metadata_for_build_wheel(metadata_directory, config_settings=None):
    """Without which pip would build twice."""
    folder = pathlib.Path(metadata_directory)
    (folder / info()).mkdir()
    for name, data in metadata(tag()).items():
        (folder / name).write_bytes(data)
    return info()


prepare_metadata_for_build_editable = prepare_metadata_for_build_wheel


def wheel(folder, files, tagged):
    """Writes a wheel of {name: bytes}; returns its name."""
    files = {**files, **metadata(tagged)}
    record = [f"{name},{digest(data)},{len(data)}"
              for name, data in sorted(files.items())]
    files[f"{info()}/RECORD"] = "\n".join([*record, f"{info()}/RECORD,,",
                                           ""]).encode()
    name = f"rollcoin-{version()}-{tagged}.whl"
    with zipfile.ZipFile(pathlib.Path(folder) / name, "w",
                         zipfile.ZIP_DEFLATED) as archive:
        for path, data in sorted(files.items()):
            entry = zipfile.ZipInfo(path)
            entry.external_attr = 0o644 << 16
            entry.compress_type = zipfile.ZIP_DEFLATED
            archive.writestr(entry, data)
    return name


def digest(data):
    raw = base64.urlsafe_b64encode(hashlib.sha256(data).digest())
    return "sha256=" + raw.decode().rstrip("=")


def sources():
    return sorted(path for path in PACKAGE.iterdir()
                  if path.suffix in (".py", ".c", ".h", ".typed"))


def build_wheel(wheel_directory, config_settings=None,
                metadata_directory=None):
    with tempfile.TemporaryDirectory() as folder:
        native = pathlib.Path(folder) / "_native.so"
        compiled(native)
        files = {f"rollcoin/{path.name}": path.read_bytes()
                 for path in [*sources(), native]
                 if path.suffix not in (".c", ".h")}
    return wheel(wheel_directory, files, tag(files["rollcoin/_native.so"]))


def build_editable(wheel_directory, config_settings=None,
                   metadata_directory=None):
    """The sources are used where they are, with what is compiled beside."""
    compiled(PACKAGE / "_native.so")
    return wheel(wheel_directory,
                 {"rollcoin.pth": f"{PACKAGE.parent}\n".encode()}, tag())


def build_sdist(sdist_directory, config_settings=None):
    """All that build_wheel() needs, the single header included."""
    base = f"rollcoin-{version()}"
    with tempfile.TemporaryDirectory() as folder:
        files = {name: (HERE / name).read_bytes()
                 for name in ("backend.py", "pyproject.toml", "README.md")}
        files["coin.h"] = (single_header(folder) / "coin.h").read_bytes()
        files["PKG-INFO"] = METADATA.format(version=version()).encode()
        for path in sources():
            files[f"src/rollcoin/{path.name}"] = path.read_bytes()
    name = f"{base}.tar.gz"
    with tarfile.open(pathlib.Path(sdist_directory) / name, "w:gz",
                      format=tarfile.PAX_FORMAT) as archive:
        for path, data in sorted(files.items()):
            entry = tarfile.TarInfo(f"{base}/{path}")
            entry.size, entry.mtime = len(data), DATE
            archive.addfile(entry, io.BytesIO(data))
    return name
