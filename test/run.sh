#!/usr/bin/env bash
# Copyright (c) 2026 The authors of Geodesic_processing.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Installs missing packages, builds everything and runs all tests.  All files are written to build/.
#   --quick   without the sanitizer build
#   --all     also check null pointers and alignment, and run all commands on all models of the data
#             folder, clang-tidy on the kernels, lintian on the Debian packages, the library as a part
#             of another project, and the fuzzer of each input format for one minute
# Environment: JOBS (default: all processors), GEODESIC_PROCESSING_DATA (default: ../shared/data).
set -u -o pipefail

cd "$(dirname "${BASH_SOURCE[0]}")/.." || exit 1
. cmake/install_packages.sh

quick=0 all=0
for argument in "$@"; do
  case $argument in
    --quick) quick=1 ;;
    --all) all=1 ;;
    *) sed -n '5,10s/^# \{0,1\}//p' "$0"; exit 1 ;;
  esac
done

jobs=${JOBS:-$(nproc)}
data=${GEODESIC_PROCESSING_DATA:-$PWD/../shared/data}
release=build/release sanitizer=build/sanitizer
summary=() failures=0 started=$SECONDS

# The numbers of checks may grow and never fall; a step fails if it finds fewer.
min_tests=2218 min_sanitized_tests=2203 min_headers=76 min_hostile_runs=3870 min_mass_runs=226
min_python_tests=1136 min_viewer_tests=41

# step NAME COMMAND...: runs the command and adds its result and its seconds to the summary.
step()
{
  local name=$1 begin=$SECONDS result=passed
  shift
  printf '\n==== %s\n' "$name"
  if ! "$@"; then
    result=FAILED
    failures=$((failures + 1))
  fi
  summary+=("$(printf '%-34s %-7s %5d s' "$name" "$result" $((SECONDS - begin)))")
  [ $result = passed ]
}

# at_least MINIMUM NUMBER WHAT: prints the number and fails if it is below the minimum.
at_least()
{
  printf '%s: %d (at least %d)\n' "$3" "$2" "$1"
  [ "$2" -ge "$1" ]
}

skip() { summary+=("$(printf '%-34s skipped  %s' "$1" "$2")"); }

finish()
{
  printf '\n'
  printf '%s\n' "${summary[@]}"
  if [ $failures -eq 0 ]; then
    printf '\nAll passed in %d s.\n' $((SECONDS - started))
    exit 0
  fi
  printf '\n%d FAILED, after %d s.\n' $failures $((SECONDS - started))
  exit 1
}

packages=(g++ cmake ninja-build ccache git lld
  libcgal-dev libboost-dev libeigen3-dev libsuitesparse-dev libopenblas-dev
  libcli11-dev nlohmann-json3-dev libgtest-dev libopenmesh-dev libassimp-dev liblemon-dev libpng-dev
  zlib1g-dev liblz4-dev libvtk9-dev xvfb xauth
  python3-dev pybind11-dev python3-numpy python3-pytest python3-hypothesis python3-meshio
  python3-scipy python3-vtk9 python3-distributed python3-mpi4py python3-zarr openmpi-bin
  mypy dpkg-dev
  doxygen texlive-binaries texlive-base libjs-mathjax clang-format-14)
[ $quick = 1 ] || packages+=(clang-14 libclang-rt-14-dev llvm-14)
[ $all = 0 ] || packages+=(clang-tidy-14 lintian python3-skbuild python3-venv)
# The viewer's packages take a gigabyte, so they are installed only for continuous integration.
# Debian's npm conflicts with other distributions of Node.js, so an existing command is used.
if [ -n "${CI:-}" ]; then
  packages+=(emscripten chromium)
  command -v npm >/dev/null || packages+=(npm)
fi

public_headers() { git ls-files 'include/*.h' ':!include/**/internal/**'; }
sources() { git ls-files --cached --others --exclude-standard '*.h' '*.cpp'; }
check_format() { sources | xargs -r clang-format-14 --dry-run -Werror; }

# The options of both builds shorten the script.  Tests, examples and demos are not optimized:
# otherwise their build takes longer than the tests.  A process runs many tests, because a sanitized
# process takes longer to start than most tests take.
options=("-DGEODESIC_PROCESSING_CLIENT_OPTIONS=-O0;-g0" -DGEODESIC_PROCESSING_TEST_SHARDS=12
  -DGEODESIC_PROCESSING_JOINED_CLIENTS=ON -DCMAKE_UNITY_BUILD=ON
  -DCMAKE_EXE_LINKER_FLAGS=-fuse-ld=lld -DGEODESIC_PROCESSING_WARNINGS_AS_ERRORS=ON
  -DGEODESIC_PROCESSING_TESTS=ON -DGEODESIC_PROCESSING_DATA="$data")

build_release()
{
  local targets=(all documentation) demos=OFF
  [ $quick = 0 ] || targets+=(all_verify_interface_header_sets) demos=ON
  cmake -S . -B $release -G Ninja -DCMAKE_BUILD_TYPE=Release "${options[@]}" \
    -DGEODESIC_PROCESSING_DEMOS=$demos -DGEODESIC_PROCESSING_DOCS=ON \
    >build/release.log || { cat build/release.log; return 1; }
  tail -n 4 build/release.log
  cmake --build $release -j "$jobs" --target "${targets[@]}" -- -k 0
}

# The library is optimized, otherwise the tests take longer than the build; the program is optimized
# slightly.  The shared library uses its own copies of inline functions of the standard library
# (-Bsymbolic-functions): with the unoptimized copies of the tests, kernels are four times slower.
# Assertions are enabled.  Only --all checks null pointers, object sizes and alignment: these checks
# take a fifth of the build.  AddressSanitizer alone reports wrong accesses, except misaligned ones.
# This build also compiles the demos, because clang takes less time than gcc.
build_sanitizer()
{
  local omitted_checks=-fno-sanitize=null,object-size,alignment
  [ $all = 0 ] || omitted_checks=
  CC=clang-14 CXX=clang++-14 cmake -S . -B $sanitizer -G Ninja -DCMAKE_BUILD_TYPE=None \
    "${options[@]}" \
    -DCMAKE_CXX_FLAGS="-O2 -Qunused-arguments -gline-tables-only -fno-omit-frame-pointer \
      -fsanitize=address,undefined $omitted_checks -fno-sanitize-recover=undefined \
      -D_GLIBCXX_ASSERTIONS" \
    -DBUILD_SHARED_LIBS=ON -DCMAKE_SHARED_LINKER_FLAGS=-Wl,-Bsymbolic-functions \
    "-DGEODESIC_PROCESSING_PROGRAM_OPTIONS=-O1;-g0" \
    -DGEODESIC_PROCESSING_PICTURES=OFF -DGEODESIC_PROCESSING_FUZZERS=ON \
    -DGEODESIC_PROCESSING_DEMOS=ON >build/sanitizer.log ||
    { cat build/sanitizer.log; return 1; }
  local targets=(all)
  [ $all = 0 ] || targets+=(all_verify_interface_header_sets)
  cmake --build $sanitizer -j "$jobs" --target "${targets[@]}" -- -k 0
}

# Compiles each public header alone, after the headers of other libraries: they are precompiled, which
# saves three minutes.  With --all, the sanitizer build compiles each header without any other header.
check_headers()
{
  local options=(-std=c++17 -DCGAL_EIGEN3_ENABLED -Wall -Wextra -Werror
    -Wno-pragma-once-outside-header -Iinclude -isystem /usr/include/eigen3)
  { echo '#pragma once' && grep -rhoE '^#include <[^>]+>' include |
    grep -v '<CGAL/Geodesic_processing' | sort -u; } >build/library_headers.h &&
    clang++-14 "${options[@]}" -x c++-header build/library_headers.h -o build/library_headers.pch &&
    at_least $min_headers "$(public_headers | wc -l)" "number of headers" &&
    public_headers | xargs -P "$jobs" -I {} clang++-14 "${options[@]}" -fsyntax-only \
      -include-pch build/library_headers.pch -x c++ {}
}

# build_consumer FOLDER OPTION...: builds and runs the program of the README in a project of its own.
build_consumer()
{
  local folder=$1
  shift
  cmake -S test/consumer -B "$folder" -G Ninja -DCMAKE_BUILD_TYPE=Release \
    -DCMAKE_CXX_COMPILER_LAUNCHER="env;CCACHE_SLOPPINESS=pch_defines,time_macros;ccache" \
    "$@" >"$folder.log" || { cat "$folder.log"; return 1; }
  cmake --build "$folder" -j "$jobs" && ctest --test-dir "$folder" --output-on-failure
}

check_installed_package()
{
  rm -rf build/prefix build/consumer
  cmake --install $release --prefix "$PWD/build/prefix" >/dev/null &&
    build_consumer build/consumer -DCMAKE_PREFIX_PATH="$PWD/build/prefix"
}

# Writes the Debian packages, extracts them in a folder and uses them there.  Only --all calls lintian,
# which takes longer than the other commands.
check_debian_packages()
{
  rm -rf build/packages build/packaged_consumer
  cpack --config $release/CPackConfig.cmake -G DEB -B "$PWD/build/packages" >build/packages.log ||
    { cat build/packages.log; return 1; }
  [ $all = 0 ] || lintian --allow-root --fail-on error build/packages/*.deb || return 1
  local package root=$PWD/build/packages/root
  for package in build/packages/*.deb; do
    dpkg-deb --extract "$package" "$root" || return 1
  done
  [ -f "$root/usr/share/doc/geodesic-processing-doc/html/index.html" ] &&
    "$root/usr/bin/geodesic" info test/consumer/two_triangles.off --json | grep '"faces": 2,' &&
    { [ ! -f $release/viewer/viewer.html ] || "$root/usr/bin/geodesic" view \
      test/consumer/two_triangles.off -o build/packages/two_triangles.html; } &&
    build_consumer build/packaged_consumer -DCMAKE_PREFIX_PATH="$root/usr"
}

# Runs the commands of the page "Getting Started" with the installed package and the Python module.
# If the page of the viewer was built, the installed program must find the installed one.
check_getting_started()
{
  local options=()
  [ -f $release/viewer/viewer.html ] || options+=(--without-viewer)
  CMAKE_GENERATOR=Ninja CMAKE_CXX_COMPILER_LAUNCHER=ccache \
    bash test/getting_started.sh build/getting_started build/prefix $release/python "${options[@]}"
}

# Builds the library as a part of another project, in the two ways that CMake has.  It is not optimized,
# to save time.
check_subprojects()
{
  local command
  rm -rf build/subproject
  for command in add_subdirectory FetchContent; do
    build_consumer build/subproject -DCMAKE_BUILD_TYPE=None -DCMAKE_UNITY_BUILD=ON \
      -DCONSUMER_COMMAND=$command || return 1
  done
}

# Prints the tests, examples and fuzz corpora of a build, one per line.
list_tests()
{
  local name
  for name in internal brute_force regression agreement surface program; do
    "$1/test/$name" --gtest_list_tests | grep '^  ' || return 1
  done
  # A build with a shared library does not have this program.
  [ ! -x "$1/test/allocation" ] || "$1/test/allocation" --gtest_list_tests | grep '^  '
  ctest --test-dir "$1" -N | grep -E ': (example|fuzz)_'
}

# run_tests BUILD MINIMUM: runs all tests of a build; fails if there are fewer than MINIMUM.
run_tests()
{
  at_least "$2" "$(list_tests "$1" | wc -l)" "number of tests" &&
    ctest --test-dir "$1" --output-on-failure --no-tests=error -j "$jobs"
}

# Checks the types of the Python package and of the tour, and that the stubs of the extension match.
check_python_types()
{
  local options=(--cache-dir=/dev/null --strict)
  /usr/bin/python3 -m mypy "${options[@]}" src/python/geodesic_processing &&
    /usr/bin/python3 -m mypy "${options[@]}" demo/tour &&
    PYTHONDONTWRITEBYTECODE=1 PYTHONPATH=$PWD/$release/python MYPYPATH=$PWD/$release/python \
      /usr/bin/python3 -m mypy.stubtest geodesic_processing._core
}

# run_python_tests LOG ARGUMENT...: runs tests of the Python module. Each test has a time limit of its
# own; that of the whole run ends a process that does not exit after its tests.
run_python_tests()
{
  local log=$1
  shift
  PYTHONDONTWRITEBYTECODE=1 PYTHONPATH=$PWD/$release/python \
    GEODESIC_PROCESSING_PROGRAM=$PWD/$release/geodesic \
    timeout --foreground -k 10 1800 /usr/bin/python3 -m pytest --quiet "$@" | tee "$log"
}

# Builds the Python module and tests it with the interpreter of the distribution. The tests of
# executors start processes and threads, so they run in a process of their own.
check_python_module()
{
  local tests=test/python logs=build/python_tests
  cmake -S . -B $release -DGEODESIC_PROCESSING_PYTHON=ON -DPython_EXECUTABLE=/usr/bin/python3 \
    >build/python.log || { cat build/python.log; return 1; }
  cmake --build $release -j "$jobs" --target python_module &&
    run_python_tests $logs.log --ignore=$tests/executor_test.py $tests &&
    run_python_tests ${logs}_executors.log $tests/executor_test.py &&
    at_least $min_python_tests \
      "$(sed -n 's/^\([0-9]*\) passed.*/\1/p' $logs.log ${logs}_executors.log |
        awk '{ sum += $1 } END { print sum + 0 }')" "number of tests" &&
    check_python_types
}

# Installs the Python module by pip: with the installed library, and with one that pip builds.
check_pip()
{
  local environment=$PWD/build/environment prefix
  for prefix in "$PWD/build/prefix" ""; do
    rm -rf "$environment" _skbuild
    /usr/bin/python3 -m venv --system-site-packages "$environment" &&
      CMAKE_PREFIX_PATH=$prefix CMAKE_BUILD_PARALLEL_LEVEL=$jobs "$environment/bin/pip" install \
        --no-build-isolation --no-deps --verbose . >build/pip.log 2>&1 ||
      { tail -n 40 build/pip.log; return 1; }
    if [ -n "$prefix" ] && ! grep -q "installed in $prefix" build/pip.log; then
      echo "The installed library is not used."
      return 1
    fi
    (cd build && "$environment/bin/python" -m pytest --quiet -p no:cacheprovider \
      ../test/python/distance_test.py) || return 1
  done
}

# Prints the commands that the viewer needs and that are missing.
missing_viewer_commands()
{
  local name
  for name in emcmake node npm chromium; do
    command -v $name >/dev/null || printf '%s ' $name
  done
}

# Builds the page of the viewer and tests it in the browser.
check_viewer()
{
  cmake -S . -B $release -DGEODESIC_PROCESSING_VIEWER=ON >build/viewer.log ||
    { cat build/viewer.log; return 1; }
  cmake --build $release -j "$jobs" --target viewer &&
    GEODESIC_VIEWER=$PWD/$release/viewer GEODESIC_PROCESSING_PROGRAM=$PWD/$release/geodesic \
      GEODESIC_PROCESSING_DATA=$data node --test --test-reporter=spec test/view/*_test.mjs |
    tee build/viewer_tests.log &&
    at_least $min_viewer_tests "$(sed -n 's/^ℹ pass //p' build/viewer_tests.log)" "number of tests"
}

check_hostile_files()
{
  bash test/hostile.sh $sanitizer/test/run_commands "$jobs" "$@" | tee build/hostile.log &&
    at_least $min_hostile_runs "$(sed -n 's/^\([0-9]*\) runs.*/\1/p' build/hostile.log)" \
      "number of hostile runs"
}

# Runs the mass test on twenty small meshes.
check_many_meshes()
{
  rm -rf build/mass build/mass_meshes
  mkdir build/mass_meshes &&
    cp "$data"/meshes/{joint_221,pig_468,spool_649,pinion_650,couplingdown_1k8}.off \
      "$data"/meshes/{bones_26comp_2k,elephant_2k8}.off "$data/meshes/eight_5k.ply" \
      "$data"/parts/{844,WusonOBJ}.obj "$data/parts/LZ_mt_Link.STL" \
      "$data"/parts/{fox_ascii,WSG50_110,57_link_2,72214,sphereWithHole}.stl \
      "$data"/patches/{nefertiti_299,patch_01_735}.off "$data"/patches/{hemisphere_2k,alligator_3k}.ply \
      build/mass_meshes &&
    bash test/mass.sh build/mass_meshes | tee build/mass.log &&
    at_least $min_mass_runs "$(sed -n 's/^# Mass test: \([0-9]*\) runs.*/\1/p' build/mass.log)" \
      "number of runs"
}

# Compares the results of gcc and clang, and those of one thread and five.
check_equal_results()
{
  # These builds have no program that generates models.  Transport costs in a spectral basis are
  # computed in single precision by Eigen, whose operations depend on the compiler.
  local only='^0 .*data/(patches/mushroom|points/oni|meshes/(pig|elephant))'
  bash test/behavior/compare.sh --only "$only" --except 'models/|--basis' $sanitizer $release "$data" &&
    bash test/behavior/compare.sh --only "$only" --except models/ --threads 1,5 $release $release "$data"
}

check_all_models()
{
  local folder failed=0
  for folder in hostile meshes patches points; do
    bash test/program/matrix.sh $sanitizer/geodesic "$data/$folder" "$jobs" || failed=1
  done
  return $failed
}

# Checks each source separately, so that it also fails if a source lacks an include.
check_tidy()
{
  CXX=clang++-14 cmake -S . -B build/tidy -G Ninja -DCMAKE_DISABLE_PRECOMPILE_HEADERS=ON \
    -DGEODESIC_PROCESSING_PICTURES=OFF >build/tidy.log || { cat build/tidy.log; return 1; }
  git ls-files 'src/*.cpp' ':!src/geodesic' ':!src/python' ':!src/view' |
    xargs -n 4 -P "$jobs" clang-tidy-14 -p build/tidy --quiet
}

# Runs each fuzzer for one minute, starting from the corpus of earlier runs.
fuzz()
{
  local target name
  for target in $sanitizer/test/fuzz_*; do
    [ -x "$target" ] || continue
    name=$(basename "$target")
    mkdir -p "build/corpus/$name"
    "$target" -max_total_time=60 -timeout=10 -rss_limit_mb=4096 \
      -artifact_prefix="build/corpus/$name-" "build/corpus/$name" "test/fuzz/corpus/${name#fuzz_}" \
      2>"build/$name.log" || { tail -n 40 "build/$name.log"; return 1; }
  done
}

# Smaller fake stacks and shorter stack traces of allocations: a sanitized process starts in 0.11 s
# instead of 0.14 s.
export ASAN_OPTIONS=allocator_may_return_null=1:detect_stack_use_after_return=1
ASAN_OPTIONS+=:max_uar_stack_size_log=16:malloc_context_size=8
export UBSAN_OPTIONS=print_stacktrace=1
export ASAN_SYMBOLIZER_PATH=/usr/bin/llvm-symbolizer-14

mkdir -p build
step "packages" install_packages "${packages[@]}" || finish
step "format" check_format
if step "build, manual" build_release; then
  step "tests" run_tests $release $min_tests
  step "python" check_python_module
  if [ -z "${CI:-}" ] && [ -n "$(missing_viewer_commands)" ]; then
    skip "viewer" "these commands are missing: $(missing_viewer_commands)"
  else
    step "viewer" check_viewer
  fi
  step "installed package" check_installed_package
  step "getting started" check_getting_started
  step "Debian packages" check_debian_packages
  [ $all = 0 ] || step "subprojects" check_subprojects
  if [ -d "$data/parts" ]; then
    step "mass test" check_many_meshes
  else
    skip "mass test" "there is no $data"
  fi
fi
[ $quick = 1 ] || step "headers" check_headers
if [ $quick = 0 ] && step "sanitizer build" build_sanitizer; then
  # To start the threads of OpenBLAS takes half of the time that a small sanitized process takes.
  export OPENBLAS_NUM_THREADS=1
  step "tests, sanitized" run_tests $sanitizer $min_sanitized_tests
  if [ -d "$data/hostile" ]; then
    step "hostile files, sanitized" check_hostile_files "$data"/hostile/*
    step "equal results" check_equal_results
  else
    skip "hostile files, sanitized" "there is no $data"
  fi
  if [ $all = 1 ]; then
    step "clang-tidy" check_tidy
    step "pip" check_pip
    [ ! -d "$data" ] || step "all models and methods, sanitized" check_all_models
    step "fuzzing" fuzz
  fi
fi
finish
