# SPDX-License-Identifier: BSD-3-Clause
"""The type stubs say what the module has: every name, argument, default and whether an attribute can be set."""
import ast
import inspect
import re
import sys

import pytest

import epcc
from conftest import TOP

sys.path.insert(0, str(TOP / "scripts"))

import python_stubs  # noqa: E402

TREE = ast.parse(python_stubs.STUBS.read_text(encoding="utf-8"))
CLASSES = {node.name: node for node in TREE.body if isinstance(node, ast.ClassDef)}
FUNCTIONS = {node.name: node for node in TREE.body if isinstance(node, ast.FunctionDef)}


def decorators(node):
    return {ast.unparse(decorator) for decorator in node.decorator_list}


def stub_arguments(node):
    """[(name, has a default, keyword only)], without self."""
    arguments, defaults = node.args.args, node.args.defaults
    found = [(a.arg, i >= len(arguments) - len(defaults), False) for i, a in enumerate(arguments) if a.arg != "self"]
    found += [(a.arg, d is not None, True) for a, d in zip(node.args.kwonlyargs, node.args.kw_defaults)]
    return found + ([(f"**{node.args.kwarg.arg}", False, False)] if node.args.kwarg else [])


def split(text):
    """At the commas that are in no brackets."""
    parts, depth = [""], 0
    for letter in text:
        depth += (letter in "([{<") - (letter in ")]}>")
        if letter == "," and depth == 0:
            parts.append("")
        else:
            parts[-1] += letter
    return [part.strip() for part in parts if part.strip()]


def real_arguments(function):
    """The same of a function of the module, from the signature in its docstring."""
    signature = re.match(r"\w+\((.*)\) -> ", function.__doc__.splitlines()[0].replace("->", "->", 1)).group(1)
    found, only = [], False
    for argument in split(signature):
        name = re.match(r"\**\w*", argument).group(0)
        if name == "*":
            only = True
        elif name not in ("self", "arg0") or argument.startswith("arg0: dict"):
            found.append(("**fields" if name == "**kwargs" else name, " = " in argument, only))
    return found


def test_the_parameters_are_those_of_the_table():
    assert python_stubs.STUBS.read_text(encoding="utf-8") == python_stubs.expected_stubs(epcc), \
        "run scripts/python_stubs.py"


def test_all_names_are_there_and_no_others():
    stubbed = set(CLASSES) | set(FUNCTIONS)
    assert stubbed == set(epcc.__all__)
    for name in CLASSES:
        assert inspect.isclass(getattr(epcc, name)) and getattr(epcc, name).__module__ == "epcc", name
    for name in FUNCTIONS:
        assert callable(getattr(epcc, name)) and not inspect.isclass(getattr(epcc, name)), name


@pytest.mark.parametrize("name", FUNCTIONS)
def test_functions_take_what_the_stubs_say(name):
    assert stub_arguments(FUNCTIONS[name]) == real_arguments(getattr(epcc, name))


def members(node):
    """name -> ("attribute" | "read-only" | "method" | "static", node)"""
    found = {}
    for item in node.body:
        if isinstance(item, ast.AnnAssign):
            found[item.target.id] = ("attribute", item)
        elif isinstance(item, ast.FunctionDef):
            kinds = decorators(item)
            if f"{item.name}.setter" in kinds:
                found[item.name] = ("attribute", item)
            elif "property" in kinds:
                found[item.name] = ("read-only", item)
            else:
                found[item.name] = ("static" if "staticmethod" in kinds else "method", item)
    return found


def real_kind(owner, name):
    member = inspect.getattr_static(owner, name)
    if isinstance(member, property):
        return "attribute" if member.fset else "read-only"
    if isinstance(member, staticmethod):
        return "static"
    return "method" if callable(member) else "attribute"


@pytest.mark.parametrize("name", [name for name in CLASSES if not name.endswith("Error")])
def test_classes_have_what_the_stubs_say(name):
    owner, stubbed = getattr(epcc, name), members(CLASSES[name])
    own = {key for base in owner.__mro__[:-1] for key in vars(base) if not key.startswith("__") and key[:1] != "_"}
    own |= {key for key in vars(owner) if key in ("__copy__", "__deepcopy__")}
    assert {key for key in stubbed if key != "__init__"} == own
    for member, (kind, node) in stubbed.items():
        if member == "__init__" or name == "Status":
            continue
        assert real_kind(owner, member) == kind, member
        if kind in ("method", "static"):
            assert len(stub_arguments(node)) == len(real_arguments(getattr(owner, member))), member
            if not member.startswith("__"):
                assert stub_arguments(node) == real_arguments(getattr(owner, member)), member
    if "__init__" in stubbed and name in ("PinholeCamera", "CloudOptions", "PlaneExtractor", "PlaneTracker",
                                          "SensorEstimator", "SensorPose", "Parameters"):
        assert stub_arguments(stubbed["__init__"][1]) == real_arguments(owner.__init__)
    has_init = (owner.__init__.__doc__ or "").startswith("__init__(") or name.startswith(("InverseDepth", "Paper"))
    assert ("__init__" in stubbed) == has_init, "what cannot be made has no __init__ in the stubs"


@pytest.mark.parametrize("name", epcc.__all__)
def test_everything_has_a_docstring(name):
    thing = getattr(epcc, name)
    assert thing.__doc__
    for member in vars(thing) if inspect.isclass(thing) and name != "Status" else ():
        if not member.startswith("_") and member != "status":
            doc = getattr(thing, member).__doc__ or ""
            assert len(re.sub(r"^\w+\(.*\) -> .*$", "", doc, flags=re.M).strip()) > 8, f"{name}.{member}"
