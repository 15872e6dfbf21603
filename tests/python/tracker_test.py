# SPDX-License-Identifier: BSD-3-Clause
"""epcc.PlaneTracker: labels that last, poses, jumps of poses, and what is refused."""
import gc

import numpy
import pytest

import epcc
from conftest import room_depth

SENSOR = epcc.SensorModel.axial(0.0005, 0.001, 0.0)


def tracked_room(camera, frames, tracker, poses=None):
    """The room from one place, with other noise in each frame."""
    for k in range(frames):
        pose = None if poses is None else poses[k]
        yield tracker.track(room_depth(camera, seed=k), camera, pose=pose, time=k / 30)


def test_each_surface_has_one_label(camera):
    tracker = epcc.PlaneTracker(sensor=SENSOR)
    frames = list(tracked_room(camera, 12, tracker))
    assert not frames[0].labels.any(), "no label before the third frame"
    assert numpy.shape(frames[0].open_directions()) == (3, 3), "no plane was expected"
    assert sorted(tracker.label_of(track) for track in frames[0].track_of_plane) == [1, 2, 3]
    assert tracker.label_of(1000) is None
    for frame in frames[3:]:
        assert frame.labels.shape == (240, 320) and frame.labels.dtype == numpy.int32
        assert set(numpy.unique(frame.labels)) <= {0, 1, 2, 3}
        assert [frame.labels[at] for at in ((100, 20), (230, 100), (60, 310))] == \
            [frames[3].labels[at] for at in ((100, 20), (230, 100), (60, 310))]
        assert len(frame.segmentation.planes) == len(frame.label_of_plane) == 3
        for label, plane in zip(frame.label_of_plane, frame.segmentation.planes):
            assert numpy.count_nonzero(frame.labels == label) == plane.pixel_count
        numpy.testing.assert_allclose(frame.pose, numpy.eye(4), atol=0.01)
        assert frame.open_directions() == []
        assert frame.pose_covariance.shape == frame.pose_information.shape == (6, 6)
        assert frame.segmentation.sensor.sigma_z(2.0) == pytest.approx(SENSOR.sigma_z(2.0), rel=0.5)
    tracks = tracker.tracks
    assert [track.label for track in tracks] == [1, 2, 3]
    assert all(track.end == "none" and track.merged_into == 0 and track.frames == 12 for track in tracks)
    walls = sorted(abs(track.coefficients[3]) for track in tracks)
    numpy.testing.assert_allclose(walls, [1.0, 1.5, 3.0], atol=0.01)
    assert "PlaneTrack 1" in repr(tracks[0])
    assert tracker.error_scale >= 1.0


def test_labels_outlive_the_frame_that_holds_them(camera):
    tracker = epcc.PlaneTracker(sensor=SENSOR)
    frame = list(tracked_room(camera, 4, tracker))[-1]
    labels, before = frame.labels, frame.labels.copy()
    del frame, tracker
    gc.collect()
    numpy.testing.assert_array_equal(labels, before)


def test_a_jump_of_given_poses_is_noted(camera):
    poses = [numpy.eye(4) for _ in range(20)]
    for pose in poses[10:]:
        pose[:3, 3] = 0.3, 0.1, 0.4
    tracker = epcc.PlaneTracker(sensor=SENSOR)
    frames = list(tracked_room(camera, 20, tracker, poses))
    assert [frame.pose_jumped for frame in frames] == [k == 10 for k in range(20)]
    assert len(tracker.tracks) == 3


def test_what_cannot_be_used_is_refused_and_the_next_frame_taken(camera, depth):
    tracker = epcc.PlaneTracker(sensor=SENSOR)
    with pytest.raises(epcc.InputError, match="4 x 4 numbers"):
        tracker.track(depth, camera, pose=numpy.eye(3))
    with pytest.raises(epcc.InputError, match="has no rotation"):
        tracker.track(depth, camera, pose=numpy.diag([2.0, 1.0, 1.0, 1.0]))
    with pytest.raises(epcc.InputError, match="last row"):
        tracker.track(depth, camera, pose=numpy.ones((4, 4)))
    with pytest.raises(TypeError, match="4 x 4 numbers"):
        tracker.track(depth, camera, pose="here")
    with pytest.raises(epcc.InputError, match="time is not finite"):
        tracker.track(depth, camera, time=float("nan"))
    tracker.track(depth, camera, time=5.0)
    with pytest.raises(epcc.InputError, match="time is before that of the last frame"):
        tracker.track(depth, camera, time=1.0)
    with pytest.raises(epcc.InputError, match="confirm_frames must be from 1 to 1000"):
        epcc.PlaneTracker(confirm_frames=0)
    assert len(tracker.track(depth, camera, time=5.0).segmentation.planes) == 3


def test_clouds_in_other_units_and_frames_have_labels_that_last(camera, cloud):
    turned = numpy.ascontiguousarray(cloud[..., [2, 0, 1]] * numpy.float32([1000, -1000, -1000]))  # x forward, mm
    tracker = epcc.PlaneTracker(sensor=SENSOR)
    frames = [tracker.track(turned, pose=numpy.eye(4), time=k / 30) for k in range(6)]
    assert not frames[1].labels.any() and len(numpy.unique(frames[5].labels)) >= 4
    numpy.testing.assert_array_equal(frames[5].labels, frames[3].labels)
