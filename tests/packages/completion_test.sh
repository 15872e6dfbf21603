#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# What bash completes for a program: every option that its --help names, and the words, files and folders that some of
# them take; and its man page names every option: completion_test.sh PROGRAM COMPLETION MAN_PAGE
set -euo pipefail

program=$1 name=$(basename "$1") page=$3
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
# shellcheck source=/dev/null
source "$2"
fail() {
  echo "completion_test.sh: $name: $*" >&2
  exit 1
}

# completed WORD...: what is offered for the last word, a line each; as bash has it, = and : are words of their own.
completed() {
  COMP_WORDS=("$name" "$@")
  COMP_CWORD=$#
  COMPREPLY=()
  "_$name"
  if ((${#COMPREPLY[@]})); then printf '%s\n' "${COMPREPLY[@]}"; fi
}
offers() { # offers "WORD WORD" EXPECTED...: the words as typed, what must be among the offers
  local typed offered expected
  read -ra typed <<<"$1"
  if [[ -z $1 || $1 == *" " ]]; then typed+=(""); fi
  offered=$(cd "$folder" && completed "${typed[@]}")
  for expected in "${@:2}"; do
    grep -qxF -- "$expected" <<<"$offered" || fail "'$1' does not offer '$expected' but: $offered"
  done
}
offers_only() {
  local typed offered
  read -ra typed <<<"$1"
  if [[ -z $1 || $1 == *" " ]]; then typed+=(""); fi
  offered=$(cd "$folder" && completed "${typed[@]}" | sort | tr '\n' ' ')
  [[ $offered == "${*:2} " || -z $offered$2 ]] || fail "'$1' offers '$offered' instead of '${*:2}'"
}

complete -p "$name" >/dev/null || fail "is not completed"

# Every word in the help's first column that starts with dashes.
options_of() { "$program" "$@" --help | grep -oE '^  -[^ ]+' | tr -d ' ' | tr ',' '\n' | sort -u; }
mapfile -t options < <(options_of)
((${#options[@]} > 3)) || fail "--help names hardly an option"
offers "-" "${options[@]}"
offers "--ver" --version
offers_only "--versi" --version
zcat "$page" | sed 's/\\//g; s/f[BIR]//g' >"$folder/page"
for option in "${options[@]}"; do
  grep -qE -- "(^|[ ,])$option( |,|\$)" "$folder/page" || fail "the man page does not name $option"
done
if command -v man >/dev/null; then
  problems=$(man --warnings -E UTF-8 -l "$page" 2>&1 >/dev/null)
  [[ -z $problems ]] || fail "man: $problems"
fi
if command -v mandoc >/dev/null; then
  problems=$(zcat "$page" | mandoc -T lint -W warning) || fail "mandoc: $problems"
fi

mkdir "$folder/frames" "$folder/other"
touch "$folder/a.json" "$folder/a.png" "$folder/b.pcd" "$folder/c.ply" "$folder/d.obj"
case $name in
  epcc_segment | epcc_view)
    offers_only "--mode " inverse-depth paper
    offers_only "--mode = p" paper
    offers_only "--scan " both columns rows
    offers_only "--unit " cm m mm
    offers_only "--projection sc" scanner
    offers_only "--criterion " a b c d
    offers_only "--plane-weight c" cauchy
    offers "--noise " auto realsense kinect-v1 poly: a.json
    offers_only "--camera " a.json frames other
    offers_only "--fx " ""
    offers "--set inverse_depth.min_con" inverse_depth.min_confidence=
    offers_only "--set sc" ""
    offers "" a.png b.pcd frames
    ;;&
  epcc_segment)
    offers_only "--mesh " c.ply d.obj frames other
    offers_only "--out " frames other
    offers_only "--labels a" a.png
    offers "--mode paper a.png --over" --overlay
    ;;
  epcc_view)
    offers_only "--snapshot " a.png frames other
    offers_only "--draw points,m" points,mesh
    ;;
  epcc_eval)
    mapfile -t options < <(options_of merge)
    offers "merge -" "${options[@]}"
    offers_only "merge --o" --out
    offers_only "merge " frames other
    offers_only "--methods epcc,epcc-paper,re" epcc,epcc-paper,region-growing
    offers "--methods " epcc omps ransac
    offers "" merge abw: tum-fr1: frames
    offers_only "tum : fr" frames
    offers_only "--predictions mine = ot" other
    ;;
  epcc_scene)
    offers_only "" a all b c d
    offers_only "--noise white : real" realsense realsense-registered
    offers_only "--noise st" stereo stereo-registered
    offers_only "--out " frames other
    ;;
  epcc_compare)
    offers_only "study " buffer criteria distance scan weights
    offers_only "study --fi" --first-seed
    offers_only "--scenes a,b,d" a,b,d
    offers_only "s" study
    ;;
  epcc_track)
    offers "--pose" --poses --pose-free --pose-sigma
    offers "--noise " auto realsense kinect-v1
    offers "--set inverse_depth.min_con" inverse_depth.min_confidence=
    offers_only "--out " frames other
    offers "" frames
    ;;
  epcc_noise) offers "--camera " a.json ;;
  epcc_lines) offers_only "--noise " auto ;;
  *) fail "has no cases here" ;;
esac
