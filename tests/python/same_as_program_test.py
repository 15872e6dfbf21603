# SPDX-License-Identifier: BSD-3-Clause
"""Python finds what epcc_segment finds on the same image: labels, planes, line segments."""
import csv
import json

import numpy
import pytest

import epcc

png = pytest.importorskip("png", reason="python3-png reads the images")


def image_of(path):
    width, height, rows, _ = png.Reader(filename=str(path)).read()
    return numpy.vstack([numpy.asarray(row, numpy.uint16) for row in rows]).reshape(height, width)


@pytest.fixture
def scene(run_tool):
    folder = run_tool("epcc_scene", "a", "--noise", "stereo", "--out", ".")
    about = json.loads((folder / "a_000.json").read_text())
    camera = epcc.PinholeCamera(*[about[key] for key in ("width", "height", "fx", "fy", "cx", "cy")])
    return folder, image_of(folder / "a_000_depth.png"), camera, about


@pytest.mark.parametrize("mode", ["default", "paper"])
@pytest.mark.parametrize("noise", ["frame's own", "auto", "kinect-v1"])
def test_labels_and_planes(scene, run_tool, mode, noise):
    folder, depth, camera, about = scene
    chosen = [] if noise == "frame's own" else ["--noise", noise]
    run_tool("epcc_segment", "a_000_depth.png", "--mode", mode, *chosen, "--labels", "l.png", "--planes", "p.json",
             "--segments", "s.csv")
    parameters = epcc.Parameters() if mode == "default" else epcc.Parameters.for_paper()
    parameters.line_segments = True
    sensor = about["noise"] if noise == "frame's own" else noise
    result = epcc.segment(depth, camera, parameters, sensor, depth_scale=about["depth_scale"])

    assert len(result.planes) > 3
    assert numpy.array_equal(result.labels, image_of(folder / "l.png"))
    planes = json.loads((folder / "p.json").read_text())["planes"]
    assert len(planes) == len(result.planes)
    for plane, written in zip(result.planes, planes):
        numpy.testing.assert_allclose(plane.coefficients, written["coefficients"], rtol=1e-6, atol=1e-9)
        numpy.testing.assert_allclose(plane.centroid, written["centroid"], rtol=1e-6, atol=1e-9)
    with open(folder / "s.csv", newline="", encoding="utf-8") as file:
        lines = list(csv.DictReader(file))
    assert len(lines) == len(result.segments)
