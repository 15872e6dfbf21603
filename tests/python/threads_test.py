# SPDX-License-Identifier: BSD-3-Clause
"""Other Python threads go on while a frame is segmented, and threads may share an object."""
import sys
import threading
import time
from concurrent.futures import ThreadPoolExecutor

import numpy
import pytest

import epcc
from conftest import room_depth


CALLS = {
    "segment": lambda camera, depth, cloud: epcc.segment(depth, camera),
    "find_geometry": lambda camera, depth, cloud: epcc.find_geometry(cloud),
    "points": lambda camera, depth, cloud: epcc.DepthFrame.from_depth(depth, camera).points(),
    "estimate_sensor": lambda camera, depth, cloud: epcc.estimate_sensor(depth, camera),
    "SensorPool": lambda camera, depth, cloud: epcc.SensorPool().add(depth, camera),
    "trace_contours": lambda camera, depth, cloud: epcc.trace_contours((depth > 2).astype(numpy.int32), 1),
}


@pytest.mark.parametrize("name", CALLS)
def test_other_threads_go_on_meanwhile(camera, depth, cloud, name):
    begun, seen, told = threading.Event(), [], []

    def work():
        end = time.monotonic() + 20.0  # only where no call ever lets the other thread in
        begun.set()
        while not seen and time.monotonic() < end:
            CALLS[name](camera, depth, cloud)
        told.append(bool(seen))

    # Python itself would change threads only after a minute: the waiting one gets on where a call lets it.
    before = sys.getswitchinterval()
    sys.setswitchinterval(60.0)
    try:
        worker = threading.Thread(target=work)
        worker.start()
        begun.wait()
        seen.append(True)
        worker.join()
    finally:
        sys.setswitchinterval(before)
    assert told == [True]


def test_many_threads_give_what_one_gives(camera):
    images = [room_depth(camera, 0.002, seed) for seed in range(8)]
    expected = [epcc.segment(image, camera).labels for image in images]
    with ThreadPoolExecutor(4) as pool:
        found = list(pool.map(lambda image: epcc.segment(image, camera).labels, images))
    assert all(map(numpy.array_equal, found, expected))


def test_threads_take_turns_with_a_shared_extractor(camera):
    images = [room_depth(camera, 0.001, seed) for seed in range(4)] * 4
    sensor = epcc.SensorModel.axial(0.0005, 0.002, 1.0)
    parameters = epcc.Parameters(threads=2, **{"inverse_depth.adapt_sensor": False})
    expected = [epcc.segment(image, camera, parameters, sensor).labels for image in images]
    extractor = epcc.PlaneExtractor(parameters, sensor)
    with ThreadPoolExecutor(4) as pool:
        found = list(pool.map(lambda image: extractor.extract(image, camera).labels, images))
    assert all(map(numpy.array_equal, found, expected))


def test_errors_in_threads_reach_their_caller(camera):
    extractor = epcc.PlaneExtractor()
    wrong = numpy.ones((5, 5), numpy.float32)
    with ThreadPoolExecutor(4) as pool:
        for future in [pool.submit(extractor.extract, wrong, camera) for _ in range(8)]:
            with pytest.raises(epcc.InputError, match="the camera's size"):
                future.result()


@pytest.mark.parametrize("threads", [2, 5])
def test_the_result_does_not_depend_on_threads_nor_on_the_vector_unit(camera, depth, threads):
    expected = epcc.segment(depth, camera).labels
    assert numpy.array_equal(epcc.segment(depth, camera, epcc.Parameters(threads=threads)).labels, expected)
    fastest = epcc.vector_unit()
    assert fastest in epcc.vector_units()
    try:
        for unit in epcc.vector_units():
            epcc.set_vector_unit(unit)
            assert epcc.vector_unit() == unit
            assert numpy.array_equal(epcc.segment(depth, camera).labels, expected)
    finally:
        epcc.set_vector_unit(fastest)
    with pytest.raises(ValueError, match="no vector unit 'mmx'"):
        epcc.set_vector_unit("mmx")
