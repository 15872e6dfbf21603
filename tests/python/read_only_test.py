# SPDX-License-Identifier: BSD-3-Clause
"""No array that a result has may be written to: it is the result's memory, or a copy that the next look would not see."""
import gc

import numpy
import pytest

import epcc
from conftest import room_depth

SENSOR = epcc.SensorModel.axial(0.0005, 0.001, 0.0)


def arrays_of(thing):
    """Name and array of each property that is one."""
    found = {}
    for name in dir(type(thing)):
        if isinstance(getattr(type(thing), name), property):
            value = getattr(thing, name)
            if isinstance(value, numpy.ndarray):
                found[name] = value
    return found


def expect_read_only(thing, *names):
    """Its arrays are those of these names, and none can be written to."""
    found = arrays_of(thing)
    assert sorted(found) == sorted(names)
    for name, array in found.items():
        assert not array.flags.writeable, name
        with pytest.raises(ValueError, match="read-only"):
            array[...] = 0
        with pytest.raises(ValueError, match="WRITEABLE"):
            array.flags.writeable = True


@pytest.fixture
def segmented(camera):
    return epcc.segment(room_depth(camera), camera, sensor=SENSOR, parameters=epcc.Parameters(line_segments=True))


def test_of_a_segmentation(segmented):
    expect_read_only(segmented, "labels", "segments")
    expect_read_only(segmented.planes[0], "coefficients", "coefficients_covariance", "centroid", "points_covariance")
    expect_read_only(segmented.contours(1)[0], "points")


def test_of_a_tracker(camera):
    tracker = epcc.PlaneTracker(sensor=SENSOR)
    for k in range(4):
        frame = tracker.track(room_depth(camera, seed=k), camera, time=k / 30)
    expect_read_only(frame, "labels", "label_of_plane", "pose", "pose_covariance", "pose_information")
    expect_read_only(tracker.tracks[0], "coefficients", "coefficients_covariance", "centroid")
    pose, plane, before = frame.pose, tracker.tracks[0].coefficients, frame.pose.copy()
    del frame, tracker
    gc.collect()
    numpy.testing.assert_array_equal(pose, before)  # it keeps what it looks into
    assert numpy.linalg.norm(plane[:3]) == pytest.approx(1.0)


def test_of_a_stream(camera):
    lines = []
    depth = room_depth(camera)
    stream = epcc.ScanLineStream(epcc.StreamGeometry.camera_columns(camera), sensor=SENSOR, on_line=lines.append)
    for column in range(camera.width):
        stream.add_column(column, depth[:, column])
    stream.finish()
    for array in arrays_of(lines[0]).values():
        assert not array.flags.writeable
    assert sorted(arrays_of(lines[0])) == ["labels", "runs"]


def test_of_a_sensor_that_was_measured(camera):
    pool = epcc.SensorPool()
    pool.add(room_depth(camera), camera)
    expect_read_only(pool.measure(), "blocks", "bins", "correlation", "correlation_fit")


def test_a_copy_may_be_changed(segmented):
    labels = segmented.labels.copy()
    labels[labels == 1] = 2
    assert (segmented.labels == 1).any()
