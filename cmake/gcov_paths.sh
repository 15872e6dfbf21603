#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# What ccache calls to compile an object that counts lines, which names its counts by its path below the build. ccache
# must not see the option, for it would tell clones apart by it.
exec "$@" "-fprofile-prefix-path=$PWD/"
