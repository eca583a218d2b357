#pragma once

#include "proofs/certificate/reader.hpp"
#include "tests/proofs/certificate/atlas_run.hpp"
#include "tests/proofs/certificate/metric_field_run.hpp"
#include "tests/proofs/certificate/small_run.hpp"
#include "tests/proofs/certificate/space_form_run.hpp"
#include "tests/proofs/certificate/submanifold_run.hpp"
#include "tests/support/temporary_folder.hpp"

namespace delcert::test {

/// A run as its certificate has it.
template <class Sample>
CertificateSummary certificate_of(const Sample& sample) {
  const TemporaryFolder folder;
  std::vector<std::string> reasons;
  sample.write(folder / "c.json", sample.claims(reasons));
  return read_certificate(folder / "c.json");
}

[[nodiscard]] inline CertificateSummary torus_certificate() {
  const TemporaryFolder folder;
  small_run().write(folder / "c.json");
  return read_certificate(folder / "c.json");
}

/// Made once; one of each family whose charts, groups or coordinates are different.
[[nodiscard]] inline const std::map<std::string, CertificateSummary>& drawn_certificates() {
  static const std::map<std::string, CertificateSummary> certificates{
      {"flat-torus", torus_certificate()},
      {"sphere-2", certificate_of(space_form_run<2>("sphere-2", ratio(1, 8)))},
      {"projective-plane", certificate_of(space_form_run<2>("projective-plane", ratio(1, 8)))},
      {"klein-bottle", certificate_of(space_form_run<2>("klein-bottle", ratio(1, 24)))},
      {"bolza-surface", certificate_of(space_form_run<2>("bolza-surface", ratio(1, 8)))},
      {"metric-field", certificate_of(sheared_run())},
      {"submanifold", certificate_of(sphere_run())},
      {"atlas", certificate_of(glued_sphere_run())}};
  return certificates;
}

/// Seven points in the plane: a hexagon of triangles about label 0, the only interior one.
[[nodiscard]] inline CertificateSummary hexagon_certificate() {
  CertificateSummary result;
  result.family = "euclidean-ball";
  result.manifold.name = "hexagon";
  result.manifold.dimension = Dimension(2);
  result.manifold_text = R"({"name":"hexagon","family":"euclidean-ball","dimension":2,"radius":"8"})";
  result.parameters = {{"seed", "1"}, {"sampling_radius", "2"}};
  const std::vector<std::array<int, 2>> places{{0, 0}, {2, 0}, {1, 2}, {-1, 2}, {-2, 0}, {-1, -2}, {1, -2}};
  for (const auto& [x, y] : places) result.points.push_back({Rational(x), Rational(y)});
  result.net_text = R"([["0","0"],["2","0"],["1","2"],["-1","2"],["-2","0"],["-1","-2"],["1","-2"]])";
  for (std::uint32_t k = 1; k < 6; ++k) result.simplices.push_back({0, k, k + 1, 0, 0});
  result.simplices.push_back({0, 1, 6, 0, 0});
  return result;
}

}  // namespace delcert::test
