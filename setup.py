# SPDX-License-Identifier: BSD-3-Clause
"""Builds the Python package epcc with CMake, which compiles the module and installs its files. pyproject.toml says the
rest. CMAKE_ARGS in the environment are more options for CMake."""
import os
import re
import shlex
import shutil
import subprocess
import sys
from pathlib import Path

from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext

TOP = Path(__file__).resolve().parent


def version():
    """That of the project, from its CMakeLists.txt."""
    return re.search(r"project\(\w+ VERSION ([\d.]+)", (TOP / "CMakeLists.txt").read_text(encoding="utf-8")).group(1)


class CMakeBuild(build_ext):
    """Configures the project for this Python with nothing but the module, and installs the component `python`."""

    def build_extension(self, ext):
        build = Path(self.build_temp).resolve()
        packages = Path(self.get_ext_fullpath(ext.name)).resolve().parent.parent
        options = {
            "CMAKE_BUILD_TYPE": "Release",
            "CMAKE_CXX_FLAGS_RELEASE": "-O3 -DNDEBUG",
            "EPCC_WITH_PYTHON": "ON",
            "EPCC_PYTHON3": sys.executable,
            "EPCC_PYTHON_INSTALL_DIR": ".",
            "EPCC_WITH_PCL": "OFF",
            "EPCC_BUILD_TOOLS": "OFF",
            "EPCC_BUILD_TESTS": "OFF",
            "EPCC_WARNINGS_AS_ERRORS": "OFF",
        }
        generator = ["-G", "Ninja"] if shutil.which("ninja") else []
        definitions = [f"-D{name}={value}" for name, value in options.items()]
        more = shlex.split(os.environ.get("CMAKE_ARGS", ""))
        subprocess.run(["cmake", "-S", TOP, "-B", build, *generator, *definitions, *more], check=True)
        jobs = str(self.parallel or os.cpu_count() or 1)
        subprocess.run(["cmake", "--build", build, "--target", "epcc_python", "-j", jobs], check=True)
        subprocess.run(["cmake", "--install", build, "--component", "python", "--prefix", packages], check=True)


(TOP / "build").mkdir(exist_ok=True)
setup(
    version=version(),
    packages=[],
    ext_modules=[Extension("epcc._epcc", sources=[])],
    cmdclass={"build_ext": CMakeBuild},
    options={"egg_info": {"egg_base": "build"}},  # leave nothing beside the sources
)
