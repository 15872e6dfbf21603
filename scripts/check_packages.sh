#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Run before a release: builds the Debian packages (build/package/packages/) and inspects them; then, as root and where
# debootstrap is installed, installs them into a bare Debian 12, runs the programs and the Python module there, builds
# programs against the libraries, removes the packages and shows that nothing is left. Half an hour at most, most of it
# downloads: check_packages.sh [FOLDER], a folder with a bare Debian 12 that is kept for the next time and not changed
# (build/debian12).
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

base=$(realpath -m "${1:-build/debian12}")
packages=build/package/packages
system=$PWD/build/debian12-with-packages
log=$PWD/build/check_packages.log
quietly() { # what a command says is shown only if it fails
  if ! "$@" >>"$log" 2>&1; then
    tail -n 30 "$log" >&2
    echo "check_packages.sh: failed: $*; see $log" >&2
    exit 1
  fi
}
stage() { printf '==== %s (after %d s)\n' "$1" "$SECONDS"; }

stage "Packages"
scripts/install_packages.sh
mkdir -p build
: >"$log"
rm -rf "$packages"
quietly cmake --preset package
quietly cmake --build --preset package
quietly cpack --config build/package/CPackConfig.cmake
stage "Contents"
python3 -B tests/packages/contents_test.py "$packages" --prefix /usr
if command -v lintian >/dev/null; then
  # The maintainer's address is for whoever publishes the packages to give (EPCC_PACKAGE_CONTACT).
  # CPack's scripts call ldconfig beside the trigger.
  known=bogus-mail-host,bogus-mail-host-in-debian-changelog,initial-upload-closes-no-bugs,maintscript-calls-ldconfig
  lintian --allow-root --fail-on error,warning --suppress-tags "$known" "$packages"/*.deb
fi
if ((EUID != 0)) || ! command -v debootstrap >/dev/null; then
  echo "check_packages.sh: not root, or no debootstrap: the packages are not installed anywhere" >&2
  exit 77
fi

stage "Bare Debian 12"
if [[ ! -e $base/etc/debian_version ]]; then
  quietly debootstrap --variant=minbase bookworm "$base" http://deb.debian.org/debian
fi
rm -rf --one-file-system "$system"
cp -a "$base" "$system"
is_mounted=no
leave() {
  if [[ $is_mounted == yes ]]; then umount "$system/proc"; fi
  rm -rf --one-file-system "$system"
}
trap leave EXIT
if mount -t proc proc "$system/proc" 2>/dev/null; then is_mounted=yes; fi
cp /etc/resolv.conf "$system/etc/resolv.conf"
mkdir "$system/root/packages" "$system/root/work"
cp "$packages"/*.deb "$system/root/packages/"
cp -r tests/packages tests/install_consumer/program docs/examples "$system/root/work/"

inside() {
  chroot "$system" /usr/bin/env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin HOME=/root LC_ALL=C.UTF-8 \
    DEBIAN_FRONTEND=noninteractive bash -c 'cd ~/work && exec "$@"' bash "$@"
}
apt() { quietly inside apt-get -q -o Acquire::Retries=3 "$@"; }
find_packages() { # find_packages PATTERN...: the files as the system sees them
  local pattern
  for pattern; do (cd "$system" && find root/packages -name "$pattern" -printf '/%p\n'); done
}

stage "Installing what runs"
apt update
mapfile -t files < <(find_packages 'lib*[0-9]_*' 'python3-*' 'epcc-*')
apt install -y --no-install-recommends "${files[@]}"
stage "Running it"
inside packages/run_programs.sh
stage "Installing what is for development"
mapfile -t files < <(find_packages '*-dev_*')
apt install -y --no-install-recommends "${files[@]}" g++ cmake make pkg-config xvfb xauth
stage "Building programs"
inside packages/build_with_cmake.sh program cmake_build
inside packages/build_with_pkg_config.sh program pkg_config_build
quietly inside cmake -S examples -B examples_build -DCMAKE_BUILD_TYPE=Release
quietly inside cmake --build examples_build -j "$(nproc)"
inside examples_build/01_depth_image
stage "Running the programs again, with a display for the viewer"
inside packages/run_programs.sh
stage "Removing"
mapfile -t names < <(cd "$packages" && for file in *.deb; do dpkg-deb -f "$file" Package; done)
mapfile -t owned < <(for file in "$packages"/*.deb; do dpkg-deb --fsys-tarfile "$file" | tar t | grep -v '/$'; done)
apt purge -y "${names[@]}"
left=$(cd "$system" && { ls -d "${owned[@]}" 2>/dev/null || true; } &&
  find . -path ./proc -prune -o -path ./root -prune -o -path ./var/cache/apt -prune -o -iname '*epcc*' -print)
if [[ -n $left ]]; then
  echo "check_packages.sh: left after removal:" "$left" >&2
  exit 1
fi
mkdir -p "$base/var/cache/apt/archives"
cp -n "$system"/var/cache/apt/archives/*.deb "$base/var/cache/apt/archives/" # for the next time
stage "Done: ${#names[@]} packages installed, used and removed, none of ${#owned[@]} files is left"
