#!/usr/bin/env bash
# Copyright (c) 2026 The authors of Geodesic_processing.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# matrix.sh PROGRAM FOLDER [JOBS]: runs every command with every method and kind of source on every
# file of a folder.  Meant for a sanitizer build; takes from minutes to an hour.  Each run must return
# 0, or 2 and one sentence that names the file.  The limit is 10 s if file and result have at most
# 50,000 vertices, otherwise 60 s.  No result may contain a NaN, and written files must be readable.
set -u

[ $# -ge 2 ] || { sed -n '5,8s/^# //p' "$0"; exit 1; }
program=$(realpath "$1") folder=$(realpath "$2") jobs=${3:-1}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# A page without scripts, to which the command view adds the surface.
echo '<script type="text/plain" id="model" data-name=""></script>' >"$work/page.html"

# Returns whether the program reads a result again, or whether a page contains a surface.
is_readable()
{
  case $1 in
    *.vtp) timeout 60 "$program" info "$1" --quiet ;;
    *.html) grep -qE '^<script [^>]* data-name="[^"]+">[A-Za-z0-9+/]+=*</script>$' "$1" ;;
  esac
}

# attempt FILE LIMIT COMMAND ARGUMENTS...
attempt()
{
  local file=$1 limit=$2 here result status spent begin=$SECONDS complaint=
  shift 2
  here=$(mktemp -d -p "$work")
  local outputs=(--values "$here/values")
  case $1 in
    matrix) result=$here/result.mtx ;;
    view) result=$here/result.html outputs=(--page "$work/page.html") ;;
    *) result=$here/result.vtp ;;
  esac
  timeout -k 5 60 "$program" "$1" "$file" "${@:2}" "${outputs[@]}" \
    -o "$result" --json --quiet >"$here/out" 2>"$here/err"
  status=$? spent=$((SECONDS - begin))
  case $status in
    0)
      if grep -qsiE '(^|[^a-z])-?nan([^a-z]|$)' "$here/out" "$here/values"; then
        complaint="a NaN in the result"
      # A file without curves has no points, and the program reads only files with points.
      elif ! grep -qE '"(circles|lines|loops)": 0,' "$here/out" &&
           ! is_readable "$result" 2>"$here/err"; then
        complaint="its result cannot be read again"
      fi ;;
    2)
      if [ "$(grep -c . "$here/err")" -ne 1 ] || ! grep -qF "$file: " "$here/err"; then
        complaint="not one sentence that names the file"
      elif [ -e "$here/values" ] || [ -e "$result" ]; then
        complaint="a result in spite of the error"
      fi ;;
    124 | 137) complaint="no end after 60 s" ;;
    *) complaint="exit code $status" ;;
  esac
  if [ $spent -gt "$limit" ] &&
     ! grep -qE '"vertices_out": ([5-9][0-9]{4}|[0-9]{6})' "$here/out"; then
    complaint="no end after $limit s"
  fi
  if [ -n "$complaint" ]; then
    echo "FAILED: geodesic $1 $file ${*:2}: $complaint"
    head -n 12 "$here/err"
  fi
  rm -rf "$here"
  [ -z "$complaint" ]
}

# Prints a twentieth of the longest edge of the bounding box, or 1 if the file has no points.
twentieth_of_extent()
{
  "$program" info "$1" --json --quiet 2>/dev/null |
    awk '/"bounding_box"/ { inside = 1 }
      inside && /[0-9]/ { gsub(/[ ,]/, ""); x[n++] = $0 }
      n == 6 { exit }
      END {
        most = 0
        for(c = 0; c < 3; ++c)
          if(x[c + 3] - x[c] > most)
            most = x[c + 3] - x[c]
        printf("%.9g", (most > 0 && most < 1e300) ? most / 20 : 1)
      }'
}

all_of_a_file()
{
  local file=$1 failed=0 limit=10 method deviation
  # About 40 bytes a vertex with its faces.
  [ "$(stat -c %s "$file")" -lt 2000000 ] || limit=60
  deviation=$(twentieth_of_extent "$file")
  attempt "$file" $limit info || failed=1
  attempt "$file" $limit view || failed=1
  for method in euclidean exact fast-marching dijkstra heat; do
    attempt "$file" $limit distance --source 0 --method $method || failed=1
    attempt "$file" $limit path --from 0 --to-at 0.3,0.2,0.1 --method $method || failed=1
    attempt "$file" $limit matrix --number 5 --method $method || failed=1
  done
  attempt "$file" $limit distance --source 0,1,2 --source-at 0.1,0.2,0.3 || failed=1
  attempt "$file" $limit distance --source-at 0,0,0 --limit 0.1 || failed=1
  attempt "$file" $limit distance --source-border || failed=1
  attempt "$file" $limit isolines --source 0 || failed=1
  attempt "$file" $limit isolines --source 0 --divided || failed=1
  attempt "$file" $limit loops || failed=1
  attempt "$file" $limit loops --through 0 || failed=1
  attempt "$file" $limit ball --source 0 --source-at 0.1,0.2,0.3 --radius 0.2 || failed=1
  attempt "$file" $limit diameter --tolerance 0.1 --iterations 10 --radius || failed=1
  attempt "$file" $limit curve --points 0,1,2 || failed=1
  attempt "$file" $limit curve --points 0,1,2 --spline --closed || failed=1
  attempt "$file" $limit path --from 1 --to 2 || failed=1
  attempt "$file" $limit path --from 1 --to-at 0.3,0.2,0.1 || failed=1
  attempt "$file" $limit surfels --estimate --outliers 1 || failed=1
  attempt "$file" $limit decal --base 0,1 || failed=1
  attempt "$file" $limit matrix --number 5 --method spectral || failed=1
  attempt "$file" $limit emd --from 0 --to 1,2 --tolerance 0.01 || failed=1
  attempt "$file" $limit plan --from 0 --to 1,2 --tolerance 0.01 || failed=1
  attempt "$file" $limit barycenter --points 0,1,2 --tolerance 0.1 || failed=1
  attempt "$file" $limit karcher-mean --points 0,1 --point-at 0.3,0.2,0.1 || failed=1
  attempt "$file" $limit streamlines --from 0 --to 1,2 --tolerance 0.01 || failed=1
  attempt "$file" $limit fuzzy --from 0 --to 1 --tolerance 0.01 || failed=1
  attempt "$file" $limit volume --from 0,0,0 --to 0.1,0.2,0.3 --tolerance 0.01 || failed=1
  attempt "$file" $limit voronoi --number 10 || failed=1
  attempt "$file" $limit voronoi --seeds 0,1 || failed=1
  attempt "$file" $limit segment --number 10 || failed=1
  attempt "$file" $limit sample --number 30 || failed=1
  attempt "$file" $limit sample --number 30 --speed curvature-attractive || failed=1
  attempt "$file" $limit voronoi --number 10 --speed curvature-repulsive || failed=1
  attempt "$file" $limit remesh --number 50 --lloyd 2 --keep-sharp 60 --fit || failed=1
  attempt "$file" $limit remesh --number 50 --fill-holes || failed=1
  attempt "$file" $limit remesh --number 50 --maximum-deviation "$deviation" || failed=1
  attempt "$file" $limit matrix --sources 0,1,2 --limit 0.1 || failed=1
  return $failed
}

export -f is_readable attempt twentieth_of_extent all_of_a_file
export program work
if find "$folder" -type f -regex '.*\.\(ply\|off\|obj\|stl\|xyz\|pwn\|vtp\)' -print0 | sort -z |
   xargs -0 -n 1 -P "$jobs" bash -c 'all_of_a_file "$1"' _; then
  echo "$folder: no crash, no hang, no NaN"
else
  exit 1
fi
