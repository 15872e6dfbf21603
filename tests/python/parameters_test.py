# SPDX-License-Identifier: BSD-3-Clause
"""epcc.Parameters: every field of the parameter table is an attribute, checked where it is set."""
import copy
import functools
import pickle
import re

import numpy
import pytest

import epcc
from conftest import TOP

FIELDS = {field.name: field for field in epcc.parameter_fields()}


def value_at(parameters, name):
    return functools.reduce(getattr, name.split("."), parameters)


def set_at(parameters, name, value):
    group, _, leaf = name.rpartition(".")
    setattr(value_at(parameters, group) if group else parameters, leaf, value)


def other_value(field):
    """A value in the range that is not the default."""
    if field.type == "bool":
        return not field.default
    if field.type == "str":
        return next(word for word in field.choices if word != field.default)
    return type(field.default)(field.high if field.default != field.high else field.low)


def test_the_headers_have_no_field_that_is_missing():
    headers = TOP / "epcc_segmentation/include/epcc_segmentation"
    types = "int|double|bool|Mode|ScanDirection|PlaneCriterion|EndpointWeight"
    declared = []
    for header in ("parameters.h", "inverse_depth_parameters.h", "paper_parameters.h"):
        text = (headers / header).read_text(encoding="utf-8")
        declared += re.findall(rf"^ +(?:{types}) (\w+) = ", text, re.M)
    assert len(declared) > 50
    assert sorted(declared) == sorted(name.rpartition(".")[2] for name in FIELDS)


@pytest.mark.parametrize("name", FIELDS)
def test_every_field_is_an_attribute(name):
    field, parameters = FIELDS[name], epcc.Parameters()
    assert value_at(parameters, name) == field.default
    assert type(value_at(parameters, name)).__name__ == field.type
    value = other_value(field)
    set_at(parameters, name, value)
    assert value_at(parameters, name) == value and type(value_at(parameters, name)).__name__ == field.type
    changed = {key for key, now in parameters.as_dict().items() if now != FIELDS[key].default}
    assert changed == {name}
    text = {True: "on", False: "off"}.get(value, value) if field.type == "bool" else value
    by_name = epcc.Parameters()
    by_name.set(f"{name}={text}")
    assert by_name == parameters != epcc.Parameters()


@pytest.mark.parametrize("name", FIELDS)
def test_every_field_is_checked_in_the_words_of_the_library(name):
    field, parameters = FIELDS[name], epcc.Parameters()
    if field.type == "bool":
        wrong, bad = "2", []
    elif field.type == "str":
        wrong, bad = "nonsense", ["nonsense", ""]
    else:
        beyond = [float("nan"), 2 * field.high + 1] if field.type == "float" else [int(field.high) + 1, 10**400]
        wrong, bad = -1, [-1, *beyond]
    with pytest.raises(epcc.InputError) as by_name:
        parameters.set(f"{name}={wrong}")
    assert str(by_name.value).startswith(f"{name} must be ") and "\n" not in str(by_name.value)
    for value in bad:
        with pytest.raises(epcc.InputError) as caught:
            set_at(parameters, name, value)
        assert caught.value.status == epcc.Status.INVALID_PARAMETERS
        assert value != wrong or str(caught.value) == str(by_name.value)
    for value in (None, [], "4" if field.type != "str" else 4, 1 if field.type == "bool" else True):
        with pytest.raises(TypeError, match=f"^{re.escape(name)} must be {field.type}, "):
            set_at(parameters, name, value)
    assert parameters == epcc.Parameters()


def test_numbers_of_numpy_and_no_broken_whole_numbers():
    parameters = epcc.Parameters()
    parameters.threads = numpy.int64(3)
    parameters.inverse_depth.line_k_max = numpy.float32(2.5)
    parameters.inverse_depth.plane_k_max = 3
    parameters.line_segments = numpy.bool_(True)
    assert (parameters.threads, parameters.inverse_depth.line_k_max, parameters.line_segments) == (3, 2.5, True)
    with pytest.raises(TypeError, match="threads must be int"):
        parameters.threads = 2.0


def test_names_that_do_not_exist():
    parameters = epcc.Parameters()
    for owner in (parameters, parameters.inverse_depth, parameters.paper.expert.lines):
        with pytest.raises(AttributeError):
            owner.treads = 2
    for call in (lambda: parameters.set("treads=2"), lambda: epcc.Parameters(treads=2)):
        with pytest.raises(epcc.InputError, match="there is no parameter 'treads'"):
            call()
    with pytest.raises(epcc.InputError, match="'threads' is not NAME=VALUE"):
        parameters.set("threads")


def test_groups_are_views_that_keep_their_parameters():
    lines = epcc.Parameters().inverse_depth.expert.lines
    lines.min_samples = 9
    assert lines.min_samples == 9
    parameters = epcc.Parameters()
    parameters.inverse_depth.expert.lines = lines
    assert parameters.as_dict()["inverse_depth.expert.lines.min_samples"] == 9
    lines.min_samples = 10
    assert parameters.inverse_depth.expert.lines.min_samples == 9  # copied, as in C++
    with pytest.raises(TypeError, match="must be an epcc.InverseDepthLines"):
        parameters.inverse_depth.expert.lines = parameters.paper.expert.lines


def test_copies_and_pickles_are_independent():
    parameters = epcc.Parameters(threads=4, mode="paper", **{"inverse_depth.stride": 2})
    for other in (parameters.copy(), copy.copy(parameters), copy.deepcopy(parameters),
                  pickle.loads(pickle.dumps(parameters))):
        assert other == parameters
        other.threads = 5
        assert parameters.threads == 4 and other != parameters
    assert repr(parameters) == "<epcc.Parameters: mode=paper, threads=4, inverse_depth.stride=2>"


def test_docstrings_are_those_of_the_headers():
    doc = epcc.InverseDepthParameters.line_k_max.__doc__
    assert doc == FIELDS["inverse_depth.line_k_max"].doc
    assert doc.startswith("Gate of a line segment (S1)") and "(0, 100] sigma_w, default 1.5. Raise it if " in doc
    assert "False | True, default True. Choose off" in epcc.InverseDepthParameters.adapt_sensor.__doc__


def test_parameters_steer_the_segmentation(camera, depth):
    assert len(epcc.segment(depth, camera, epcc.Parameters(**{"inverse_depth.min_points": 20000})).planes) == 1
    extractor = epcc.PlaneExtractor()
    assert len(extractor.extract(depth, camera).planes) == 3
    extractor.parameters.inverse_depth.min_points = 20000  # in place
    assert len(extractor.extract(depth, camera).planes) == 1
    extractor.parameters = epcc.Parameters()
    assert len(extractor.extract(depth, camera).planes) == 3
