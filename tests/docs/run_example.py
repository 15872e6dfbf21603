# SPDX-License-Identifier: BSD-3-Clause
"""Runs an example and compares its output with the comment at its end: run_example.py SOURCE PROGRAM [ARG...]"""
import subprocess
import sys

from output_check import difference


def promised(source):
    comment = "#" if source.endswith(".py") else "//"
    lines = open(source, encoding="utf-8").read().splitlines()
    start = max(i for i, line in enumerate(lines) if line.startswith(f"{comment} Prints"))
    return "\n".join(line[len(f"{comment}   "):] for line in lines[start + 1:])


said = promised(sys.argv[1])
run = subprocess.run(sys.argv[2:], stdout=subprocess.PIPE, text=True, check=False)
if run.returncode != 0:
    sys.exit(f"{sys.argv[2]} ended with {run.returncode}")
problem = difference(said, run.stdout) if said else "the source does not say what it prints"
sys.exit(problem or 0)
