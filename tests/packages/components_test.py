#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Installs a build component by component, below DESTDIR and below another prefix: together they are what is installed
without saying a component, no file is of two, and nothing of the tests is among them."""
import argparse
import os
import shutil
import subprocess
import sys
import unittest
from pathlib import Path

ARGUMENTS = argparse.Namespace()
TYPICAL = {
    "core": ["libepcc_core.so", "plane_extractor.h", "epcc_core.pc", "epcc_segmentationConfig.cmake"],
    "geometry": ["libepcc_geometry.so", "surface_mesh.h", "epcc_geometry.pc", "epcc_geometryTargets.cmake"],
    "pcl": ["libepcc_segmentation.so", "epcc_segmentation.hpp", "epcc_segmentation.pc",
            "epcc_segmentationTargets.cmake"],
    "python": ["__init__.py", "__init__.pyi", "py.typed"],
    "tools": ["epcc_segment", "epcc_eval", "epcc_segment.1.gz"],
    "viewer": ["epcc_view", "epcc_view.1.gz"],
}


def install(name, *options, destdir=None):
    """The files installed below work/NAME, relative to it."""
    top = ARGUMENTS.work / name
    shutil.rmtree(top, ignore_errors=True)
    environment = {key: value for key, value in os.environ.items() if key != "DESTDIR"}
    if destdir:
        environment["DESTDIR"] = str(top)
    else:
        options += ("--prefix", str(top))
    command = ["cmake", "--install", str(ARGUMENTS.build), *options]
    subprocess.run(command, check=True, stdout=subprocess.DEVNULL, env=environment)
    return {str(path.relative_to(top)) for path in top.rglob("*") if not path.is_dir() or path.is_symlink()}


class Components(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.everything = install("everything")
        cls.parts = {name: install(name, "--component", name) for name in ARGUMENTS.components}

    def test_parts_are_the_whole(self):
        files = [file for part in self.parts.values() for file in part]
        self.assertEqual(sorted(files), sorted(self.everything))

    def test_each_has_its_files(self):
        for name, part in self.parts.items():
            self.assertLessEqual(set(TYPICAL[name]), {Path(file).name for file in part}, name)

    def test_nothing_of_the_tests(self):
        for file in self.everything:
            self.assertNotRegex(file.lower(), r"test|bench|gtest|accuracy|line_study|\.o$")

    def test_destdir(self):
        below = install("destdir", destdir=True)
        prefix = ARGUMENTS.prefix.lstrip("/")
        self.assertEqual(below, {f"{prefix}/{file}" for file in self.everything})

    def test_no_file_names_the_build(self):
        top = ARGUMENTS.work / "everything"
        for file in self.everything:
            if file.endswith((".cmake", ".pc", ".py")) or "completions/" in file:
                text = (top / file).read_text(encoding="utf-8")
                self.assertNotIn(str(ARGUMENTS.build), text, file)
                self.assertNotIn(str(ARGUMENTS.work), text, file)

    def test_installed_programs_find_their_libraries(self):
        if "tools" not in self.parts:
            self.skipTest("without the tools")
        for name in ("epcc_segment", "epcc_eval"):
            subprocess.run([ARGUMENTS.work / "everything/bin" / name, "--version"], check=True,
                           stdout=subprocess.DEVNULL)
        shown = subprocess.run(["readelf", "-d", ARGUMENTS.work / "everything/bin/epcc_segment"], check=True,
                               stdout=subprocess.PIPE, text=True).stdout
        self.assertNotIn(str(ARGUMENTS.build), shown)


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("build", type=Path)
    parser.add_argument("--work", type=Path, required=True)
    parser.add_argument("--prefix", required=True, help="CMAKE_INSTALL_PREFIX of the build")
    parser.add_argument("--components", nargs="+", required=True)
    parser.parse_args(namespace=ARGUMENTS)
    unittest.main(argv=sys.argv[:1])
