#pragma once

#include <memory>

#include "kernel/manifold/submanifold/polyhedral_mesh.hpp"

namespace delcert {

/// What `PolyhedralMesh::evaluation` returns. Keeps a reference.
[[nodiscard]] std::unique_ptr<GraphEvaluation> mesh_evaluation(const PolyhedralMesh& mesh);

}  // namespace delcert
