# SPDX-License-Identifier: BSD-3-Clause
"""epcc.ScanLineStream finds in scan lines what the whole frame's scan finds, and says what it cannot use."""
import gc
import math
import weakref

import numpy
import pytest

import epcc

SENSOR = epcc.SensorModel.axial(0.001, 0.001)


def whole(frame, camera=None, rows=False, **options):
    parameters = epcc.Parameters.for_paper()
    parameters.scan = "rows" if rows else "columns"
    return epcc.segment(frame, camera, parameters, SENSOR, **options)


class Collected:
    """The labels (line x sample) and planes of a stream."""

    def __init__(self, geometry, lines, first=0, **options):
        self.labels = numpy.zeros((lines, geometry.height), numpy.int64)
        self.planes = {}
        self.first = first
        options.setdefault("sensor", SENSOR)
        self.stream = epcc.ScanLineStream(geometry, on_plane=self.take_plane, on_line=self.take_line, **options)

    def take_plane(self, found):
        self.planes[found.id] = found

    def take_line(self, line):
        self.labels[line.index - self.first] = line.labels
        for first, last, plane in line.runs:
            assert plane not in self.planes, "a plane comes behind its lines"
            assert (line.labels[first : last + 1] == plane).all()

    def expect(self, result, labels):
        """The same regions, and the same planes. labels: H x W, of the stream."""
        assert len(self.planes) == len(result.planes) >= 3
        for number, found in self.planes.items():
            there = numpy.unique(result.labels[labels == number])
            assert len(there) == 1 and there[0] > 0
            assert ((result.labels == there[0]) == (labels == number)).all()
            plane = result.planes[there[0] - 1]
            assert found.plane.pixel_count == plane.pixel_count
            numpy.testing.assert_allclose(found.plane.coefficients, plane.coefficients, atol=1e-8)


def in_units(depth, scale):
    return numpy.round(depth / scale).astype(numpy.uint16)


@pytest.mark.parametrize("rows", [False, True])
@pytest.mark.parametrize("kind", ["metres", "millimetres", "quarters"])
def test_a_camera_is_the_whole_frame(camera, depth, rows, kind):
    scale = {"metres": None, "millimetres": None, "quarters": 0.00025}[kind]
    image = depth if kind == "metres" else in_units(depth, scale or 0.001)
    result = whole(image, camera, rows, depth_scale=scale)
    make = epcc.StreamGeometry.camera_rows if rows else epcc.StreamGeometry.camera_columns
    collected = Collected(make(camera), camera.height if rows else camera.width)
    for i in range(len(collected.labels)):
        if rows:
            assert collected.stream.add_row(i, image[i], depth_scale=scale)
        else:
            assert collected.stream.add_column(i, image[:, i], depth_scale=scale)
    collected.stream.finish()
    collected.expect(result, collected.labels if rows else collected.labels.T)
    assert collected.stream.taken == len(collected.labels) and collected.stream.lost == 0


def test_what_is_not_measured_in_whole_numbers(camera, depth):
    image = in_units(depth, 0.001)
    image[::7, ::3] = 0
    image[::5, ::4] = 65535
    result = whole(image, camera)
    assert (result.labels[(image == 0) | (image == 65535)] == 0).all()
    collected = Collected(epcc.StreamGeometry.camera_columns(camera), camera.width)
    for i in range(camera.width):
        collected.stream.add_column(i, image[:, i])
    collected.stream.finish()
    collected.expect(result, collected.labels.T)


def test_float_depths_have_a_scale_as_well(camera, depth):
    centimetres = (100 * depth).astype(numpy.float32)
    result = whole(centimetres, camera, depth_scale=0.01)
    collected = Collected(epcc.StreamGeometry.camera_columns(camera), camera.width)
    for i in range(camera.width):
        collected.stream.add_column(i, centimetres[:, i], depth_scale=0.01)
    collected.stream.finish()
    collected.expect(result, collected.labels.T)


def test_arrays_of_any_stride(camera, depth):
    flipped = numpy.ascontiguousarray(depth[::-1])[::-1]
    collected = Collected(epcc.StreamGeometry.camera_columns(camera), camera.width)
    for i in range(camera.width):
        collected.stream.add_column(i, flipped[:, i])
    collected.stream.finish()
    collected.expect(whole(depth, camera), collected.labels.T)


def test_points_are_the_whole_cloud(cloud):
    geometry = epcc.StreamGeometry.points(cloud.shape[0], "perspective")
    collected = Collected(geometry, cloud.shape[1])
    for i in range(cloud.shape[1]):
        assert collected.stream.add_points(i, cloud[:, i])
    collected.stream.finish()
    frame = epcc.DepthFrame.from_points(cloud, epcc.CloudOptions(projection="perspective"))
    collected.expect(whole(frame), collected.labels.T)


STEP = -2.0 * math.pi / 600
ELEVATIONS = numpy.radians(numpy.linspace(12.0, -28.0, 24))
STAGGER = STEP * numpy.tile([6.0, 2.25, -2.0, -7.0], 6)


def room_ranges(azimuth):
    """Of all rings at their azimuths: walls 5 m ahead, 3 m behind, 2.5 m left, 3.5 m right, the floor 1.5 m down."""
    ahead, left, up = numpy.cos(azimuth), numpy.sin(azimuth), numpy.sin(ELEVATIONS)
    inverse = numpy.maximum.reduce([ahead / 5.0, -ahead / 3.0, left / 2.5, -left / 3.5]) * numpy.cos(ELEVATIONS)
    return (1.0 / numpy.maximum(inverse, -up / 1.5)).astype(numpy.float32)


@pytest.mark.parametrize("counted", [False, True])
@pytest.mark.parametrize("whole_numbers", [False, True])
def test_staggered_rings_show_the_planes_of_the_room(counted, whole_numbers):
    geometry = epcc.StreamGeometry.scanner(ELEVATIONS, STEP, STAGGER)
    assert geometry.is_staggered and geometry.kind == "scanner" and geometry.ring_azimuths == list(STAGGER)
    assert [geometry.ring_shift(ring) for ring in range(4)] == [-6, -2, 2, 7]
    collected = Collected(geometry, 600 + 13, first=-7, sensor=epcc.SensorModel.axial(0.003, 0.0))
    for i in range(600):
        values = room_ranges(i * STEP + STAGGER)
        scale = 0.002 if whole_numbers else None
        if whole_numbers:
            values = in_units(values, scale)
        if counted:
            assert collected.stream.add_column(i, values, i * STEP, depth_scale=scale)
        else:
            assert collected.stream.add_column_at(math.remainder(i * STEP, 2.0 * math.pi), values, depth_scale=scale)
    collected.stream.finish()
    assert (collected.labels > 0).mean() > 0.8
    found = numpy.array([p.plane.coefficients for p in collected.planes.values()])
    for expected in [(-1, 0, 0, 5), (1, 0, 0, 3), (0, -1, 0, 2.5), (0, 1, 0, 3.5), (0, 0, 1, 1.5)]:
        assert numpy.abs(found - expected).max(axis=1).min() < 2e-3, expected


def test_rings_that_are_not_staggered():
    geometry = epcc.StreamGeometry.scanner(list(ELEVATIONS), STEP)
    assert not geometry.is_staggered and geometry.ring_azimuths == [] and geometry.ring_shift(5) == 0
    assert geometry.projection == "spherical" and geometry.azimuth_step == STEP and geometry.height == 24
    with pytest.raises(IndexError):
        geometry.ring_shift(24)


def test_geometries_that_cannot_be():
    for azimuths, words in [
        (STAGGER[:-1], "there must be a ring azimuth for each of the 24 elevations, not 23"),
        (numpy.degrees(STAGGER), "ring azimuths must lie within pi/4 radians of the column's"),
        (numpy.full(24, numpy.nan), "ring azimuths must lie within pi/4 radians of the column's"),
    ]:
        with pytest.raises(epcc.InputError, match=words) as error:
            epcc.StreamGeometry.scanner(ELEVATIONS, STEP, azimuths)
        assert error.value.status == epcc.Status.INVALID_PARAMETERS
    with pytest.raises(epcc.InputError, match="azimuth step"):
        epcc.StreamGeometry.scanner(ELEVATIONS, 0.0)
    with pytest.raises(epcc.InputError, match="spherical"):
        epcc.StreamGeometry.points(10, "round")
    with pytest.raises(TypeError):
        epcc.StreamGeometry()


def test_what_cannot_be_a_line(camera, depth):
    stream = epcc.ScanLineStream(epcc.StreamGeometry.camera_columns(camera), sensor=SENSOR)
    column = numpy.ascontiguousarray(depth[:, 0])
    for scale in (0.0, -1.0, math.nan, math.inf):
        for values in (column, in_units(column, 0.001)):
            with pytest.raises(epcc.InputError, match="scale must be positive") as error:
                stream.add_column(0, values, depth_scale=scale)
            assert error.value.status == epcc.Status.INVALID_CAMERA
    with pytest.raises(epcc.InputError, match="has 240 samples, not 239"):
        stream.add_column(0, column[1:])
    with pytest.raises(epcc.InputError, match=r"not \(240, 320\)"):
        stream.add_column(0, depth)
    with pytest.raises(TypeError, match="float64"):
        stream.add_column(0, column.astype(float))
    with pytest.raises(TypeError, match="masked"):
        stream.add_column(0, numpy.ma.masked_array(column, column > 1))
    packed = numpy.zeros(240, [("flag", "u1"), ("depth", "f4")])
    with pytest.raises(epcc.InputError, match="ascontiguousarray"):
        stream.add_column(0, packed["depth"])
    for add in (lambda: stream.add_row(0, column), lambda: stream.add_column_at(0.0, column[:7]),
                lambda: stream.add_column(0, column, 0.0), lambda: stream.add_points(0, depth[:, :3])):
        with pytest.raises(epcc.InputError, match=r"columns of a camera: add_column\(index, values\)$") as error:
            add()
        assert error.value.status == epcc.Status.UNSUPPORTED_SCAN
    with pytest.raises(epcc.InputError, match="is not one of 0 to 319"):
        stream.add_column(320, column)
    assert stream.taken == 0
    points = epcc.ScanLineStream(epcc.StreamGeometry.points(4, "spherical"), sensor=SENSOR)
    with pytest.raises(epcc.InputError, match="N x 3"):
        points.add_points(0, numpy.zeros((4, 4), numpy.float32))
    with pytest.raises(epcc.InputError, match="follow one another"):
        points.add_points(0, numpy.zeros((3, 4), numpy.float32).T)
    with pytest.raises(epcc.InputError, match="has 4 samples, not 5"):
        points.add_points(0, numpy.zeros((5, 3), numpy.float32))
    with pytest.raises(TypeError):
        points.add_points(0, numpy.zeros((4, 3)))


def test_lines_that_come_late_are_left_out(camera, depth):
    stream = epcc.ScanLineStream(epcc.StreamGeometry.camera_columns(camera), sensor=SENSOR)
    assert stream.add_column(5, depth[:, 5])
    assert stream.add_column(5, depth[:, 5]) is False
    assert stream.add_column(3, depth[:, 3]) is False
    assert stream.add_column(8, depth[:, 8]) is True
    assert (stream.taken, stream.lost, stream.refused) == (2, 2, 2)
    stream.reset()
    assert (stream.taken, stream.lost, stream.refused) == (0, 0, 0)


def test_the_sensor_is_measured_unless_it_is_named(camera, depth):
    stream = epcc.ScanLineStream(epcc.StreamGeometry.camera_rows(camera), sensor="auto", measured_lines=100)
    for i in range(camera.height):
        assert stream.is_measuring == (i <= 100)
        stream.add_row(i, depth[i])
    assert stream.measured_blocks > 10
    assert 0.3 < stream.sensor.sigma_z(2.0) / 0.004 < 3.0
    named = epcc.ScanLineStream(epcc.StreamGeometry.camera_rows(camera), sensor="kinect-v1")
    assert not named.is_measuring
    with pytest.raises(epcc.InputError, match="measured_lines"):
        epcc.ScanLineStream(epcc.StreamGeometry.camera_rows(camera), measured_lines=1)
    parameters = epcc.Parameters()
    parameters.paper.min_segments = 100000
    none = Collected(epcc.StreamGeometry.camera_rows(camera), camera.height, parameters=parameters)
    for i in range(camera.height):
        none.stream.add_row(i, depth[i])
    none.stream.finish()
    assert none.planes == {} and not none.labels.any()


def test_open_planes_grow(camera, depth):
    stream = epcc.ScanLineStream(epcc.StreamGeometry.camera_rows(camera), sensor=SENSOR, lines_at_once=1)
    largest = 0
    for i in range(100):
        stream.add_row(i, depth[i])
        counts = [found.plane.pixel_count for found in stream.open_planes()]
        assert not counts or max(counts) >= largest
        largest = max(counts, default=largest)
    assert largest > 1000
    assert "StreamPlane 1, lines" in repr(stream.open_planes()[0])


def test_what_a_function_raises_comes_out_and_nothing_is_lost(camera, depth):
    heard = []

    def fails_once(found):
        heard.append(found.id)
        if len(heard) == 1:
            raise KeyError("the disk is full")

    stream = epcc.ScanLineStream(epcc.StreamGeometry.camera_columns(camera), sensor=SENSOR, on_plane=fails_once)
    for i in range(camera.width):
        if not heard:
            try:
                stream.add_column(i, depth[:, i])
            except KeyError:
                pass
        else:
            stream.add_column(i, depth[:, i])
    if not heard:
        with pytest.raises(KeyError):
            stream.finish()
    stream.finish()
    assert sorted(heard) == list(range(1, len(heard) + 1)) and len(heard) >= 3
    with pytest.raises(TypeError, match="on_plane must be a function"):
        stream.on_plane = 3
    stream.on_plane = None
    assert stream.on_plane is None and stream.on_line is None


def test_a_function_may_use_the_stream(camera, depth):
    seen = []
    stream = epcc.ScanLineStream(epcc.StreamGeometry.camera_rows(camera), sensor=SENSOR)
    stream.on_line = lambda line: seen.append((line.index, len(stream.open_planes()), stream.add_row(0, depth[0])))
    for i in range(camera.height):
        stream.add_row(i, depth[i])
    stream.on_plane = lambda found: seen.append(found.id)
    stream.finish()
    assert [entry[0] for entry in seen if isinstance(entry, tuple)][: camera.height] == list(range(camera.height))
    assert stream.refused >= camera.height - 40


def test_a_stream_whose_functions_hold_it_is_collected(camera):
    class Owner:
        def __init__(self):
            self.stream = epcc.ScanLineStream(epcc.StreamGeometry.camera_rows(camera), on_plane=self.take)

        def take(self, found):
            pass

    owner = Owner()
    gone = weakref.ref(owner)
    del owner
    gc.collect()
    assert gone() is None
