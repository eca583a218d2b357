#pragma once

#include <utility>

#include "kernel/theorems/graph_triangulation.hpp"
#include "support/progress.hpp"
#include "tests/kernel/theorems/torus_mesh.hpp"

namespace delcert::test {

/// A mesh with what level 5 measures of it.
template <int m>
struct TriangulatedMesh {
  Mesh<m> mesh;
  GraphVertices vertices;
  GraphTriangulation<m> triangulation;

  explicit TriangulatedMesh(Mesh<m> made)
      : mesh(std::move(made)),
        vertices(mesh.vertices()),
        triangulation(check_graph_triangulation<m>(vertices, mesh.simplices, no_progress())) {}
  // The vertices are those of the mesh.
  TriangulatedMesh(const TriangulatedMesh&) = delete;
  TriangulatedMesh& operator=(const TriangulatedMesh&) = delete;
};

}  // namespace delcert::test
