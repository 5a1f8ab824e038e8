#!/usr/bin/env bash
# Copyright (c) 2026 The authors of Geodesic_processing.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Installs missing packages and builds the program `geodesic`.  Then computes pictures of models, two
# at a time, while the demo programs are built.  Runs the demo programs at the end.  Writes the
# pictures and an HTML page to demo/gallery/.
# Environment: JOBS, the number of build jobs (default: all processors).
set -u -o pipefail

cd "$(dirname "${BASH_SOURCE[0]}")/.." || exit 1
. cmake/install_packages.sh

jobs=${JOBS:-$(nproc)}
build=build/demo
gallery=demo/gallery
models=$build/models
parts=$build/parts # fragments of the page, and one file per failure
log=$build/run.log
started=$SECONDS

packages=(g++ cmake ninja-build ccache
  libcgal-dev libboost-dev libeigen3-dev libsuitesparse-dev libopenblas-dev
  libcli11-dev nlohmann-json3-dev libpng-dev zlib1g-dev liblz4-dev libvtk9-dev xvfb xauth)

install_packages "${packages[@]}" || exit 1

mkdir -p $build $gallery "$models"
rm -rf "$parts" $build/demos_failed
mkdir -p "$parts"
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

# Builds the demo programs; the ones that generate models are built and run first.
build_demos()
{
  if ! { nice cmake --build $build -j "$jobs" --target demo_make_models demo_make_test_image &&
         $build/demo/make_models $models && $build/demo/make_test_image $models/rings.png &&
         touch $models/are_made && nice cmake --build $build -j "$jobs"; }; then
    touch $build/demos_failed
  fi
} >>$log 2>&1

# Waits until the demo programs have generated the models.
wait_for_models()
{
  until [ -e $models/are_made ]; do
    [ ! -e $build/demos_failed ] || build_failed
    sleep 0.2
  done
}

server='' demo_build=''
trap 'kill $server $demo_build 2>/dev/null' EXIT

echo "Building the program and downloading models"
fetch_models &
fetching=$!
{ cmake -S . -B $build -G Ninja -DCMAKE_BUILD_TYPE=Release -DCMAKE_UNITY_BUILD=ON \
    -DGEODESIC_PROCESSING_DEMOS=ON &&
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
  echo "Debian's libcgal-demo is not available: the pictures use generated models instead."
  animal=$models/knot.off beast=$animal part=$models/hills.off runner=$animal bear=$animal
  bunny=$animal loop=$animal cow=$animal
  holes=$models/hills.off mask=$models/hills.off small=$models/hills.off
  scan=$models/scan.xyz scan_with_normals=$scan
  wait_for_models
fi

page=$gallery/index.html
number_of_parts=0 this_part='' # path prefix of the current page fragment
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
iframe { width: 100%; height: 32em; border: 1px solid #ddd; border-radius: 6px; }
code, pre { background: #f2f2f2; padding: 0.2em 0.4em; display: block; white-space: pre-wrap; }
</style></head><body>
<h1>Geodesic_processing: a tour</h1>
<p>Geodesic distances and paths on surfaces. The command follows each picture.</p>
<main>
HTML

escape() { sed -e 's/&/\&amp;/g' -e 's/</\&lt;/g' -e 's/>/\&gt;/g' -e 's/"/\&quot;/g'; }

# Prints the command without the folders of its files.
shown() { printf '%s' "$*" | sed -e "s|[^ ]*/||g" | escape; }

# Waits until at most $1 pictures are still being computed.
drawn=()
wait_for_pictures()
{
  local limit=$1 id rest
  while [ ${#drawn[@]} -gt "$limit" ]; do
    wait -n "${drawn[@]}"
    rest=()
    for id in "${drawn[@]}"; do
      ! kill -0 "$id" 2>/dev/null || rest+=("$id")
    done
    drawn=("${rest[@]}")
  done
}

# picture NAME CAPTION COMMAND ARGUMENTS...: runs a command of the program in the background and adds
# the picture of its result to the page.
picture()
{
  wait_for_pictures 1
  next_part
  draw "$@" &
  drawn+=($!)
}

draw()
{
  local name=$1 caption=$2 begin=$SECONDS text
  shift 2
  rm -f "$gallery/$name.png"
  if "$build/geodesic" "$@" --quiet --picture "$gallery/$name.png" >>$log 2>"$this_part.errors" &&
     [ -s "$gallery/$name.png" ]; then
    printf '%-24s %3d s  %s\n' "$name" $((SECONDS - begin)) "$caption"
    text=$(printf '%s' "$caption" | escape)
    printf '<figure><img src="%s.png" alt="%s"><figcaption><p>%s</p><code>geodesic %s</code></figcaption></figure>\n' \
      "$name" "$text" "$text" "$(shown "$@")" >"$this_part.html"
  else
    touch "$this_part.failed"
    printf '%-24s FAILED: geodesic %s\n' "$name" "$*" >&2
    cat "$this_part.errors" >&2
  fi
}

# program NAME ARGUMENTS...: runs a demo program and adds its output to the page.  The caption is the
# first comment line of its source.  If the last argument is a .ply file, a picture of it is drawn,
# colored by $property (default: distance; `none`: without values).  A program may also write the
# gallery's picture itself.  Waits for all pictures first, because some programs measure times and
# some read results of earlier pictures.
program()
{
  wait_for_pictures 0
  next_part
  local name=$1 file=${as:-$1} caption text output picture=''
  local shown_by=(--property "${property:-distance}")
  [ "${property-}" != none ] || shown_by=()
  shift
  caption=$(sed -n '4s|^// ||p' "demo/$name.cpp")
  printf '\n%s\n' "$caption"
  rm -f "$gallery/$file.png"
  if output=$("$build/demo/$name" "$@" 2>&1); then
    printf '%s\n' "$output"
    [[ ${!#} != *.ply ]] || "$build/geodesic" info "${!#}" "${shown_by[@]}" --quiet \
      --picture "$gallery/$file.png" >>$log 2>&1
    text=$(printf '%s' "$caption" | escape)
    [ ! -s "$gallery/$file.png" ] || picture="<img src=\"$file.png\" alt=\"$text\">"
    printf '<figure>%s<figcaption><p>%s</p><pre>%s</pre><code>%s</code></figcaption></figure>\n' \
      "$picture" "$text" "$(printf '%s' "$output" | escape)" \
      "$(shown "$name" "$@")" >"$this_part.html"
  else
    touch "$this_part.failed"
    printf '%s FAILED: %s\n' "$name" "$output" >&2
  fi
}

# Adds interactive viewers of ten surfaces to the page, if the page of the viewer was built.
add_viewers()
{
  local viewer model name
  next_part
  echo '</main>' >"$this_part.html"
  for viewer in $build/viewer/viewer.html build/release/viewer/viewer.html; do
    [ ! -s $viewer ] || break
  done
  [ -s $viewer ] || { echo "The viewers are missing, because the target viewer was not built."; return; }
  echo '<h2>Interactive viewers</h2><p>Click on a surface to compute distances.</p><main>' \
    >>"$this_part.html"
  for model in "$animal" "$bunny" "$bear" "$part" "$holes" "$runner" "$beast" "$mask" "$knot" "$scan"; do
    next_part
    name=$(basename "${model%.*}")
    if "$build/geodesic" view "$model" --page $viewer --quiet -o "$gallery/view-$name.html" \
      2>"$this_part.errors"; then
      printf '<figure><iframe src="view-%s.html" loading="lazy" title="%s"></iframe><figcaption><p><a href="view-%s.html">%s</a></p><code>geodesic %s</code></figcaption></figure>\n' \
        "$name" "$name" "$name" "$name" "$(shown view "$model" -o "$name.html")" >"$this_part.html"
    else
      touch "$this_part.failed"
      cat "$this_part.errors" >&2
    fi
  done
  next_part
  echo '</main>' >"$this_part.html"
}

echo "Computing pictures"
picture distance "Geodesic distance from one vertex (isolines at round values)" \
  distance "$animal" --source 0
picture isolines "Mesh split along isolines of the distance from one vertex, with the labels of its faces" \
  isolines "$animal" --source 0 --number 11 --divided
picture heat "Distance from one vertex, approximated by the heat method" \
  distance "$animal" --source 0 --method heat
picture near "Distance from three vertices, computed up to a maximum distance" \
  distance "$runner" --source 100,5000,12000 --limit 0.15
picture border "Distance to the nearest boundary" distance "$holes" --source-border
picture sample "300 samples by farthest point sampling" sample "$animal" --number 300
picture sample-part "600 evenly spaced samples of a mechanical part" sample "$part" --number 600
picture sample-attracted "600 samples of a mechanical part, denser at creases" \
  sample "$part" --number 600 --speed curvature-attractive
picture sample-repelled "600 samples of a mechanical part, sparser at creases" \
  sample "$part" --number 600 --speed curvature-repulsive
picture sample-even "600 evenly spaced samples of a smooth surface" sample "$bunny" --number 600
picture sample-bent "600 samples of a smooth surface, denser in regions of high curvature" \
  sample "$bunny" --number 600 --speed curvature-attractive
picture voronoi "Geodesic Voronoi cells of 60 seeds from farthest point sampling" \
  voronoi "$bear" --number 60
picture voronoi-part "Geodesic Voronoi cells of 40 seeds on a mechanical part" \
  voronoi "$part" --number 40
picture segment "At least 40 charts of similar size with disk topology, and their centers" \
  segment "$bear" --number 40 --disks
picture segment-part "Charts with disk topology that are smaller at creases, because the fronts are slower there" \
  segment "$part" --number 60 --disks --speed curvature-attractive
picture remesh "Remeshing with 1,000 vertices and 10 relaxation steps" \
  remesh "$animal" --number 1000 --lloyd 10
picture part "Input mesh of a mechanical part, with its edges" info "$part" --sides
picture remesh-part "Remeshing that keeps edges sharper than 40 degrees" \
  remesh "$part" --number 1000 --lloyd 10 --keep-sharp 40
picture remesh-spacing "Remeshing with kept sharp edges and a maximum vertex spacing along them" \
  remesh "$part" --number 1000 --lloyd 10 --keep-sharp 40 --curve-spacing 0.015
picture remesh-part-even "Uniform remeshing without feature edges" remesh "$part" --number 1000
picture remesh-part-bent "Remeshing with denser samples at creases, without feature edges" \
  remesh "$part" --number 1000 --speed curvature-attractive
picture remesh-part-both "Remeshing with denser samples at creases and kept sharp edges" \
  remesh "$part" --number 1000 --speed curvature-attractive --keep-sharp 20
picture remesh-part-repelled "Remeshing with sparser samples at creases: triangles are smaller in flat regions" \
  remesh "$part" --number 1000 --speed curvature-repulsive
picture holes "Input mesh with holes" info "$holes"
picture remesh-filled "Remeshing after hole filling" \
  remesh "$holes" --number 1500 --lloyd 10 --fill-holes
picture remesh-100 "Remeshing with 100 vertices" \
  remesh "$animal" --number 100 --lloyd 10
picture remesh-400 "Remeshing with 400 vertices" remesh "$animal" --number 400 --lloyd 10
picture remesh-1600 "Remeshing with 1,600 vertices" remesh "$animal" --number 1600 --lloyd 10
wait_for_models
for strength in 0 5 20; do
  picture remesh-image-$strength "Remeshing of a terrain, refined at the edges of an image of rings (strength $strength)" \
    remesh "$terrain" --number 3000 --density-image "$rings" --strength $strength
done
picture function-samples "Samples that are denser at the edges of an image, projected along the shortest axis of the bounding box" \
  sample "$animal" --number 1500 --density-image "$rings" --strength 8
picture function-remesh "Remeshing that is refined at the edges of an image, projected along the shortest axis of the bounding box" \
  remesh "$animal" --number 1500 --density-image "$rings" --strength 8
picture remesh-even "Uniform remeshing with 1,500 vertices" remesh "$beast" --number 1500 --lloyd 5
picture remesh-bent "Curvature-adapted remeshing with 1,500 vertices" \
  remesh "$beast" --number 1500 --lloyd 5 --speed curvature-attractive
for strength in 0.1 0.3 1; do
  picture remesh-strength-$strength "Curvature-adapted remeshing (strength $strength)" \
    remesh "$animal" --number 1500 --speed curvature-attractive --strength $strength
done
picture base "Base mesh of 100 vertices: its edges as geodesics on the input" \
  base "$animal" --number 100
picture base-flat "Remeshing with 100 vertices and planar triangles" \
  remesh "$animal" --number 100 --allow-self-intersections
picture base-undivided "Input mesh with its edges" info "$small" --sides
picture base-divided "Input mesh, its faces cut along the geodesic edges of a base mesh" \
  base "$small" --number 50 --divided
picture base-part "Edges of a base mesh that follow sharp edges" \
  base "$part" --number 150 --keep-sharp 40
picture semiregular "Semi-regular remeshing: each base face is subdivided into 64 triangles" \
  semiregular "$animal" --number 100 --levels 3
picture semiregular-2 "Semi-regular remeshing: each base face is subdivided into 16 triangles" \
  semiregular "$animal" --number 100 --levels 2
picture semiregular-4 "Semi-regular remeshing: each base face is subdivided into 256 triangles" \
  semiregular "$animal" --number 100 --levels 4
picture semiregular-quads "Semi-regular remeshing with kept sharp edges: each base face is subdivided into 48 quadrilaterals" \
  semiregular "$part" --number 150 --levels 2 --keep-sharp 40 --quads
picture path "Shortest path between two vertices" path "$beast" --from 0 --to 5000
picture ball "Geodesic ball around a vertex, and the circle that bounds it" \
  ball "$small" --source 691 --radius 0.25
picture diameter "Distance from an end of the longest shortest path" diameter "$small"
picture curve "Cubic Bezier curve, and the shortest paths of its control polygon" \
  curve "$cow" --point-at=-.35,.15,.2 --point-at=-.2,-.15,.3 --point-at=0,.3,.2 --point-at=.2,-.1,.3
picture spline "Closed cubic B-spline, and the shortest paths of its control polygon" \
  curve "$cow" --point-at=-.3,.15,.3 --point-at=-.15,-.1,.3 --point-at=.05,0,.3 \
  --point-at=.2,-.15,.3 --point-at=.25,.05,.3 --point-at=0,.15,.3 --spline --closed
picture path-mask "Shortest path on a mesh with boundary" path "$mask" --from 0 --to 1000
picture logmap "Logarithmic map: geodesic polar coordinates around a point" \
  logmap "$bunny" --base 1000 --radius 0.5 --up 0,1,0
picture logmap-exact "Logarithmic map from the initial directions of exact shortest paths" \
  logmap "$bunny" --base 1000 --radius 0.5 --up 0,1,0 --method exact
picture logmap-heat "Logarithmic map from distances of the heat method" \
  logmap "$bunny" --base 1000 --radius 0.5 --up 0,1,0 --distances heat
picture logmap-edges "Discrete exponential map: errors accumulate along chains of edges" \
  logmap "$bunny" --base 1000 --radius 0.5 --up 0,1,0 --method discrete-exponential
for number in 5 10 20 100; do
  picture flatten-$number "Parameterization from $number base points, shown by a checkerboard" \
    flatten "$mask" --base-points $number
done
picture flatten-flat "Injective parameterization in the plane, without inverted faces" \
  flatten "$mask" --injective --flat
picture atlas "Texture atlas: one color per chart, on the mesh" atlas "$bunny" --number 30
picture atlas-flat "Texture atlas in the plane: charts without flips or overlaps, separated by gutters" \
  atlas "$bunny" --number 30 --flat
picture atlas-image "Image projected onto the mesh and baked into its texture atlas" \
  atlas "$bunny" --number 30 --image "$rings"
picture decal "Two decals that preserve lengths and directions along the lines through their centers" \
  decal "$bunny" --base-at 0.25,-0.1,0.3 --base-at 0.1,0.05,0.4 --up 0,1,0
picture decal-rough "Decal on a rough surface" \
  decal "$animal" --base-at 0,45,60 --up 0,1,0
picture decal-sleeve "Decal that wraps around a tail" decal "$animal" --base-at 0,-20,100 --up 0,1,0
picture decal-knot "Decal that wraps around a knot" decal "$knot" --base-at -2,1.8,1.5 --up 0,1,0
picture decal-image "Two decals with an image of rings on a terrain" \
  decal "$terrain" --base-at 35,40,20 --base-at 85,80,20 --up 0,1,0 --width 60 --width 40 --image "$rings"
picture decal-cloud "Decal on a point cloud, with one color per surfel" \
  decal "$knot_scan" --base-at -2,1.8,1.5 --up 0,1,0
picture spectral "Spectral distance: optimal transport along the gradient of a harmonic function" \
  distance "$small" --source 100 --method spectral
picture spectral-100 "Transport distance with 100 eigenfunctions, closer to the geodesic distance" \
  distance "$small" --source 100 --method emd --basis 100
picture biharmonic "Biharmonic distance from the same vertex" \
  distance "$small" --source 100 --method biharmonic
picture spectral-holes "Spectral distance on a mechanical part with holes" \
  distance "$holes" --source 100 --method spectral
picture biharmonic-holes "Biharmonic distance on a mechanical part with holes" \
  distance "$holes" --source 100 --method biharmonic
picture spectral-fine "Spectral distance from a point of the input mesh" \
  distance "$small" --source-at=-0.161,-0.483,-0.052 --method spectral
if "$build/geodesic" remesh "$small" --number 600 --lloyd 5 --quiet -o $build/coarse.ply 2>>$log; then
  picture spectral-coarse "Spectral distance from the same point on a mesh remeshed with 600 vertices" \
    distance $build/coarse.ply --source-at=-0.161,-0.483,-0.052 --method spectral
fi
# Writes a unit mass per vertex; the second line of an OFF file begins with the number of vertices.
yes 1 | head -n "$(sed -n '2s/ .*//p' "$small")" >$build/everywhere.txt
picture emd-everywhere "Transport of a uniform mass distribution to one vertex: optimal flow and potential" \
  emd "$small" --from $build/everywhere.txt --to 100 --density --normalize
picture emd-feet "Transport from four feet to the tip of the trunk: optimal flow and potential" \
  emd "$small" --from 1766,2200,2278,2552 --to 691
picture emd "Transport from three vertices to three others: optimal flow and the potential that certifies the lower bound" \
  emd "$bunny" --from 0,500,1500 --to 100,2000,3000
picture barycenter "Vertex with the minimum sum of squared distances to five points, and the shortest paths to them" \
  barycenter "$small" --points 691,1766,2200,2278,2552
picture karcher-mean "Karcher mean of five points, and the shortest paths to them" \
  karcher-mean "$small" --points 691,1766,2200,2278,2552
picture karcher-mean-cloud "Karcher mean of three points of a point cloud" \
  karcher-mean "$scan" --points 0,1000,3000
picture volume-slice "Transport distance in space from an interior point, on a plane inside and outside the mesh" \
  volume "$small" --from=-0.061,-0.201,-0.006 --slice z,-0.006 --refine 0
picture volume-slices "Transport distance in space from an interior point, on two planes" \
  volume "$small" --from=-0.061,-0.201,-0.006 --slice x,0 --slice y,-0.2 --refine 0 --resolution 40
picture volume-knot "Transport distance inside and outside a knot" \
  volume "$loop" --from 0.277,0.419,-0.015 --slice z,-0.015 --refine 0
picture volume-path "Path inside a mesh from the trunk to a foot" \
  volume "$small" --from 0.152,0.371,0.201 --to=-0.113,-0.456,-0.052 --path --refine 0
picture volume-path-knot "Path inside a knot" \
  volume "$loop" --from 0.277,0.419,-0.015 --to=-0.367,-0.14,0.092 --path --refine 0
picture volume-path-cow "Path inside a mesh from a foot to the mouth" \
  volume "$cow" --from=-0.364,-0.299,-0.102 --to 0.473,0.173,0.021 --path --refine 0
picture emd-cloud "Transport on a point cloud from three points to three others: optimal flow and potential" \
  emd "$scan" --from 0,500,1500 --to 100,2000,3000
picture feature "Distance to a set of four vertices from one optimal transport" \
  feature-distance "$animal" --feature 0,100,2000,9000
picture feature-path "Distance to a path through faces and to a point inside a face" \
  feature-distance "$small" --feature-path 691,2278 --feature-at 0.1,0.2,0.1
picture ridge "Distance to a ridge vertex, with high speeds in regions of similar curvature" \
  feature-distance "$beast" --feature 3000 --speed curvature-like-3000 --strength 1
picture ridge-plain "Distance to a ridge vertex with unit speed" \
  feature-distance "$beast" --feature 3000
picture maze "Transport from two locations in a maze to the nearest exits" \
  plan $models/maze.ply --from people --to room
picture floor "Evacuation of rooms to the doors at both ends of a corridor" \
  plan $models/floor.ply --from people --density --to room
picture floor-full "Evacuation of rooms when the right door admits a quarter of the people" \
  plan $models/floor.ply --from people --density --to room --capacity room
picture maze-spread "Transport from two locations to all of a maze, with a penalty on the squared density" \
  plan $models/maze.ply --from people --to floor --spread 500
picture streamlines "Streamlines of the optimal flow from one hind foot to the other feet" \
  streamlines "$small" --from 1766 --to 2200,2278,2552 --number 60
picture streamlines-everywhere "Streamlines from a uniform mass distribution to the tip of the trunk: shortest paths" \
  streamlines "$small" --from $build/everywhere.txt --to 691 --density --normalize --number 200
picture streamlines-runner "Streamlines from one vertex to three others" \
  streamlines "$runner" --from 0 --to 5000,10000,15000 --number 60
picture streamlines-cloud "Streamlines on a point cloud" \
  streamlines "$scan" --from 0 --to 1000,3000 --number 40
picture fuzzy "Fuzzy geodesic from an optimal flow between two blobs of mass" \
  fuzzy "$small" --from 691 --to 2278 --width 0.06
picture fuzzy-detours "Fuzzy geodesic from the length of detours" \
  fuzzy "$small" --from 691 --to 2278 --width 0.06 --by-distances
picture fuzzy-cloud "Fuzzy geodesic on a point cloud" fuzzy "$scan" --from 0 --to 3000
picture cloud "Geodesic distance from one point of a point cloud" distance "$scan" --source 0
picture cloud-image "Samples of a point cloud that are denser at the edges of an image" \
  sample "$scan" --number 1500 --density-image "$rings"
picture cloud-remesh "Triangle mesh with 600 vertices reconstructed from a point cloud" \
  remesh "$scan" --number 600 --lloyd 10
picture cloud-voronoi "Geodesic Voronoi cells of 30 seeds on a point cloud with normals" \
  voronoi "$scan_with_normals" --number 30
picture cloud-path "Shortest path on a point cloud and its initial path in the surfel graph" \
  path "$scan" --from 0 --to 2000 --start
picture cloud-path-knot "Shortest path on a point cloud of a knot and its initial path in the surfel graph" \
  path "$knot_scan" --from 0 --to 12000 --start
picture cloud-path-noise "Shortest path on a noisy cloud after denoising; the initial path connects the denoised surfels" \
  path "$noisy_scan" --from 0 --to 12000 --start
picture cloud-path-jagged "Path on a noisy cloud, projected to planes without denoising: the path is jagged" \
  path "$noisy_scan" --from 0 --to 12000 --start --surfel-noise kept --surfel-path-method projected-planes
picture cloud-path-sphere "Shortest path on a sphere is a great circle; its initial path in the surfel graph zigzags" \
  path $models/sphere.xyz --from 1000 --to 6800 --start
picture cloud-path-pipe "Shortest path around a pipe with noise and outliers, and its initial path in the surfel graph" \
  path $models/pipe.xyz --from 20 --to 11950 --start
picture cloud-graph "Edges of the surfel graph: they join surfels whose spheres intersect and whose normals agree" \
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
  picture two-speeds-$number "Remeshing of a square with two speeds, from $number samples" \
    remesh $build/sampling_with_speed_map.ply --number $number --speed speed
  picture square-$number "Remeshing of a square, from $number samples" \
    remesh $build/sampling_with_speed_map.ply --number $number
done
picture three-fronts "Voronoi cells of three seeds, two of them in the slow half" \
  voronoi $build/sampling_with_speed_map.ply --seeds 8000,10101,30000 --speed speed
property=speed program sampling_density "$bunny" $build/sampling_density.ply
picture sample-chosen "Samples with a user-defined density" \
  sample $build/sampling_density.ply --number 1000 --speed speed
picture remesh-chosen "Remeshing with a user-defined density" \
  remesh $build/sampling_density.ply --number 1500 --lloyd 5 --speed speed
program cut_locus "$bunny" $build/cut_locus.ply
property=graticule program azimuthal_map $build/azimuthal_map.ply
program distance_family "$small" 100 $build/distance_family.ply
program robustness "$small" 100 $build/robustness.ply
property=detour program detour_cost "$small" 100 1500 $build/detour_cost.ply
property=density program barycenter_of_six_masses "$runner" $build/barycenter_of_six_masses.ply
property=none program distance_gradients "$small" 100 1200 $build/distance_gradients.ply
property=likelihood program fuzzy_geodesics "$small" 691 2278 $build/fuzzy_geodesics.ply
property=potential program hodge_decomposition "$small" 100 1200 $build/hodge_decomposition.ply
as=hodge_decomposition_maze property=potential program hodge_decomposition $models/maze.ply 804 3 1223 \
  $build/hodge_decomposition_maze.ply
program compare_methods "$small"
program damaged_soup "$animal" $build/damaged_soup.ply
# Generates a mesh of a million vertices.
if "$build/geodesic" semiregular "$animal" --number 1000 --levels 5 --quiet -o $build/large.ply 2>>$log; then
  property=none program large_inputs $build/large.ply
fi
program mesh_vs_cloud "$animal" $build/cloud.ply
program voronoi_areas "$bear" $build/voronoi_areas.ply
program path_queries "$animal"
property=path program noisy_cloud_paths "$scan" 0 2500 $build/noisy_cloud_paths.ply
property=none program path_energy "$bunny" 1500 100 $build/path_energy.ply
program neighborhood_queries "$animal"
program remeshing "$animal" $build/remeshed.off
property=coordinate program barycentric_isolines "$animal" 100 $build/barycentric_isolines.ply
picture base-distance "Distance to the nearest base vertex" \
  info $build/barycentric_isolines.ply --property distance
picture base-colors "Random colors of the base vertices, interpolated by barycentric coordinates" \
  info $build/barycentric_isolines.ply --property color
picture step-sample "100 samples by farthest point sampling" sample "$animal" --number 100
picture step-voronoi "Geodesic Voronoi cells of 100 samples" voronoi "$animal" --number 100
picture step-remesh "Remeshing: the dual triangulation of 100 Voronoi cells" \
  remesh "$animal" --number 100
picture step-semiregular "Semi-regular remeshing: each base face is subdivided into 4 triangles" \
  semiregular "$animal" --number 100 --levels 1
program contact_sheet $gallery/{distance,step-sample,step-voronoi,step-remesh,base}.png \
  $gallery/{barycentric_isolines,step-semiregular,semiregular}.png $gallery/contact_sheet.png
program wavelet_bit_rate "$bunny" $build/levels.off
for bits in 0.7 1 2 6; do
  picture wavelet-$bits "Mesh decoded from at most $bits bits per vertex" \
    wavelet $build/levels.off --bits $bits
done
picture wavelet-tenth "Mesh reconstructed from the largest 10 % of the wavelet coefficients" \
  wavelet $build/levels.off --keep 10
next_part
caption="Rate-distortion curve: error relative to the bounding box diagonal over bits per vertex"
cp doc/fig/rate_distortion.svg $gallery &&
  printf '<figure><img src="rate_distortion.svg" alt="%s"><figcaption><p>%s</p></figcaption></figure>\n' \
    "$caption" "$caption" >"$this_part.html"
wait_for_pictures 0
seconds=$((SECONDS - started))
add_viewers
{ cat "$parts"/*.html && echo '</body></html>'; } >$page
failures=$(find "$parts" -name '*.failed' | wc -l)

echo
if [ "$failures" -ne 0 ]; then
  echo "$failures pictures or programs failed after $seconds s; $log contains" \
       "the output of the pictures' commands." >&2
  exit 1
fi
echo "The gallery is $PWD/$page, written in $seconds s."
