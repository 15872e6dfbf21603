# SPDX-License-Identifier: BSD-3-Clause
"""Arrays are looked at where they lie: strides, flips, masks, and what keeps them alive."""
import gc
import sys
import tracemalloc

import numpy
import pytest

import epcc
from conftest import room_depth


def same(camera, image, expected):
    result = epcc.segment(image, camera)
    return numpy.array_equal(result.labels, expected.labels) and len(result.planes) == len(expected.planes)


@pytest.mark.parametrize("number", [numpy.float32, numpy.uint16])
def test_any_row_stride(camera, number):
    image = (room_depth(camera) * (1 if number == numpy.float32 else 1000)).astype(number)
    expected = epcc.segment(image, camera)
    assert len(expected.planes) == 3
    wide = numpy.full((240, 400), 7, number)
    wide[:, 40:360] = image
    assert same(camera, wide[:, 40:360], expected)
    every_second = numpy.full((480, 320), 7, number)
    every_second[::2] = image
    assert same(camera, every_second[::2], expected)
    assert same(camera, numpy.ascontiguousarray(image[::-1])[::-1], expected)  # bottom up: a negative stride


def test_rows_at_odd_bytes(camera):
    image = room_depth(camera)
    record = numpy.dtype({"names": ["row"], "formats": ["(320,)f4"], "offsets": [1], "itemsize": 1283})
    packed = numpy.zeros(240, record)
    packed["row"] = image
    assert packed["row"].strides[0] == 1283
    assert same(camera, packed["row"], epcc.segment(image, camera))


def test_the_image_is_not_copied(camera):
    big = epcc.PinholeCamera(2000, 2000, 1000, 1000, 999.5, 999.5)
    image = room_depth(big)
    tracemalloc.start()
    frame = epcc.DepthFrame.from_depth(image, big)
    peak = tracemalloc.get_traced_memory()[1]
    tracemalloc.stop()
    assert peak < 10000  # bytes; the image has 16 million
    image[:] = 2.0  # what is written later is seen
    assert numpy.nanmax(frame.points()[..., 2]) == 2.0


def test_a_frame_keeps_its_array_alive(camera):
    image = room_depth(camera)
    before = sys.getrefcount(image)
    frame = epcc.DepthFrame.from_depth(image, camera)
    assert sys.getrefcount(image) == before + 1
    masked = frame.masked(numpy.ones((240, 320), bool))
    del frame
    expected = epcc.segment(image, camera).labels
    del image
    gc.collect()
    assert numpy.array_equal(epcc.segment(masked).labels, expected)


def test_masked_pixels_are_not_measured(camera, depth):
    mask = numpy.ones((240, 320), bool)
    mask[:, 200:] = False
    frame = epcc.DepthFrame.from_depth(depth, camera).masked(mask)
    assert numpy.isnan(frame.points()[:, 200:]).all() and not numpy.isnan(frame.points()[:, :200]).any()
    assert not epcc.segment(frame).labels[:, 200:].any()
    with pytest.raises(epcc.InputError, match="not that of the frame"):
        frame.masked(mask[:, 1:])
    with pytest.raises(epcc.InputError, match="not contiguous"):
        frame.masked(numpy.ones((320, 240), bool).T)
    with pytest.raises(TypeError, match="bool or uint8, not float32"):
        frame.masked(mask.astype(numpy.float32))


def test_points_of_larger_records(cloud):
    with_colour = numpy.zeros((240, 320, 8), numpy.float32)
    with_colour[..., :3] = cloud
    assert numpy.array_equal(epcc.segment(with_colour[..., :3]).labels, epcc.segment(cloud).labels)


def test_how_a_depth_image_is_read(camera, depth):
    image = depth.copy()
    image[:50] = 42.0
    frame = epcc.DepthFrame.from_depth(image, camera, invalid=42.0, min_depth=1.0, max_depth=2.5)
    z = frame.points()[..., 2]
    assert numpy.isnan(z[:50]).all()
    assert numpy.nanmin(z) >= 1.0 and numpy.nanmax(z) <= 2.5
    rows, columns = numpy.mgrid[0:240, 0:320]
    rays = numpy.sqrt(1 + ((columns - 159.5) / 200) ** 2 + ((rows - 119.5) / 200) ** 2)
    frame = epcc.DepthFrame.from_depth((depth * rays).astype(numpy.float32), camera, is_distance=True)
    numpy.testing.assert_allclose(frame.points()[..., 2], depth, rtol=1e-5)
    assert (frame.width, frame.height, frame.projection, frame.geometry) == (320, 240, "perspective", None)


def test_a_point_of_an_image_is_where_the_camera_says(camera, depth):
    points = epcc.DepthFrame.from_depth(depth, camera).points()
    assert points.dtype == numpy.float32 and points.shape == (240, 320, 3)
    z = depth[30, 40]
    numpy.testing.assert_allclose(points[30, 40], [(40 - 159.5) / 200 * z, (30 - 119.5) / 200 * z, z], rtol=1e-6)
