# SPDX-License-Identifier: BSD-3-Clause
"""Clouds in any frame and unit, and the outlines of planes."""
import numpy
import pytest

import epcc

AXES = numpy.array([[0, 0, 1], [-1, 0, 0], [0, -1, 0]], float)  # a robot's frame: x forward, y left, z up
ORIGIN = numpy.array([0.3, -0.2, 1.5])


@pytest.fixture(scope="module")
def posed(cloud):
    return (cloud @ AXES.T + ORIGIN).astype(numpy.float32)


def test_where_a_camera_is_in_a_cloud(posed):
    geometry = epcc.find_geometry(posed)
    assert geometry.projection == "perspective" and not geometry.is_plain
    numpy.testing.assert_allclose(geometry.pose.axes, AXES, atol=0.02)
    numpy.testing.assert_allclose(geometry.pose.origin, ORIGIN, atol=0.05)
    assert geometry.unit == 1.0 and geometry.residual < 0.05


def test_planes_are_in_the_frame_of_the_cloud(posed):
    result = epcc.segment(posed)
    floor = result.planes[1]
    numpy.testing.assert_allclose(floor.coefficients, [0, 0, 1, -0.5], atol=0.02)  # z = 0.5: a metre below 1.5
    assert result.geometry.pose.origin == pytest.approx(ORIGIN, abs=0.05)
    frame = epcc.DepthFrame.from_points(posed, geometry=result.geometry)
    assert numpy.array_equal(epcc.segment(frame).labels, result.labels)
    numpy.testing.assert_allclose(frame.points(), posed, atol=1e-5)


def test_units(cloud):
    assert epcc.find_geometry(1000 * cloud).unit == 0.001 and epcc.find_geometry(1000 * cloud).unit_is_guessed
    centimetres = epcc.DepthFrame.from_points(100 * cloud, epcc.CloudOptions(unit=0.01))
    assert centimetres.geometry.unit == 0.01 and not centimetres.geometry.unit_is_guessed
    assert epcc.segment(centimetres).planes[0].coefficients[3] == pytest.approx(3.0, abs=0.01)


def test_a_viewpoint_is_tried(posed):
    options = epcc.CloudOptions(sensor="camera", viewpoint=epcc.SensorPose(AXES, ORIGIN))
    geometry = epcc.find_geometry(posed, options)
    numpy.testing.assert_allclose(geometry.pose.origin, ORIGIN, atol=1e-6)
    numpy.testing.assert_allclose(options.viewpoint.axes, AXES)


def test_a_scanner_and_its_rings():
    azimuth, elevation = numpy.meshgrid(numpy.linspace(numpy.pi, -numpy.pi, 720, endpoint=False),
                                        numpy.linspace(0.3, -0.3, 32))
    direction = numpy.stack([numpy.cos(elevation) * numpy.cos(azimuth), numpy.cos(elevation) * numpy.sin(azimuth),
                             numpy.sin(elevation)], axis=-1)
    room = 1 / numpy.max(numpy.abs(direction) / [4.0, 3.0, 1.5], axis=-1)  # a box of 8 x 6 x 3 m
    geometry = epcc.find_geometry((room[..., None] * direction).astype(numpy.float32))
    assert geometry.projection == "spherical" and geometry.grid.closes_round and not geometry.grid.rings_are_columns


def test_depths_beyond_the_range_are_none(cloud):
    frame = epcc.DepthFrame.from_points(cloud, epcc.CloudOptions(max_depth=2.0))
    assert numpy.nanmax(frame.points()[..., 2]) <= 2.0


def test_options_are_checked():
    options = epcc.CloudOptions(projection="spherical")
    assert options.projection == "spherical" and options.sensor == "any"
    options.projection = None
    assert options.projection is None
    with pytest.raises(ValueError, match="'radar' is none of 'any', 'camera', 'scanner'"):
        epcc.CloudOptions(sensor="radar")
    with pytest.raises(ValueError, match="'fisheye' is none of 'perspective'"):
        epcc.CloudOptions(projection="fisheye")
    with pytest.raises(epcc.InputError):
        epcc.CloudOptions(unit=-1.0)


def test_a_finder_serves_a_stream(posed, cloud):
    finder = epcc.GeometryFinder()
    for points in (posed, posed, cloud):
        assert finder.find(points).projection == "perspective"
    assert finder.find(cloud).is_plain


def test_outlines_of_a_ring():
    labels = numpy.zeros((10, 12), numpy.int64)
    labels[1:8, 2:9] = 3
    labels[3:6, 4:7] = 0
    outer, hole = epcc.trace_contours(labels, 3)
    assert not outer.is_hole and hole.is_hole
    assert outer.signed_area == 36 and hole.signed_area < 0
    assert outer.points.dtype == numpy.int32 and outer.points.shape == (24, 2)
    column, row = outer.points.T
    assert (labels[row, column] == 3).all()
    assert epcc.trace_contours(labels, 1) == [] and epcc.trace_contours(labels, 0) == []
    everything = epcc.trace_all_contours(labels, 3)
    assert [len(contours) for contours in everything] == [0, 0, 2]
    assert numpy.array_equal(everything[2][0].points, outer.points)


def test_outlines_of_planes(camera, depth):
    result = epcc.segment(depth, camera)
    all_contours = result.all_contours()
    assert len(all_contours) == 3
    for label, contours in enumerate(all_contours, 1):
        alone = result.contours(label)
        traced = epcc.trace_contours(result.labels, label)
        assert len(contours) == len(alone) == len(traced)
        assert all(numpy.array_equal(a.points, b.points) for a, b in zip(contours, alone))
    wall = all_contours[0][0].points
    del all_contours, alone
    assert (result.labels[wall[:, 1], wall[:, 0]] == 1).all()


def test_labels_that_are_no_image():
    with pytest.raises(epcc.InputError, match=r"H x W, not \(5,\)"):
        epcc.trace_contours(numpy.zeros(5, numpy.int32), 1)
    with pytest.raises(ValueError, match="label_count must not be negative"):
        epcc.trace_all_contours(numpy.zeros((5, 5), numpy.int32), -1)
    assert epcc.trace_contours(numpy.zeros((0, 5), numpy.int32), 1) == []
