# Copyright (c) 2026 The authors of Geodesic_processing.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# The folders of the kernels, bottom first, and the folders that each one may include.  The names
# are the same in src, include/CGAL/Geodesic_processing/internal and test/internal.
set(kernel_folders core mesh numerics operators spatial_search surfels paths distances curvature
                   log_map sampling parameterization subdivision remeshing transport)
set(core_uses "")
set(mesh_uses core)
set(numerics_uses core)
set(operators_uses core numerics)
set(spatial_search_uses core numerics)
set(surfels_uses core mesh numerics spatial_search)
set(paths_uses core mesh surfels)
set(distances_uses core mesh numerics operators paths)
set(curvature_uses core distances numerics)
set(log_map_uses core distances mesh paths)
set(sampling_uses core distances log_map mesh)
set(parameterization_uses core distances mesh numerics sampling)
set(subdivision_uses core mesh)
set(remeshing_uses core distances mesh paths sampling spatial_search subdivision)
set(transport_uses core mesh numerics operators paths spatial_search)
# The adaptors convert property maps and named parameters to arrays and back.  They are headers only.
set(adaptors_uses core distances log_map mesh operators parameterization paths remeshing sampling
                  surfels transport)

# The folders of the program in src/geodesic.
set(program_folders readers io repair picture app commands)
set(readers_uses "")
set(io_uses readers)
set(repair_uses readers io)
set(picture_uses readers io)
set(app_uses readers io repair picture)
set(commands_uses readers io repair picture app)
# The headers that the readers may include besides their own and those of the standard library.  So
# other programs can use them without CGAL.
set(reader_headers lz4.h nlohmann/json.hpp zlib.h)
