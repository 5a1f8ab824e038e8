// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef GEODESIC_PROGRAM_APP_COMMANDS_H
#define GEODESIC_PROGRAM_APP_COMMANDS_H

namespace CLI {
class App;
}

namespace program {

// Each function adds one subcommand with its options. The subcommand runs if the command line
// selects it. Failures are thrown as the errors of errors.h or of the library.
void add_info(CLI::App& program);
void add_distance(CLI::App& program);
void add_isolines(CLI::App& program);
void add_ball(CLI::App& program);
void add_diameter(CLI::App& program);
void add_path(CLI::App& program);
void add_loops(CLI::App& program);
void add_curve(CLI::App& program);
void add_logmap(CLI::App& program);
void add_decal(CLI::App& program);
void add_flatten(CLI::App& program);
void add_atlas(CLI::App& program);
void add_matrix(CLI::App& program);
void add_merge_matrices(CLI::App& program);
void add_sample(CLI::App& program);
void add_voronoi(CLI::App& program);
void add_segment(CLI::App& program);
void add_remesh(CLI::App& program);
void add_base(CLI::App& program);
void add_semiregular(CLI::App& program);
void add_wavelet(CLI::App& program);
void add_surfels(CLI::App& program);
void add_emd(CLI::App& program);
void add_plan(CLI::App& program);
void add_barycenter(CLI::App& program);
void add_karcher_mean(CLI::App& program);
void add_feature_distance(CLI::App& program);
void add_fuzzy(CLI::App& program);
void add_streamlines(CLI::App& program);
void add_volume(CLI::App& program);
void add_view(CLI::App& program);

} // namespace program

#endif // GEODESIC_PROGRAM_APP_COMMANDS_H
