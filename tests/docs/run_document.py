# SPDX-License-Identifier: BSD-3-Clause
"""Does what a document tells its reader to do, in a folder that holds docs/, with the package installed beside it:

    run_document.py DOCUMENT.md --install BUILD_FOLDER --work FOLDER [--path FOLDER]
                    [--python PYTHON]

A ```cmake block is CMakeLists.txt and a ```cpp block main.cpp, which must build; a ```python block is main.py, which
must run, where --python names the interpreter that the module epcc was built for (python3 to the reader). A block
marked ```cpp fragment or ```python fragment is no whole program. In a ```console block each line after "$ " is run;
what the document shows below it is what it must print, where a line ... stands for any lines. Programs of the project
are found in the folder given by --path."""
import argparse
import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

from output_check import difference

BLOCK = re.compile(r"^```(\w+)([^\n]*)\n(.*?)^```$", re.MULTILINE | re.DOTALL)


def commands(block):
    """Pairs of a command and the output shown below it."""
    parts = re.split(r"^\$ ", block, flags=re.MULTILINE)[1:]
    return [(part.partition("\n")[0], part.partition("\n")[2].rstrip()) for part in parts]


def shown_problem(shown, printed):
    """Pieces between lines ... are found one after the other; without such lines all must agree."""
    pieces = re.split(r"^ *\.\.\.\n?", shown, flags=re.MULTILINE)
    if len(pieces) == 1:
        return difference(shown, printed)
    lines, at, problem = printed.splitlines(), 0, ""
    for piece in filter(str.strip, pieces):
        wanted = len(piece.splitlines())
        for start in range(at, len(lines) - wanted + 1):
            problem = difference(piece, "\n".join(lines[start:start + wanted]))
            if not problem:
                at = start + wanted
                break
        else:
            return f"not printed:\n{piece}\n{problem}"
    return ""


class Reader:
    def __init__(self, work, environment, has_python=False):
        self.work, self.environment, self.has_python = work, environment, has_python

    def run(self, command, shown=""):
        done = subprocess.run(command, shell=True, executable="/bin/bash", cwd=self.work, env=self.environment,
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, check=False)
        problem = f"ended with {done.returncode}" if done.returncode else ""
        if not problem and shown:
            problem = shown_problem(shown, done.stdout)
        if problem:
            sys.exit(f"$ {command}\n{done.stdout}\n{problem}")

    def follow(self, document):
        programs = 0
        for language, words, block in BLOCK.findall(document):
            if language == "cmake":
                (self.work / "CMakeLists.txt").write_text(block, encoding="utf-8")
            elif language == "cpp" and "fragment" not in words:
                (self.work / "main.cpp").write_text(block, encoding="utf-8")
                self.run("cmake -S . -B build -DCMAKE_BUILD_TYPE=Release && cmake --build build")
                programs += 1
            elif language == "python" and "fragment" not in words and self.has_python:
                (self.work / "main.py").write_text(block, encoding="utf-8")
                self.run("python3 main.py")
                programs += 1
            elif language == "console":
                for command, shown in commands(block):
                    if self.has_python or not command.startswith("python3 "):
                        self.run(command, shown)
        return programs


def python_environment(environment, prefix, python, folder):
    """What makes `python3` that interpreter and lets it find the installed module."""
    folder.mkdir()
    (folder / "python3").symlink_to(python)
    packages = next(prefix.rglob("epcc/__init__.py")).parent.parent
    return dict(environment, PYTHONPATH=str(packages), PATH=f"{folder}:{environment['PATH']}")


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("document", type=Path)
    parser.add_argument("--install", type=Path, required=True)
    parser.add_argument("--work", type=Path, required=True)
    parser.add_argument("--path", default="")
    parser.add_argument("--python", default="")
    options = parser.parse_args()
    shutil.rmtree(options.work, ignore_errors=True)
    folder = options.work / "reader"
    folder.mkdir(parents=True)
    (folder / "docs").symlink_to(Path(__file__).resolve().parents[2] / "docs")
    prefix = options.work / "prefix"
    subprocess.run(["cmake", "--install", options.install, "--prefix", prefix], stdout=subprocess.DEVNULL, check=True)
    environment = dict(os.environ, CMAKE_PREFIX_PATH=str(prefix), PATH=f"{options.path}:{os.environ['PATH']}")
    if options.python:
        environment = python_environment(environment, prefix, options.python, options.work / "python")
    programs = Reader(folder, environment, bool(options.python)).follow(options.document.read_text(encoding="utf-8"))
    print(f"{programs} programs of {options.document.name} built or run")


if __name__ == "__main__":
    main()
