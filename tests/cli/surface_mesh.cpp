// surface_mesh RADIUS: a mesh of the torus of revolution with the radii 2 and 1 by CGAL's make_surface_mesh, in OFF,
// for the command that certifies meshes. RADIUS: what the surface's Delaunay balls are bounded by.

#include <CGAL/Complex_2_in_triangulation_3.h>
#include <CGAL/IO/facets_in_complex_2_to_triangle_mesh.h>
#include <CGAL/Implicit_surface_3.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_default_triangulation_3.h>
#include <CGAL/make_surface_mesh.h>

#include <cstdio>
#include <cstdlib>

namespace {

using Triangulation = CGAL::Surface_mesh_default_triangulation_3;
using Traits = Triangulation::Geom_traits;

double torus(const Traits::Point_3& p) {
  const double flat = p.x() * p.x() + p.y() * p.y();
  const double sum = flat + p.z() * p.z() + 3;
  return sum * sum - 16 * flat;
}

}  // namespace

int main(int count, char** arguments) {
  if (count != 2) return 64;
  Triangulation triangulation;
  CGAL::Complex_2_in_triangulation_3<Triangulation> complex(triangulation);
  const CGAL::Implicit_surface_3<Traits, double (*)(const Traits::Point_3&)> surface(
      torus, Traits::Sphere_3(Traits::Point_3(2, 0, 0), 36), 1e-12);
  const double radius = std::atof(arguments[1]);
  const CGAL::Surface_mesh_default_criteria_3<Triangulation> criteria(30, radius, radius);
  CGAL::make_surface_mesh(complex, surface, criteria, CGAL::Manifold_tag());
  CGAL::Surface_mesh<Traits::Point_3> mesh;
  CGAL::facets_in_complex_2_to_triangle_mesh(complex, mesh);
  std::printf("OFF\n%zu %zu 0\n", static_cast<std::size_t>(mesh.number_of_vertices()),
              static_cast<std::size_t>(mesh.number_of_faces()));
  for (const auto vertex : mesh.vertices()) {
    const auto& p = mesh.point(vertex);
    std::printf("%.15f %.15f %.15f\n", p.x(), p.y(), p.z());
  }
  for (const auto face : mesh.faces()) {
    std::printf("3");
    for (const auto vertex : mesh.vertices_around_face(mesh.halfedge(face)))
      std::printf(" %u", static_cast<unsigned>(vertex));
    std::printf("\n");
  }
  return 0;
}
