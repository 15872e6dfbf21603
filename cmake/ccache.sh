#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# The compiler through ccache. Paths below the sources count relative to them, so that a fresh clone anywhere else, as
# CI has it, finds what another one has compiled.
CCACHE_BASEDIR=$(cd "$(dirname "$0")/.." && pwd) CCACHE_NOHASHDIR=1 exec ccache "$@"
