// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Measures the time and the peak memory of each step from a file to geodesic distances.
#include <CGAL/Geodesic_processing.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/IO/polygon_soup_io.h>
#include <CGAL/Real_timer.h>
#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <optional>
#include <string>
#include <thread>
#include <vector>

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Vertex = Mesh::Vertex_index;

namespace GP = CGAL::Geodesic_processing;

// Calls f(). Prints its time and the peak memory of the process during the call, which only Linux
// reports. The memory includes freed memory that the C library keeps.
template <typename Function>
void measure(const std::string& step, const Function& f)
{
  std::ofstream("/proc/self/clear_refs") << 5; // resets the peak
  CGAL::Real_timer timer;
  timer.start();
  f();
  timer.stop();
  std::cout << step << ": " << timer.time() << " s";
  std::ifstream status("/proc/self/status");
  for(std::string word; status >> word;)
    if(double kilobytes = 0.; word == "VmHWM:" && status >> kilobytes)
      std::cout << ", peak memory " << 1.024e-3 * kilobytes << " MB";
  std::cout << '\n';
}

// Computes the distances from vertex 0 once, with the time to construct the solver.
template <typename Method>
void query(const std::string& name, const GP::Mesh_domain<Mesh>& domain)
{
  double farthest = 0.;
  measure(name,
          [&]
          {
            GP::Geodesic_distance_solver<Mesh, Method> solver(domain);
            solver.compute(Vertex(0));
            for(const Vertex v : solver.reached())
              farthest = (std::max)(farthest, solver.distance(v));
          });
  std::cout << "  largest distance " << farthest << '\n';
}

int main(int argc, char* argv[])
{
  std::vector<Kernel::Point_3> points;
  std::vector<std::vector<std::size_t>> polygons;
  bool is_read = false;
  if(argc == 2)
    measure("Read the file",
            [&] { is_read = CGAL::IO::read_polygon_soup(argv[1], points, polygons); });
  if(!is_read || polygons.empty())
    return std::cerr << "usage: large_inputs MESH\n", EXIT_FAILURE;
  std::cout << "  " << points.size() << " points, " << polygons.size() << " polygons\n";

  // The domain is the same with any number of threads.
  const auto prepare = [&](unsigned number_of_threads)
  {
    return GP::make_domain(
        points, polygons, GP::parameters::merge_tolerance(0.).number_of_threads(number_of_threads));
  };
  measure("Prepare, one thread", [&] { prepare(1); });
  const unsigned number_of_threads = (std::max)(2u, std::thread::hardware_concurrency());
  std::optional<GP::Soup_domain<Kernel::Point_3>> domain;
  measure("Prepare, " + std::to_string(number_of_threads) + " threads",
          [&] { domain = prepare(number_of_threads); });
  std::cout << "  " << domain->number_of_vertices() << " vertices, " << domain->number_of_faces()
            << " triangles\n";

  points = {};
  polygons = {};
  query<GP::Fast_marching>("Fast marching", *domain);
  query<GP::Exact>("Exact", *domain);
  return EXIT_SUCCESS;
}
