#pragma once

#include "kernel/manifold/gluing/chart_distortion.hpp"
#include "kernel/manifold/gluing/formula_atlas.hpp"
#include "kernel/manifold/gluing/metric_field_atlas.hpp"
#include "kernel/manifold/manifold_file.hpp"
#include "kernel/manifold/quotient/space_form_atlas.hpp"
#include "kernel/manifold/submanifold/submanifold_atlas.hpp"
#include "kernel/run/chart_run.hpp"
#include "proofs/certificate/writer.hpp"

namespace delcert {

// What each family puts into a certificate (docs/certificate-format.md).

/// The value of the key `manifold`: a Gram matrix or a radius; a group, exactly.
[[nodiscard]] std::string manifold_object(const ManifoldDescription& manifold);
[[nodiscard]] std::string manifold_object(const SpaceForm& form);
/// A metric, and how far the charts are from it on patches of this radius.
[[nodiscard]] std::string manifold_object(const MetricFieldDescription& field, const ChartDistortion& distortion,
                                          const Rational& patch_radius);
/// Charts and transitions of a file, and the radius of the patches of labels.
[[nodiscard]] std::string manifold_object(const FormulaAtlasDescription& atlas, const Rational& patch_radius);
/// Whether points of a submanifold are found over their coordinates in charts, or are given, on M or near it.
enum class VerticesKind : unsigned char { on_manifold, given };
/// Equations in a box, and a bound of how steep M is in the charts.
[[nodiscard]] std::string manifold_object(const EmbeddedManifold& manifold, const Rational& slope,
                                          VerticesKind vertices);

/// "spherical", "flat", "hyperbolic".
[[nodiscard]] std::string_view family_of(Curvature curvature);

/// Of a certified run. References are kept.
template <int m>
[[nodiscard]] CertificateContent<m> content_of(const ManifoldDescription& manifold, const FlatAtlas<m>& atlas,
                                               std::span<const LiftedSimplex<m>> net_simplices,
                                               const RunParameters& parameters, const RunResult<m>& run,
                                               const Claims& claims);
template <int m>
[[nodiscard]] CertificateContent<m> content_of(const SpaceFormAtlas<m>& atlas, const RunParameters& parameters,
                                               const ChartRun<m>& run, const Claims& claims);
template <int m>
[[nodiscard]] CertificateContent<m> content_of(const MetricFieldAtlas<m>& atlas, const ChartDistortion& distortion,
                                               const RunParameters& parameters, const ChartRun<m>& run,
                                               const Claims& claims);
template <int m>
[[nodiscard]] CertificateContent<m> content_of(const FormulaAtlas<m>& atlas, const Rational& distortion,
                                               const RunParameters& parameters, const ChartRun<m>& run,
                                               const Claims& claims);
/// Of a complex that is given: its vertices are the centres of the charts.
template <int m>
[[nodiscard]] CertificateContent<m> content_of(const EmbeddedManifold& manifold, const FittedCharts& charts,
                                               const Rational& sampling_radius,
                                               const std::vector<LabelSimplex<m>>& simplices,
                                               const RunParameters& parameters, const Claims& claims);
template <int m>
[[nodiscard]] CertificateContent<m> content_of(const SubmanifoldAtlas<m>& atlas, const RunParameters& parameters,
                                               const ChartRun<m>& run, const Claims& claims);

}  // namespace delcert
