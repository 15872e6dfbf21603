#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Builds programs with what pkg-config says of the installed libraries: shared, below a prefix that was moved after
installing, and static, which hand on what they need themselves."""
import argparse
import os
import shutil
import subprocess
import sys
import unittest
from pathlib import Path

HERE = Path(__file__).resolve().parent
ARGUMENTS = argparse.Namespace()


def run(*command, **environment):
    done = subprocess.run([str(word) for word in command], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
                          env={**os.environ, **environment}, check=False)
    if done.returncode:
        raise AssertionError(f"{' '.join(map(str, command))}\n{done.stdout}")
    return done.stdout


def pkg_config_folder(prefix):
    return str(next(prefix.rglob("epcc_core.pc")).parent)


def build_and_run(prefix, folder, libraries, **environment):
    folder_of_packages = pkg_config_folder(prefix)
    return run(HERE / "build_with_pkg_config.sh", HERE.parent / "install_consumer/program", folder, *libraries,
               PKG_CONFIG_PATH=folder_of_packages, **environment)


class PkgConfig(unittest.TestCase):
    def setUp(self):
        shutil.rmtree(ARGUMENTS.work, ignore_errors=True)
        ARGUMENTS.work.mkdir(parents=True)

    def test_shared_below_a_moved_prefix(self):
        prefix = ARGUMENTS.work / "prefix"
        for component in ARGUMENTS.libraries:
            run("cmake", "--install", ARGUMENTS.build, "--component", component, "--prefix", prefix)
        moved = prefix.rename(ARGUMENTS.work / "moved")
        libraries = str(Path(pkg_config_folder(moved)).parent)
        build_and_run(moved, ARGUMENTS.work / "shared", ARGUMENTS.libraries, RUN_PATH=libraries)
        linked = run("ldd", ARGUMENTS.work / "shared/use_core", LD_LIBRARY_PATH=libraries)
        self.assertIn(str(Path(libraries, "libepcc_core.so").resolve().parent), linked.replace("/..", ""))
        flags = run("pkg-config", "--libs", "epcc_core", PKG_CONFIG_PATH=pkg_config_folder(moved))
        self.assertNotIn("hwy", flags)  # the library's own affair
        version = run("pkg-config", "--modversion", "epcc_core", PKG_CONFIG_PATH=pkg_config_folder(moved)).strip()
        self.assertRegex(version, r"^\d+\.\d+\.\d+$")

    def test_static(self):
        """A static build of the libraries; its archives are made of the objects of the shared ones."""
        build, prefix = ARGUMENTS.work / "static_build", ARGUMENTS.work / "static"
        libraries = [name for name in ARGUMENTS.libraries if name != "pcl"]
        run("cmake", "-S", ARGUMENTS.source, "-B", build, "-G", ARGUMENTS.generator, "-DCMAKE_BUILD_TYPE=Release",
            "-DBUILD_SHARED_LIBS=OFF", "-DEPCC_WITH_PCL=OFF", "-DEPCC_WITH_PYTHON=OFF", "-DEPCC_BUILD_TOOLS=OFF",
            "-DEPCC_BUILD_TESTS=OFF", f"-DEPCC_WITH_GEOS={'ON' if 'geometry' in libraries else 'OFF'}")
        for archive in ARGUMENTS.archives:
            path, name = archive.split("=")
            shutil.copy(path, build / "epcc_segmentation" / name)
        for component in libraries:
            run("cmake", "--install", build, "--component", component, "--prefix", prefix)
        for flags in ("", "--static"):
            build_and_run(prefix, ARGUMENTS.work / "programs", libraries, PKG_CONFIG_FLAGS=flags)
            linked = run("ldd", ARGUMENTS.work / "programs/use_core")
            self.assertNotIn("libepcc", linked)
        for library in libraries:
            run("cmake", "-S", HERE.parent / "install_consumer/program", "-B", ARGUMENTS.work / f"cmake_{library}",
                "-G", ARGUMENTS.generator, f"-DCMAKE_PREFIX_PATH={prefix}", f"-DEPCC_COMPONENT={library}")
            run("cmake", "--build", ARGUMENTS.work / f"cmake_{library}")
            run(ARGUMENTS.work / f"cmake_{library}/use_{library}")


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("build", type=Path)
    parser.add_argument("--source", type=Path, required=True)
    parser.add_argument("--work", type=Path, required=True)
    parser.add_argument("--generator", default="Ninja")
    parser.add_argument("--libraries", nargs="+", required=True, help="components: core geometry pcl")
    parser.add_argument("--archives", nargs="+", required=True, metavar="FILE=NAME")
    parser.parse_args(namespace=ARGUMENTS)
    unittest.main(argv=sys.argv[:1])
