// Copyright (c) 2026 The authors of Geodesic_processing.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Generates models for the gallery: meshes, point clouds and floor plans.
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/boost/graph/generators.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <random>
#include <string>
#include <vector>

using Point = CGAL::Simple_cartesian<double>::Point_3;
using Vector = CGAL::Simple_cartesian<double>::Vector_3;
using Mesh = CGAL::Surface_mesh<Point>;

// Creates a closed tube around a torus knot, with a radius that varies along it.
Mesh make_tube(int number_along, int number_around)
{
  Mesh mesh;
  std::vector<Mesh::Vertex_index> vertex;
  for(int i = 0; i < number_along; ++i)
    for(int j = 0; j < number_around; ++j)
    {
      const double t = 2. * CGAL_PI * i / number_along, a = 2. * CGAL_PI * j / number_around;
      const double r = 0.42 + 0.05 * std::sin(9. * t);
      const double axis_distance = 2. + std::cos(3. * t) + r * std::cos(a);
      vertex.push_back(
          mesh.add_vertex(Point(axis_distance * std::cos(2. * t), axis_distance * std::sin(2. * t),
                                std::sin(3. * t) + r * std::sin(a))));
    }
  const auto at = [&](int i, int j)
  { return vertex[(i % number_along) * number_around + j % number_around]; };
  for(int i = 0; i < number_along; ++i)
    for(int j = 0; j < number_around; ++j)
    {
      mesh.add_face(at(i, j), at(i + 1, j), at(i + 1, j + 1));
      mesh.add_face(at(i, j), at(i + 1, j + 1), at(i, j + 1));
    }
  return mesh;
}

using Vertex_map = Mesh::Property_map<Mesh::Vertex_index, double>;

// Writes a triangulated floor plan, two triangles per floor cell, to a PLY file. `mark` sets the
// number of people and the capacity of each vertex.
template <typename Is_floor, typename Mark>
bool write_plan(const std::string& file, int columns, int rows, const Is_floor& is_floor,
                const Mark& mark)
{
  Mesh mesh;
  std::vector<Mesh::Vertex_index> vertex((columns + 1) * (rows + 1));
  Vertex_map people = mesh.add_property_map<Mesh::Vertex_index, double>("v:people").first;
  Vertex_map capacity = mesh.add_property_map<Mesh::Vertex_index, double>("v:room").first;
  mesh.add_property_map<Mesh::Vertex_index, double>("v:floor", 1.);
  const auto at = [&](int i, int j)
  {
    Mesh::Vertex_index& v = vertex[j * (columns + 1) + i];
    if(v == Mesh::null_vertex())
    {
      v = mesh.add_vertex(Point(i, j, 0.));
      mark(i, j, people[v], capacity[v]);
    }
    return v;
  };
  for(int j = 0; j < rows; ++j)
    for(int i = 0; i < columns; ++i)
      if(is_floor(i, j))
      {
        // Diagonals alternate, so that the triangulation favors no direction.
        const int turn = (i + j) % 2;
        const Mesh::Vertex_index a = at(i + turn, j), b = at(i + 1, j + turn),
                                 c = at(i + 1 - turn, j + 1), d = at(i, j + 1 - turn);
        mesh.add_face(a, b, c);
        mesh.add_face(a, c, d);
      }
  std::ofstream out(file);
  return CGAL::IO::write_PLY(out, mesh);
}

// Generates a maze by randomized depth-first search: a spanning tree of a square lattice. Passages
// are three cells wide and walls one cell.
std::vector<bool> make_maze(int size, unsigned seed)
{
  const int cells = 4 * size + 1;
  std::vector<bool> is_floor(cells * cells, false), is_visited(size * size, false);
  const auto carve = [&](int i, int j, int width, int height)
  {
    for(int y = j; y < j + height; ++y)
      std::fill_n(is_floor.begin() + y * cells + i, width, true);
  };
  std::mt19937 random(seed);
  std::vector<int> path = {0};
  is_visited[0] = true;
  while(!path.empty())
  {
    const int x = path.back() % size, y = path.back() / size;
    carve(4 * x + 1, 4 * y + 1, 3, 3);
    std::vector<int> neighbors;
    for(const int step : {-1, 1, -size, size})
      if((step != -1 || x > 0) && (step != 1 || x < size - 1) && path.back() + step >= 0 &&
         path.back() + step < size * size && !is_visited[path.back() + step])
        neighbors.push_back(path.back() + step);
    if(neighbors.empty())
    {
      path.pop_back();
      continue;
    }
    const int to = neighbors[random() % neighbors.size()], u = to % size, v = to / size;
    if(v == y)
      carve(4 * (std::max)(x, u), 4 * y + 1, 1, 3);
    else
      carve(4 * x + 1, 4 * (std::max)(y, v), 3, 1);
    is_visited[to] = true;
    path.push_back(to);
  }
  return is_floor;
}

bool write_maze(const std::string& file)
{
  const int size = 9, cells = 4 * size + 1;
  const std::vector<bool> is_floor = make_maze(size, 7);
  // People start at two inner vertices. Exits are at the beginning of the first row and at the end
  // of the last row.
  return write_plan(
      file, cells, cells, [&](int i, int j) { return is_floor[j * cells + i]; },
      [&](int i, int j, double& people, double& capacity)
      {
        people = (i == 14 && j == 23) || (i == 22 && j == 10) ? 0.5 : 0.;
        capacity = (i == 1 && j > 1 && j < 4) || (i == cells - 1 && j > cells - 4 && j < cells - 1)
                       ? 1.
                       : 0.;
      });
}

// Writes a floor plan of rooms on both sides of a corridor. The right door has capacity for a
// quarter of the people only. Walls are one cell thick.
bool write_floor(const std::string& file)
{
  const int columns = 73, rows = 29;
  return write_plan(
      file, columns, rows,
      [&](int i, int j)
      {
        const bool in_corridor = j > 12 && j < 16, is_wall = i % 12 == 0 || j == 0 || j == 28;
        const bool is_door = (j == 12 || j == 16) && i % 12 > 4 && i % 12 < 7;
        const bool is_between = i == 36 && (j == 5 || j == 6);
        return in_corridor || is_door || is_between || (!is_wall && j != 12 && j != 16);
      },
      [&](int i, int j, double& people, double& capacity)
      {
        people = j < 13 || j > 16 ? 1. : 0.;
        const double all = 12. * 11. * 11.;
        capacity = i == 0 ? all : i == columns ? all / 16. : 0.;
      });
}

int main(int argc, char* argv[])
{
  const std::string folder = argc > 1 ? argv[1] : ".";
  Mesh hills;
  const auto height = [](double x, double y)
  { return 9. * std::sin(x / 9.) * std::cos(y / 13.) + 3. * std::sin((x + 2. * y) / 7.); };
  CGAL::make_grid(
      120, 120, hills, [&](int i, int j) { return Point(i, j, height(i, j)); }, true);

  std::ofstream cloud(folder + "/scan.xyz"), noisy(folder + "/noisy.xyz");
  const Mesh knot = make_tube(600, 40);
  std::mt19937 random(1);
  std::normal_distribution<double> noise(0., 0.02); // a third of the point spacing
  for(Mesh::Vertex_index v : knot.vertices())
  {
    cloud << knot.point(v) << '\n';
    noisy << knot.point(v) + Vector(noise(random), noise(random), noise(random)) << '\n';
  }
  // A sphere, and a noisy pipe. The noise of one in twenty points is four times larger.
  std::ofstream sphere(folder + "/sphere.xyz"), pipe(folder + "/pipe.xyz");
  for(int i = 0; i < 10000; ++i)
  {
    const double z = 1. - (2. * i + 1.) / 10000., r = std::sqrt(1. - z * z);
    const double a = i * CGAL_PI * (3. - std::sqrt(5.));
    sphere << Point(r * std::cos(a), r * std::sin(a), z) << '\n';
  }
  std::uniform_real_distribution<double> offset(-0.5, 0.5);
  for(int i = 0; i < 201 * 60; ++i)
  {
    const double a = 2. * CGAL_PI * (i % 201) / 201., z = 30. * (i / 201) / 59.;
    const double r = 15. + (i % 20 == 0 ? 4. : 1.) * offset(random);
    pipe << Point(r * std::cos(a), r * std::sin(a), z) << '\n';
  }

  const bool written = write_maze(folder + "/maze.ply") && write_floor(folder + "/floor.ply") &&
                       CGAL::IO::write_polygon_mesh(folder + "/knot.off", knot) &&
                       CGAL::IO::write_polygon_mesh(folder + "/hills.off", hills) && cloud &&
                       noisy && sphere && pipe;
  return written ? EXIT_SUCCESS : EXIT_FAILURE;
}
