# SPDX-License-Identifier: BSD-3-Clause
"""convert_nyu.py on small .mat files as MATLAB stores them: HDF5 behind 512 bytes of text, images transposed.

Arguments: convert_nyu.py and epcc_segment, which must be able to read what the script writes. Exit code 77: skipped.
"""

import json
import os
import subprocess
import sys
import tempfile
import unittest

try:
    import h5py
    import numpy
    import png
except ImportError as missing:
    print(f"skipped: {missing}; install python3-h5py and python3-png")
    sys.exit(77)

SEGMENT = sys.argv.pop()
SCRIPT = sys.argv.pop()
COUNT, WIDTH, HEIGHT = 3, 640, 480

ROWS, COLUMNS = numpy.mgrid[0:HEIGHT, 0:WIDTH]
# Metres of each image, rows x columns.
DEPTHS = numpy.stack([1.0 + n + 0.001 * ROWS + 0.0001 * COLUMNS for n in range(COUNT)]).astype(numpy.float32)
PLANES = numpy.stack([numpy.where(COLUMNS < 10 + n, 0, numpy.where(ROWS < 5, 1, 300)) for n in range(COUNT)])


class ConvertNyu(unittest.TestCase):
    def setUp(self):
        self.temporary = tempfile.TemporaryDirectory(prefix="epcc-test-")
        self.addCleanup(self.temporary.cleanup)
        self.mat = self.path("nyu_depth_v2_labeled.mat")
        self.out = self.path("out")

    def path(self, name):
        return os.path.join(self.temporary.name, name)

    def write_mat(self, **variables):
        with h5py.File(self.mat, "w", userblock_size=512) as file:
            for name, stack in variables.items():
                upright = stack.ndim == 3
                data = stack.transpose(0, 2, 1) if upright else stack
                chunks = (1, 160, 120) if upright and data.shape[1] >= 160 else None
                file.create_dataset(name, data=data, chunks=chunks, compression="gzip" if chunks else None)

    def run_script(self, *arguments):
        return subprocess.run([sys.executable, SCRIPT, *arguments], capture_output=True, text=True, check=False)

    def convert(self):
        result = self.run_script(self.mat, "--out", self.out)
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertEqual(result.stderr, "")
        return result.stdout

    def expect_failure(self, code, words, *arguments):
        result = self.run_script(*(arguments or (self.mat, "--out", self.out)))
        self.assertEqual(result.returncode, code, result.stderr)
        self.assertEqual(result.stdout, "")
        self.assertEqual(result.stderr.count("\n"), 1, result.stderr)
        self.assertTrue(result.stderr.startswith("convert_nyu.py: "), result.stderr)
        self.assertIn(words, result.stderr)

    def image(self, name):
        with open(os.path.join(self.out, name), "rb") as file:
            _, _, rows, info = png.Reader(file=file).read()
            self.assertEqual(info["bitdepth"], 16)
            self.assertTrue(info["greyscale"])
            return numpy.array([list(row) for row in rows])

    def test_depth_is_turned_upright_in_units_of_the_scale(self):
        self.write_mat(depths=DEPTHS)
        self.assertEqual(self.convert(), f"3 frames in {self.out}\n")
        names = [f"nyu_000{n}{ending}" for n in (1, 2, 3) for ending in (".json", "_depth.png")]
        self.assertEqual(sorted(os.listdir(self.out)), sorted(names))
        with open(os.path.join(self.out, "nyu_0002.json"), encoding="utf-8") as file:
            camera = json.load(file)
        self.assertEqual((camera["width"], camera["height"]), (640, 480))
        self.assertAlmostEqual(camera["fx"], 518.857901, 6)
        self.assertAlmostEqual(camera["fy"], 519.469611, 6)
        self.assertAlmostEqual(camera["cx"], 325.582449, 6)
        self.assertAlmostEqual(camera["cy"], 253.736166, 6)
        self.assertEqual(camera["noise"], "kinect-v1")
        metres = self.image("nyu_0002_depth.png") * camera["depth_scale"]
        self.assertLessEqual(numpy.abs(metres - DEPTHS[1]).max(), 0.000101)

    def test_what_was_measured_goes_before_what_was_filled_in(self):
        raw = numpy.full((COUNT, HEIGHT, WIDTH), 2.0, numpy.float32)
        raw[:, 0], raw[:, 1], raw[:, 2], raw[:, 3] = 0.0, 10.0, numpy.nan, -1.0
        self.write_mat(depths=DEPTHS, rawDepths=raw)
        self.convert()
        depth = self.image("nyu_0001_depth.png")
        self.assertTrue((depth[:4] == 0).all())
        self.assertTrue((depth[4:] == 10000).all())

    def test_planes_of_the_variable(self):
        self.write_mat(depths=DEPTHS, planes=PLANES.astype(numpy.uint16))
        self.convert()
        self.assertTrue((self.image("nyu_0003_labels.png") == PLANES[2]).all())

    def test_planes_of_the_folder_choose_the_frames(self):
        self.write_mat(depths=DEPTHS)
        os.mkdir(self.path("planes"))
        self.expect_failure(3, "no frame")
        numpy.save(self.path("planes/0003.npy"), PLANES[2].ravel().astype(numpy.float64))
        png.from_array(PLANES[1].tolist(), "L;16").save(self.path("planes/0002.png"))
        self.assertEqual(self.convert(), f"2 frames in {self.out}\n")
        self.assertFalse(os.path.exists(os.path.join(self.out, "nyu_0001.json")))
        self.assertTrue((self.image("nyu_0002_labels.png") == PLANES[1]).all())
        self.assertTrue((self.image("nyu_0003_labels.png") == PLANES[2]).all())

    def test_frames_are_read_by_the_programs(self):
        self.write_mat(depths=DEPTHS)
        self.convert()
        result = subprocess.run([SEGMENT, self.out], capture_output=True, text=True, check=False)
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertEqual(result.stdout.count(": 640x480, "), 3, result.stdout)
        self.assertIn("noise kinect-v1", result.stdout)

    def test_bad_files(self):
        self.expect_failure(3, "does not exist")
        self.expect_failure(3, "is not a regular file", self.temporary.name, "--out", self.out)
        with open(self.mat, "wb") as file:
            file.write(b"MATLAB 5.0 MAT-file")
        self.expect_failure(3, "is not a MATLAB 7.3")
        self.write_mat()
        self.expect_failure(3, "depths: is missing")
        self.write_mat(depths=DEPTHS[:, :, :64])
        self.expect_failure(3, "depths: is not 480 x 640 x images")
        self.write_mat(depths=DEPTHS, planes=PLANES[:2])
        self.expect_failure(3, "planes: has not as many images")
        self.assertFalse(os.path.exists(self.out))
        self.write_mat(depths=DEPTHS, planes=PLANES + 0.5)
        self.expect_failure(3, "planes: holds a value")
        self.write_mat(depths=DEPTHS)
        with open(self.mat, "r+b") as file:
            file.truncate(os.path.getsize(self.mat) * 2 // 3)
        self.expect_failure(3, self.mat)

    def test_bad_label_files(self):
        self.write_mat(depths=DEPTHS)
        os.mkdir(self.path("planes"))
        for name, content in (("0001.npy", b"x"), ("0001.png", b"no picture"), ("0001.png", b"")):
            with open(self.path("planes/" + name), "wb") as file:
                file.write(content)
            self.expect_failure(3, "planes/" + name)
        png.from_array([[0] * 3 * WIDTH] * HEIGHT, "RGB").save(self.path("planes/0001.png"))
        self.expect_failure(3, "is not greyscale")

    def test_usage(self):
        self.expect_failure(2, "FILE.mat", "--out", self.out)
        self.expect_failure(2, "--out", self.mat)
        self.expect_failure(2, "--frob", self.mat, "--out", self.out, "--frob")
        help_text = self.run_script("--help")
        self.assertEqual(help_text.returncode, 0)
        for words in ("--out", "FILE.mat", "Exit codes"):
            self.assertIn(words, help_text.stdout)

    def test_output_that_cannot_be_written(self):
        self.write_mat(depths=DEPTHS)
        with open(self.out, "wb") as file:
            file.write(b"kept")
        self.expect_failure(4, "cannot be made")
        os.remove(self.out)
        os.makedirs(os.path.join(self.out, "nyu_0001_depth.png"))
        self.expect_failure(4, "nyu_0001_depth.png: file: ")
        self.assertEqual(os.listdir(self.out), ["nyu_0001_depth.png"])


if __name__ == "__main__":
    unittest.main()
