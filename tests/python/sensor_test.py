# SPDX-License-Identifier: BSD-3-Clause
"""The sensor: named, in numbers, as text, or measured on frames, over a stream and over a pool."""
import math
import pickle

import numpy
import pytest

import epcc
from conftest import room_depth


def test_models_in_numbers():
    axial = epcc.SensorModel.axial(0.001, 0.003, 2.0)
    assert axial.sigma_z(2.0) == pytest.approx(math.hypot(0.001, 0.012))
    assert axial.variance_z(2.0) == pytest.approx(axial.sigma_z(2.0) ** 2)
    assert axial.sigma_inverse_depth(2.0) == pytest.approx(axial.sigma_z(2.0) / 4)
    for of_depth in (axial.sigma_z, axial.variance_z, axial.sigma_inverse_depth):
        assert numpy.isnan(of_depth(math.nan))
    assert axial.coefficients == (0.001, 0.003, 0.0) and not axial.is_polynomial and axial.correlation_length == 2.0
    assert axial.pixels_per_sample == pytest.approx(8 * math.pi) and axial.pixels_per_line_sample == 5.0
    assert axial.description == "axial a=0.001 m b=0.003 1/m l=2 px"
    z = numpy.linspace(0.5, 5.0, 10)
    numpy.testing.assert_allclose(axial.sigma_z(z), numpy.hypot(0.001, 0.003 * z**2))
    polynomial = epcc.SensorModel.polynomial(0.002, 0.001, 0.003)
    assert polynomial.is_polynomial and polynomial.sigma_z(2.0) == pytest.approx(0.013)
    assert axial.scaled(2).sigma_z(3.0) == pytest.approx(2 * axial.sigma_z(3.0))
    assert axial.with_correlation_length(7).correlation_length == 7.0
    assert pickle.loads(pickle.dumps(axial)) == axial != polynomial
    white = axial.with_correlated_share(0.25)
    assert white.correlated_share == 0.25 and axial.correlated_share == 1.0 and white != axial
    assert pickle.loads(pickle.dumps(white)) == white == epcc.SensorModel.parse("0.001,0.003,2,0.25")


def test_presets_and_texts():
    names = epcc.SensorModel.preset_names()
    assert "kinect-v1" in names and "realsense" in names
    for name in names:
        assert epcc.SensorModel.parse(name) == epcc.SensorModel.preset(name)
    assert epcc.SensorModel.parse("0.001,0.003,2") == epcc.SensorModel.axial(0.001, 0.003, 2.0)
    assert epcc.SensorModel.parse("poly:0.002,0.001,0.003") == epcc.SensorModel.polynomial(0.002, 0.001, 0.003)


@pytest.mark.parametrize("call, words", [
    (lambda: epcc.SensorModel.preset("kinect-v9"), "'kinect-v9' is no preset (d435i, kinect-v1,"),
    (lambda: epcc.SensorModel.parse("kinect-v9"), "'kinect-v9' is neither a preset (d435i, kinect-v1,"),
    (lambda: epcc.SensorModel.parse("-1,0,1"), "'-1,0,1': a and b of sigma_z must not be negative"),
    (lambda: epcc.SensorModel.axial(0, 0), "a and b of sigma_z must not both be zero"),
    (lambda: epcc.SensorModel.axial(1, 1).with_correlated_share(2), "the correlated share must be in [0, 1]"),
    (lambda: epcc.SensorModel.axial(1, 1, -1), "the correlation length must be in [0, 1000] pixels"),
    (lambda: epcc.SensorModel.polynomial(math.nan, 0, 1), "the coefficients of sigma_z must be finite"),
    (lambda: epcc.SensorModel.axial(0.001, 0.001).scaled(1e9), "the coefficients of sigma_z must be at most 1000"),
])
def test_models_that_cannot_be_used(call, words):
    with pytest.raises(epcc.InputError) as caught:
        call()
    assert str(caught.value).startswith(words) and caught.value.status == epcc.Status.INVALID_PARAMETERS


def test_how_a_segmentation_takes_its_sensor(camera, depth):
    as_given = epcc.Parameters(**{"inverse_depth.adapt_sensor": False})
    model = epcc.SensorModel.preset("kinect-v1")
    assert epcc.segment(depth, camera, as_given, model).sensor == model
    assert epcc.segment(depth, camera, as_given, "kinect-v1").sensor == model
    measured = epcc.segment(depth, camera, as_given).sensor
    assert epcc.segment(depth, camera, as_given, "auto").sensor == measured != model
    assert epcc.estimate_sensor(depth, camera).model() == measured
    with pytest.raises(epcc.InputError, match="'kinect' is neither a preset"):
        epcc.segment(depth, camera, as_given, "kinect")


def test_an_extractor_measures_over_a_stream(camera):
    extractor = epcc.PlaneExtractor()
    assert extractor.measures_sensor
    for seed in range(8):
        extractor.extract(room_depth(camera, 0.002, seed), camera)
    truth = 0.002 * 9 * math.sqrt(1)
    assert extractor.sensor.sigma_z(3.0) == pytest.approx(truth, rel=0.3)
    extractor.sensor = "realsense"
    assert not extractor.measures_sensor and extractor.sensor == epcc.SensorModel.preset("realsense")
    extractor.sensor = None
    assert extractor.measures_sensor


def test_estimators(camera):
    stream = epcc.SensorEstimator()
    for seed in range(5):
        estimate = stream.update(room_depth(camera, 0.002, seed), camera)
    assert estimate.blocks > 50 and estimate.model().sigma_z(3.0) == pytest.approx(0.018, rel=0.3)
    stream.reset()
    image = room_depth(camera, 0.004)
    assert stream.update(image, camera).model() == epcc.estimate_sensor(image, camera).model()
    for memory, interval in ((0, 4), (15, 0), (15, 151)):
        with pytest.raises(ValueError, match="must be"):
            epcc.SensorEstimator(memory, interval)


def test_a_pool_says_what_its_estimate_comes_from(camera):
    pool = epcc.SensorPool()
    for seed in range(3):
        assert pool.add(room_depth(camera, 0.002, seed), camera)
    small = epcc.PinholeCamera(160, 120, 100, 100, 79.5, 59.5)
    assert not pool.add(room_depth(small), small) and pool.frames == 3
    measurement = pool.measure()
    assert measurement.estimate.model().sigma_z(3.0) == pytest.approx(0.018, rel=0.3)
    assert measurement.blocks.dtype.names == ("depth", "residual") and len(measurement.blocks) > 300
    assert measurement.bins.dtype.names == ("depth", "error", "sigma", "blocks")
    assert measurement.bins["blocks"].sum() <= len(measurement.blocks)
    assert 0.5 < numpy.median(measurement.blocks["depth"]) < 4.0
    assert len(measurement.correlation) == len(measurement.correlation_fit) > 3 and len(measurement.sides) == 3
    blocks = measurement.blocks
    del measurement
    assert 0.5 < numpy.median(blocks["depth"]) < 4.0


def test_nothing_can_be_measured_on_an_empty_frame(camera):
    assert epcc.estimate_sensor(numpy.zeros((240, 320), numpy.uint16), camera).blocks == 0
    assert epcc.SensorPool().measure().estimate.blocks == 0
