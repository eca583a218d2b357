#pragma once

#include <memory>

#include "kernel/manifold/submanifold/polyhedral_mesh.hpp"

namespace delcert {

/// What `PolyhedralMesh::sampler` returns. Keeps a reference.
[[nodiscard]] std::unique_ptr<ManifoldSampler> mesh_sampler(const PolyhedralMesh& mesh, double radius);

}  // namespace delcert
