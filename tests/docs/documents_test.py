# SPDX-License-Identifier: BSD-3-Clause
"""The checks of the documents see what is wrong: outputs that differ, links and functions that do not exist."""
import sys
import unittest
from pathlib import Path

TOP = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(TOP / "scripts"))

import check_docs  # noqa: E402
from output_check import difference  # noqa: E402
from run_document import commands, shown_problem  # noqa: E402


class Outputs(unittest.TestCase):
    def test_numbers_may_differ_in_their_last_digits(self):
        self.assertEqual(difference("46673 pixels, rms -0.00", "46674 pixels,  rms 0.00"), "")

    def test_other_numbers_words_and_lines_are_differences(self):
        self.assertNotEqual(difference("271360 pixels", "272000 pixels"), "")
        self.assertNotEqual(difference("2.00 m", "2.02 m"), "")
        for printed in ("4 planes\nend", "3 lines\nend", "3 planes", "3 planes\nend\nmore"):
            self.assertNotEqual(difference("3 planes\nend", printed), "", printed)

    def test_dots_stand_for_any_lines(self):
        self.assertEqual(shown_problem("a\n...\nc", "a\nb\nb\nc"), "")
        self.assertNotEqual(shown_problem("a\n...\nc", "a\nb\nb"), "")
        self.assertNotEqual(shown_problem("c\n...\na", "a\nb\nc"), "")

    def test_a_command_has_the_output_below_it(self):
        self.assertEqual(commands("$ one\nx\ny\n$ two\n"), [("one", "x\ny"), ("two", "")])


class Names(unittest.TestCase):
    def test_links(self):
        page = TOP / "README.md"
        self.assertEqual(check_docs.link_problem(page, "docs/tutorial.md#1-install"), "")
        self.assertIn("heading", check_docs.link_problem(page, "docs/tutorial.md#nowhere"))
        self.assertIn("file", check_docs.link_problem(page, "docs/nowhere.md"))

    def test_functions(self):
        self.assertEqual(check_docs.place_problem("plane_extractor.cpp", "PlaneExtractor::extract"), "")
        self.assertEqual(check_docs.place_problem("paper_parameters.h", "PlaneCriterion"), "")
        for path, name in (("plane_extractor.cpp", "PlaneExtractor::none"), ("plane_extractor.cpp", "Nobody::extract"),
                           ("plane_extractor.cpp", "nothing"), ("nowhere.cpp", "extract")):
            self.assertNotEqual(check_docs.place_problem(path, name), "", name)

    def test_paths(self):
        for path in ("eval/measures/overlap_table", "metric/scan_line.cpp", "epcc_segmentation/contours.h", "a/b"):
            self.assertEqual(check_docs.path_problem(path), "", path)
        for path in ("eval/overlap_table", "metric/nowhere.cpp", "docs/algorithm.md"):
            self.assertNotEqual(check_docs.path_problem(path), "", path)


class Figures(unittest.TestCase):
    """The README's table is part of docs/research/accuracy.md, which is renewed by itself."""
    SETS = {"RealSense": "realsense", "Kinect": "kinect", "ABW": "abw", "seven further": "sensors", "two lidars": "lidars"}

    def totals(self):
        """(data, method) -> "correct (noise)"; of frames that name no sensor the default mode is epcc-auto."""
        text = (TOP / "docs/research/accuracy.md").read_text()
        table = text.split("<!-- table totals -->")[1].split("<!-- end of table -->")[0]
        found = {}
        for line in table.splitlines():
            cells = [cell.strip() for cell in line.strip("| ").split("|")]
            if len(cells) == 11 and cells[8].isdigit():
                found[cells[0], cells[1]] = f"{cells[8]} ({cells[9]})"
        return found

    def test_the_table_of_the_readme_is_that_of_accuracy(self):
        totals = self.totals()
        rows = 0
        for line in (TOP / "README.md").read_text().splitlines():
            cells = [cell.strip().replace("*", "") for cell in line.strip("| ").split("|")]
            data = next((name for start, name in self.SETS.items() if cells[0].startswith(start)), None)
            if data is None or len(cells) != 7:
                continue
            rows += 1
            default = "epcc" if (data, "epcc") in totals else "epcc-auto"
            methods = [default, "epcc-paper", "region-growing", "ransac", "omps"]
            self.assertEqual(cells[2:], [totals[data, method] for method in methods], data)
        self.assertEqual(rows, len(self.SETS))


class Lines(unittest.TestCase):
    def test_prose_is_narrow_and_tables_may_be_wide(self):
        self.assertNotEqual(check_docs.width_problem("x" * 121), "")
        for line in ("x" * 120, "| " + "x" * 121, "    " + "x" * 121):
            self.assertEqual(check_docs.width_problem(line), "")


if __name__ == "__main__":
    unittest.main()
