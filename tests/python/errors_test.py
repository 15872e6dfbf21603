# SPDX-License-Identifier: BSD-3-Clause
"""Bad input is an exception that says in the library's words what is wrong; nothing crashes."""
import pickle
import subprocess
import sys

import numpy
import pytest

import epcc

IMAGE = numpy.ones((240, 320), numpy.float32)


def raised(call, *arguments, **keywords):
    with pytest.raises(epcc.InputError) as caught:
        call(*arguments, **keywords)
    assert "\n" not in str(caught.value)
    return caught.value


def test_kinds_of_errors():
    assert issubclass(epcc.EpccError, RuntimeError)
    assert issubclass(epcc.InputError, epcc.EpccError) and issubclass(epcc.InputError, ValueError)
    assert issubclass(epcc.OutOfMemoryError, epcc.EpccError) and issubclass(epcc.OutOfMemoryError, MemoryError)
    assert epcc.EpccError.__module__ == "epcc" and epcc.EpccError("x").status is None


def test_cameras_that_are_none():
    error = raised(epcc.PinholeCamera, 320, 240, 0.0, 200.0, 0.0, 0.0)
    assert str(error) == "fx and fy must be positive" and error.status == epcc.Status.INVALID_CAMERA
    assert str(raised(epcc.PinholeCamera, 0, 240, 1, 1, 0, 0)) == "the image size must be positive"
    assert str(raised(epcc.PinholeCamera, 320, 240, 1, 1, numpy.nan, 0)) == "cx and cy must be finite"


def test_a_camera_spoilt_later(camera):
    spoilt = pickle.loads(pickle.dumps(camera))
    assert spoilt == camera
    spoilt.fx = -1.0
    assert str(raised(spoilt.validate)) == "fx and fy must be positive"
    assert str(raised(epcc.segment, IMAGE, spoilt)) == "fx and fy must be positive"


def test_sizes_that_do_not_belong_together(camera):
    error = raised(epcc.segment, IMAGE[1:], camera)
    assert str(error) == "the camera's size is not that of the depth image"
    assert error.status == epcc.Status.SIZE_MISMATCH
    error = raised(epcc.segment, IMAGE[:0], camera)
    assert str(error) == "the depth image is empty" and error.status == epcc.Status.EMPTY_CLOUD
    assert "H x W, not (320,)" in str(raised(epcc.segment, IMAGE[0], camera))
    assert "H x W x 3, not (240, 320, 4)" in str(raised(epcc.segment, numpy.ones((240, 320, 4), numpy.float32)))


def test_memory_that_no_view_can_look_at(camera):
    wide = numpy.ones((240, 640), numpy.float32)
    assert "columns do not adjoin" in str(raised(epcc.segment, wide[:, ::2], camera))
    assert "columns do not adjoin" in str(raised(epcc.segment, IMAGE[:, ::-1], camera))
    repeated = numpy.broadcast_to(IMAGE[0], (240, 320))
    assert "row stride, in bytes, is less than a row" in str(raised(epcc.segment, repeated, camera))
    overlapping = numpy.lib.stride_tricks.as_strided(IMAGE, (240, 320), (8, 4))
    assert "row stride, in bytes, is less than a row" in str(raised(epcc.segment, overlapping, camera))
    points = numpy.ones((240, 320, 3), numpy.float32)
    for view in (points[::2], points[:, ::2][::-1], points.transpose(1, 0, 2), points[..., ::-1]):
        assert "do not follow one another in memory" in str(raised(epcc.segment, view))


def test_types_that_are_no_depth(camera):
    for number in (numpy.float64, numpy.int32, numpy.uint8, ">u2", ">f4", bool):
        with pytest.raises(TypeError, match="a depth image is uint16 or float32, not "):
            epcc.segment(IMAGE.astype(number), camera)
    with pytest.raises(TypeError, match="a cloud is float32, not float64"):
        epcc.segment(numpy.ones((240, 320, 3)))
    with pytest.raises(TypeError, match="None was given"):
        epcc.segment(None, camera)
    with pytest.raises(TypeError, match="needs its camera"):
        epcc.segment(IMAGE)
    with pytest.raises(TypeError, match="no camera"):
        epcc.segment(numpy.ones((240, 320, 3), numpy.float32), camera)
    with pytest.raises(TypeError, match="its camera"):
        epcc.segment(epcc.DepthFrame.from_depth(IMAGE, camera), camera)
    with pytest.raises(TypeError, match="sensor must be None, a str or an epcc.SensorModel, not float"):
        epcc.segment(IMAGE, camera, sensor=0.01)


def test_masked_arrays_are_not_taken_for_whole_ones(camera):
    for masked in (numpy.ma.masked_less(IMAGE, 2.0), numpy.ma.masked_less(numpy.ones((9, 9, 3), numpy.float32), 2.0)):
        with pytest.raises(TypeError, match="a masked array is not looked at"):
            epcc.segment(masked, camera if masked.ndim == 2 else None)


def test_lists_are_arrays_of_the_wrong_type():
    with pytest.raises(TypeError, match="a depth image is uint16 or float32, not float64"):
        epcc.segment([[1.0, 2.0]], epcc.PinholeCamera(2, 1, 1, 1, 0, 0))


LITTLE_MEMORY = """
import resource
import numpy, epcc
image = numpy.full((4000, 4000), 2000, numpy.uint16)
camera = epcc.PinholeCamera(4000, 4000, 3000, 3000, 2000, 2000)
extractor = epcc.PlaneExtractor()
used = int(open("/proc/self/statm").read().split()[0]) * resource.getpagesize()
resource.setrlimit(resource.RLIMIT_AS, (used + 50_000_000, resource.RLIM_INFINITY))
try:
    extractor.extract(image, camera)
except MemoryError as error:
    assert type(error) is epcc.OutOfMemoryError, type(error)
    assert error.status == epcc.Status.OUT_OF_MEMORY and str(error) == "out of memory"
    resource.setrlimit(resource.RLIMIT_AS, (resource.RLIM_INFINITY, resource.RLIM_INFINITY))
    print(len(extractor.extract(image, camera).planes))
"""


@pytest.mark.skipif(not sys.platform.startswith("linux"), reason="the limit on memory is Linux's")
def test_no_memory_for_a_frame_is_an_error_that_the_extractor_survives():
    run = subprocess.run([sys.executable, "-c", LITTLE_MEMORY], stdout=subprocess.PIPE, text=True, check=True)
    assert run.stdout == "1\n"


def test_a_scale_that_is_none(camera):
    for scale in (0.0, -1.0, numpy.nan, numpy.inf, 1000.5):
        error = str(raised(epcc.segment, IMAGE, camera, depth_scale=scale))
        assert error == "the depth image's scale must be positive, at most 1000 m a unit"


def test_a_range_that_is_none(camera):
    for low, high in ((5.0, 1.0), (-1.0, 1.0), (0.0, numpy.nan), (numpy.nan, 1.0)):
        error = raised(epcc.DepthFrame.from_depth, IMAGE, camera, min_depth=low, max_depth=high)
        assert str(error) == "the depths must be 0 <= min_depth < max_depth"


def test_labels_beyond_32_bits(camera):
    frame = epcc.DepthFrame.from_depth(IMAGE, camera)
    for label, kind in ((2**32 + 1, numpy.int64), (2**31, numpy.uint32), (-(2**40), numpy.int64), (2**63, numpy.uint64)):
        labels = numpy.ones(IMAGE.shape, kind)
        assert len(epcc.fit_planes(frame, "realsense", labels).planes) == 1
        labels[60:] = numpy.array(label, kind)
        error = raised(epcc.fit_planes, frame, "realsense", labels)
        assert str(error) == "a label must fit in 32 bits, from -2^31 to 2^31 - 1"
        assert str(raised(epcc.trace_contours, labels, 1)) == str(error)


def test_parameters_that_do_not_fit_together(camera):
    parameters = epcc.Parameters()
    parameters.paper.expert.lines.buffer_samples = 3
    text = "paper.expert.lines.buffer_samples (n_buf) must be at least fit_samples + validation_samples = 8, not 3"
    assert str(raised(parameters.validate)) == text
    error = raised(epcc.segment, IMAGE, camera, parameters)
    assert str(error) == text and error.status == epcc.Status.INVALID_PARAMETERS


def test_an_extractor_lives_on_after_an_error(camera, depth):
    extractor = epcc.PlaneExtractor()
    raised(extractor.extract, IMAGE[1:], camera)
    assert len(extractor.extract(depth, camera).planes) == 3


def test_rows_of_a_spherical_scan():
    azimuth, elevation = numpy.meshgrid(numpy.linspace(1.5, -1.5, 200), numpy.linspace(0.3, -0.3, 32))
    flat = numpy.cos(elevation)
    direction = [flat * numpy.cos(azimuth), flat * numpy.sin(azimuth), numpy.sin(elevation)]
    scan = (3.0 * numpy.stack(direction, axis=-1)).astype(numpy.float32)
    frame = epcc.DepthFrame.from_points(scan, epcc.CloudOptions(projection="spherical"))
    assert frame.projection == "spherical"
    error = raised(epcc.segment, frame, parameters=epcc.Parameters(scan="rows"))
    assert error.status == epcc.Status.UNSUPPORTED_SCAN and "cones" in str(error)


def test_a_cloud_that_nothing_can_have_seen():
    points = numpy.random.default_rng(0).standard_normal((240, 320, 3)).astype(numpy.float32)
    error = raised(epcc.segment, points)
    assert error.status == epcc.Status.UNKNOWN_GEOMETRY and "no camera and no scanner" in str(error)
    assert raised(epcc.find_geometry, points).status == epcc.Status.UNKNOWN_GEOMETRY
