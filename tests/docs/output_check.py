# SPDX-License-Identifier: BSD-3-Clause
"""Compares what a program prints with what a document says: words alike, whole numbers to a fifth of a percent, others
to one unit of the last digit shown, for the last bit of a mathematics library may move a pixel."""
import re

NUMBER = re.compile(r"-?\d+(?:\.\d+)?(?:e[-+]?\d+)?")


def alike(said, printed):
    decimals = len(re.sub(r"e.*", "", said).partition(".")[2])
    last_digit = 1.01 * 10.0 ** -decimals if decimals else 0.0
    return abs(float(said) - float(printed)) <= max(0.002 * abs(float(said)), last_digit)


def difference(said, printed):
    """Empty if the texts agree, else the first lines that do not."""
    said_lines, printed_lines = said.rstrip().splitlines(), printed.rstrip().splitlines()
    for number, line in enumerate(said_lines):
        other = printed_lines[number] if number < len(printed_lines) else "(nothing)"
        same_words = NUMBER.sub("#", line).split() == NUMBER.sub("#", other).split()
        if not same_words or not all(map(alike, NUMBER.findall(line), NUMBER.findall(other))):
            return f"said:    {line}\nprinted: {other}"
    if len(printed_lines) > len(said_lines):
        return f"printed, not said: {printed_lines[len(said_lines)]}"
    return ""
