# SPDX-License-Identifier: BSD-3-Clause
"""What the tests of the Python module share: a room's corner rendered with numpy, and the project's programs."""
import os
import subprocess
from pathlib import Path

import numpy
import pytest

import epcc

TOP = Path(__file__).resolve().parents[2]


def room_depth(camera, noise=0.001, seed=0):
    """Metres, H x W float32: a floor 1 m below the camera, a wall 3 m ahead, another 1.5 m to the right."""
    rows, columns = numpy.mgrid[0 : camera.height, 0 : camera.width]
    down, right = (rows - camera.cy) / camera.fy, (columns - camera.cx) / camera.fx
    depth = 1.0 / numpy.maximum(numpy.maximum(1.0 / 3.0, down / 1.0), right / 1.5)
    error = numpy.random.default_rng(seed).standard_normal(depth.shape) * noise * depth**2
    return (depth + error).astype(numpy.float32)


@pytest.fixture(scope="session")
def camera():
    return epcc.PinholeCamera(width=320, height=240, fx=200.0, fy=200.0, cx=159.5, cy=119.5)


@pytest.fixture(scope="session")
def depth(camera):
    depth = room_depth(camera)
    depth.flags.writeable = False  # nothing may write to a caller's image
    return depth


@pytest.fixture(scope="session")
def cloud(camera, depth):
    return epcc.DepthFrame.from_depth(depth, camera).points()


@pytest.fixture
def run_tool(tmp_path):
    """Runs a program of the project in an empty folder; skips where the programs are not built."""

    def run(name, *arguments):
        folder = os.environ.get("EPCC_BIN_DIR", "")
        if not os.path.exists(os.path.join(folder, name)):
            pytest.skip(f"{name} is not built")
        subprocess.run([os.path.join(folder, name), *arguments], cwd=tmp_path, check=True, stdout=subprocess.DEVNULL)
        return tmp_path

    return run
