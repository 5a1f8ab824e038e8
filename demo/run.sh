#!/usr/bin/env bash
# Copyright (c) 2026 The authors of Geodesic_processing.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Installs what is missing and builds the program.  As soon as it exists it draws pictures of real
# models, two at a time, while the demo programs are built; these are run at the end.  Leaves the
# pictures and a page that shows them in demo/gallery/.
# Environment: JOBS (default: all processors).
set -u -o pipefail

cd "$(dirname "${BASH_SOURCE[0]}")/.." || exit 1
. cmake/install_packages.sh

jobs=${JOBS:-$(nproc)}
build=build/demo
gallery=demo/gallery
models=$build/models
parts=$build/parts # of the page, and a file for each failure
log=$build/run.log
started=$SECONDS

packages=(g++ cmake ninja-build ccache
  libcgal-dev libboost-dev libeigen3-dev libsuitesparse-dev libopenblas-dev
  libcli11-dev nlohmann-json3-dev libpng-dev libvtk9-dev xvfb xauth)

install_packages "${packages[@]}" || exit 1

mkdir -p $build $gallery "$models"
rm -rf "$parts" $build/demos_failed
mkdir -p "$parts"
: >$log

# Real models come in the documentation of Debian's libcgal-demo, which need not be installed.
fetch_models()
{
  local folder
  [ -d $models/data ] && return 0
  folder=$(mktemp -d) || return 1
  chmod 755 "$folder"
  # A machine on which nothing had to be installed may never have heard of the package.
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
  echo "The build failed; all of its words are in $log." >&2
  exit 1
}

# One X server for all pictures; without it the program starts one for each.
start_server()
{
  local pipe=$build/display
  rm -f $pipe
  Xvfb -displayfd 3 -screen 0 1600x1200x24 -nolisten tcp 3>$pipe >/dev/null 2>&1 &
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

# The demo programs, those that make models first.
build_demos()
{
  if ! { nice cmake --build $build -j "$jobs" --target demo_make_models demo_make_test_image &&
         $build/demo/make_models $models && $build/demo/make_test_image $models/rings.png &&
         touch $models/are_made && nice cmake --build $build -j "$jobs"; }; then
    touch $build/demos_failed
  fi
} >>$log 2>&1

# Waits until models were made by a demo program.
wait_for_models()
{
  until [ -e $models/are_made ]; do
    [ ! -e $build/demos_failed ] || build_failed
    sleep 0.2
  done
}

server='' demo_build=''
trap 'kill $server $demo_build 2>/dev/null' EXIT

echo "Building the program and fetching models"
fetch_models &
fetching=$!
{ cmake -S . -B $build -G Ninja -DCMAKE_BUILD_TYPE=Release -DGEODESIC_PROCESSING_DEMOS=ON &&
  cmake --build $build -j "$jobs" --target geodesic; } >>$log 2>&1 || build_failed
start_server
rm -f $models/are_made
build_demos &
demo_build=$!

terrain=$models/hills.off knot=$models/knot.off rings=$models/rings.png
knot_scan=$models/scan.xyz noisy_scan=$models/noisy.xyz

if wait $fetching; then
  m=$models/data/meshes p=$models/data/points_3
  animal=$m/armadillo.off beast=$m/ChineseDragon-10kv.off part=$m/fandisk.off
  runner=$m/man.off holes=$m/mech-holes-shark.off mask=$m/mannequin-devil.off
  bear=$m/bear.off bunny=$m/bunny00.off small=$m/elephant.off loop=$m/knot1.off cow=$m/cow.off
  scan=$p/kitten.xyz scan_with_normals=$p/oni.pwn
else
  echo "Debian's libcgal-demo cannot be had here: the tour runs on models of its own."
  animal=$models/knot.off beast=$animal part=$models/hills.off runner=$animal bear=$animal
  bunny=$animal loop=$animal cow=$animal
  holes=$models/hills.off mask=$models/hills.off small=$models/hills.off
  scan=$models/scan.xyz scan_with_normals=$scan
  wait_for_models
fi

page=$gallery/index.html
number_of_parts=0 this_part='' # of the page, which is written next
next_part()
{
  number_of_parts=$((number_of_parts + 1))
  printf -v this_part '%s/%04d' "$parts" $number_of_parts
}

next_part
cat >"$this_part.html" <<'HTML'
<!DOCTYPE html>
<html lang="en"><head><meta charset="utf-8"><title>Geodesic_processing: a tour</title>
<style>
body { font-family: sans-serif; max-width: 70em; margin: 2em auto; padding: 0 1em; color: #222; }
main { display: grid; grid-template-columns: repeat(auto-fill, minmax(24em, 1fr)); gap: 2em; }
figure { margin: 0; } img { width: 100%; }
code, pre { background: #f2f2f2; padding: 0.2em 0.4em; display: block; white-space: pre-wrap; }
</style></head><body>
<h1>Geodesic_processing: a tour</h1>
<p>Distances and paths along surfaces. Under each picture is the command that made it.</p>
<main>
HTML

escape() { sed -e 's/&/\&amp;/g' -e 's/</\&lt;/g' -e 's/>/\&gt;/g'; }

# The command as a reader would type it: without our folders.
shown() { printf '%s' "$*" | sed -e "s|[^ ]*/||g" | escape; }

# Waits for a picture when two are being drawn, or for all of them.
drawn=()
wait_for_pictures()
{
  local most=$1 id rest
  while [ ${#drawn[@]} -gt "$most" ]; do
    wait -n "${drawn[@]}"
    rest=()
    for id in "${drawn[@]}"; do
      ! kill -0 "$id" 2>/dev/null || rest+=("$id")
    done
    drawn=("${rest[@]}")
  done
}

# picture NAME SENTENCE COMMAND ARGUMENTS...: starts to draw the program's picture of its own result.
picture()
{
  wait_for_pictures 1
  next_part
  draw "$@" &
  drawn+=($!)
}

draw()
{
  local name=$1 sentence=$2 begin=$SECONDS
  shift 2
  rm -f "$gallery/$name.png"
  if "$build/geodesic" "$@" --quiet --picture "$gallery/$name.png" >>$log 2>"$this_part.errors" &&
     [ -s "$gallery/$name.png" ]; then
    printf '%-24s %3d s  %s\n' "$name" $((SECONDS - begin)) "$sentence"
    printf '<figure><img src="%s.png" alt=""><figcaption><p>%s</p><code>geodesic %s</code></figcaption></figure>\n' \
      "$name" "$(printf '%s' "$sentence" | escape)" "$(shown "$@")" >"$this_part.html"
  else
    touch "$this_part.failed"
    printf '%-24s FAILED: geodesic %s\n' "$name" "$*" >&2
    cat "$this_part.errors" >&2
  fi
}

# program NAME ARGUMENTS...: a demo program; its question is the first line of its source.  A
# result that it leaves, the last argument then, is shown by its distances or another $property, or
# without one where that is `none`; or it is the gallery's picture itself.  Nothing is drawn
# meanwhile: some programs measure times, and some read what pictures' commands have left.
program()
{
  wait_for_pictures 0
  next_part
  local name=$1 file=${as:-$1} question answer picture=''
  local shown_by=(--property "${property:-distance}")
  [ "${property-}" != none ] || shown_by=()
  shift
  question=$(sed -n '4s|^// ||p' "demo/$name.cpp")
  printf '\n%s\n' "$question"
  rm -f "$gallery/$file.png"
  if answer=$("$build/demo/$name" "$@" 2>&1); then
    printf '%s\n' "$answer"
    [[ ${!#} != *.ply ]] || "$build/geodesic" info "${!#}" "${shown_by[@]}" --quiet \
      --picture "$gallery/$file.png" >>$log 2>&1
    [ ! -s "$gallery/$file.png" ] || picture="<img src=\"$file.png\" alt=\"\">"
    printf '<figure>%s<figcaption><p>%s</p><pre>%s</pre><code>%s</code></figcaption></figure>\n' \
      "$picture" "$(printf '%s' "$question" | escape)" "$(printf '%s' "$answer" | escape)" \
      "$(shown "$name" "$@")" >"$this_part.html"
  else
    touch "$this_part.failed"
    printf '%s FAILED: %s\n' "$name" "$answer" >&2
  fi
}

echo "Drawing"
picture distance "How far is every place from one vertex?" distance "$animal" --source 0
picture heat "The same by the flow of heat." distance "$animal" --source 0 --method heat
picture near "Only what is near to any of three places is visited when there is a limit." \
  distance "$runner" --source 100,5000,12000 --limit 0.15
picture border "How deep in the surface, seen from its borders?" distance "$holes" --source-border
picture sample "Which places cover a surface evenly?" sample "$animal" --number 300
picture sample-part "Samples of a part of a machine, evenly spread." sample "$part" --number 600
picture sample-attracted "Samples of a part of a machine where creases attract them." \
  sample "$part" --number 600 --speed curvature-attractive
picture sample-repelled "The same number where creases repel them." \
  sample "$part" --number 600 --speed curvature-repulsive
picture sample-even "Samples of a smooth surface, evenly spread," sample "$bunny" --number 600
picture sample-bent "and where curvature attracts them." \
  sample "$bunny" --number 600 --speed curvature-attractive
picture voronoi "Which of sixty seeds, spread by farthest points, is nearest?" \
  voronoi "$bear" --number 60
picture voronoi-part "The same on a part of a machine." voronoi "$part" --number 40
picture segment "Forty charts of about equal size, each a disc, with their centres." \
  segment "$bear" --number 40 --discs
picture segment-part "Charts that are smaller where creases slow fronts down." \
  segment "$part" --number 60 --discs --speed curvature-attractive
picture remesh "The same surface in 1,000 vertices, with even triangles." \
  remesh "$animal" --number 1000 --lloyd 10
picture part "A part of a machine, as it is." info "$part" --sides
picture remesh-part "Sharp edges are kept on request." \
  remesh "$part" --number 1000 --lloyd 10 --keep-sharp 40
picture remesh-spacing "With small steps along them." \
  remesh "$part" --number 1000 --lloyd 10 --keep-sharp 40 --curve-spacing 0.015
picture remesh-part-even "The same part evenly, its creases left to chance," remesh "$part" --number 1000
picture remesh-part-bent "with samples that creases attract, but which do not lie on them," \
  remesh "$part" --number 1000 --speed curvature-attractive
picture remesh-part-both "and with these creases kept." \
  remesh "$part" --number 1000 --speed curvature-attractive --keep-sharp 20
picture remesh-part-repelled "With samples that creases repel triangles are small where it is flat." \
  remesh "$part" --number 1000 --speed curvature-repulsive
picture holes "A surface with holes, as it is." info "$holes"
picture remesh-filled "The holes of a surface are filled first on request." \
  remesh "$holes" --number 1500 --lloyd 10 --fill-holes
picture remesh-100 "One surface in 100 vertices," \
  remesh "$animal" --number 100 --lloyd 10
picture remesh-400 "in 400," remesh "$animal" --number 400 --lloyd 10
picture remesh-1600 "and in 1,600." remesh "$animal" --number 1600 --lloyd 10
wait_for_models
for strength in 0 5 20; do
  picture remesh-image-$strength "A terrain with small triangles where a picture of rings varies, by a strength of $strength." \
    remesh "$terrain" --number 3000 --density-image "$rings" --strength $strength
done
picture function-samples "On an animal a picture is seen along its shortest side: samples where it varies," \
  sample "$animal" --number 1500 --density-image "$rings" --strength 8
picture function-remesh "and triangles." \
  remesh "$animal" --number 1500 --density-image "$rings" --strength 8
picture remesh-even "A beast in 1,500 vertices, evenly," remesh "$beast" --number 1500 --lloyd 5
picture remesh-bent "and with more of them where it bends." \
  remesh "$beast" --number 1500 --lloyd 5 --speed curvature-attractive
for strength in 0.1 0.3 1; do
  picture remesh-strength-$strength "Where it bends triangles are smaller, by a strength of $strength." \
    remesh "$animal" --number 1500 --speed curvature-attractive --strength $strength
done
picture base "The edges of a base of 100 vertices, as geodesics." base "$animal" --number 100
picture base-flat "The same vertices and flat triangles." \
  remesh "$animal" --number 100 --allow-self-intersections
picture base-undivided "The triangles of a model," info "$small" --sides
picture base-divided "and how the edges of a base divide them." \
  base "$small" --number 50 --divided
picture base-part "Edges of a base that follow sharp ones." base "$part" --number 150 --keep-sharp 40
picture semiregular "Each base face cut into 64." semiregular "$animal" --number 100 --levels 3
picture semiregular-2 "The same faces cut into 16," semiregular "$animal" --number 100 --levels 2
picture semiregular-4 "and into 256." semiregular "$animal" --number 100 --levels 4
picture semiregular-quads "Base faces cut into 48 quadrilaterals, with sharp edges." \
  semiregular "$part" --number 150 --levels 2 --keep-sharp 40 --quads
picture path "The shortest path from tip to tip." path "$beast" --from 0 --to 5000
picture path-mask "A shortest path on a surface with a border." path "$mask" --from 0 --to 1000
picture logmap "Normal coordinates around a place: rings of equal distances, and straight lines." \
  logmap "$bunny" --base 1000 --radius 0.5 --up 0,1,0
picture logmap-exact "The same by the directions in which shortest paths leave." \
  logmap "$bunny" --base 1000 --radius 0.5 --up 0,1,0 --method exact
picture logmap-heat "And from distances by the flow of heat." \
  logmap "$bunny" --base 1000 --radius 0.5 --up 0,1,0 --distances heat
picture logmap-edges "By the discrete exponential map, which adds up edges and goes astray." \
  logmap "$bunny" --base 1000 --radius 0.5 --up 0,1,0 --method discrete-exponential
for number in 5 10 20 100; do
  picture flatten-$number "A mask flattened by $number base points, and squares of the plane on it." \
    flatten "$mask" --base-points $number
done
picture flatten-flat "The plane itself, no face turned round." flatten "$mask" --injective --flat
picture atlas "A model and the texture of its charts, in a colour each." atlas "$bunny" --number 30
picture atlas-flat "The texture's plane: charts without flips or overlaps, with room between them." \
  atlas "$bunny" --number 30 --flat
picture atlas-image "A picture that is seen on the model from one side, painted into its texture." \
  atlas "$bunny" --number 30 --image "$rings"
picture decal "Two pictures on an animal: lines through their middles keep lengths and directions." \
  decal "$bunny" --base-at 0.25,-0.1,0.3 --base-at 0.1,0.05,0.4 --up 0,1,0
picture decal-rough "On a rough shell." \
  decal "$animal" --base-at 0,45,60 --up 0,1,0
picture decal-sleeve "One that goes all around a tail." decal "$animal" --base-at 0,-20,100 --up 0,1,0
picture decal-knot "And around a knot." decal "$knot" --base-at -2,1.8,1.5 --up 0,1,0
picture decal-image "Rings on a terrain, twice." \
  decal "$terrain" --base-at 35,40,20 --base-at 85,80,20 --up 0,1,0 --width 60 --width 40 --image "$rings"
picture decal-cloud "On a scan it is surfels that have the colours." \
  decal "$knot_scan" --base-at -2,1.8,1.5 --up 0,1,0
picture spectral "A smooth distance from a foot, by transport of masses along the gradient of a harmonic function," \
  distance "$small" --source 100 --method spectral
picture spectral-100 "and with a hundred eigenfunctions, with which it comes nearer to the length of ways." \
  distance "$small" --source 100 --method emd --basis 100
picture biharmonic "Its elder sister, the biharmonic distance, is uneven." \
  distance "$small" --source 100 --method biharmonic
picture spectral-holes "Around holes the distance is smooth too, of a vertex of a part of a machine," \
  distance "$holes" --source 100 --method spectral
picture biharmonic-holes "and so is the biharmonic one." \
  distance "$holes" --source 100 --method biharmonic
picture spectral-fine "Spectral distances from a place of the foot," \
  distance "$small" --source-at=-0.161,-0.483,-0.052 --method spectral
if "$build/geodesic" remesh "$small" --number 600 --lloyd 5 --quiet -o $build/coarse.ply 2>>$log; then
  picture spectral-coarse "and with a fifth of the vertices, on other triangles." \
    distance $build/coarse.ply --source-at=-0.161,-0.483,-0.052 --method spectral
fi
# A mass at each vertex: the second line of the file begins with their number.
yes 1 | head -n "$(sed -n '2s/ .*//p' "$small")" >$build/everywhere.txt
picture emd-everywhere "All of a surface moves to a foot: the potential falls by the distance." \
  emd "$small" --from $build/everywhere.txt --to 100 --density --normalize
picture emd-feet "From four feet to the tip of the trunk." \
  emd "$small" --from 1766,2200,2278,2552 --to 691
picture emd "From three places to three others: what moves, and the potential that proves the least work." \
  emd "$bunny" --from 0,500,1500 --to 100,2000,3000
picture barycenter "Which vertex has the least sum of squared distances to four feet and the tip of the trunk?" \
  barycenter "$small" --points 691,1766,2200,2278,2552
picture volume-slice "How far is every point of a plane, inside of a body and outside, by masses on its surface?" \
  volume "$small" --from=-0.061,-0.201,-0.006 --slice z,-0.006 --refine 0
picture volume-slices "On two planes, from the same place," \
  volume "$small" --from=-0.061,-0.201,-0.006 --slice x,0 --slice y,-0.2 --refine 0 --resolution 40
picture volume-knot "and from one in a knot: what is near through the air is far." \
  volume "$loop" --from 0.277,0.419,-0.015 --slice z,-0.015 --refine 0
picture volume-path "A path inside of a body, down the distance to its end, from the trunk to a foot," \
  volume "$small" --from 0.152,0.371,0.201 --to=-0.113,-0.456,-0.052 --path --refine 0
picture volume-path-knot "around a knot," \
  volume "$loop" --from 0.277,0.419,-0.015 --to=-0.367,-0.14,0.092 --path --refine 0
picture volume-path-cow "and from a foot to a mouth." \
  volume "$cow" --from=-0.364,-0.299,-0.102 --to 0.473,0.173,0.021 --path --refine 0
picture emd-cloud "The same on points alone." emd "$scan" --from 0,500,1500 --to 100,2000,3000
picture feature "How far is everything from four places, by one transport?" \
  feature-distance "$animal" --feature 0,100,2000,9000
picture feature-path "From a path through faces, and from a place in one." \
  feature-distance "$small" --feature-path 691,2278 --feature-at 0.1,0.2,0.1
picture ridge "From a ridge of the back, with speeds that are high where it bends like there." \
  feature-distance "$beast" --feature 3000 --speed curvature-like-3000 --strength 1
picture ridge-plain "The same with one speed." feature-distance "$beast" --feature 3000
picture maze "From two places in a maze to whichever way out is nearer." \
  plan $models/maze.ply --from people --to room
picture floor "How people leave their rooms for the doors at both ends of a corridor." \
  plan $models/floor.ply --from people --density --to room
picture floor-full "The same where the right door has room for a quarter of them." \
  plan $models/floor.ply --from people --density --to room --capacity room
picture maze-spread "From two places to all others, where it costs to be crowded." \
  plan $models/maze.ply --from people --to floor --spread 500
picture streamlines "Which grain goes where? Lines of the flow from a hind foot to all the others." \
  streamlines "$small" --from 1766 --to 2200,2278,2552 --number 60
picture streamlines-everywhere "And from everywhere to the tip of the trunk, along shortest paths." \
  streamlines "$small" --from $build/everywhere.txt --to 691 --density --normalize --number 200
picture streamlines-runner "From a head to three other places of a man." \
  streamlines "$runner" --from 0 --to 5000,10000,15000 --number 60
picture streamlines-cloud "On points alone." streamlines "$scan" --from 0 --to 1000,3000 --number 40
picture fuzzy "Where do shortest paths between the surroundings of two places pass? Where a flow between blobs is strong," \
  fuzzy "$small" --from 691 --to 2278 --width 0.06
picture fuzzy-detours "or over small detours." fuzzy "$small" --from 691 --to 2278 --width 0.06 --by-distances
picture fuzzy-cloud "On points alone." fuzzy "$scan" --from 0 --to 3000
picture cloud "Distance on a scan: points alone, without triangles." distance "$scan" --source 0
picture cloud-image "Samples of a scan where a picture of rings varies, seen along its shortest side." \
  sample "$scan" --number 1500 --density-image "$rings"
picture cloud-remesh "A surface of the scan, in 600 vertices." \
  remesh "$scan" --number 600 --lloyd 10
picture cloud-voronoi "Nearest seeds on points with normals." \
  voronoi "$scan_with_normals" --number 30
picture cloud-path "A shortest path on points, and the chain of arcs that it started from." \
  path "$scan" --from 0 --to 2000 --start
picture cloud-path-knot "The same on a cloud that was made for it." \
  path "$knot_scan" --from 0 --to 12000 --start
picture cloud-path-noise "Where there is noise it is removed first; the chain is that of the clean surfels." \
  path "$noisy_scan" --from 0 --to 12000 --start
picture cloud-path-jagged "Projected to planes, as others do, without removing it, the path is torn to and fro." \
  path "$noisy_scan" --from 0 --to 12000 --start --surfel-noise kept --surfel-path-method projected-planes
picture cloud-path-sphere "Arcs of a sphere zigzag; the path is a great circle." \
  path $models/sphere.xyz --from 1000 --to 6800 --start
picture cloud-path-pipe "Through noise with outliers, around a pipe." \
  path $models/pipe.xyz --from 20 --to 11950 --start
picture cloud-graph "Which surfels of a scan are joined: those whose spheres meet and whose normals agree." \
  surfels "$scan_with_normals" --arcs

next_part
echo '</main><h2>The demo programs</h2><main>' >"$this_part.html"
wait_for_pictures 0
wait $demo_build
demo_build=''
[ ! -e $build/demos_failed ] || build_failed
program farthest_vertex "$animal" $build/farthest.ply
program covering_radius "$animal" $build/covering.ply
program curvature_adapted_sampling "$part" $build/attracted.ply
program sampling_with_speed_map 170 $build/sampling_with_speed_map.ply
for number in 30 170 680; do
  picture two-speeds-$number "The triangles of $number such samples." \
    remesh $build/sampling_with_speed_map.ply --number $number --speed speed
done
picture three-fronts "Where do three fronts meet, of which two start in the slow half?" \
  voronoi $build/sampling_with_speed_map.ply --seeds 8000,10101,30000 --speed speed
property=speed program sampling_density "$bunny" $build/sampling_density.ply
picture sample-chosen "Samples where a user wants them," \
  sample $build/sampling_density.ply --number 1000 --speed speed
picture remesh-chosen "and small triangles." \
  remesh $build/sampling_density.ply --number 1500 --lloyd 5 --speed speed
program cut_locus "$bunny" $build/cut_locus.ply
property=graticule program azimuthal_map $build/azimuthal_map.ply
program distance_family "$small" 100 $build/distance_family.ply
program robustness "$small" 100 $build/robustness.ply
property=detour program detour_cost "$small" 100 1500 $build/detour_cost.ply
property=density program barycenter_of_six_masses "$runner" $build/barycenter_of_six_masses.ply
property=likelihood program fuzzy_geodesics "$small" 691 2278 $build/fuzzy_geodesics.ply
property=none program hodge_decomposition "$small" 100 1200 $build/hodge_decomposition.ply
as=hodge_decomposition_maze property=none program hodge_decomposition $models/maze.ply 804 3 1223 \
  $build/hodge_decomposition_maze.ply
program compare_methods "$small"
program mesh_vs_cloud "$animal" $build/cloud.ply
program voronoi_areas "$bear" $build/lands.ply
program path_queries "$animal"
program neighborhood_queries "$animal"
program remeshing "$animal" $build/remeshed.off
property=share program barycentric_isolines "$animal" 100 $build/shares.ply
picture base-distance "And how far is each from the nearest corner?" \
  info $build/shares.ply --property distance
picture step-sample "A hundred places that cover a surface," sample "$animal" --number 100
picture step-voronoi "the cells of what is nearest to each," voronoi "$animal" --number 100
picture step-remesh "the triangles between their centres," remesh "$animal" --number 100
picture step-semiregular "and each of these cut into four on the surface." \
  semiregular "$animal" --number 100 --levels 1
program contact_sheet $gallery/{distance,step-sample,step-voronoi,step-remesh,base}.png \
  $gallery/{barycentric_isolines,step-semiregular,semiregular}.png $gallery/contact_sheet.png
program wavelet_bit_rate "$bunny" $build/levels.off
for bits in 0.7 1 2 6; do
  picture wavelet-$bits "At most $bits bits for each vertex." wavelet $build/levels.off --bits $bits
done
picture wavelet-tenth "A tenth of the details, the largest." wavelet $build/levels.off --keep 10
next_part
cp doc/fig/rate_distortion.svg $gallery &&
  printf '<figure><img src="rate_distortion.svg" alt=""><figcaption><p>%s</p></figcaption></figure>\n' \
    "Errors over the bits for each vertex, relative to the diagonal." >"$this_part.html"
wait_for_pictures 0
{ cat "$parts"/*.html && echo '</main></body></html>'; } >$page
failures=$(find "$parts" -name '*.failed' | wc -l)

echo
if [ "$failures" -ne 0 ]; then
  echo "$failures of the pictures and programs failed, after $((SECONDS - started)) s; $log has" \
       "what they said." >&2
  exit 1
fi
echo "The gallery is in $PWD/$page, made in $((SECONDS - started)) s."
