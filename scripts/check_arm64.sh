#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Fails if the core does not compile for arm64, whose vector unit (NEON) no build for x86-64 looks at. Nothing is linked
# or run: that takes a cross compiler, and headers that suit every processor. The kernels are compiled, little optimised:
# whether their instructions can be had shows only then. All else must have nothing that only one processor knows, and
# is searched for that: compiling it for another would read the same headers once more, for minutes.
# Exit code 77 where the compiler is not installed.
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

mapfile -t sources < <(scripts/source_files.sh . .cpp | grep '^epcc_segmentation/src/' | grep -v '/pcl/')
mapfile -t kernels < <(grep -l 'hwy/foreach_target.h' "${sources[@]}")
if ((${#kernels[@]} < 10)); then
  echo "check_arm64.sh: the kernels are not where they were" >&2
  exit 1
fi

one_processor='immintrin|x86intrin|arm_neon|arm_sve|__builtin_(ia32|arm|aarch64)|_mm[0-9]*_|__x86_64__|__aarch64__|__asm'
if grep -rnE "$one_processor" epcc_segmentation/src epcc_segmentation/include; then
  echo "check_arm64.sh: these lines are for one processor; kernels are written with Highway" >&2
  exit 1
fi

folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
compile() { "${command[@]}" -O1 -c "$1" -o "$folder/${1//\//_}.o"; }

# One compiler a core.
failed=0
running=0
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
echo "${#kernels[@]} kernels compile for arm64, and nothing else of ${#sources[@]} sources is for one processor"
