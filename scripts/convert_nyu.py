#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Converts the labelled part of NYU Depth V2, nyu_depth_v2_labeled.mat, to native labelled frames.

Writes nyu_0001_depth.png, nyu_0001.json and, where there are plane labels, nyu_0001_labels.png to the folder OUT, numbered
as MATLAB counts; epcc_eval and epcc_segment read that folder. Needs Debian's python3-h5py, python3-numpy and python3-png.

Depth is the variable rawDepths (what was measured, projected to the colour camera), or depths (its holes filled in) where there
is no other; 0 and all from 9.99 m, where the data set's toolbox clamps, is not measured. Units of OUT's images: 0.2 mm.

The data set has labels of objects, not of planes. Plane labels of one's own are taken from a variable "planes" of the .mat, of
the size of the depth, or else from NNNN.npy or NNNN.png (grey) in a folder "planes" beside it: 0 = no plane, 1..65534 = plane,
65535 = ignore. Where that folder exists, only the frames that have a file in it are converted.
"""

import argparse
import json
import os
import sys
import tempfile

DONE, USAGE, INPUT, OUTPUT = 0, 2, 3, 4

WIDTH, HEIGHT = 640, 480
# The colour camera of the data set's toolbox (camera_params.m: fx_rgb, fy_rgb, cx_rgb, cy_rgb); both depth variables are
# projected to it.
CAMERA = {"fx": 518.85790117450188, "fy": 519.46961112127485, "cx": 325.58244941119034, "cy": 253.73616633400465}
DEPTH_SCALE = 0.0002  # metres a unit: 16 bits hold 13.1 m
MAX_DEPTH = 9.99  # metres
IGNORE = 65535


class Failure(Exception):
    """What is wrong, in one line, and the exit code."""

    def __init__(self, code, text):
        super().__init__(" ".join(str(text).split()))
        self.code = code


class OneLineParser(argparse.ArgumentParser):
    def error(self, message):
        raise Failure(USAGE, f"{message} (see {self.prog} --help)")


def parse_arguments():
    parser = OneLineParser(
        prog="convert_nyu.py",
        description=__doc__,
        epilog="Exit codes: 0 done, 2 wrong usage, 3 the input could not be used or a Python module is missing, "
        "4 an output could not be written.",
        formatter_class=argparse.RawDescriptionHelpFormatter,
        allow_abbrev=False,
    )
    parser.add_argument("mat", metavar="FILE.mat", help="nyu_depth_v2_labeled.mat (MATLAB 7.3, which is HDF5)")
    parser.add_argument("--out", metavar="DIR", required=True, help="folder for the frames; made if need be")
    return parser.parse_args()


def load_modules():
    """The modules that are not Python's own, so that --help works without them."""
    global h5py, numpy, png
    try:
        import h5py
        import numpy
        import png
    except ImportError as error:
        raise Failure(INPUT, f"{error}; install python3-h5py, python3-numpy and python3-png") from error


def image_stack(mat, path, name):
    """The variable as HDF5 has it: images x columns x rows."""
    stack = mat[name]
    if not isinstance(stack, h5py.Dataset) or stack.ndim != 3 or stack.shape[1:] != (WIDTH, HEIGHT):
        raise Failure(INPUT, f"{path}: {name}: is not {HEIGHT} x {WIDTH} x images")
    if stack.dtype.kind not in "fiub":
        raise Failure(INPUT, f"{path}: {name}: does not hold numbers")
    return stack


def image_of(stack, path, index):
    try:
        return stack[index].T
    except OSError as error:
        raise Failure(INPUT, f"{path}: {stack.name.lstrip('/')}: image {index + 1} cannot be read, {error}") from error


def depth_units(metres):
    """Depth of the toolbox in units of the native frames, 0 = not measured."""
    measured = (metres > 0) & (metres < MAX_DEPTH)  # false for NaN
    return numpy.where(measured, numpy.rint(numpy.where(measured, metres, 0) / DEPTH_SCALE), 0).astype(numpy.uint16)


def checked_labels(values, path, field):
    if values.dtype.kind not in "fiub":
        raise Failure(INPUT, f"{path}: {field}: does not hold numbers")
    if values.size == WIDTH * HEIGHT and values.ndim == 1:
        values = values.reshape(HEIGHT, WIDTH)
    if values.shape != (HEIGHT, WIDTH):
        raise Failure(INPUT, f"{path}: {field}: is not {HEIGHT} x {WIDTH}")
    if not ((values >= 0) & (values <= IGNORE) & (values == numpy.floor(values))).all():
        raise Failure(INPUT, f"{path}: {field}: holds a value that is no whole number from 0 to {IGNORE}")
    return values.astype(numpy.uint16)


def read_label_file(path):
    try:
        if path.endswith(".npy"):
            return checked_labels(numpy.load(path, allow_pickle=False), path, "data")
        with open(path, "rb") as file:
            _, _, rows, info = png.Reader(file=file).read()
            if not info["greyscale"] or info["alpha"]:
                raise Failure(INPUT, f"{path}: color type: is not greyscale")
            return checked_labels(numpy.array([list(row) for row in rows]), path, "size")
    except (OSError, ValueError, EOFError, png.Error) as error:
        raise Failure(INPUT, f"{path}: file: {error}") from error


class PlaneLabels:
    """The labels of a frame by its index: those of the variable, else those of the folder, else none."""

    def __init__(self, mat, path, count):
        self.path = path
        self.stack = image_stack(mat, path, "planes") if "planes" in mat else None
        if self.stack is not None and len(self.stack) != count:
            raise Failure(INPUT, f"{path}: planes: has not as many images as the depth")
        folder = os.path.join(os.path.dirname(path), "planes")
        self.folder = folder if self.stack is None and os.path.isdir(folder) else None

    def _file(self, index):
        for ending in (".png", ".npy"):
            file = os.path.join(self.folder, f"{index + 1:04d}{ending}")
            if os.path.exists(file):
                return file
        return None

    def wants(self, index):
        return self.folder is None or self._file(index) is not None

    def read(self, index):
        if self.stack is not None:
            return checked_labels(image_of(self.stack, self.path, index), self.path, "planes")
        return read_label_file(self._file(index)) if self.folder is not None else None


def write_whole(path, write):
    """Under a hidden name first: whoever finds the file finds all of it."""
    try:
        handle, temporary = tempfile.mkstemp(prefix=".epcc-", suffix=".tmp", dir=os.path.dirname(path))
        try:
            with os.fdopen(handle, "wb") as file:
                write(file)
            os.chmod(temporary, 0o666 & ~UMASK)
            os.replace(temporary, path)
        except BaseException:
            os.unlink(temporary)
            raise
    except OSError as error:
        raise Failure(OUTPUT, f"{path}: file: {error.strerror}") from error


def write_gray16(path, image):
    writer = png.Writer(WIDTH, HEIGHT, greyscale=True, bitdepth=16)
    write_whole(path, lambda file: writer.write(file, image.tolist()))


def write_frame(base, depth, labels):
    camera = {"width": WIDTH, "height": HEIGHT, **CAMERA, "depth_scale": DEPTH_SCALE, "noise": "kinect-v1"}
    camera["source"] = "NYU Depth V2, labelled"
    write_gray16(base + "_depth.png", depth)
    if labels is not None:
        write_gray16(base + "_labels.png", labels)
    write_whole(base + ".json", lambda file: file.write((json.dumps(camera, indent=1) + "\n").encode()))


def open_mat(path):
    if not os.path.isfile(path):
        raise Failure(INPUT, f"{path}: file: {'is not a regular file' if os.path.exists(path) else 'does not exist'}")
    try:
        return h5py.File(path, "r")
    except OSError as error:
        raise Failure(INPUT, f"{path}: file: is not a MATLAB 7.3 (HDF5) file, or cut short: {error}") from error


def convert(path, out):
    with open_mat(path) as mat:
        depth_name = "rawDepths" if "rawDepths" in mat else "depths"
        if depth_name not in mat:
            raise Failure(INPUT, f"{path}: depths: is missing")
        depths = image_stack(mat, path, depth_name)
        labels = PlaneLabels(mat, path, len(depths))
        wanted = [index for index in range(len(depths)) if labels.wants(index)]
        if not wanted:
            raise Failure(INPUT, f"{labels.folder or path}: there is no frame to convert")
        try:
            os.makedirs(out, exist_ok=True)
        except OSError as error:
            raise Failure(OUTPUT, f"{out}: folder: cannot be made, {error.strerror}") from error
        for index in wanted:
            depth = depth_units(image_of(depths, path, index))
            write_frame(os.path.join(out, f"nyu_{index + 1:04d}"), depth, labels.read(index))
            if sys.stderr.isatty():
                print(f"\r\033[K{index + 1}/{len(depths)} frames", end="", file=sys.stderr, flush=True)
        if sys.stderr.isatty():
            print("\r\033[K", end="", file=sys.stderr, flush=True)
    print(f"{len(wanted)} {'frame' if len(wanted) == 1 else 'frames'} in {out}")


def main():
    try:
        arguments = parse_arguments()
        load_modules()
        convert(arguments.mat, arguments.out)
        return DONE
    except Failure as failure:
        print(f"convert_nyu.py: {failure}", file=sys.stderr)
        return failure.code


UMASK = os.umask(0)
os.umask(UMASK)

if __name__ == "__main__":
    sys.exit(main())
