#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Installs what is missing, builds release and prints the comparison table: reproduce.sh [--paper|--default] [...]
# Further options go to epcc_compare, see docs/research/comparison.md. Tables and Fig. 21 are left in results/.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

scripts/prepare.sh epcc_compare
exec build/release/bin/epcc_compare "$@"
