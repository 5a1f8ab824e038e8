#!/usr/bin/env bash
# Copyright (c) 2026 The authors of Geodesic_processing.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Writes a part of the rows of a distance matrix: one task of an array job of Slurm.
#SBATCH --array=0-15
#SBATCH --cpus-per-task=4
#SBATCH --mem=4G
#SBATCH --requeue
set -eu
model=$1 matrix=$2 rows=$3 # the matrix has one row for each of so many vertices

i=$SLURM_ARRAY_TASK_ID n=$SLURM_ARRAY_TASK_COUNT
"${GEODESIC:-geodesic}" matrix "$model" --rows $((rows * i / n)):$((rows * (i + 1) / n)) \
  --threads "${SLURM_CPUS_PER_TASK:-1}" -o "${matrix%.npy}.$i.npy"
