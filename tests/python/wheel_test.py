# SPDX-License-Identifier: BSD-3-Clause
"""`pip wheel .` at the project's top makes a wheel that works, and leaves nothing beside the sources."""
import importlib.util
import os
import subprocess
import sys
import zipfile

import pytest

import epcc
from conftest import TOP

missing = [name for name in ("pip", "setuptools", "wheel") if importlib.util.find_spec(name) is None]

SCRIPT = """
import epcc, numpy
assert epcc.__file__.startswith({folder!r}), epcc.__file__
result = epcc.segment(numpy.full((48, 64), 2000, numpy.uint16), epcc.PinholeCamera(64, 48, 60, 60, 31.5, 23.5))
assert len(result.planes) == 1 and abs(result.planes[0].coefficients[3] - 2) < 1e-6, result
"""


def listing():
    ignored = {".git", "build", "results", "demo"}
    return sorted(str(path) for path in TOP.iterdir() if path.name not in ignored)


@pytest.mark.skipif(missing, reason=f"not installed: {', '.join('python3-' + name for name in missing)}")
def test_a_wheel(tmp_path):
    before = listing()
    # The flags of this build: what it has compiled comes from the compiler cache.
    environment = dict(os.environ, CMAKE_ARGS="-DEPCC_WARNINGS_AS_ERRORS=ON")
    subprocess.run([sys.executable, "-m", "pip", "wheel", TOP, "--no-build-isolation", "--no-deps", "--no-index",
                    "--disable-pip-version-check", "-w", tmp_path], check=True, env=environment)
    assert listing() == before
    (wheel,) = tmp_path.glob("epcc_segmentation-*.whl")
    assert wheel.name.startswith(f"epcc_segmentation-{epcc.__version__}-cp{sys.version_info[0]}{sys.version_info[1]}-")
    folder = tmp_path / "unpacked"
    with zipfile.ZipFile(wheel) as archive:
        names = {name for name in archive.namelist() if ".dist-info/" not in name}
        archive.extractall(folder)
    module = next(name for name in names if name.endswith(".so"))
    assert names == {"epcc/__init__.py", "epcc/__init__.pyi", "epcc/py.typed", module}
    assert module.startswith("epcc/_epcc.")
    environment = dict(os.environ, PYTHONPATH=str(folder))
    subprocess.run([sys.executable, "-c", SCRIPT.format(folder=str(folder))], check=True, env=environment, cwd=tmp_path)
