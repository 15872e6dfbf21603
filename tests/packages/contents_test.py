#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Looks into the Debian packages in a folder: which there are, what they depend on, what they hold and what not."""
import argparse
import gzip
import io
import re
import subprocess
import sys
import tarfile
import unittest
from pathlib import Path

LIBRARIES = {"core": "libepcc-core", "geometry": "libepcc-geometry", "segmentation": "libepcc-segmentation"}
TOOLS = ("compare", "eval", "lines", "noise", "scene", "segment", "track")
ARGUMENTS = argparse.Namespace()


def dpkg_deb(*arguments):
    return subprocess.run(["dpkg-deb", *arguments], stdout=subprocess.PIPE, check=True).stdout


class Package:
    def __init__(self, path):
        fields = re.split(r"^(\w[\w-]*): ?", dpkg_deb("-f", path).decode("utf-8"), flags=re.MULTILINE)[1:]
        self.fields = {name: value.rstrip("\n") for name, value in zip(fields[::2], fields[1::2])}
        self.name = self.fields["Package"]
        self.archive = tarfile.open(fileobj=io.BytesIO(dpkg_deb("--fsys-tarfile", path)))
        self.entries = {entry.name[1:]: entry for entry in self.archive if not entry.isdir()}
        control = tarfile.open(fileobj=io.BytesIO(dpkg_deb("--ctrl-tarfile", path)))
        self.control = {entry.name[2:]: control.extractfile(entry).read().decode()
                        for entry in control if entry.isfile()}

    def depends(self):
        return {part.split()[0]: part for part in self.fields.get("Depends", "").split(", ") if part}

    def read(self, name):
        return self.archive.extractfile("." + name).read()


def packages():
    return {package.name: package for package in map(Package, sorted(ARGUMENTS.folder.glob("*.deb")))}


class Contents(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.packages = packages()
        cls.version = cls.packages["libepcc-core-dev"].fields["Version"]
        cls.abi = ".".join(cls.version.split(".")[:2])

    def runtime(self, stem):
        return self.packages[stem + self.abi]

    def test_names(self):
        expected = {name for stem in LIBRARIES.values() for name in (stem + self.abi, stem + "-dev")}
        expected |= {"epcc-tools", "epcc-viewer", "python3-epcc"}
        self.assertEqual(set(self.packages), expected - set(ARGUMENTS.without))

    def test_every_package_says_what_it_is(self):
        for package in self.packages.values():
            with self.subTest(package.name):
                self.assertEqual(package.fields["Version"], self.version)
                summary, *lines = package.fields["Description"].split("\n")
                self.assertLessEqual(len(summary), 70)
                self.assertRegex(summary, r"^[a-z]\S")
                self.assertGreater(len(lines), 3)
                for line in lines:
                    self.assertRegex(line, r"^ (\.$|\S)")
                    self.assertLessEqual(len(line), 80)
                documents = f"/usr/share/doc/{package.name}/"
                copyright_text = package.read(documents + "copyright").decode()
                self.assertRegex(copyright_text, r"(?m)^Copyright: .*authors$")
                licence = copyright_text.split("\nLicense: BSD-3-clause\n")[-1].splitlines()
                self.assertTrue(licence[0].startswith(" Redistribution and use in source"))
                self.assertEqual([line for line in licence if not line.startswith(" ") or not line.strip()], [])
                changes = gzip.decompress(package.read(documents + "changelog.Debian.gz")).decode()
                self.assertTrue(changes.startswith(f"epcc-segmentation ({self.version}) "))

    def test_files_belong_to_root_and_to_one_package(self):
        owner = {}
        for package in self.packages.values():
            for name, entry in package.entries.items():
                self.assertNotIn(name, owner)
                owner[name] = package.name
                self.assertTrue(name.startswith("/usr/"), name)
                self.assertEqual((entry.uname, entry.gname), ("root", "root"), name)
                if entry.isfile():
                    self.assertEqual(entry.mode, 0o755 if name.startswith("/usr/bin/") else 0o644, name)
                self.assertNotRegex(name.lower(), r"test|bench|accuracy|line_study|gtest|\.o$|\.a$")

    def test_libraries_and_their_development_files(self):
        for library, stem in LIBRARIES.items():
            if stem + "-dev" in ARGUMENTS.without:
                continue
            with self.subTest(library):
                runtime, development = self.runtime(stem), self.packages[stem + "-dev"]
                shared = {Path(name).name for name in runtime.entries if ".so" in name}
                self.assertEqual(shared, {f"libepcc_{library}.so.{self.abi}", f"libepcc_{library}.so.{self.abi}.0"})
                self.assertFalse([name for name in development.entries if ".so." in name])
                names = {Path(name).name for name in development.entries}
                self.assertLessEqual({f"libepcc_{library}.so", f"epcc_{library}.pc", f"epcc_{library}Targets.cmake"},
                                     names)
                self.assertTrue([name for name in names if name.endswith(".h")])
                self.assertEqual(development.depends()[runtime.name], f"{runtime.name} (= {self.version})")
                self.assertEqual(runtime.control["shlibs"].split()[:3], [f"libepcc_{library}", self.abi, runtime.name])
                self.assertIn("activate-noawait ldconfig", runtime.control["triggers"])
        self.assertIn("/usr/include/epcc_segmentation/plane_extractor.h", self.packages["libepcc-core-dev"].entries)

    def test_depends(self):
        expected = {
            "libepcc-core" + self.abi: ["libc6", "libstdc++6", "libhwy1"],
            "libepcc-core-dev": ["libeigen3-dev"],
            "libepcc-geometry" + self.abi: ["libc6", "libgeos-c1v5", "libepcc-core" + self.abi],
            "libepcc-geometry-dev": ["libepcc-core-dev"],
            "libepcc-segmentation" + self.abi: ["libc6", "libpcl-common1.13", "libepcc-core" + self.abi],
            "libepcc-segmentation-dev": ["libepcc-core-dev", "libpcl-dev"],
            "python3-epcc": ["libc6", "libhwy1", "python3", "python3-numpy"],
            "epcc-tools": ["libc6", "libpng16-16", "liblzf1", "libpcl-segmentation1.13", "libepcc-core" + self.abi,
                           "libepcc-geometry" + self.abi],
            "epcc-viewer": ["libpcl-visualization1.13", "libepcc-core" + self.abi, "libepcc-geometry" + self.abi],
        }
        for name, depends in expected.items():
            if name in self.packages:
                self.assertLessEqual(set(depends), set(self.packages[name].depends()), name)
        for name in self.packages:
            if not name.endswith("-dev"):
                self.assertFalse([other for other in self.packages[name].depends() if other.endswith("-dev")], name)
        # Whoever wants the core, the programs or the module has no use for windows.
        for name in ("libepcc-core" + self.abi, "libepcc-core-dev", "epcc-tools", "python3-epcc"):
            self.assertNotRegex(self.packages[name].fields["Depends"], "vtk|visualization|x11|qt")

    def test_programs_have_a_page_and_completion(self):
        programs = {f"epcc_{tool}": "epcc-tools" for tool in TOOLS}
        if "epcc-viewer" in self.packages:
            programs["epcc_view"] = "epcc-viewer"
        for program, owner in programs.items():
            package = self.packages[owner]
            page = gzip.decompress(package.read(f"/usr/share/man/man1/{program}.1.gz")).decode()
            self.assertTrue(page.startswith(f".TH {program.upper()} 1 "))
            script = package.read(f"/usr/share/bash-completion/completions/{program}").decode()
            self.assertIn(f"complete -F _{program} {program}", script)
            self.assertIn(f"/usr/bin/{program}", package.entries)
        names = [name for package in self.packages.values() for name in package.entries]
        self.assertEqual(sum(name.startswith("/usr/bin/") for name in names), len(programs))

    def test_python_module_is_compiled_and_cleaned_by_debian_s_means(self):
        package = self.packages["python3-epcc"]
        self.assertIn("py3compile -p python3-epcc", package.control["postinst"])
        self.assertIn("py3clean -p python3-epcc", package.control["prerm"])
        self.assertLessEqual({"__init__.py", "__init__.pyi", "py.typed"}, {Path(name).name for name in package.entries})
        self.assertRegex(package.fields["Depends"], r"python3 \(>= 3\.\d+\), python3 \(<< 3\.\d+\)")

    def test_folders_are_debian_s(self):
        if ARGUMENTS.prefix != "/usr":
            self.skipTest(f"configured for {ARGUMENTS.prefix}")
        folder = f"/usr/lib/{subprocess.check_output(['gcc', '-print-multiarch'], text=True).strip()}"
        development = self.packages["libepcc-core-dev"].entries
        self.assertIn(folder + "/pkgconfig/epcc_core.pc", development)
        self.assertIn(folder + "/cmake/epcc_segmentation/epcc_segmentationConfig.cmake", development)
        self.assertIn(f"{folder}/libepcc_core.so.{self.abi}", self.runtime("libepcc-core").entries)
        self.assertIn("/usr/lib/python3/dist-packages/epcc/__init__.py", self.packages["python3-epcc"].entries)


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("folder", type=Path)
    parser.add_argument("--prefix", default="/usr", help="CMAKE_INSTALL_PREFIX of the build")
    parser.add_argument("--without", nargs="*", default=[], metavar="PACKAGE",
                        help="packages that the build leaves out")
    parser.parse_args(namespace=ARGUMENTS)
    unittest.main(argv=sys.argv[:1])
