#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Writes a program's man page (packed by gzip) and the script by which bash completes its command line, both from what
its --help says."""
import argparse
import gzip
import os
import sys
from pathlib import Path

from bash_completion import bash_completion
from help_text import output_of, read_command
from man_page import man_page


def write(path, data):
    """All of the file or none of it."""
    path.parent.mkdir(parents=True, exist_ok=True)
    part = path.with_name(f".{path.name}.part")
    part.write_bytes(data)
    os.replace(part, path)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("program", help="path of the program")
    parser.add_argument("--man", type=Path, required=True, metavar="NAME.1.gz")
    parser.add_argument("--completion", type=Path, required=True, metavar="FILE")
    parser.add_argument("--see-also", nargs="*", default=[], metavar="PROGRAM", help="what the page refers to")
    arguments = parser.parse_args()
    try:
        command = read_command(arguments.program)
    except ValueError as error:
        sys.exit(f"write_pages.py: {error}")
    version = output_of(arguments.program, "--version").split()[-1]
    page = man_page(command, version, arguments.see_also)
    write(arguments.man, gzip.compress(page.encode("utf-8"), 9, mtime=0))  # the same page, the same file
    write(arguments.completion, bash_completion(command, arguments.program).encode("utf-8"))


if __name__ == "__main__":
    main()
