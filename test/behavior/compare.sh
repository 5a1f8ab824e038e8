#!/usr/bin/env bash
# Copyright (c) 2026 The authors of Geodesic_processing.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# compare.sh [OPTIONS] BEFORE_BUILD AFTER_BUILD [DATA]
# Runs the same commands of the program, and the same library calls, with two builds and compares
# their results. Run it before and after a change that must not alter any result.
#   BEFORE_BUILD, AFTER_BUILD   build folders on this machine.  Commands on generated models need
#                               the demos of the first one (-DGEODESIC_PROCESSING_DEMOS=ON).
#                               Library calls need builds of the same type and compiler
#   DATA                        folder with real models (default: shared/data next to the
#                               repository); without it, the commands on real models are skipped
#   --no-messages   ignore the words of standard error, of help texts and of readable results
#   --only REGEX    only commands that match
#   --except REGEX  not the commands that match
#   --threads N,M   N threads before and M after, for commands that state no number
#   --keep FOLDER   keep the outputs of all commands in this folder
# Exit codes, standard output, standard error and all written files must be equal. The times in
# JSON ("seconds") are ignored. Numbers are compared by value, in shortest round-trip form.
# The exit code is 0 if all commands are equal, 1 if one differs, 2 if nothing could be compared.
# Environment: JOBS (default: all processors). OPENBLAS_CORETYPE, OPENBLAS_NUM_THREADS and
# OMP_NUM_THREADS reach both builds unchanged.
set -u -o pipefail
export LC_ALL=C
unset DISPLAY # each picture gets a display server of its own

here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
started=$SECONDS

fail() { echo "compare.sh: $*" >&2; exit 2; }
usage() { sed -n '5,25s/^# \{0,1\}//p' "$0" >&2; exit 2; }

with_messages=1 only=. except= keep= threads=
while [[ ${1-} == -* ]]; do
  case $1 in
    --no-messages) with_messages=0 ;;
    --only) only=${2-} && shift ;;
    --except) except=${2-} && shift ;;
    --threads) threads=${2-} && shift ;;
    --keep) keep=${2-} && shift ;;
    *) usage ;;
  esac
  shift || usage
done
[ $# -eq 2 ] || [ $# -eq 3 ] || usage

before=$(realpath -e "$1") && after=$(realpath -e "$2") || exit 2
data=$(realpath -m "${3:-$here/../../../shared/data}")
for build in "$before" "$after"; do
  [ -x "$build/geodesic" ] || fail "$build has no program geodesic."
done

if [ -n "$keep" ]; then
  mkdir -p "$keep" && work=$(realpath "$keep") || exit 2
  rm -rf "$work"/{before,after,models,report}
else
  work=$(mktemp -d) || exit 2
  trap 'rm -rf "$work"' EXIT
fi
mkdir -p "$work"/{before,after,models,report}
models=$work/models

# ----------------------------------------------------------------------------------------- commands

# Each line: the expected exit code of the program, and its arguments. If the code is 0, the options
# --json, -o and --values are added, unless "=" follows the code or -o is given. The code "?" is for
# commands that need optional components.
commands()
{
  cat <<'LIST'
0 library_calls

0= --version
0= --help
0= info --help
0= distance --help
0= path --help
0= logmap --help
0= decal --help
0= flatten --help
0= atlas --help
0= matrix --help
0= sample --help
0= voronoi --help
0= segment --help
0= isolines --help
0= loops --help
0= remesh --help
0= base --help
0= semiregular --help
0= wavelet --help
0= surfels --help
0= emd --help
0= plan --help
0= barycenter --help
0= karcher-mean --help
0= feature-distance --help
0= fuzzy --help
0= streamlines --help
0= volume --help

0 info models/hills.off
0 info models/knot.off -o out.obj
0 info models/scan.xyz
0 info models/painted.ply -o out.vtp
0 info models/ring.off -o out.off
0 info data/meshes/joint_221.off
0 info data/meshes/bones_26comp_2k.off
0 info data/meshes/turbine_9k.off
0 info data/meshes/plane_holes_8k5.ply
0 info data/points/oni_normals_1k.pwn
0 info data/points/b9_aerial_22k.ply
0 info models/painted.vtp
2 info data/formats/lumbar3.vtp
2 info data/formats/ground_jaw.vtp
0 info data/parts/28_link_3.stl
0 info data/parts/fox_ascii.stl
0 info data/parts/798.obj
0 info data/hostile/alstom_6comp.off
0 info data/hostile/fandisk_quads.off
0 info data/hostile/hm_moebius.off
0 info data/hostile/hm_bowtie_vertex.off
0 info data/hostile/hm_unwelded_soup.off
0 info data/hostile/hm_big_endian.ply
0 info data/hostile/hm_scale_1e160.off
0= info data/meshes/elephant_2k8.off
0= info data/points/fin90_pca_normals_757.xyz
? info data/meshes/joint_221.off --picture out.png --sides

0 distance models/hills.off --source 0
0 distance models/hills.off --source-border
0 distance models/ring.off --source 3 --method exact
0 distance models/ring.off --source 3 --method spectral
0 distance models/painted.ply --source 10 --method fast-marching --speed speed
0 distance models/painted.ply --source 10 --speed colours
0 distance models/painted.ply --source 10 --density-image models/rings.png
0 distance models/scan.xyz --source 0 --threads 1
0 distance models/sphere.xyz --source 100 --method heat
0 distance models/cloud.xyz --source 5 --method dijkstra
0 distance data/meshes/elephant_2k8.off --source 100,200 --method dijkstra
0 distance data/meshes/elephant_2k8.off --source 100,200 --method fast-marching
0 distance data/meshes/elephant_2k8.off --source 100,200 --method euclidean -o out.vtp
0 distance data/meshes/elephant_2k8.off --source 100,200 --method exact -o out.obj
0 distance data/meshes/elephant_2k8.off --source 100 --method heat
0 distance data/meshes/elephant_2k8.off --source 100 --method spectral
0 distance data/meshes/elephant_2k8.off --source 100 --method biharmonic
0 distance data/meshes/pig_468.off --source 100 --method emd --basis 20
0 distance data/meshes/elephant_2k8.off --source-at=-0.161,-0.483,-0.052 --limit 0.3
0 distance data/meshes/knot2_2comp_6k.off --source 0 --method exact
0 distance data/meshes/fandisk_6k5.off --source 7 --speed curvature-attractive --strength 0.5
0 distance data/meshes/triceratops_2k8.off --source 7 --method exact
0 distance data/meshes/mech_holes_shark_5k.off --source-border
0 distance data/points/kitten_normals_5k.xyz --source 0
0 distance data/points/oni_normals_1k.pwn --source 0 --method fast-marching
0 distance data/points/hippo1_6k.ply --source 0
0 distance data/hostile/hm_graded_1e6.off --source 0 --method exact
0 distance data/hostile/hm_scale_1e-160.off --source 0
0 distance data/hostile/hm_isolated_vertices.off --source 0
0 distance data/hostile/capsule_degenerate_5k.ply --source 0 --method exact
0 distance data/hostile/beetle_1k1_nonmanifold.ply --source 0
0= distance data/meshes/pig_468.off --source 3
? distance data/meshes/pig_468.off --source 3 --picture out.png

0 path models/hills.off --from 0 --to 14000
0 path models/hills.off --from-at 10,20,3 --to-at 90,80,5 -o out.ply
0 path models/knot.off --from 0 --to 12000 -o out.obj
0 path models/sphere.xyz --from 1000 --to 6800 --start
0 path models/pipe.xyz --from 20 --to 11950
0 path models/noisy.xyz --from 0 --to 9000 --surfel-noise kept --surfel-path-method projected-planes
0 path models/scan.xyz --from 0 --to 2000 --method euclidean
0 path data/meshes/cow_2k9.off --from 0 --to 2000
0 path data/meshes/cow_2k9.off --from 0 --to 2000 --method exact
0 path data/meshes/cow_2k9.off --from 0 --to 2000 --method heat
0 path data/meshes/cow_2k9.off --from 0 --to 2000 --method dijkstra
0 path data/meshes/triceratops_2k8.off --from 0 --to 2000
0 path data/points/kitten_normals_5k.xyz --from 0 --to 2000 --surfel-path-method robust-spheres
0 path data/points/kitten_normals_5k.xyz --from 0 --to 2000 --surfel-graph nearest --control-points 60
0 path data/hostile/hm_roll_near_touch.off --from 0 --to 900
0 path data/hostile/hm_outliers.xyz --from 0 --to 900

0 logmap models/hills.off --base 7000 --radius 30 --up 0,1,0
0 logmap models/sphere.xyz --base 50 --radius 0.8
0 logmap data/meshes/eight_5k.ply --base 100
0 logmap data/meshes/eight_5k.ply --base 100 --method exact
0 logmap data/meshes/elephant_2k8.off --base 100 --radius 0.4 --method discrete-exponential -o out.obj
0 logmap data/meshes/elephant_2k8.off --base-at 0.1,0.2,0.1 --distances heat
0 logmap data/points/oni_normals_1k.pwn --base 10

0 decal models/hills.off --base-at 35,40,20 --base-at 85,80,20 --up 0,1,0 --width 60 --width 40 --image models/rings.png
0 decal models/scan.xyz --base 300 --up 0,1,0
0 decal data/meshes/elephant_2k8.off --base 100,900 --up 0,1,0 -o out.obj
0 decal data/meshes/elephant_2k8.off --base 100 --method exact --height 0.2 -o out.vtp
0 decal data/meshes/pig_468.off --base 10 --texels 8 -o out.obj

0 flatten models/painted.ply
0 flatten data/patches/mushroom_2k.off --base-points 50 -o out.obj
0 flatten data/patches/three_peaks_2k.off --method mds
0 flatten data/patches/three_peaks_2k.off --method lscm
0 flatten data/patches/three_peaks_2k.off --method authalic
0 flatten data/patches/three_peaks_2k.off --method arap --flat
0 flatten data/patches/mushroom_2k.off --injective
0 flatten data/patches/hemisphere_2k.ply --injective --base-points 40 --neighbors 8
0 flatten data/points/fin90_pca_normals_757.xyz

0 atlas models/ring.off --number 6 --texels 256
0 atlas data/meshes/elephant_2k8.off --number 20 --texels 512 --gutter 3
0 atlas data/meshes/elephant_2k8.off --number 12 --texels 256 -o out.gltf
0 atlas data/meshes/pig_468.off --number 8 --texels 256 --image models/rings.png -o out.glb
0 atlas data/meshes/spool_649.off --number 5 --iterations 2 --texels 128 --flat

0 matrix models/hills.off --number 20
0 matrix models/cloud.xyz --limit 0.3
0 matrix data/meshes/elephant_2k8.off --sources 0,100,200,300,400 --method exact
0 matrix data/meshes/elephant_2k8.off --number 12 --method spectral
0 matrix data/meshes/elephant_2k8.off --number 8 --method emd --basis 12 --threads 3
0 matrix data/meshes/elephant_2k8.off --number 12 --method biharmonic
0 matrix data/meshes/elephant_2k8.off --number 30 --method heat --threads 1
0 matrix data/meshes/pig_468.off --limit 0.1 --method fast-marching
0 matrix data/points/kitten_normals_5k.xyz --number 20 --method dijkstra

0 sample models/hills.off --number 300
0 sample models/knot.off --spacing 0.5
0 sample models/painted.ply --number 60 --speed speed
0 sample models/hills.off --number 300 --density-image models/rings.png --strength 8
0 sample models/scan.xyz --number 200 --seed 5
0 sample data/meshes/fandisk_6k5.off --number 200 --speed curvature-attractive
0 sample data/meshes/fandisk_6k5.off --number 200 --speed curvature-repulsive --threads 3
0 sample data/meshes/bones_26comp_2k.off --number 60
0 sample data/points/hippo1_6k.ply --number 100 --speed curvature-like-30

0 voronoi models/knot.off --number 40
0 voronoi models/painted.ply --seeds 0,40,800 --speed speed
0 voronoi models/scan.xyz --number 30
0 voronoi data/meshes/mech_holes_shark_5k.off --seeds 0,100,4000
0 voronoi data/points/oni_normals_1k.pwn --number 12

0 segment models/hills.off --number 20 --iterations 5
0 segment data/meshes/eight_5k.ply --number 12 --discs
0 segment data/meshes/fandisk_6k5.off --number 20 --speed curvature-attractive --discs
0 segment data/points/oni_normals_1k.pwn --number 8

0 remesh models/hills.off --number 500 --lloyd 3
0 remesh models/hills.off --number 400 --density-image models/rings.png --strength 5 -o out.off
0 remesh models/sphere.xyz --number 300
0 remesh data/meshes/elephant_2k8.off --number 400 --lloyd 5
0 remesh data/meshes/elephant_2k8.off --number 300 --fit -o out.obj
0 remesh data/meshes/elephant_2k8.off --number 200 --maximum-deviation 0.01
0 remesh data/meshes/fandisk_6k5.off --number 400 --lloyd 3 --keep-sharp 40 --curve-spacing 0.03
0 remesh data/meshes/mech_holes_shark_5k.off --number 400 --fill-holes
0 remesh data/meshes/cow_2k9.off --number 60 --allow-self-intersections
0 remesh data/meshes/pig_468.off --number 200 --speed curvature-attractive --seed 9
0 remesh data/points/kitten_normals_5k.xyz --number 300 --lloyd 3
0 remesh data/hostile/hm_two_spheres_crossing.off --number 100

0 base models/ring.off --number 20
0 base data/meshes/elephant_2k8.off --number 60
0 base data/meshes/elephant_2k8.off --number 50 --divided -o out.vtp
0 base data/meshes/eight_5k.ply --number 60 --coordinates mean-value
0 base data/meshes/fandisk_6k5.off --number 100 --keep-sharp 40 --coordinates uniform

0 semiregular models/ring.off --number 30 --levels 2
0 semiregular data/meshes/elephant_2k8.off --number 60 --levels 3 -o out.obj
0 semiregular data/meshes/fandisk_6k5.off --number 100 --levels 2 --keep-sharp 40 --quads
0 semiregular data/meshes/cow_2k9.off --number 80 --levels 4 --maximum-deviation 0.02

0 wavelet models/levels.ply --keep 10
0 wavelet models/levels.ply --bits 2 -o out.gpw
0 wavelet models/levels.ply --keep 5 --predictor linear --levels 2 -o out.off
0 info models/levels.gpw

0 surfels models/sphere.xyz --neighbors 12
0 surfels models/pipe.xyz --estimate --outliers 2
0 surfels models/cloud.xyz --arcs -o out.vtp
0 surfels data/points/oni_normals_1k.pwn --arcs --surfel-graph spheres
0 surfels data/points/before_upsample_850.xyz --surfel-noise removed
0 surfels data/points/blobby_3k.xyz --estimate
0 surfels data/hostile/hm_normals_random_sign.xyz --surfel-graph nearest
0 surfels data/hostile/hm_duplicates_points.xyz

0 emd models/ring.off --from 0 --to 200,300
0 emd models/painted.ply --from people --to room --normalize --bound-above --hodge
0 emd models/painted.ply --from people --to models/masses.txt --density --normalize
0 emd models/cloud.xyz --from 0,1 --to 100,200
0 emd data/meshes/elephant_2k8.off --from 1766,2200 --to 691 --refine 0
0 emd data/meshes/elephant_2k8.off --from 1766,2200 --to 691 --method admm --tolerance 0.02 --refine 0
0 emd data/meshes/pig_468.off --from 0 --to 100,200 --method weiszfeld --tolerance 0.01 -o out.vtp
0= emd data/meshes/elephant_2k8.off --from 1766,2200 --to 691 --basis 20 --json -o out.ply
0 emd data/points/oni_normals_1k.pwn --from 0 --to 500 --speed curvature-attractive

0 plan models/maze.ply --from people --to room
0 plan models/floor.ply --from people --density --to room --capacity room
0 plan models/painted.ply --from people --to room --spread 2 --normalize
0 plan data/meshes/pig_468.off --from 0,50 --to 100,200,300 --capacity 0.3,0.4,0.5
0 plan data/meshes/pig_468.off --from 0 --to-path 100,200 --to-at 0,0,0
0 plan data/points/oni_normals_1k.pwn --from 0 --to 100,200

0 barycenter models/ring.off --points 0,100,200
0 barycenter models/painted.ply --of people --of room --normalize --weight 1 --weight 2
0 barycenter data/meshes/pig_468.off --points 0,100,200,300 --weight 1 --weight 2 --weight 1 --weight 1
0 barycenter data/points/before_upsample_850.xyz --points 0,400 --tolerance 0.05
0 karcher-mean models/ring.off --points 0,100,200 -o out.vtp
0 karcher-mean data/meshes/elephant_2k8.off --points 691,2278 --point-at 0.1,0.2,0.1 --weight 1 --weight 2 --weight 1 -o out.obj
0 karcher-mean data/points/oni_normals_1k.pwn --points 0,500,700 -o out.ply

0 feature-distance models/ring.off --feature 0,100
0 feature-distance models/painted.ply --border --speed speed
0 feature-distance data/meshes/elephant_2k8.off --feature-path 691,2278 --feature-at 0.1,0.2,0.1 --refine 0
0 feature-distance data/meshes/fandisk_6k5.off --feature 30 --speed curvature-like-30 --strength 1 --refine 0
0 feature-distance data/points/oni_normals_1k.pwn --feature 0,700

0 fuzzy models/painted.ply --from 5 --to 800
0 fuzzy data/meshes/elephant_2k8.off --from 691 --to 2278 --width 0.06 --refine 0
0 fuzzy data/meshes/elephant_2k8.off --from 691 --to 2278 --width 0.06 --by-distances
0 fuzzy data/points/oni_normals_1k.pwn --from 0 --to 700

0 isolines models/ring.off --source 0 --number 8 -o out.vtp
0 isolines models/painted.ply --property people --isovalues 0.5,1 -o out.obj
0 isolines data/meshes/elephant_2k8.off --source 691 --method euclidean -o out.ply
0 isolines data/meshes/elephant_2k8.off --source 691 --divided -o out.vtp
0 isolines data/patches/three_peaks_2k.off --source 0 -o out.svg
2 isolines data/points/oni_normals_1k.pwn --source 0
0 loops data/meshes/pig_468.off -o out.vtp
0 loops data/meshes/pig_468.off --through 5 -o out.obj
0 loops models/ring.off --along 0,5,9
2 loops data/points/oni_normals_1k.pwn
0 streamlines models/ring.off --from 0 --to 200,300 --number 20
0 streamlines models/painted.ply --from people --to room --normalize --number 30 --as-traced
0 streamlines data/meshes/pig_468.off --from 0 --to 100,200 --seeds 0,1,2 -o out.ply
0 streamlines data/meshes/elephant_2k8.off --from 1766 --to 2200,2278 --number 20 --refine 0 -o out.obj
0 streamlines data/points/oni_normals_1k.pwn --from 0 --to 500,700 --number 15

0 volume models/ring.off --from 1,0,0 --to=-1,0.1,0 --refine 0 --bound-above
0 volume models/ring.off --from 1,0,0 --slice z,0 --resolution 10 --refine 0
0 volume data/meshes/pinion_650.off --from 0,0,0 --to 1,1,1 --path --refine 0 -o out.vtp
0 volume models/ring.off --from 1,0,0 --to=-1,0.1,0 --path --refine 0 -o out.vtp
0 volume data/meshes/pinion_650.off --from 0,0,0 --to 1,1,1 --refine 0
0 volume data/meshes/knot1_3k.off --from 0.277,0.419,-0.015 --slice z,-0.015 --slice x,0 --resolution 6 --refine 0

2 info models/missing.off
2 info models/masses.txt
2 info data/hostile/hm_all_nan.ply
2 info data/hostile/hm_truncated_binary.ply
2 info data/hostile/hm_index_out_of_range.off
2 info data/hostile/hm_empty.xyz
2 info data/hostile/hm_zero_bytes.off
2 distance models/ring.off --source 100000
2 distance models/ring.off --source-border
2 distance models/painted.ply --source 0 --speed missing
2 distance models/cloud.xyz --source 0 --method exact
2 path models/ring.off --from 0 --to 100000
2 decal models/ring.off --base 100000
2 flatten models/ring.off --injective
2 wavelet data/meshes/joint_221.off --keep 10
2 base models/cloud.xyz --number 20
2 surfels models/ring.off
2 remesh models/cloud.xyz --number 20 --fill-holes
2 emd models/painted.ply --from people --to room
2 emd models/ring.off --from missing --to 0
2 volume models/painted.ply --from 0,0,0 --to 1,1,1
2 feature-distance models/cloud.xyz --feature-at 0,0,0
2 semiregular models/cloud.xyz --number 20
1 distance models/ring.off
1 distance models/ring.off --source x
1 distance models/ring.off --source 0 --method magic
1 distance models/ring.off --source 0 --limit -1
1 distance models/ring.off --source 0 --speed speed --method heat
1 distance models/ring.off --source 0 --basis 3
1 path models/ring.off --from 0
1 logmap models/ring.off --base 0,1
1 flatten models/painted.ply --method magic
1 atlas models/ring.off --number 5 --texels 3
1 matrix models/ring.off
1 matrix models/ring.off --sources 1,1
1 sample models/ring.off --number 0
1 voronoi models/ring.off
1 remesh models/ring.off
1 remesh models/ring.off --number -5
1 semiregular models/ring.off --number 20 --levels 99
1 wavelet models/levels.ply --keep 200
1 surfels models/cloud.xyz --surfel-graph magic
1 surfels models/cloud.xyz --outliers 101
1 emd models/ring.off --from 0
1 plan models/ring.off --from 0 --to 1 --capacity 1,2
1 barycenter models/ring.off
1 karcher-mean models/ring.off
1 fuzzy models/ring.off --from 0 --to 0
1 streamlines models/ring.off --from 0 --to 1 --method magic
1 volume models/ring.off --from 0,0 --to 1,1,1
1 volume models/ring.off --from 0,0,0 --slice w,1
1 distance models/ring.off --source 0 -o out.xyz
1 nothing models/ring.off
1
3 distance models/ring.off --source 0 -o missing/out.ply
3 info models/ring.off -o models/folder.ply
1 info models/ring.off -o models
LIST
}

# --------------------------------------------------------------------------------------- comparison

cat >"$work/compare.py" <<'PYTHON'
"""compare.py BEFORE AFTER WITH_MESSAGES: prints how two folders of outputs differ."""
import base64, json, math, os, re, struct, sys, zlib

before, after, with_messages = sys.argv[1], sys.argv[2], sys.argv[3] == "1"
NUMBER = re.compile(r"(?<![\w.])[-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?(?![\w.])")


def shortest(x):
    """Returns a number in the shortest form that reads back as the same number."""
    if isinstance(x, int):
        return str(x)
    if math.isfinite(x) and x == int(x) and abs(x) < 1e16:
        return "-0" if x == 0 and math.copysign(1, x) < 0 else str(int(x))
    return repr(x)


def number(text):
    return int(text) if re.fullmatch(r"[-+]?\d+", text) else float(text)


def text_lines(text):
    return NUMBER.sub(lambda m: shortest(number(m[0])), text).splitlines()


def without_seconds(x):
    if isinstance(x, dict):
        return {k: without_seconds(v) for k, v in x.items() if k != "seconds"}
    return [without_seconds(v) for v in x] if isinstance(x, list) else x


def json_lines(text):
    data = without_seconds(json.loads(text))
    buffers = []
    for buffer in data.get("buffers", []) if isinstance(data, dict) else []:
        if buffer.get("uri", "").startswith("data:"):
            buffers += words(base64.b64decode(buffer.pop("uri").split(",", 1)[1]))
    return json.dumps(data, indent=1, ensure_ascii=False).splitlines() + buffers


def words(data):
    """Returns the 32-bit floating point numbers of a glTF buffer, and the integers behind them."""
    whole = len(data) // 4 * 4
    return [f"{shortest(f)} ({u})" for (f,), (u,) in
            zip(struct.iter_unpack("<f", data[:whole]), struct.iter_unpack("<I", data[:whole]))]


def glb_lines(data):
    result, at = [], 12
    while at < len(data):
        size, kind = struct.unpack_from("<I4s", data, at)
        chunk = data[at + 8:at + 8 + size]
        result += json_lines(chunk.decode()) if kind == b"JSON" else words(chunk)
        at += 8 + size
    return result


TYPES = {"char": "b", "uchar": "B", "short": "h", "ushort": "H", "int": "i", "uint": "I",
         "float": "f", "double": "d", "int8": "b", "uint8": "B", "int16": "h", "uint16": "H",
         "int32": "i", "uint32": "I", "float32": "f", "float64": "d"}


def ply_lines(data):
    header, body = data.split(b"end_header\n", 1)
    result = header.decode().splitlines()
    if "format ascii 1.0" in result:
        return result + text_lines(body.decode())
    order = "<" if "format binary_little_endian 1.0" in result else ">"
    elements = []
    for line in map(str.split, result):
        if line[:1] == ["element"]:
            elements.append((line[1], int(line[2]), []))
        elif line[:1] == ["property"]:
            elements[-1][2].append(line[1:-1])
    at = 0
    for name, count, properties in elements:
        for _ in range(count):
            row = []
            for kind in properties:
                size = 1
                if kind[0] == "list":
                    size, = struct.unpack_from(order + TYPES[kind[1]], body, at)
                    at += struct.calcsize(TYPES[kind[1]])
                form = order + str(size) + TYPES[kind[-1]]
                row += struct.unpack_from(form, body, at)
                at += struct.calcsize(form)
            result.append(name + " " + " ".join(map(shortest, row)))
    return result + [f"{len(body) - at} bytes follow"]


VTK_TYPES = {"Float64": "d", "Float32": "f", "Int64": "q", "UInt64": "Q", "Int32": "i",
             "UInt32": "I", "Int8": "b", "UInt8": "B"}


def vtp_lines(text):
    result = []
    for line in text.splitlines():
        array = re.fullmatch(r'(\s*<DataArray type="(\w+)".*format="binary">)(.*)(</DataArray>)', line)
        if array:
            values = base64.b64decode(array[3])[8:]
            form = "<" + VTK_TYPES[array[2]]
            result += [array[1]] + [shortest(x) for x, in struct.iter_unpack(form, values)]
        else:
            result.append(line)
    return result


def png_lines(data):
    """Returns the header and the rows of the image."""
    at, pixels, header = 8, b"", b""
    while at < len(data):
        size, kind = struct.unpack_from(">I4s", data, at)
        if kind == b"IHDR":
            header = data[at + 8:at + 8 + size]
        if kind == b"IDAT":
            pixels += data[at + 8:at + 8 + size]
        at += 12 + size
    width, height, depth, color = struct.unpack_from(">IIBB", header)
    rows = zlib.decompress(pixels)
    stride = len(rows) // height
    return [f"{width} x {height}, depth {depth}, color {color}"] + \
        ["x" + rows[i * stride:(i + 1) * stride].hex() for i in range(height)]


def lines_of(folder, name, data):
    """Returns the content of an output in comparable lines."""
    try:
        if name.endswith(".png"):
            return png_lines(data)
        if name.endswith(".ply"):
            return ply_lines(data)
        if name.endswith(".glb"):
            return glb_lines(data)
        if name.endswith(".gpw"):
            return [str(byte) for byte in data]
        text = data.decode(errors="backslashreplace").replace(folder, ".")
        if name.endswith(".gltf") or (name == "stdout" and text.startswith("{")):
            return json_lines(text)
        if name.endswith(".vtp"):
            return vtp_lines(text)
    except (ValueError, IndexError, struct.error, zlib.error) as error:
        return [f"not readable: {error}"] + [data[i:i + 16].hex() for i in range(0, len(data), 16)]
    if with_messages or name not in ("stdout", "stderr"):
        return text_lines(text)
    # Without messages, the numbers of a readable result still count, unless it is a help text.
    if name == "stderr" or re.search(r"--help|--version", read(folder, "arguments").decode()):
        return []
    return [shortest(number(x)) for x in NUMBER.findall(text)]


def read(folder, name):
    with open(os.path.join(folder, name), "rb") as file:
        return file.read()


def excerpt(line, other):
    """Returns at most 120 characters of a line, around its first difference from another one."""
    same = next((i for i, (a, b) in enumerate(zip(line, other)) if a != b), 0)
    begin = max(0, same - 40) if len(line) > 120 else 0
    return ("..." if begin else "") + line[begin:begin + 120]


def compare(name):
    data = [read(before, name), read(after, name)]
    if data[0] == data[1]:
        return []
    a, b = lines_of(before, name, data[0]), lines_of(after, name, data[1])
    if a == b:
        return []
    size = max(len(a), len(b))
    first = next(i for i in range(size) if a[i:i + 1] != b[i:i + 1])
    x, y = (lines[first] if first < len(lines) else "(no more lines)" for lines in (a, b))
    lengths = str(len(a)) if len(a) == len(b) else f"{len(a)} and {len(b)}"
    result = [f"{name}, line {first + 1} of {lengths}:",
              "  before: " + excerpt(x, y), "  after:  " + excerpt(y, x)]
    if len(a) != len(b):
        return result
    different, words_differ, largest = 0, False, 0.
    for x, y in zip(a, b):
        if x == y:
            continue
        different += 1
        words_differ = words_differ or NUMBER.sub("#", x) != NUMBER.sub("#", y)
        for p, q in zip(NUMBER.findall(x), NUMBER.findall(y)):
            p, q = float(p), float(q)
            if p != q:
                largest = max(largest, abs(p - q) / max(abs(p), abs(q)))
    kinds = ([f"numbers by at most {largest:.3g} (relative)"] if largest > 0 else []) + \
        (["words"] if words_differ or largest == 0 else [])
    result.append(f"  {different} lines differ, {' and '.join(kinds)}")
    return result


names = [sorted(os.path.relpath(os.path.join(folder, file), top)
                for folder, _, files in os.walk(top) for file in files) for top in (before, after)]
report = []
for name in sorted(set(names[0]) | set(names[1])):
    if name not in names[1]:
        report.append(f"{name} is only written before.")
    elif name not in names[0]:
        report.append(f"{name} is only written after.")
    else:
        report += compare(name)
if read(before, "exit_code") != read(after, "exit_code"):
    report.append("standard error after: " + read(after, "stderr").decode(errors="replace")[:1000])
print("\n".join(report), end="\n" if report else "")
PYTHON

# Small models with properties that the program reads.
cat >"$work/models.py" <<'PYTHON'
from math import cos, exp, pi, sin, sqrt

n = 29
with open("painted.ply", "w") as ply, open("masses.txt", "w") as masses:
    names = "x y z speed red green blue u v people room".split()
    ply.write(f"ply\nformat ascii 1.0\nelement vertex {n * n}\n")
    ply.writelines(f"property double {name}\n" for name in names)
    ply.write(f"element face {2 * (n - 1) ** 2}\nproperty list uchar int vertex_indices\nend_header\n")
    for j in range(n):
        for i in range(n):
            x, y = 2 * i / (n - 1) - 1, 2 * j / (n - 1) - 1
            row = [x, y, 0.5 * exp(-3 * (x * x + y * y)), 1.5 + sin(4 * x), 255 * (i > n // 2),
                   128 + 100 * sin(5 * y), 40, (x + 1) / 2, (y + 1) / 2,
                   exp(-20 * ((x + 0.5) ** 2 + y * y)), float(i == n - 1 and 5 < j < 20)]
            ply.write(" ".join(map(repr, map(float, row))) + "\n")
            masses.write(f"{1 + 0.5 * cos(3 * x)!r}\n")
    for j in range(n - 1):
        for i in range(n - 1):
            a = j * n + i
            ply.write(f"3 {a} {a + 1} {a + n + 1}\n3 {a} {a + n + 1} {a + n}\n")

length, girth = 40, 14
with open("ring.off", "w") as off:
    off.write(f"OFF\n{length * girth} {2 * length * girth} 0\n")
    for i in range(length):
        for j in range(girth):
            t, a = 2 * pi * i / length, 2 * pi * j / girth
            r = 1 + 0.35 * cos(a)
            off.write(f"{r * cos(t)!r} {r * sin(t)!r} {0.35 * sin(a)!r}\n")
    at = lambda i, j: i % length * girth + j % girth
    for i in range(length):
        for j in range(girth):
            off.write(f"3 {at(i, j)} {at(i + 1, j)} {at(i + 1, j + 1)}\n")
            off.write(f"3 {at(i, j)} {at(i + 1, j + 1)} {at(i, j + 1)}\n")

with open("cloud.xyz", "w") as xyz:
    for i in range(1500):
        z = 1 - (2 * i + 1) / 1500
        r, a = sqrt(1 - z * z), i * pi * (3 - sqrt(5))
        xyz.write(f"{1.4 * r * cos(a)!r} {r * sin(a)!r} {0.8 * z!r}\n")
PYTHON

# ------------------------------------------------------------------------------------ library calls

cached() { sed -n "s/^$2:[A-Z]*=//p" "$1/CMakeCache.txt"; }

# library_calls BUILD: compiles library_calls.cpp as the build compiles users of the library, links
# the build's library and runs the program.
library_calls()
{
  local build=$1 source tree library cxx
  local -a options launcher
  tree=$(cached "$build" CMAKE_HOME_DIRECTORY)
  source=$tree/test/behavior/library_calls.cpp
  [ -f "$source" ] || source=$here/library_calls.cpp
  launcher=(env)
  [ -z "$(cached "$build" ccache)" ] || launcher=("$(cached "$build" ccache)")
  mapfile -t options < <(python3 - "$build" "$tree" <<'PYTHON'
import json, shlex, sys
build, tree = sys.argv[1:]
with open(build + "/compile_commands.json") as file:
    commands = json.load(file)
demo = next(c for c in commands if c["file"].startswith(tree + "/demo/"))
words, result = shlex.split(demo["command"]), []
while words:
    word = words.pop(0)
    if word in ("-isystem", "-I", "-D"):
        result += [word, words.pop(0)]
    elif word.startswith(("-I", "-D", "-O", "-std", "-f", "-m")):
        result.append(word)
print("\n".join(result))
PYTHON
  )
  for library in "$build"/libGeodesic_processing.{a,so}; do
    [ ! -f "$library" ] || break
  done
  cxx=$(cached "$build" CMAKE_CXX_COMPILER)
  if ! { "${launcher[@]}" "$cxx" "${options[@]}" -c "$source" -o "$PWD.o" &&
         "$cxx" "$PWD.o" "$library" -Wl,-rpath,"$build" "$(cached "$build" CHOLMOD_LIBRARY)" \
           -lgmpxx -lmpfr -lgmp -ldl -pthread -o "$PWD.program"; } 2>"$PWD.log"; then
    head -n 30 "$PWD.log" >&2
    return 125
  fi
  "$PWD.program"
}

# ------------------------------------------------------------------------------------------- runs

# run BUILD FOLDER THREADS CODE ARGUMENTS...: runs a command in a folder of its own, in which models
# and data have the same names for each build.
run()
{
  local build=$1 folder=$2 threads=$3 code=$4
  shift 4
  mkdir -p "$folder"
  ln -s "$models" "$folder/models"
  ln -s "$data" "$folder/data"
  (
    cd "$folder" || exit
    echo "$*" >arguments
    if [ "${1-}" = library_calls ]; then
      library_calls "$build" >stdout 2>stderr
    else
      if [ "$code" = 0 ]; then
        case " $* ${1-}" in
          *" -o "*) ;;
          *matrix) set -- "$@" -o out.mtx ;;
          *atlas) set -- "$@" -o out.obj ;;
          *path | *isolines | *loops | *streamlines) set -- "$@" -o out.vtp ;;
          *) set -- "$@" -o out.ply ;;
        esac
        set -- "$@" --values values.txt --json
        case $threads$* in *--threads* | [!0-9]*) ;; *) set -- "$@" --threads "$threads" ;; esac
      fi
      timeout -k 5 100 "$build/geodesic" "$@" >stdout 2>stderr </dev/null
    fi
    echo $? >exit_code
  )
  rm "$folder/models" "$folder/data"
}

# run_both NUMBER CODE ARGUMENTS...: leaves the differences in report/NUMBER.
run_both()
{
  local number=$1 code=$2 report=$work/report/$1 begin=$EPOCHREALTIME end status
  shift 2
  run "$before" "$work/before/$number" "${threads%,*}" "$code" "$@"
  run "$after" "$work/after/$number" "${threads#*,}" "$code" "$@"
  end=$EPOCHREALTIME
  echo "$(((${end/./} - ${begin/./}) / 1000)) ms  $*" >"$report.time"
  {
    status=$(<"$work/before/$number/exit_code")
    [[ ${code%=} == "$status" ]] || [[ $code == '?' && $status -le 3 ]] ||
      echo "The exit code before is $status instead of ${code%=}:" \
        "$(head -c 300 "$work/before/$number/stderr")"
    python3 "$work/compare.py" "$work/before/$number" "$work/after/$number" "$with_messages"
  } >"$report" 2>&1
  if [ -s "$report" ]; then
    printf 'DIFFERENT: %s\n%s\n' "$*" "$(sed 's/^/  /' "$report")"
  fi
  [ -n "$keep" ] || rm -rf "$work/before/$number"* "$work/after/$number"*
}

export before after data work models here with_messages keep threads
export -f run run_both library_calls cached

echo "Running commands with OPENBLAS_CORETYPE=${OPENBLAS_CORETYPE-} OPENBLAS_NUM_THREADS=${OPENBLAS_NUM_THREADS-} OMP_NUM_THREADS=${OMP_NUM_THREADS-}"
number=0 skipped=0 list=()
while read -r line; do
  [[ -n $line && $line =~ $only ]] || continue
  [[ -z $except || ! $line =~ $except ]] || continue
  if [[ $line == *data/* && ! -d $data ]]; then
    skipped=$((skipped + 1))
    continue
  fi
  number=$((number + 1))
  list+=("$(printf '%03d' $number) $line")
done < <(commands)
[ $number -gt 0 ] || fail "no command matches."

generate_models()
{
  cd "$models" && "$before/demo/make_models" . && "$before/demo/make_test_image" rings.png &&
    python3 "$work/models.py" &&
    "$before/geodesic" semiregular ring.off --number 30 --levels 4 --quiet -o levels.ply &&
    "$before/geodesic" wavelet levels.ply --bits 4 --quiet -o levels.gpw &&
    "$before/geodesic" info painted.ply --quiet -o painted.vtp && mkdir folder.ply
}
if [[ ${list[*]} == *models/* ]]; then
  for demo in make_models make_test_image; do
    [ -x "$before/demo/$demo" ] || fail "$before has no $demo; build it with demos."
  done
  echo "Generating models"
  (generate_models) >"$work/models.log" 2>&1 ||
    fail "the models cannot be generated: $(<"$work/models.log")"
fi

# shellcheck disable=SC2016,SC2086 # the inner shell splits the line into arguments
printf '%s\0' "${list[@]}" |
  xargs -0 -n 1 -P "${JOBS:-$(nproc)}" bash -c 'set -f; run_both $1' _ | tee "$work/differences"

different=$(find "$work/report" -name '[0-9]*[0-9]' -size +0 | wc -l)
finished=$(find "$work/report" -name '[0-9]*[0-9]' | wc -l)
different=$((different + number - finished))
[ -z "$keep" ] || sort -rn "$work"/report/*.time >"$work/times"
[ $skipped -eq 0 ] || echo "$skipped commands skipped, as there is no $data"
echo "$number commands, $((number - different)) equal, $different different" \
     "($((SECONDS - started)) s)"
[ "$different" -eq 0 ]
