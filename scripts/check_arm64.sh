#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Fails if the core does not compile for arm64, whose vector unit (NEON) no build for x86-64 looks at. Nothing is linked
# or run: that takes a cross compiler, and headers that suit every processor. Exit code 77 where it is not installed.
# Code is made of the kernels alone, little optimised: whether their instructions can be had shows only then. All else
# has nothing that knows the processor, and is only read.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

compiler=aarch64-linux-gnu-g++
if ! command -v "$compiler" >/dev/null; then
  echo "check_arm64.sh: $compiler is not installed (Debian: g++-aarch64-linux-gnu)" >&2
  exit 77
fi

# Warnings and definitions are those that the build has, read where it reads them.
mapfile -t flags < <(grep -oE -- ' -[Wf][a-z-]+(=[a-z]+)?' cmake/EpccTargets.cmake | tr -d ' ')
mapfile -t definitions < <(grep -oE 'HWY_[A-Z0-9_]+=(0|1|\([A-Z0-9_|]+\))' epcc_segmentation/CMakeLists.txt)
if ((${#flags[@]} < 5 || ${#definitions[@]} != 2)); then
  echo "check_arm64.sh: the flags in cmake/EpccTargets.cmake or epcc_segmentation/CMakeLists.txt are not as they were" >&2
  exit 1
fi
command=("$compiler" -std=c++17 -fPIC "${flags[@]}" "${definitions[@]/#/-D}" -isystem /usr/include/eigen3
  -Iepcc_segmentation/include -Iepcc_segmentation/src)
if command -v ccache >/dev/null; then command=(ccache "${command[@]}"); fi

folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
mapfile -t sources < <(scripts/source_files.sh . .cpp | grep '^epcc_segmentation/src/' | grep -v '/pcl/')
mapfile -t kernels < <(grep -l 'hwy/foreach_target.h' "${sources[@]}")
mapfile -t others < <(grep -L 'hwy/foreach_target.h' "${sources[@]}")
if ((${#kernels[@]} < 10)); then
  echo "check_arm64.sh: the kernels are not where they were" >&2
  exit 1
fi

# All but the kernels in a row, as a unity build has it: most of the time goes into the headers.
printf '#include "%s"\n' "${others[@]}" >"$folder/others.cpp"
read_others() {
  "${command[@]}" -I. -fsyntax-only "$folder/others.cpp"
}
compile() {
  "${command[@]}" -O1 -c "$1" -o "$folder/${1//\//_}.o"
}

# One compiler a core.
failed=0
read_others &
running=1
for source in "${kernels[@]}"; do
  if ((running == $(nproc))); then
    wait -n || ((++failed))
    ((--running)) || true
  fi
  compile "$source" &
  ((++running))
done
for (( ; running > 0; --running)); do wait -n || ((++failed)); done
if ((failed)); then
  echo "check_arm64.sh: the core does not compile for arm64" >&2
  exit 1
fi
echo "${#sources[@]} sources compile for arm64"
