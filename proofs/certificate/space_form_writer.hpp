#pragma once

#include <array>
#include <filesystem>
#include <vector>

#include "kernel/manifold/space_form/space_form.hpp"
#include "kernel/progress.hpp"
#include "kernel/simplex/vector.hpp"
#include "proofs/certificate/document.hpp"
#include "proofs/certificate/space_form_claims.hpp"

namespace delcert {

/// Everything that goes into a certificate of a space form. References are kept.
template <int m>
struct SpaceFormContent {
  const SpaceForm& form;
  const RunParameters& parameters;  ///< mode measured or none
  const Rational& sampling_radius;
  const std::vector<Vector<Rational, m>>& centres;  ///< conformal coordinates of the net
  const std::vector<Vector<Rational, m>>& vectors;  ///< tangent vectors of the perturbed points
  const std::vector<std::vector<std::array<std::uint32_t, static_cast<std::size_t>(m)>>>&
      stars;  ///< the other labels of simplices, sorted
  const SpaceFormClaims& claims;
};

/// Writes a certificate as docs/certificate-format.md specifies, as `write_certificate` does.
template <int m>
void write_space_form_certificate(const std::filesystem::path& path, const SpaceFormContent<m>& content,
                                  const Progress& progress = no_progress());

/// The manifold block of a certificate: the group, exactly.
[[nodiscard]] std::string manifold_object(const SpaceForm& form);

/// "spherical", "flat", "hyperbolic".
[[nodiscard]] std::string_view family_of(Curvature curvature);

}  // namespace delcert
