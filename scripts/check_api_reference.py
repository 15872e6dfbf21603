#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Makes the API reference in a folder of its own and prints what is wrong with it: what Doxygen warns of, enumerators
without words, headers without a page or topic, examples that no class links to, links that lead nowhere. Called with
the Doxyfile that CMake has made; exit code 1 if anything is wrong. Versions of Doxygen differ in what they warn of: the
project's is 1.9.4, Debian 12's; exit code 77 where it is not installed."""
import re
import shutil
import subprocess
import sys
import tempfile
import xml.etree.ElementTree as ElementTree
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
HEADERS = ROOT / "epcc_segmentation/include"
EXAMPLES = ROOT / "docs/examples"
VERSION = "1.9.4"


def doxygen():
    """The program's path; None where there is none of the project's version."""
    path = shutil.which("doxygen")
    if path is None:
        return None
    printed = subprocess.run([path, "--version"], capture_output=True, text=True, check=False).stdout
    return path if printed.split()[:1] == [VERSION] else None


def make(program, settings, folder):
    """Runs Doxygen with its output in the folder, as pages and as XML; what it has to say, line by line."""
    settings += f'\nOUTPUT_DIRECTORY = "{folder}"\nGENERATE_XML = YES\nXML_PROGRAMLISTING = NO\n'
    run = subprocess.run([program, "-"], input=settings, capture_output=True, text=True, check=False)
    said = (run.stdout + run.stderr).replace(f"{ROOT}/", "").splitlines()
    return said or ([f"doxygen ended with code {run.returncode}"] if run.returncode else [])


def pages_of(folder):
    return {page.name: page.read_text(encoding="utf-8") for page in sorted((folder / "html").glob("*.html"))}


def enumerator_problems(folder):
    """Enumerators without words, which Doxygen 1.9.4 leaves out without a warning."""
    found = set()
    for file in (folder / "xml").glob("*.xml"):
        for enumeration in ElementTree.parse(file).iterfind(".//memberdef[@kind='enum']"):
            for value in enumeration.iterfind("enumvalue"):
                words = [text for kind in ("brief", "detailed") for text in value.find(f"{kind}description").itertext()]
                if not "".join(words).strip():
                    found.add(f"{enumeration.findtext('name')}::{value.findtext('name')}: an enumerator without words")
    return sorted(found)


def header_problems(pages, headers):
    """Headers, named as they are included, without a page or on the page of no topic."""
    of_header = {}
    for page in pages.values():
        title = re.search(r"<title>[^<]*: ([^<]+) File Reference</title>", page)
        if title:
            of_header[title.group(1)] = page
    for header in headers:
        if header not in of_header:
            yield f"{header}: a header without a page"
        elif 'class="ingroups"' not in of_header[header]:
            yield f"{header}: a header without a topic (docs/api/header_filter.awk)"


def example_problems(pages, examples):
    """Examples without a page (docs/api/examples.dox), or without a link from the page of a class."""
    of_classes = "".join(page for name, page in pages.items() if name.startswith(("class", "struct")))
    for example in examples:
        if f">{example}</a>" not in pages.get("examples.html", ""):
            yield f"{example}: an example without a page (docs/api/examples.dox)"
        elif not re.search(rf'href="[^"]*-example\.html[^"]*">{re.escape(example)}</a>', of_classes):
            yield f"{example}: an example that is linked from no class"


def link_problems(pages, folder):
    """Links to pages, and to places in them, that do not exist."""
    places = {name: set(re.findall(r'\b(?:id|name)="([^"]+)"', page)) for name, page in pages.items()}
    for name, page in pages.items():
        for target in sorted(set(re.findall(r'href="([^":]+)"', page))):
            file, _, place = target.partition("#")
            file = file or name
            if not (folder / "html" / file).exists():
                yield f"{name}: a link to {target}, which does not exist"
            elif place and file in places and place not in places[file]:
                yield f"{name}: a link to {target}, a place that does not exist"


def main(doxyfile):
    program = doxygen()
    if program is None:
        print(f"check_api_reference.py: doxygen {VERSION} is not installed (Debian: doxygen)", file=sys.stderr)
        return 77
    headers = [str(path.relative_to(HEADERS)) for path in sorted(HEADERS.rglob("*.h"))]
    examples = [path.name for path in sorted(EXAMPLES.glob("*.cpp"))]
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        problems = make(program, Path(doxyfile).read_text(encoding="utf-8"), folder)
        pages = pages_of(folder)
        problems += enumerator_problems(folder)
        problems += [*header_problems(pages, headers), *example_problems(pages, examples),
                     *link_problems(pages, folder)]
    print("\n".join(problems) if problems else
          f"the API reference: {len(headers)} headers and {len(examples)} examples on {len(pages)} pages, no warnings")
    return 1 if problems else 0


if __name__ == "__main__":
    if len(sys.argv) != 2:
        print("usage: check_api_reference.py DOXYFILE", file=sys.stderr)
        sys.exit(2)
    sys.exit(main(sys.argv[1]))
