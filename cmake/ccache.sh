#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# The compiler through ccache. Paths below the sources count relative to them, so that a fresh clone anywhere else, as
# CI has it, finds what another one has compiled: in objects that count lines, too, which have relative paths in them
# (gcov_paths.sh) and where gcov needs no folder to find a source (gcno_cwd).
cmake=$(cd "$(dirname "$0")" && pwd)
CCACHE_BASEDIR=${cmake%/*} CCACHE_NOHASHDIR=1 CCACHE_SLOPPINESS=gcno_cwd CCACHE_PREFIX=$cmake/gcov_paths.sh exec ccache "$@"
