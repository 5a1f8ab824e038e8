#!/usr/bin/env bash
# Copyright (c) 2026 The authors of Geodesic_processing.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Installs missing packages, builds and runs the benchmarks, prints tables and writes five plots.
# Takes about an hour.  Run it on an idle machine.
#   --quick      small meshes only, a minute
#   --patient    also run CGAL's exact distances and as-rigid-as-possible maps if they take minutes
#   --record     also write the data files of doc/results and the plots of doc/fig
#   NAME         run only this benchmark (the name of a source file without its extension)
# Environment: BUILD (default: build/benchmark), JOBS (default: all processors),
# GEODESIC_PROCESSING_DATA (default: ../shared/data).
set -u -o pipefail

cd "$(dirname "${BASH_SOURCE[0]}")/../.." || exit 1
. cmake/install_packages.sh

options=() patient=() programs=() is_recorded=false
for argument in "$@"; do
  case $argument in
    --quick) options=(--quick) ;;
    --patient) patient=(--patient) ;;
    --record) is_recorded=true ;;
    *)
      if [ ! -f "test/benchmark/$argument.cpp" ]; then
        sed -n '5,13s/^# \{0,1\}//p' "$0"
        exit 1
      fi
      programs+=("$argument")
      ;;
  esac
done
[ ${#programs[@]} -gt 0 ] ||
  programs=(accuracy error_distribution speed memory inputs soups isolines curves exact sampling
            remeshing holes cloud_errors surfels surfel_scans logmap distortion decal flattening base wavelets
            transport transport_bounds transport_family transport_claims transport_times regions
            flows barycenters means volumes viewer_queries commands)

build=${BUILD:-build/benchmark}
install_packages g++ cmake ninja-build ccache libcgal-dev libboost-dev libeigen3-dev \
  libsuitesparse-dev libopenblas-dev libcli11-dev nlohmann-json3-dev zlib1g-dev || exit 1

mkdir -p "$build"
{
  cmake -S . -B "$build" -G Ninja -DCMAKE_BUILD_TYPE=Release \
    -DGEODESIC_PROCESSING_BENCHMARKS=ON \
    -DGEODESIC_PROCESSING_DATA="${GEODESIC_PROCESSING_DATA:-$PWD/../shared/data}" &&
    cmake --build "$build" -j "${JOBS:-$(nproc)}"
} >"$build/build.log" 2>&1 || { cat "$build/build.log"; exit 1; }

plots=$build
if $is_recorded; then
  if [ ${#options[@]} -gt 0 ]; then
    echo "Only complete runs are recorded, without --quick." >&2
    exit 1
  fi
  plots=doc/fig
  export GEODESIC_PROCESSING_RESULTS=$PWD/doc/results
  GEODESIC_PROCESSING_COMMIT=$(git log -1 --format=%h -- include src)
  git diff --quiet HEAD -- include src || GEODESIC_PROCESSING_COMMIT+=", modified"
  export GEODESIC_PROCESSING_COMMIT
fi

# All libraries use one thread.
export OPENBLAS_NUM_THREADS=1 OMP_NUM_THREADS=1
grep -m 1 'model name' /proc/cpuinfo
for program in "${programs[@]}"; do
  arguments=("${options[@]}")
  case $program in
    accuracy) arguments+=("$plots/convergence.svg") ;;
    error_distribution) arguments+=("$plots/error_distribution.svg") ;;
    wavelets) arguments+=("$plots/rate_distortion.svg") ;;
    exact) arguments+=("${patient[@]}" "$plots/trade_off.svg") ;;
    flattening) arguments+=("${patient[@]}") ;;
    commands) arguments+=("$build/geodesic") ;;
    transport_claims) arguments+=("$plots/basis_size.svg") ;;
  esac
  printf '\n'
  load=$(cut -d ' ' -f 1 /proc/loadavg)
  "$build/test/benchmark/$program" "${arguments[@]}" || exit 1
  ! $is_recorded || sed -i "1a load average before\t$load" "$GEODESIC_PROCESSING_RESULTS/$program.tsv"
done
