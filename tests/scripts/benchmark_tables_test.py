# SPDX-License-Identifier: BSD-3-Clause
"""The tables of the benchmark page are what epcc_bench measured, and the page has a place for each."""
import json
import sys
import tempfile
import unittest
from pathlib import Path

TOP = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(TOP / "scripts"))

import benchmark_tables  # noqa: E402

PRINTED = """a case
Ratios of the times    640x480
paper / default           2.00

Median over the frames, ms
  Default  1.00  of 2
"""


def case(name, time, **counters):
    return {"name": name, "run_type": "iteration", "real_time": time, **counters}


def cases_of(*cases):
    run = {"context": {}, "benchmarks": list(cases)}
    with tempfile.NamedTemporaryFile("w", suffix=".json") as file:
        json.dump(run, file)
        file.flush()
        return benchmark_tables.read_cases(file.name)[1]


class Tables(unittest.TestCase):
    def test_sizes_are_columns_in_their_order(self):
        tables = benchmark_tables.all_tables(cases_of(case("Default/1280x720", 123.4), case("Default/640x480", 2.346),
                                                      case("Paper/640x480", 45.67)), PRINTED)
        self.assertEqual(tables["sizes"], ["| ms | 640x480 | 1280x720 |", "| --- | ---: | ---: |",
                                           "| `Default` | 2.35 | 123 |", "| `Paper` | 45.7 |  |"])
        self.assertIsNone(tables["variants"])

    def test_frames_and_repetitions_give_medians(self):
        tables = benchmark_tables.all_tables(
            cases_of(case("Default/frames/a", 1.0, read=0.5, found=3.0), case("Default/frames/b", 3.0, read=0.25, found=6.0),
                     case("Default/frames/b", 9.0, read=0.25, found=6.0),
                     case("Default/frames/a/threads:2", 0.5),
                     {"name": "Default/frames/a_mean", "run_type": "aggregate", "real_time": 77.0}), PRINTED)
        self.assertEqual(tables["frames"][2:], ["| `Default/frames` | 0.25 |  |  |  |  |  | 3.00 | 6 |",
                                                "| `Default/threads:2/frames` |  |  |  |  |  |  | 0.50 |  |"])

    def test_rows_are_in_order_whatever_ran_first(self):
        tables = benchmark_tables.all_tables(
            cases_of(*[case(f"Scene/{name}", 1.0) for name in ("facets-64", "facets-4", "facets-16", "b", "a")],
                     *[case(f"Noise/{name}", 1.0) for name in ("x4", "x0.5", "x1")]), PRINTED)
        names = [row.split("`")[1] for row in tables["curves"][2:]]
        self.assertEqual(names, ["Noise/x0.5", "Noise/x1", "Noise/x4", "Scene/a", "Scene/b", "Scene/facets-4",
                                 "Scene/facets-16", "Scene/facets-64"])

    def test_ratios_are_those_that_were_printed(self):
        tables = benchmark_tables.all_tables(cases_of(), PRINTED)
        self.assertEqual(tables["ratios"],
                         ["```", "Ratios of the times    640x480", "paper / default           2.00", "```"])

    def test_the_page_has_every_table(self):
        page = (TOP / "docs/reference/benchmark.md").read_text(encoding="utf-8")
        for name in [*benchmark_tables.all_tables({}, ""), "machine"]:
            self.assertIn("\nnew\n", benchmark_tables.rewrite(page, {name: ["new"]}))
        with self.assertRaises(SystemExit):
            benchmark_tables.rewrite(page, {"other": ["new"]})


if __name__ == "__main__":
    unittest.main()
