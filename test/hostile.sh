#!/usr/bin/env bash
# Copyright (c) 2026 The authors of Geodesic_processing.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# hostile.sh PROGRAM JOBS FILE...: runs every command on every file.
# For any file the program must return 0, or 2 and one sentence, within the time limit and without a
# NaN in the result.
#
# The time limit is 10 s if file and result have at most 50,000 vertices, otherwise 60 s.  It holds for
# a processor on which this shell counts to 500,000 in 1.4 s, and is longer on a slower one.  Commands
# run side by side, although each uses all processors.  One that needs more than 10 s runs again alone.
set -u

program=$(realpath "$1") jobs=$2
shift 2
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

count() { for((i = 0; i < 500000; ++i)); do :; done; }
TIMEFORMAT=%U
limit=$({ time count; } 2>&1 | awk '{ print int(10 * ($1 > 1.4 ? $1 / 1.4 : 1) + 0.5) }')
echo "time limits: $limit s and $((6 * limit)) s"

check()
{
  local file=$1 command=$2 out status sentence begin
  shift 2
  local -a options=("$@")
  out=$(mktemp -p "$folder")
  case $command in distance | matrix | remesh) set -- "$@" --values "$out.values" ;; esac
  begin=$SECONDS
  timeout -k 5 $((6 * limit)) "$program" "$command" "$file" "$@" --json --quiet >"$out" 2>"$out.err"
  status=$?
  # A file has about 40 bytes for each vertex with its two faces.
  if [ $((SECONDS - begin)) -gt "$limit" ] && [ "$(stat -c %s "$file")" -lt 2000000 ] &&
     ! grep -qE '"vertices_out": ([5-9][0-9]{4}|[0-9]{6})' "$out"; then
    if [ -z "${alone:-}" ]; then
      { printf '%q ' "$file" "$command" "${options[@]}" && echo; } >>"$folder/slow"
    else
      sentence="no end after $limit s"
    fi
  fi
  case $status in
    0) if grep -qiE '(^|[^a-z])-?nan([^a-z]|$)' "$out" "$out.values" 2>/dev/null; then
         sentence="a NaN in the result"
       fi ;;
    2) [ "$(grep -c . "$out.err")" -eq 1 ] || sentence="not one sentence on standard error" ;;
    124 | 137) sentence="no end after $((6 * limit)) s" ;;
    *) sentence="exit code $status" ;;
  esac
  if [ -n "${sentence:-}" ]; then
    echo "$command $file: $sentence"
    head -n 15 "$out.err"
    return 1
  fi
}

check_all()
{
  local file=$1 failed=0
  check "$file" info || failed=1
  check "$file" distance --source 0 || failed=1
  check "$file" voronoi --number 3 || failed=1
  check "$file" segment --number 5 --iterations 2 || failed=1
  check "$file" sample --number 20 || failed=1
  check "$file" sample --number 20 --speed curvature-attractive || failed=1
  check "$file" remesh --number 20 || failed=1
  check "$file" remesh --number 20 --keep-sharp 40 || failed=1
  check "$file" remesh --number 20 --fill-holes || failed=1
  check "$file" base --number 20 || failed=1
  check "$file" semiregular --number 20 --levels 1 || failed=1
  check "$file" path --from 0 --to 1 || failed=1
  check "$file" surfels || failed=1
  check "$file" logmap --base 0 || failed=1
  check "$file" flatten --base-points 20 || failed=1
  check "$file" flatten --base-points 20 --injective || failed=1
  check "$file" atlas --number 200 --iterations 1 --texels 512 --gutter 3 || failed=1
  check "$file" wavelet --keep 10 --bits 4 || failed=1
  check "$file" decal --base 0 || failed=1
  check "$file" distance --source 0 --relative-tolerance 0.01 || failed=1
  check "$file" distance --source 0 --method euclidean || failed=1
  check "$file" path --from 0 --to 1 --method exact || failed=1
  check "$file" matrix --number 5 --method exact || failed=1
  check "$file" emd --from 0 --to 1 || failed=1
  check "$file" barycenter --points 0,1 --tolerance 0.1 --refine 0 || failed=1
  check "$file" feature-distance --feature 0 || failed=1
  check "$file" feature-distance --feature-path 0,2 --feature-at 0.1,0.2,0.3 || failed=1
  check "$file" plan --from 0 --to 1,2 --capacity 0.6,0.7 || failed=1
  check "$file" fuzzy --from 0 --to 1 || failed=1
  check "$file" streamlines --from 0 --to 1 || failed=1
  check "$file" volume --from 0.1,0.2,0.3 --to 0.4,0.2,0.1 || failed=1
  check "$file" matrix --number 5 --method spectral || failed=1
  return $failed
}

export -f check check_all
export program folder limit
failed=0
printf '%s\0' "$@" | xargs -0 -n 1 -P "$jobs" bash -c 'check_all "$1"' _ || failed=1
if [ -e "$folder/slow" ]; then
  while read -r arguments; do
    eval "alone=1 check $arguments" || failed=1
  done <"$folder/slow"
fi
if [ $failed = 0 ]; then
  commands=$(declare -f check_all | grep -c "check \"")
  echo "$(($# * commands)) runs ($# files, $commands commands): no crash, no hang, no NaN"
else
  exit 1
fi
