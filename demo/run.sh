#!/usr/bin/env bash
# Copyright (c) 2026 The authors of Geodesic_processing.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Installs missing packages, builds the program `geodesic` and the demo programs, and runs all commands
# that demo/tour/tour.md lists.  Writes their pictures and an HTML page to demo/gallery/, and checks the
# page in the browser.
# Environment: JOBS, the number of build jobs (default: all processors).
set -u -o pipefail

cd "$(dirname "${BASH_SOURCE[0]}")/.." || exit 1
. cmake/install_packages.sh

jobs=${JOBS:-$(nproc)}
build=build/demo
models=$build/models
log=$build/run.log
started=$SECONDS

packages=(g++ cmake ninja-build ccache
  libcgal-dev libboost-dev libeigen3-dev libsuitesparse-dev libopenblas-dev
  libcli11-dev nlohmann-json3-dev libpng-dev zlib1g-dev liblz4-dev libvtk9-dev xvfb xauth python3)
# The packages that check the page are installed only for continuous integration.  Debian's npm
# conflicts with other distributions of Node.js, so an existing command is used.
if [ -n "${CI:-}" ]; then
  packages+=(chromium)
  command -v npm >/dev/null || packages+=(npm)
fi

install_packages "${packages[@]}" || exit 1

mkdir -p "$models"
: >$log

# Downloads Debian's libcgal-demo and extracts its models.  The package is not installed.
fetch_models()
{
  local folder
  [ -d $models/data ] && return 0
  folder=$(mktemp -d) || return 1
  chmod 755 "$folder"
  # If the download fails, the package lists may be missing: updates them and downloads again.
  { (cd "$folder" && apt-get download libcgal-demo) ||
    { can_be_root && as_root apt-get update && (cd "$folder" && apt-get download libcgal-demo); }
  } >>$log 2>&1 &&
    dpkg-deb --fsys-tarfile "$folder"/libcgal-demo_*.deb 2>>$log |
      tar -xO ./usr/share/doc/libcgal-dev/data.tar.gz 2>>$log |
      tar -xz -C $models data/meshes data/points_3 2>>$log
  local status=$?
  rm -rf "$folder"
  [ $status -eq 0 ] || rm -rf $models/data
  return $status
}

build_failed()
{
  tail -n 30 $log >&2
  echo "The build failed; the complete output is in $log." >&2
  exit 1
}

# Builds the program, and generates the models that libcgal-demo does not contain.
build_program()
{
  cmake -S . -B $build -G Ninja -DCMAKE_BUILD_TYPE=Release -DCMAKE_UNITY_BUILD=ON \
    -DGEODESIC_PROCESSING_DEMOS=ON &&
    cmake --build $build -j "$jobs" --target geodesic demo_make_models demo_make_test_image &&
    $build/demo/make_models $models && $build/demo/make_test_image $models/rings.png
} >>$log 2>&1

# Starts one X server for all pictures.  Without it, the program starts a server per picture.
# A server that resets itself when a picture is complete refuses the next connection at times.
start_server()
{
  local pipe=$build/display
  rm -f $pipe
  Xvfb -displayfd 3 -screen 0 1600x1200x24 -nolisten tcp -noreset 3>$pipe >/dev/null 2>&1 &
  server=$!
  for ((i = 0; i < 100; ++i)); do
    [ ! -s $pipe ] || break
    sleep 0.1
  done
  if [ -s $pipe ]; then
    GEODESIC_DISPLAY=:$(<$pipe)
    export GEODESIC_DISPLAY
  fi
}

# Prints the commands that the check of the page needs and that are missing.
missing_check_commands()
{
  local name
  for name in node npm chromium; do
    command -v $name >/dev/null || printf '%s ' $name
  done
}

install_check_packages()
{
  mkdir -p $build/check && cp test/tour/package.json test/tour/package-lock.json $build/check &&
    npm ci --prefix $build/check --ignore-scripts --no-audit --no-fund --loglevel=error
} >>$log 2>&1

# Opens the page in the browser and checks it.  Without the commands and packages of the check, only
# continuous integration fails.
check_page()
{
  local missing
  missing=$(missing_check_commands)
  if [ -z "$missing" ] && ! install_check_packages; then
    missing="packages of npm"
  fi
  if [ -n "$missing" ]; then
    echo "The page was not checked, because these are missing: $missing"
    [ -z "${CI:-}" ]
  else
    GEODESIC_TOUR_PACKAGES=$build/check node --test --test-reporter=spec test/tour/page_test.mjs
  fi
}

server=''
trap 'kill $server 2>/dev/null' EXIT

echo "Building the program and downloading models"
fetch_models &
fetching=$!
build_program || build_failed
wait $fetching ||
  echo "Debian's libcgal-demo is not available: the pictures use generated models instead."
start_server

echo "Computing pictures"
export PYTHONDONTWRITEBYTECODE=1
status=0
python3 demo/tour/run.py || status=1
python3 demo/tour/page.py || exit 1
echo "The gallery is $PWD/demo/gallery/index.html, written in $((SECONDS - started)) s."
check_page || status=1
exit $status
