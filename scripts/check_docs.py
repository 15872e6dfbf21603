#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Checks that the documents name what exists: relative links and their headings, paths of the project in `code`, and
FILE:FUNCTION in the tables that say where things are; and that prose stays within 120 columns. Prints what does not;
exit code 1 if anything."""
import re
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
CORE = ROOT / "epcc_segmentation"
# Where a path in a document may start: the project's top, and for the code map the core's folders.
BASES = [ROOT, CORE / "src", CORE / "include/epcc_segmentation"]
FOLDERS = ("baselines", "cmake", "datasets", "docs", "epcc_segmentation", "eval", "scripts", "tests")

WIDTH = 120

LINK = re.compile(r"\]\(([^)\s]+)\)")
CODE = re.compile(r"(?<!`)`([^`\n]+)`(?!`)")
PLACE = re.compile(r"([\w./-]+\.(?:h|hpp|cpp|py|sh)):([A-Za-z_]\w*(?:::\w+)?)")
PATH = re.compile(r"[\w.-]+(?:/[\w.-]+)*/?")


def prose(text):
    """The text with fenced blocks emptied, lines kept."""
    lines, fenced = [], False
    for line in text.splitlines():
        if line.lstrip().startswith("```"):
            fenced = not fenced
            line = ""
        lines.append("" if fenced else line)
    return lines


def anchors(page):
    """The names that a page's headings have on a forge."""
    names = set()
    for line in prose(page.read_text(encoding="utf-8")):
        if line.startswith("#"):
            heading = re.sub(r"[`*]|\[|\]\([^)]*\)", "", line.lstrip("#").strip()).lower()
            names.add(re.sub(r"[^\w\- ]", "", heading).replace(" ", "-"))
    return names


def link_problem(page, target):
    if re.match(r"[a-z]+:", target):
        return ""
    path, _, anchor = target.partition("#")
    file = (page.parent / path).resolve() if path else page
    if not file.exists():
        return f"link to {target}: there is no such file"
    if anchor and anchor not in anchors(file):
        return f"link to {target}: there is no such heading"
    return ""


def found(path):
    return next((base / path for base in BASES if (base / path).exists()), None)


def place_problem(path, name):
    """FILE:NAME or FILE:CLASS::MEMBER: the file declares or defines it."""
    file = found(path)
    if file is None:
        return f"{path}:{name}: there is no such file"
    text = re.sub(r"//.*", "", file.read_text(encoding="utf-8"))
    owner, _, member = name.rpartition("::")
    declared = rf"\b(?:class|struct|enum class|using|concept)\s+(?:\w+_EXPORT\s+)?{member}\b|\b{member}\s*\("
    if owner and re.search(rf"\b{owner}::{member}\b", text):
        return ""
    has_owner = not owner or re.search(rf"\b(?:class|struct)\s+(?:\w+_EXPORT\s+)?{owner}\b", text)
    if has_owner and re.search(declared, text):
        return ""
    return f"{path}:{name}: the file has no such function or type"


def path_problem(code):
    """`eval/measures/overlap_table` and the like, with or without the ending of a source file, and paths to include."""
    if re.fullmatch(r"\w+/[\w/]+\.(h|hpp|cpp)", code) and found(code):
        return ""  # relative to the core, as in the code map
    if not PATH.fullmatch(code) or "/" not in code:
        return ""
    if code.split("/")[0] not in FOLDERS and not re.search(r"\.(h|hpp|cpp|cmake)$", code):
        return ""
    if any((base / (code + ending)).exists() for base in (ROOT, CORE / "include") for ending in ("", ".h", ".cpp")):
        return ""
    return f"`{code}`: there is no such file or folder"


def width_problem(line):
    if len(line) <= WIDTH or line.startswith(("|", "    ", "![")):
        return ""
    return f"{len(line)} columns: prose has at most {WIDTH}"


def problems(page):
    for number, line in enumerate(prose(page.read_text(encoding="utf-8")), 1):
        found_here = [width_problem(line)] + [link_problem(page, target) for target in LINK.findall(line)]
        for code in CODE.findall(line):
            place = PLACE.fullmatch(code)
            found_here.append(place_problem(*place.groups()) if place else path_problem(code))
        for problem in filter(None, found_here):
            yield f"{page.relative_to(ROOT)}:{number}: {problem}"


def main():
    pages = sorted(ROOT.glob("*.md")) + sorted((ROOT / "docs").rglob("*.md"))
    found_all = [problem for page in pages for problem in problems(page)]
    print("\n".join(found_all) if found_all else f"{len(pages)} documents name what exists")
    return 1 if found_all else 0


if __name__ == "__main__":
    sys.exit(main())
