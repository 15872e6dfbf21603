#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# The compiler through ccache. Paths below the sources count relative to them, so that a fresh clone anywhere else, as
# CI has it, finds what another one has compiled.
cmake=$(cd "$(dirname "$0")" && pwd)
export CCACHE_BASEDIR="${cmake%/*}" CCACHE_NOHASHDIR=1
# An object that counts lines is shared, too: it has relative paths in it (gcov_paths.sh), with which gcov needs no
# folder to find a source (gcno_cwd). ccache takes a prefix with a space in its path for two, and finds it by its name.
for option; do
  if [ "$option" = --coverage ]; then
    export PATH="$cmake:$PATH" CCACHE_PREFIX=gcov_paths.sh CCACHE_SLOPPINESS=gcno_cwd
  fi
done
exec ccache "$@"
