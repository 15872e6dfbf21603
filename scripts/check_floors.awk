# SPDX-License-Identifier: BSD-3-Clause
# The rules of check_floors.sh. Reads lines "arrows FLOOR: ...", then "file PATH", then "include PATH:LINE:#include ...".

BEGIN {
  rank["epcc_segmentation"] = 1; rank["datasets"] = 2; rank["baselines"] = 3; rank["eval"] = 4; rank["tests"] = 5
}

# The first folder of a path, and the second.
function floor_of(path) { sub("/.*", "", path); return path }
function room_of(path, parts) { return split(path, parts, "/") > 2 ? parts[2] : "" }

function is_inner(path) { return path ~ "^epcc_segmentation/src/" }

# The project's file that an include names, or nothing.
function resolved(file, name, folder, places, i, path) {
  folder = file
  sub("[^/]*$", "", folder)
  split(folder " |epcc_segmentation/include/|epcc_segmentation/src/", places, "|")
  places[1] = folder
  places[4] = ""
  for (i = 1; i <= 4; ++i) {
    path = places[i] name
    while (sub("[^/]+/\\.\\./", "", path)) { }
    if (path in exists) return path
  }
  return ""
}

# Rooms may use what stands behind an arrow, and what those may use.
function read_arrows(floor, text, chains, steps, users, used, c, s, t, u, v) {
  gsub(" ", "", text)
  split(text, chains, ";")
  for (c in chains) {
    split(chains[c], steps, "->")
    for (s = 1; s in steps; ++s) {
      split(steps[s], users, ",")
      for (t = s + 1; t in steps; ++t) {
        split(steps[t], used, ",")
        for (u in users) for (v in used) arrow[floor, users[u], used[v]] = 1
      }
    }
  }
}

function problem(text) {
  print place ": " text > "/dev/stderr"
  failed = 1
}

function check(file, target, own, other, from, to) {
  own = floor_of(file)
  other = floor_of(target)
  from = room_of(file)
  to = room_of(target)
  if (rank[own] < rank[other]) {
    problem(own " includes " target ", a floor above it")
  } else if (is_inner(target) && file ~ "^epcc_segmentation/include/") {
    problem("a public header includes " target)
  } else if (is_inner(target) && own != "epcc_segmentation" && file !~ "^tests/epcc_segmentation/") {
    problem("includes " target ", which only the core and its tests may")
  } else if (own == other && own in has_arrows && from != to && !((own, from, to) in arrow)) {
    problem("no arrow leads from " own "/" from " to " target)
  }
}

{ kind = $1; sub("^[a-z]* ", "") }
kind == "arrows" {
  split($0, head, ": ")
  has_arrows[head[1]] = 1
  read_arrows(head[1], head[2])
}
kind == "file" { exists[$0] = 1 }
kind == "include" && match($0, "^[^:]*:[0-9]*:") {
  place = substr($0, 1, RLENGTH - 1)
  file = place
  sub(":.*", "", file)
  name = $0
  sub("^[^\"<]*[\"<]", "", name)
  sub("[\">].*", "", name)
  target = resolved(file, name)
  if (target != "" && floor_of(file) in rank && floor_of(target) in rank) check(file, target)
}
END { exit failed }
