# SPDX-License-Identifier: BSD-3-Clause
"""epcc.segment(): depth images and clouds in, labels and planes out."""
import pickle

import numpy
import pytest

import epcc
from conftest import room_depth

# Unit normal towards the camera and distance: wall ahead, floor, wall to the right.
ROOM = numpy.array([[0, 0, -1, 3], [0, -1, 0, 1], [-1, 0, 0, 1.5]])


def assert_is_room(result):
    assert len(result.planes) == 3
    for plane, expected in zip(result.planes, ROOM):
        numpy.testing.assert_allclose(plane.coefficients, expected, atol=0.01)


def test_the_walls_and_the_floor_of_a_room(camera, depth):
    result = epcc.segment(depth, camera)
    assert_is_room(result)
    assert result.labels.shape == (240, 320) and result.labels.dtype == numpy.int32
    assert result.labels[100, 20] == 1 and result.labels[230, 100] == 2 and result.labels[60, 310] == 3
    counts = numpy.bincount(result.labels.ravel(), minlength=4)
    assert [plane.pixel_count for plane in result.planes] == list(counts[1:])
    assert counts[1] > counts[2] > counts[3]


def test_a_plane_has_what_the_library_says_of_it(camera, depth):
    result = epcc.segment(depth, camera)
    wall = result.planes[0]
    points = epcc.DepthFrame.from_depth(depth, camera).points()[result.labels == 1].astype(float)
    numpy.testing.assert_allclose(wall.centroid, points.mean(axis=0), atol=2e-3)
    numpy.testing.assert_allclose(wall.points_covariance, numpy.cov(points.T, bias=True), atol=2e-3)
    distances = wall.signed_distance(points)
    assert distances.shape == (len(points),)
    assert wall.rms == pytest.approx(numpy.sqrt(numpy.mean(distances**2)), rel=0.02)
    assert wall.coefficients_covariance.shape == (4, 4)
    assert numpy.all(numpy.linalg.eigvalsh(wall.coefficients_covariance) > -1e-12)
    assert 0.9 < wall.confidence <= 1.0
    assert numpy.linalg.norm(wall.coefficients[:3]) == pytest.approx(1.0)


def test_projected_points_lie_on_the_plane(camera, depth):
    wall = epcc.segment(depth, camera).planes[0]
    points = numpy.random.default_rng(1).uniform(-1, 1, (4, 5, 3))
    projected = wall.project(points)
    assert projected.shape == points.shape
    numpy.testing.assert_allclose(wall.signed_distance(projected), 0.0, atol=1e-12)
    offsets = wall.signed_distance(points)[..., None] * wall.coefficients[:3]
    numpy.testing.assert_allclose(projected + offsets, points, atol=1e-12)
    assert isinstance(wall.signed_distance([0, 0, 0]), float)
    assert wall.signed_distance([0, 0, 0]) == pytest.approx(wall.coefficients[3])
    with pytest.raises(epcc.InputError, match=r"\(\.\.\., 3\), not \(2,\)"):
        wall.project([1.0, 2.0])


def test_millimetres_and_other_scales(camera, depth):
    expected = epcc.segment(depth, camera).planes
    millimetres = numpy.round(1000 * depth).astype(numpy.uint16)
    assert_is_room(epcc.segment(millimetres, camera))
    tenths = numpy.round(10000 * depth).astype(numpy.uint16)
    assert_is_room(epcc.segment(tenths, camera, depth_scale=1e-4))
    planes = epcc.segment((1000 * depth).astype(numpy.float32), camera, depth_scale=0.001).planes
    assert planes[0].rms == pytest.approx(expected[0].rms, rel=1e-3)


def test_a_frame_without_a_valid_pixel_has_no_planes(camera):
    for empty in (numpy.zeros((240, 320), numpy.uint16), numpy.full((240, 320), numpy.nan, numpy.float32)):
        result = epcc.segment(empty, camera)
        assert result.planes == [] and not result.labels.any()


def test_labels_outlive_the_result_and_the_next_frame(camera, depth):
    extractor = epcc.PlaneExtractor()
    labels = extractor.extract(depth, camera).labels
    before = labels.copy()
    extractor.extract(room_depth(camera)[::-1], camera)
    assert labels.base is not None and not labels.flags.owndata
    assert numpy.array_equal(labels, before)


def test_planes_outlive_the_result(camera, depth):
    coefficients = epcc.segment(depth, camera).planes[0].coefficients
    numpy.testing.assert_allclose(coefficients, ROOM[0], atol=0.01)
    with pytest.raises(ValueError):
        coefficients[0] = 1.0


def test_a_plane_can_be_pickled_and_shown(camera, depth):
    wall = epcc.segment(depth, camera).planes[0]
    copy = pickle.loads(pickle.dumps(wall))
    for name in ("coefficients", "coefficients_covariance", "centroid", "points_covariance", "rms", "pixel_count",
                 "confidence"):
        assert numpy.array_equal(getattr(copy, name), getattr(wall, name)), name
    assert repr(copy) == repr(wall) and f"{wall.pixel_count} pixels" in repr(wall)


def test_line_segments_are_a_structured_array(camera, depth):
    assert len(epcc.segment(depth, camera).segments) == 0
    result = epcc.segment(depth, camera, epcc.Parameters(line_segments=True))
    segments = result.segments
    assert len(segments) > 100 and not segments.flags.owndata
    assert set(numpy.unique(segments["scan"])) == {0, 1}
    columns = segments[segments["scan"] == 0]
    assert columns["line"].max() < 320 and columns["last"].max() < 240
    assert numpy.all(segments["first"] < segments["last"])
    on_wall = segments[segments["label"] == 1]
    for end in ("start", "end"):
        assert numpy.abs(result.planes[0].signed_distance(on_wall[end])).max() < 0.1
    # A column's t1 is the distance from the x axis, its t2 is y.
    wall = columns[columns["label"] == 1][0]
    middle = (wall["start"] + wall["end"]) / 2
    assert wall["mean"][0] == pytest.approx(numpy.hypot(middle[0], middle[2]), abs=0.05)
    assert wall["mean"][1] == pytest.approx(middle[1], abs=0.1)
    assert wall["covariance"].shape == (2, 2) and wall["variance"] < 1e-3
    # theta . (t1, t2) = 1 on the line, with a covariance for which 1/theta . ray is known to millimetres there.
    assert wall["theta"] @ wall["mean"] == pytest.approx(1.0, abs=1e-2)
    assert 0.0 < numpy.sqrt(wall["mean"] @ wall["theta_covariance"] @ wall["mean"]) < 1e-2


def test_times_and_sensor_are_told(camera, depth):
    result = epcc.segment(depth, camera)
    assert 0.0 < result.times.lines < result.times.total < 60.0
    assert result.sensor.sigma_z(2.0) == pytest.approx(0.0045, rel=0.5)
    assert result.geometry is None


def test_a_cloud_gives_the_planes_of_its_image(camera, depth, cloud):
    result = epcc.segment(cloud)
    assert_is_room(result)
    assert result.geometry.is_plain and result.geometry.projection == "perspective"
    assert numpy.mean(result.labels == epcc.segment(depth, camera).labels) > 0.99


def test_the_paper_mode(camera, depth):
    result = epcc.segment(depth, camera, epcc.Parameters.for_paper(), "0.0005,0.001,1")
    assert len(result.planes) >= 3
    assert all(plane.confidence == 1.0 for plane in result.planes)


def test_labels_of_others_get_their_planes(camera, depth):
    frame = epcc.DepthFrame.from_depth(depth, camera)
    found = epcc.segment(frame)
    labels = numpy.choose(found.labels, [-7, 5, 1, 9])
    fitted = epcc.fit_planes(frame, found.sensor, labels)
    assert_is_room(fitted)
    assert numpy.array_equal(fitted.labels, found.labels)
    with pytest.raises(epcc.InputError, match="not that of the frame"):
        epcc.fit_planes(frame, None, labels[1:])


def test_labels_of_others_get_their_lines(camera, depth):
    frame = epcc.DepthFrame.from_depth(depth, camera)
    labels = numpy.zeros(depth.shape, numpy.uint8)
    labels[20:60, 10:13] = 4
    fitted = epcc.fit_lines(frame, None, labels)
    assert len(fitted.planes) == 0 and numpy.array_equal(fitted.labels, labels)
    segments = fitted.segments
    assert [numpy.count_nonzero(segments["scan"] == scan) for scan in (0, 1)] == [3, 40]
    assert set(segments["line"][:3]) == {10, 11, 12} and set(segments["label"]) == {4}
    assert numpy.all(segments["first"][:3] == 20) and numpy.all(segments["last"][:3] == 59)
    assert numpy.all(numpy.linalg.eigvalsh(segments["theta_covariance"]) > 0.0)
    with pytest.raises(epcc.InputError, match="not that of the frame"):
        epcc.fit_lines(frame, None, labels[1:])


def test_doubts_are_fields_and_words(camera, depth):
    result = epcc.segment(depth, camera)
    assert not result.doubts.any() and result.doubts.in_words() == ""
    assert not result.doubts.sensor_is_generic and not result.doubts.bytes_are_swapped
    assert 0 < result.doubts.error_share < 0.01
    assert 0 <= result.doubts.jump_share < 0.1
    assert result.doubts.scattered_share == 1.0
    assert result.doubts.limit_share == result.doubts.limit_depth == 0.0
    with pytest.raises(AttributeError):
        result.doubts.error_share = 0


def test_doubts_outlive_their_result(camera, depth):
    doubts = epcc.segment((1000 * depth).astype(numpy.uint16).byteswap(), camera).doubts
    epcc.segment(depth, camera)
    assert doubts.any() and doubts.bytes_are_swapped
    assert "wrong order" in doubts.in_words() and doubts.in_words() in repr(doubts)


def test_few_pixels_are_doubted(camera, depth):
    kept = numpy.random.default_rng(1).random(depth.shape) < 0.03
    doubts = epcc.segment(numpy.where(kept, depth, 0), camera).doubts
    assert doubts.scattered_share == pytest.approx(0.03, abs=0.005)
    assert "only" in doubts.in_words()
