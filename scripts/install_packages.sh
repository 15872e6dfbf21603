#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Installs the Debian packages the project needs, if any is missing; silent when all are there. Scripts that need more
# than the project does name it: install_packages.sh [PACKAGE...]
set -euo pipefail

packages=(
  g++ cmake ninja-build ccache git ca-certificates python3
  libeigen3-dev libhwy-dev libgeos-dev libpcl-dev libpng-dev zlib1g-dev liblzf-dev
  nlohmann-json3-dev libcli11-dev libgtest-dev librapidcheck-dev libbenchmark-dev
  python3-h5py python3-png # scripts/convert_nyu.py, with its test
  pybind11-dev python3-dev python3-numpy # the Python module
  python3-pytest python3-pip python3-setuptools python3-wheel # its tests, and the wheel
  libx11-dev xvfb # epcc_view, with its test
  pkg-config dpkg-dev file # what is installed, with its test, and the Debian packages
  "$@"
)

is_installed() {
  [[ "$(dpkg-query -W -f='${db:Status-Abbrev}' "$1" 2>/dev/null)" == ii* ]]
}

missing=()
for package in "${packages[@]}"; do
  is_installed "$package" || missing+=("$package")
done
((${#missing[@]})) || exit 0

as_root=()
if ((EUID != 0)); then
  if ! command -v sudo >/dev/null; then
    echo "install_packages.sh: neither root nor sudo, cannot install: ${missing[*]}" >&2
    exit 1
  fi
  as_root=(sudo)
fi

# apt-get with a lock timeout; sudo drops the environment, so the frontend is named here.
apt() {
  "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get -qq -o DPkg::Lock::Timeout=300 -o Acquire::Retries=3 "$@"
}

# Mirrors fail now and then: three tries, then the error counts.
retry() {
  local try
  for try in 1 2 3; do
    if "$@"; then return 0; fi
    if ((try < 3)); then sleep $((5 * try)); fi
  done
  return 1
}

log=$(mktemp)
trap 'rm -f "$log"' EXIT
install_all() {
  # A failed update is no reason to stop: older package lists may do.
  apt update >"$log" 2>&1 || true
  apt install -y --no-install-recommends "${missing[@]}" >>"$log" 2>&1
}

echo "Installing ${missing[*]} (a few minutes the first time)" >&2
if ! retry install_all; then
  tail -n 20 "$log" >&2
  echo "install_packages.sh: apt-get failed, see above" >&2
  exit 1
fi
