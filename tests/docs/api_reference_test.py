# SPDX-License-Identifier: BSD-3-Clause
"""The check of the API reference sees what is wrong, on headers made for it; and header_filter.awk makes of a header
what Doxygen needs. Called with the Doxyfile that CMake has made; exit code 77 without Doxygen."""
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

TOP = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(TOP / "scripts"))

import check_api_reference as check  # noqa: E402

HEADER = """// SPDX-License-Identifier: BSD-3-Clause
// What the file is for (Sec. 3).
#pragma once

namespace epcc {

/// A class that has words.
class Extractor {
 public:
  /// Planes of Eq. 22 are found. The rest.
  int extract() const;
MEMBERS
};

/// An enumeration.
enum class Kind {
  First,  ///< the first
ENUMERATOR
};

inline int Extractor::extract() const {
  return 1;
}

}  // namespace epcc
"""
EXAMPLE = """#include <epcc_segmentation/status.h>
int main() {
  epcc::Extractor extractor;
  return extractor.extract();
}
"""
TOPICS = "/** \\namespace epcc\n * The library. */\n/** \\defgroup segmentation Segmentation\n * A topic. */\n"


class Reference:
    """The reference of one header, status.h unless told, and one example, linked.cpp."""

    def __init__(self, members="", enumerator="", header="status.h", example="", example_text=EXAMPLE):
        with tempfile.TemporaryDirectory() as name:
            folder = Path(name)
            path = folder / "include/epcc_segmentation" / header
            path.parent.mkdir(parents=True)
            path.write_text(HEADER.replace("MEMBERS", members).replace("ENUMERATOR", enumerator), encoding="utf-8")
            (folder / "linked.cpp").write_text(example_text, encoding="utf-8")
            (folder / "topics.dox").write_text(TOPICS + example, encoding="utf-8")
            settings = DOXYFILE.read_text(encoding="utf-8") + (
                f'\nINPUT = "{folder}/include" "{folder}/topics.dox"\nEXAMPLE_PATH = "{folder}"\n'
                f'STRIP_FROM_PATH = "{folder}/include"\n')
            self.warnings = "\n".join(check.make(check.doxygen(), settings, folder))
            self.pages = check.pages_of(folder)
            self.enumerators = check.enumerator_problems(folder)
            self.links = list(check.link_problems(self.pages, folder))
            self.headers = list(check.header_problems(self.pages, [f"epcc_segmentation/{header}"]))


class Warnings(unittest.TestCase):
    def test_what_is_complete_gives_none(self):
        reference = Reference()
        self.assertEqual((reference.warnings, reference.enumerators, reference.headers), ("", [], []))

    def test_a_function_or_field_without_words(self):
        self.assertIn("none() (function)", Reference(members="  void none();").warnings)
        self.assertIn("none (variable)", Reference(members="  int none = 0;").warnings)

    def test_a_reference_to_what_does_not_exist(self):
        self.assertIn("nowhere", Reference(members="  /// See \\ref nowhere.\n  void some();").warnings)

    def test_an_enumerator_without_words(self):
        self.assertEqual(Reference(enumerator="  Second").enumerators, ["Kind::Second: an enumerator without words"])


class Pages(unittest.TestCase):
    def test_a_header_without_page_or_topic(self):
        reference = Reference(header="nobody.h")
        self.assertIn("no topic", reference.warnings)
        self.assertIn("without a topic", "".join(reference.headers))
        self.assertIn("without a page", "".join(check.header_problems(reference.pages, ["epcc_segmentation/other.h"])))

    def test_an_example_that_is_linked_and_others(self):
        page = "\n/*! \\example linked.cpp\n * An example. */\n"
        self.assertEqual(list(check.example_problems(Reference(example=page).pages, ["linked.cpp"])), [])
        stranger = Reference(example=page, example_text="int main() {}\n")
        self.assertIn("no class", "".join(check.example_problems(stranger.pages, ["linked.cpp"])))
        self.assertIn("without a page", "".join(check.example_problems(Reference().pages, ["linked.cpp"])))

    def test_links_that_lead_nowhere(self):
        pages = {"a.html": '<a href="b.html"></a> <a href="#here"></a> <i id="there"></i> <a href="#there"></a>'}
        problems = list(check.link_problems(pages, Path("/nowhere")))
        self.assertIn("a.html: a link to b.html, which does not exist", problems)
        with tempfile.TemporaryDirectory() as name:
            (Path(name) / "html").mkdir()
            for page in ("a.html", "b.html"):
                (Path(name) / "html" / page).touch()
            self.assertEqual(list(check.link_problems(pages, Path(name))),
                             ["a.html: a link to #here, a place that does not exist"])


class Filter(unittest.TestCase):
    def test_lines_stay_and_get_what_doxygen_needs(self):
        with tempfile.TemporaryDirectory() as name:
            path = Path(name) / "include/epcc_segmentation/status.h"
            path.parent.mkdir(parents=True)
            path.write_text(HEADER, encoding="utf-8")
            filtered = subprocess.run(["awk", "-f", TOP / "docs/api/header_filter.awk", path], capture_output=True,
                                      text=True, check=True).stdout.splitlines()
        self.assertEqual(len(filtered), len(HEADER.splitlines()))
        self.assertEqual(filtered[:3],
                         [r"/// \file", r"/// What the file is for (Sec.\ 3).", r"/// \ingroup segmentation"])
        self.assertIn(r"  /// %Planes of Eq.\ 22 are found. The rest.", filtered)
        self.assertFalse([line for line in filtered if line.startswith("inline")])


if __name__ == "__main__":
    DOXYFILE = Path(sys.argv.pop(1))
    if check.doxygen() is None:
        print(f"doxygen {check.VERSION} is not installed", file=sys.stderr)
        sys.exit(77)
    unittest.main()
