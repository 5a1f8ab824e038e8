#!/usr/bin/env bash
# Copyright (c) 2026 The authors of Geodesic_processing.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# mass.sh FOLDER [RESULTS]: runs twelve commands of the program on every mesh file of a folder, two
# at a time, and checks the results with check_results.
#
# Each run has one thread, 60 s of processor time and 4 GB of memory.  RESULTS (default: build/mass)
# keeps exit codes, times, messages, JSON and violated invariants.  A run that has a result is not
# repeated, so the script can be stopped and started again.  At the end it prints tables of the runs
# and of the refusals (exit code 2), and lists of the failures.  It returns 1 if there is a failure,
# or if a command refuses more than 2 % of the files.  Failures are:
# - an exit code other than 0 and 2, or a refusal without exactly one sentence,
# - a run without end, if the mesh has at most 100,000 faces,
# - a violated invariant, for example a value that is not finite.
# Environment: GEODESIC and CHECK_RESULTS are the programs (default: those in build/release).
set -u
export LC_ALL=C

[ $# -eq 1 ] || [ $# -eq 2 ] || { sed -n '5,17s/^# \{0,1\}//p' "$0" >&2; exit 1; }
root=$(realpath "$(dirname "${BASH_SOURCE[0]}")/..")
folder=$(realpath -e "$1") && results=$(realpath -m "${2:-$root/build/mass}") &&
  program=$(realpath -e "${GEODESIC:-$root/build/release/geodesic}") &&
  checker=$(realpath -e "${CHECK_RESULTS:-$root/build/release/test/check_results}") || exit 1
seconds=60 kilobytes=4000000 max_faces=100000 max_refused=2

# run NAME COMMAND ARGUMENTS...: runs a command and appends a line to the file `runs`: the name, the
# exit code, the processor time in seconds, and the number and the first of the lines on standard
# error.
run()
{
  local name=$1 code times
  shift
  grep -qs "^$name"$'\t' runs && return
  # A process that waits for itself uses no processor time, so there is also a limit of real time.
  times=$({ time (ulimit -t $seconds -v $kilobytes
    timeout --foreground -k 5 $((10 * seconds)) "$program" "$@" --threads 1 --json --quiet \
      >"$name.json" 2>err); } 2>&1)
  code=$?
  printf '%s\t%d\t%s\t%d\t%s\n' "$name" $code "$(awk 'END { print $1 + $2 }' <<<"$times")" \
    "$(grep -c . err)" "$(head -n 1 err | tr '\t' ' ')" >>runs
}

# run_all CHECKSUM FILE: runs all commands on the file and checks the results.
run_all()
{
  local file=$2 target
  mkdir -p "$results/$1" && cd "$results/$1" || return
  [ ! -e violations ] || return
  echo "$file" >file
  run info info "$file" --values info.txt
  grep -qs '"kind": "mesh"' info.json || { finish; return; } # nothing else, or a cloud
  run exact distance "$file" --source 0 --method exact --values exact.txt
  run front distance "$file" --source 0 --method euclidean --values front.txt
  # The vertex farthest from vertex 0, or vertex 1 if there are no distances
  [ -e target ] || { [ ! -e exact.txt ] || cat exact.txt; } |
    awk '$1 != "inf" && $1 + 0 >= d { d = $1 + 0; v = NR - 1 } END { print NR ? v : 1 }' >target
  target=$(cat target)
  run path path "$file" --from 0 --to "$target" --values path.txt
  run sample sample "$file" --number 50 --values sample.txt
  run voronoi voronoi "$file" --number 20 --values voronoi.txt
  run segment segment "$file" --number 20 --iterations 5 --values segment.txt
  run remesh remesh "$file" --number 500 -o remesh.off
  run semiregular semiregular "$file" --number 60 --levels 2 -o semiregular.off
  # Only a connected surface with boundary can be flattened.
  ! grep -q '"components": 1,' info.json || grep -q '"boundary_loops": 0,' info.json ||
    run flatten flatten "$file" --base-points 100 --flat -o flatten.off
  run atlas atlas "$file" --number 30 --texels 512 -o atlas.obj
  run emd emd "$file" --from 0 --to "$target" --bound-above
  finish
}

# Checks the results in the current folder and deletes those that the tables do not need.
finish()
{
  local json code
  timeout 600 "$checker" . >checked 2>&1
  code=$?
  [ $code -le 1 ] || printf 'check_results\texit code %d\n' $code >>checked
  for json in *.json; do
    printf '%s\t%s\n' "${json%.json}" "$(tr -d '\n' <"$json" | tr -s ' ')"
  done >json
  rm -f ./*.json ./*.txt ./*.off ./*.obj ./*.mtl ./*.png err target
  mv checked violations
}

# Prints the tables.  Standard input has one line for each file: checksum and path.
print_tables()
{
  awk -F '\t' -v results="$results" -v max_faces=$max_faces -v max_refused=$max_refused \
    -f "$root/test/mass/tables.awk"
}

mkdir -p "$results" || exit 1
version=$(sha256sum <"$program")
if [ -e "$results/program" ] && [ "$(cat "$results/program")" != "$version" ]; then
  echo "mass.sh: $results has the results of another program." >&2
  exit 1
fi
echo "$version" >"$results/program"

export -f run run_all finish
export program checker results seconds kilobytes
export TIMEFORMAT='%U %S'
files=$(mktemp)
trap 'rm -f "$files"' EXIT
# Files with equal contents are tested once.  In the order of their checksums, the first files are a
# random sample of all.
find "$folder" -type f -iregex '.*\.\(ply\|off\|obj\|stl\|vtp\|gltf\|glb\|gii\)\(\.gz\)?' -print0 |
  sort -z | xargs -0 -r sha256sum | sort -s -u -k 1,1 |
  awk '{ print substr($1, 1, 16) "\t" substr($0, 67) }' >"$files"
tr '\t\n' '\0\0' <"$files" | xargs -0 -r -n 2 -P 2 bash -c 'run_all "$1" "$2"' _
print_tables <"$files"
