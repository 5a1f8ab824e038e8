#!/usr/bin/env bash
# Copyright (c) 2026 The authors of Geodesic_processing.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# hostile.sh RUN_COMMANDS JOBS FILE...: runs every command on every file, with the test program
# run_commands.  For any file the program must return 0, or 2 and one sentence, within the time
# limit and without a NaN in the result.
#
# The time limit is 10 s if file and result have at most 50,000 vertices, otherwise 60 s.  It holds
# for a processor on which this shell counts to 500,000 in 1.4 s, and is longer on a slower one.
# Commands run side by side, although each uses all processors.  One that needs more than 10 s runs
# again alone.
set -u

run_commands=$(realpath "$1") jobs=$2
shift 2
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

count() { for((i = 0; i < 500000; ++i)); do :; done; }
TIMEFORMAT=%U
limit=$({ time count; } 2>&1 | awk '{ print int(10 * ($1 > 1.4 ? $1 / 1.4 : 1) + 0.5) }')
echo "time limits: $limit s and $((6 * limit)) s"

# Prints the commands with their options, separated by tabs.
list_commands()
{
  tr ' ' '\t' <<'COMMANDS'
info
distance --source 0
voronoi --number 3
segment --number 5 --iterations 2
sample --number 20
sample --number 20 --speed curvature-attractive
remesh --number 20
remesh --number 20 --keep-sharp 40
remesh --number 20 --fill-holes
base --number 20
semiregular --number 20 --levels 1
path --from 0 --to 1
surfels
logmap --base 0
flatten --base-points 20
flatten --base-points 20 --injective
atlas --number 200 --iterations 1 --texels 512 --gutter 3
wavelet --keep 10 --bits 4
decal --base 0
distance --source 0 --relative-tolerance 0.01
distance --source 0 --method euclidean
path --from 0 --to 1 --method exact
matrix --number 5 --method exact
emd --from 0 --to 1
barycenter --points 0,1 --tolerance 0.1 --refine 0
karcher-mean --points 0,1
feature-distance --feature 0
feature-distance --feature-path 0,2 --feature-at 0.1,0.2,0.3
plan --from 0 --to 1,2 --capacity 0.6,0.7
fuzzy --from 0 --to 1
isolines --source 0
isolines --source 0 --divided
loops
loops --through 0
loops --along 0,1,2
path --from 0 --to 1 --through 2
ball --source 0 --radius 0.3
diameter --iterations 5 --radius
curve --points 0,1,2
curve --points 0,1,2,3 --spline --closed
streamlines --from 0 --to 1
volume --from 0.1,0.2,0.3 --to 0.4,0.2,0.1
matrix --number 5 --method spectral
COMMANDS
}

# check FILE COMMAND EXIT_CODE SECONDS OUTPUT: checks a run.  OUTPUT.out, .err and .values are its
# output, its messages and its result.  Prints what is wrong.
check()
{
  local file=$1 command=${2//$'\t'/ } code=$3 seconds=$4 output=$5 sentence=
  # A file has about 40 bytes for each vertex with its two faces.
  if [ "$seconds" -gt "$limit" ] && [ "$(stat -c %s "$file")" -lt 2000000 ] &&
     ! grep -qE '"vertices_out": ([5-9][0-9]{4}|[0-9]{6})' "$output.out"; then
    sentence="no end after $limit s"
    [ -n "${alone:-}" ] || { printf '%s\t%s\n' "$file" "$2" >>"$folder/slow"; sentence=; }
  fi
  case $code in
    0) if grep -qiE '(^|[^a-z])-?nan([^a-z]|$)' "$output.out" "$output.values" 2>/dev/null; then
         sentence="a NaN in the result"
       fi ;;
    2) [ "$(grep -c . "$output.err")" -eq 1 ] || sentence="not one sentence on standard error" ;;
    142) sentence="no end after $((6 * limit)) s" ;;
    *) sentence="exit code $code" ;;
  esac
  [ -n "$sentence" ] || return 0
  echo "$command $file: $sentence"
  head -n 15 "$output.err"
  return 1
}

# check_all FILE COMMAND...: runs the commands on the file and checks them.  If one of them ends the
# process, a new process runs the ones that follow.
check_all()
{
  local file=$1 work=$folder/$BASHPID failed=0 i code seconds command name options status
  shift
  while [ $# -gt 0 ]; do
    mkdir -p "$work"
    i=0
    for command in "$@"; do
      name=${command%%$'\t'*} options=${command#"$name"}
      case $name in distance | matrix | remesh) options+=$'\t--values\t'$work/$i.values ;; esac
      printf '%s\t%s%s\t--json\t--quiet\n' "$name" "$file" "$options"
      i=$((i + 1))
    done >"$work/commands"
    "$run_commands" "$work" $((6 * limit)) <"$work/commands" >"$work/report"
    status=$? i=0
    while read -r code seconds; do
      check "$file" "$1" "$code" "$seconds" "$work/$i" || failed=1
      shift
      i=$((i + 1))
    done <"$work/report"
    if [ $status -ne 0 ] && [ $# -gt 0 ]; then
      check "$file" "$1" $status 0 "$work/$i" || failed=1
      shift
    elif [ $status -ne 0 ]; then
      echo "$file: exit code $status after the last command"
      head -n 15 "$work/$((i - 1)).err"
      failed=1
    fi
    rm -rf "$work"
  done
  return $failed
}

# check_file FILE: runs all commands on the file.
check_file()
{
  local -a commands
  mapfile -t commands < <(list_commands)
  check_all "$1" "${commands[@]}"
}

export -f list_commands check check_all check_file
export run_commands folder limit
failed=0
printf '%s\0' "$@" | xargs -0 -n 1 -P "$jobs" bash -c 'check_file "$1"' _ || failed=1
if [ -e "$folder/slow" ]; then
  while IFS=$'\t' read -r file command; do
    alone=1 check_all "$file" "$command" || failed=1
  done <"$folder/slow"
fi
if [ $failed = 0 ]; then
  commands=$(list_commands | grep -c .)
  echo "$(($# * commands)) runs ($# files, $commands commands): no crash, no hang, no NaN"
else
  exit 1
fi
