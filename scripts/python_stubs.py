#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Writes the classes of the parameters into the type stubs of the Python module, from the module that was built:

    PYTHONPATH=build/release/python /usr/bin/python3 scripts/python_stubs.py
"""
import textwrap
from pathlib import Path

STUBS = Path(__file__).resolve().parent.parent / "epcc_segmentation/python/epcc/__init__.pyi"
MARK = "# From here on as scripts/python_stubs.py writes it.\n"

METHODS = """    def __init__(self, **fields: Union[bool, str, int, float]) -> None: ...
    @staticmethod
    def for_paper() -> Parameters: ...
    def set(self, assignment: str) -> None: ...
    def as_dict(self) -> Dict[str, Union[bool, str, int, float]]: ...
    def validate(self) -> None: ...
    def copy(self) -> Parameters: ...
    def __copy__(self) -> Parameters: ...
    def __deepcopy__(self, memo: Dict[Any, Any]) -> Parameters: ...
"""


def type_text(field):
    words = ", ".join(f'"{word}"' for word in field.choices)
    return f"Literal[{words}]" if field.type == "str" else field.type


def doc_text(doc):
    """As the text of a string in the stub, in lines of at most 120 columns."""
    return textwrap.indent(textwrap.fill(f'"""{doc}"""', 116), "    ") + "\n"


def class_text(owner, groups, fields):
    """owner: an object of the class. groups: name -> object; fields: those of the table that are its own."""
    name = type(owner).__name__
    lines = [f"class {name}:\n"]
    for field in fields:
        lines += [f"    {field.name.rpartition('.')[2]}: {type_text(field)}\n", doc_text(field.doc)]
    lines += [f"    {leaf}: {type(group).__name__}\n" for leaf, group in groups.items()]
    if name == "Parameters":
        lines.append(METHODS)
    else:
        lines.append("    def __init__(self, parameters: Parameters) -> None: ...\n")
    return "".join(lines)


def parameter_stubs(epcc):
    """The classes of all groups of parameters, the deepest last."""
    fields = epcc.parameter_fields()
    paths = {""}
    for field in fields:
        parts = field.name.split(".")[:-1]
        paths |= {".".join(parts[:depth]) for depth in range(len(parts) + 1)}
    objects = {"": epcc.Parameters()}
    for path in sorted(paths - {""}):
        parent, _, leaf = path.rpartition(".")
        objects[path] = getattr(objects[parent], leaf)
    texts = []
    for path, owner in objects.items():
        groups = {p.rpartition(".")[2]: o for p, o in objects.items() if p and p.rpartition(".")[0] == path}
        own = [field for field in fields if field.name.rpartition(".")[0] == path]
        texts.append(class_text(owner, groups, own))
    return "\n".join(texts)


def expected_stubs(epcc):
    """The whole file as it should be."""
    start = STUBS.read_text(encoding="utf-8").partition(MARK)[0]
    return start + MARK + "\n" + parameter_stubs(epcc)


def main():
    import epcc

    STUBS.write_text(expected_stubs(epcc), encoding="utf-8")
    print(f"written: {STUBS.name}")


if __name__ == "__main__":
    main()
