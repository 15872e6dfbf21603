#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Turns round one comparison of the measures, or of the rules by which regions and planes are joined, at a time (< to
>=, == to !=), and says which of these mutants no test notices:

    scripts/mutation_check.py [measures|merging ...] [--boundary] [--list]

All mutants of a group are in one build, of a copy of the sources: a comparison `a < b` becomes `a < Mutant<17> < b`,
which is the same until EPCC_MUTANT is 17. With --boundary a comparison is moved to its boundary instead (< to <=).
What survives must be in tests/mutation/equivalent_mutants.txt, with the reason. Takes some minutes a group and is no
part of the tests; --list only says what would be tried.
"""
import argparse
import concurrent.futures
import os
import re
import resource
import shutil
import subprocess
import sys
import time
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
WORK = ROOT / "build/mutation"
EQUIVALENT = ROOT / "tests/mutation/equivalent_mutants.txt"
CORE = "epcc_segmentation/src/"

# Sources, and test programs with the filters of their tests: the narrow ones first, for most mutants end there.
GROUPS = {
    "measures": (["eval/measures/*.cpp", "eval/measures/*.h"], [("eval_measures_test", "*")]),
    "merging": (
        [CORE + "inverse_depth/" + name + ".*" for name in (
            "direction_joining", "evidence", "merge_queue", "occluded_contacts", "plane_growing", "region_contacts",
            "region_merging", "region_pairs")] +
        [CORE + "metric/" + name + ".*" for name in ("line_clustering", "ordered_turns", "plane_clustering",
                                                     "segment_distance")],
        [("core_test", "*Region*:*Merg*:*Evidence*:*Occlu*:*Contact*:*PlaneClustering*:*PlanePrototype*:*SegmentDistance*:"
                       "*LineClustering*:*Growing*-*OnEveryUnit*"),
         ("core_threads_test", "-ManyExtractors*:WorkerPool*:OnThreads*"),
         ("core_test", "*Tracker*:*LidarRooms*:*ScanHeading*:*Carried*:*Known*:*LineSegments*:*OpenBlocks*:*Steady*"),
         ("scan_line_stream_test", "ScanLineStream*")]),
}

KINDS = {"<": "Less", "<=": "LessEqual", ">": "Greater", ">=": "GreaterEqual", "==": "Equal", "!=": "NotEqual"}
BOUNDARY = {"<": "<=", "<=": "<", ">": ">=", ">=": ">"}
COMPARISON = re.compile(r"(?<= )(<=|>=|==|!=|<|>)(?= |$)")


def masked(line):
    """The line with texts, characters and its comment blanked."""
    line = re.sub(r'"(\\.|[^"\\])*"|\'(\\.|[^\'\\])\'', lambda m: "_" * len(m.group()), line)
    comment = line.find("//")
    return line if comment < 0 else line[:comment] + " " * (len(line) - comment)


class Mutant:
    def __init__(self, number, path, line_number, line, nth, operator, column):
        self.number, self.path, self.line_number, self.line = number, path, line_number, line.strip()
        self.nth, self.operator, self.column = nth, operator, column

    def key(self, boundary):
        """What names it as long as its line is not changed."""
        kind = " boundary" if boundary else ""
        return f"{self.path} | {self.line} | {self.operator} {self.nth}{kind}"


def mutants_of(group, boundary):
    found = []
    for pattern in GROUPS[group][0]:
        for path in sorted(ROOT.glob(pattern)):
            for number, line in enumerate(path.read_text().split("\n"), 1):
                if line.startswith("#") or re.search(r"static_assert|\btemplate\b|operator", line):
                    continue
                for nth, match in enumerate(COMPARISON.finditer(masked(line)), 1):
                    if boundary and match.group() not in BOUNDARY:
                        continue
                    found.append(Mutant(len(found) + 1, str(path.relative_to(ROOT)), number, line, nth, match.group(),
                                        match.start()))
    return found


def header(boundary):
    lines = ["#pragma once", "#pragma GCC system_header", "#include <cstdlib>", "namespace epcc_mutant {",
             'inline const int active = std::getenv("EPCC_MUTANT") ? std::atoi(std::getenv("EPCC_MUTANT")) : 0;']
    for operator, kind in KINDS.items():
        other = f"l.a {BOUNDARY[operator]} b" if boundary and operator in BOUNDARY else f"!(l.a {operator} b)"
        lines += [f"template <int K> struct {kind} {{}};",
                  f"template <class A, int K> struct {kind}Left {{ const A& a; }};",
                  f"template <class A, int K> {kind}Left<A, K> operator{operator}(const A& a, {kind}<K>) {{",
                  "  return {a};", "}",
                  "template <class A, int K, class B>",
                  f"bool operator{operator}(const {kind}Left<A, K>& l, const B& b) {{",
                  f"  return active == K ? {other} : (l.a {operator} b);", "}"]
    return "\n".join(lines + ["}", ""])


def write_changed(path, text):
    """What did not change is not built again."""
    if not path.exists() or path.read_text() != text:
        path.write_text(text)


def write_sources(source, mutants, boundary):
    """The copy, with every mutant that compiles; only files that change are written."""
    write_changed(source / "mutant.h", header(boundary))
    by_file = {}
    for mutant in mutants:
        by_file.setdefault(mutant.path, []).append(mutant)
    for path, inside in by_file.items():
        lines = (ROOT / path).read_text().split("\n")
        for mutant in sorted(inside, key=lambda m: -m.column):
            line, at = lines[mutant.line_number - 1], mutant.column
            end = at + len(mutant.operator)
            middle = f"{mutant.operator} epcc_mutant::{KINDS[mutant.operator]}<{mutant.number}>{{}} {mutant.operator}"
            lines[mutant.line_number - 1] = line[:at] + middle + line[end:]
        lines.insert(0, f'#include "{source}/mutant.h"\n#pragma GCC diagnostic ignored "-Wparentheses"\n#line 1')
        write_changed(source / path, "\n".join(lines))


def build(group, mutants, boundary, data):
    """Builds the programs; returns the mutants that compile."""
    source, binaries = WORK / group, WORK / group / "build/release"
    names = subprocess.run([ROOT / "scripts/source_files.sh", ROOT, ""], check=True, capture_output=True, text=True)
    for name in names.stdout.split("\n"):
        if not name:
            continue
        target = source / name
        target.parent.mkdir(parents=True, exist_ok=True)
        if not target.exists() or target.read_bytes() != (ROOT / name).read_bytes():
            shutil.copy(ROOT / name, target)
    write_sources(source, mutants, boundary)
    # As the release build, so that ccache has what has no mutant.
    subprocess.run(["cmake", "--preset", "release", f"-DEPCC_DATA_DIR={data}"], cwd=source, check=True,
                   stdout=subprocess.DEVNULL)
    programs = sorted({program for program, _ in GROUPS[group][1]})
    while True:
        run = subprocess.run(["cmake", "--build", binaries, f"-j{os.cpu_count()}", "--target", *programs, "--", "-k",
                              "0"], capture_output=True, text=True)
        if run.returncode == 0:
            return mutants
        # Of a template the line that needs it is told, not the one in the header.
        told = [line for line in run.stdout.split("\n") if " error: " in line or "required from" in line]
        wrong = {(path, int(line)) for text in told
                 for path, line in re.findall(r"((?:eval/measures|epcc_segmentation/src)/[\w/.-]+):(\d+)", text)}
        left = [mutant for mutant in mutants if (mutant.path, mutant.line_number) not in wrong]
        if len(left) == len(mutants):
            sys.exit("mutation_check.py: the sources do not compile\n" + run.stdout[-5000:])
        for mutant in set(mutants) - set(left):
            print(f"not tried, a constant: {mutant.path}:{mutant.line_number}: {mutant.line}", flush=True)
        mutants = left
        write_sources(source, mutants, boundary)


def passes(group, number, program, tests, limit):
    command = ["prlimit", f"--cpu={limit}", WORK / group / "build/release/bin" / program,
               f"--gtest_filter={tests}", "--gtest_fail_fast", "--gtest_brief=1"]
    return subprocess.run(command, env={**os.environ, "EPCC_MUTANT": str(number)}, stdout=subprocess.DEVNULL,
                          stderr=subprocess.DEVNULL).returncode == 0


def survives(group, mutant, limits):
    return all(passes(group, mutant.number, program, tests, limits[program, tests])
               for program, tests in GROUPS[group][1])


def limits_of(group):
    """Seconds of the processor, five times what each takes without a mutant: endless loops end, a busy machine counts
    for nothing."""
    limits = {}
    for program, tests in GROUPS[group][1]:
        start = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
        if not passes(group, 0, program, tests, 3600):
            sys.exit(f"mutation_check.py: {program} fails without a mutant")
        limits[program, tests] = 5 + int(5 * (resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - start))
    return limits


def equivalent():
    lines = EQUIVALENT.read_text().split("\n") if EQUIVALENT.exists() else []
    return {line.rsplit(" | ", 1)[0] for line in lines if line and not line.startswith("#")}


def check(group, boundary, jobs, data):
    start = time.monotonic()
    mutants = build(group, mutants_of(group, boundary), boundary, data)
    limits = limits_of(group)
    known, new = equivalent(), []
    with concurrent.futures.ThreadPoolExecutor(jobs) as pool:
        for mutant, alive in zip(mutants, pool.map(lambda m: survives(group, m, limits), mutants)):
            if not alive:
                continue
            is_known = mutant.key(boundary) in known
            new += [] if is_known else [mutant]
            print(f"{'equivalent' if is_known else 'SURVIVES'}: {mutant.path}:{mutant.line_number}: "
                  f"{mutant.key(boundary)}", flush=True)
    print(f"{group}: {len(mutants)} mutants, {len(new)} survive without a reason, "
          f"{time.monotonic() - start:.0f} s", flush=True)
    return not new


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    parser.add_argument("groups", nargs="*", metavar="GROUP", help="measures, merging (both)")
    parser.add_argument("--boundary", action="store_true", help="move comparisons to their boundary (< to <=)")
    parser.add_argument("--list", action="store_true", help="only say what would be tried")
    parser.add_argument("--jobs", type=int, default=os.cpu_count(), help="test programs at a time")
    parser.add_argument("--data", default=ROOT.parent / "shared/data", help="folder with the real frames, if any")
    options = parser.parse_args()
    for group in options.groups:
        if group not in GROUPS:
            parser.error(f"there is no group '{group}'")
    good = True
    for group in options.groups or GROUPS:
        if options.list:
            for mutant in mutants_of(group, options.boundary):
                print(f"{mutant.path}:{mutant.line_number}: {mutant.key(options.boundary)}")
        else:
            good = check(group, options.boundary, options.jobs, options.data) and good
    return 0 if good else 1


if __name__ == "__main__":
    sys.exit(main())
