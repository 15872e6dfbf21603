#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Rewrites the tables of the benchmark page from what epcc_bench left: benchmark_tables.py OUT.json OUT.txt PAGE.md
[VERSIONS]. OUT.json is its --benchmark_out, OUT.txt what it printed. A table is what stands between
`<!-- table NAME -->` and `<!-- end of table -->`; one whose cases were not run stays as it is."""
import json
import re
import statistics
import sys
from pathlib import Path

STAGES = ["read", "sensor", "lines", "planes", "regions", "result"]
FLOORS = ["Floor", "FloorWeights", "FloorStatistics"]
OWN = ["Default", "Default/threads:2", "Paper", "Paper/threads:2", "Auto", "AutoStream", "Sensor", "PclClass"]
PEERS = ["PclOrganizedMultiPlane", "PclRegionGrowing", "PclRansac"]


def read_cases(path):
    """(method or method/variant, place) -> [case, ...]; the place of all frames of a folder is "frames"."""
    run = json.loads(Path(path).read_text(encoding="utf-8"))
    cases = {}
    for case in run["benchmarks"]:
        if case.get("error_occurred") or case.get("run_type") == "aggregate":
            continue
        method, place, *rest = case["name"].split("/")
        variant = rest[-1] if rest and (place != "frames" or rest[-1].startswith("threads:")) else ""
        key = (method + ("/" + variant if variant else ""), place)
        cases.setdefault(key, []).append(case)
    return run["context"], cases


def median(cases, field="real_time"):
    values = [case[field] for case in cases if field in case]
    return statistics.median(values) if values else None


def number(value):
    """Three digits that count."""
    if value is None:
        return ""
    return f"{value:.0f}" if value >= 100 else f"{value:.1f}" if value >= 10 else f"{value:.2f}"


def count(value):
    return "" if value is None else f"{value:g}"


def table(header, rows):
    rows = [row for row in rows if any(row[1:])]
    if not rows:
        return None
    align = ["---"] + ["---:"] * (len(header) - 1)
    return ["| " + " | ".join(row) + " |" for row in [header, align, *rows]]


def sizes(cases):
    found = {place for _, place in cases if re.fullmatch(r"\d+x\d+", place)}
    return sorted(found, key=lambda place: [int(side) for side in place.split("x")])


def by_size(cases, methods):
    places = sizes(cases)
    return table(["ms"] + places, [[f"`{method}`"] + [number(median(cases.get((method, place), []))) for place in places]
                                   for method in methods])


def with_stages(cases, keys):
    rows = [[f"`{method}/{place}`"] + [number(median(cases.get((method, place), []), stage)) for stage in STAGES]
            + [number(median(cases.get((method, place), []))), count(median(cases.get((method, place), []), "found"))]
            for method, place in keys]
    return table(["ms"] + STAGES + ["frame", "planes found"], rows)


def natural(key):
    """Sorts numbers by their value; the cases may have been run in any order."""
    return [[float(part) if re.fullmatch(r"[\d.]+", part) else 0.0, part] for text in key
            for part in re.findall(r"\d+(?:\.\d+)?|\D+", text)]


def variants(cases, kind):
    return sorted({method for method, _ in cases if re.search(rf"/{kind}", method)}, key=lambda method: natural([method]))


def all_tables(cases, printed):
    methods = list(dict.fromkeys(FLOORS + OWN + PEERS))
    frames = sorted(key for key in cases if key[1] == "frames")
    ratios = re.search(r"^Ratios of the times.*", printed, re.M | re.S)
    return {
        "sizes": by_size(cases, methods),
        "variants": by_size(cases, variants(cases, "uint16") + variants(cases, "stride:") + variants(cases, "unit:")),
        "profile": with_stages(cases, [(method, place) for place in ("640x480", "1920x1080")
                                       for method in ("Default", "Paper", "Auto", "AutoStream")]),
        "curves": with_stages(cases, sorted((key for key in cases if key[0] in ("Noise", "Scene")), key=natural)),
        "frames": with_stages(cases, frames),
        "ratios": ["```"] + [line.rstrip() for line in ratios.group().split("\n\n")[0].rstrip().splitlines()] + ["```"]
                  if ratios else None,
    }


def machine(context, versions):
    model = re.search(r"model name\s*: (.*)", Path("/proc/cpuinfo").read_text(encoding="utf-8"))
    return [f"{model.group(1) if model else 'a processor'}, {context['num_cpus']} cores, vector unit "
            f"{context.get('vector_unit', 'unknown')}; load {context['load_avg'][0]:.1f} at the start; "
            f"{context['date'][:10]}.", *([versions + "."] if versions else [])]


def rewrite(page, tables):
    for name, lines in tables.items():
        if lines is None:
            continue
        pattern = re.compile(rf"(<!-- table {name} -->\n).*?(<!-- end of table -->)", re.S)
        page, count = pattern.subn(lambda found: found[1] + "\n".join(lines) + "\n" + found[2], page)
        if count != 1:
            sys.exit(f"benchmark_tables.py: the page has no table {name}")
    return page


def main(json_path, printed_path, page_path, versions=""):
    context, cases = read_cases(json_path)
    tables = all_tables(cases, Path(printed_path).read_text(encoding="utf-8"))
    tables["machine"] = machine(context, versions)
    page = Path(page_path)
    page.write_text(rewrite(page.read_text(encoding="utf-8"), tables), encoding="utf-8")


if __name__ == "__main__":
    main(*sys.argv[1:])
