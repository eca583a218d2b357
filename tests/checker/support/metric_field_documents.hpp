#pragma once

#include <gtest/gtest.h>

#include <fstream>
#include <functional>
#include <iterator>

#include "kernel/number/exact_text.hpp"
#include "kernel/sample/separation.hpp"
#include "tests/checker/support/certificate_text.hpp"
#include "tests/checker/support/run_checker.hpp"
#include "tests/proofs/certificate/metric_field_run.hpp"
#include "tests/support/temporary_folder.hpp"

// Certificates of runs on metric fields, as documents that can be changed.
namespace delcert::checker_tests {

using test::MetricFieldSample;
using test::ratio;
using Change = std::function<void(Json&)>;

template <int m>
std::string bytes_of(const MetricFieldSample<m>& sample, const delcert::Claims& claims) {
  const test::TemporaryFolder folder;
  sample.write(folder / "run.json", claims);
  std::ifstream file(folder / "run.json", std::ios::binary);
  return std::string(std::istreambuf_iterator<char>(file), {});
}

template <int m>
delcert::Claims claims_of(const MetricFieldSample<m>& sample) {
  std::vector<std::string> reasons;
  return sample.claims(reasons);
}

template <int m>
Json document_of(const MetricFieldSample<m>& sample) {
  Json result = Json::parse(bytes_of<m>(sample, claims_of<m>(sample)));
  result.erase("sha256");
  return result;
}

inline const Json& sheared_document() {
  static const Json document = document_of<2>(test::sheared_run());
  return document;
}

/// Of a constant metric, whose charts are the same everywhere.
inline const Json& flat_document() {
  static const Json document = document_of<2>(test::flat_run());
  return document;
}

/// The lattice A_3* in a metric that is nearly its own, but for waves of this height: nothing is perturbed.
inline MetricFieldSample<3> lattice_sample(const Rational& height) {
  MetricFieldDescription description = test::constant_field({{Rational(3), Rational(-1), Rational(-1)},
                                                             {Rational(-1), Rational(3), Rational(-1)},
                                                             {Rational(-1), Rational(-1), Rational(3)}});
  description.waves.push_back({{1, 0, 1}, test::multiple_of_identity(3, height), test::zero_matrix(3)});
  description.waves[0].sine[0][1] = description.waves[0].sine[1][0] = height;
  MetricFieldAtlas<3> atlas(MetricField<3>(description), test::lattice_points<3>(11), ratio(11, 100));
  const auto distortion = fit_patches<3>(atlas, no_progress());
  ParameterChoice choice;
  choice.mode = RunMode::none;
  const RunParameters parameters = parameters_for(Dimension(3), measure_separation<3>(atlas), choice);
  RunRequest request;
  request.perturb = false;
  request.certify_model = false;
  const auto geometry = geometry_of<3>(atlas, distortion);
  auto run = run_in_charts<3>(atlas, geometry, parameters.algorithm, request, no_progress());
  const auto triangulation = check_affine_triangulation<3>(atlas, run.points, run.complex);
  return {std::move(atlas), distortion, parameters, std::move(run), {{}, triangulation}};
}

/// Rejected by the rule alone; accepted without it.
inline void expect_forgery(const std::string& rule, const Json& valid, const Change& change, int status = 1) {
  SCOPED_TRACE(rule);
  Json document = valid;
  change(document);
  const CheckerRun run = run_checker(sealed(document));
  EXPECT_EQ(run.status, status) << run.output;
  EXPECT_EQ(run.rules, std::set<std::string>{rule}) << run.output;
  if (status != 1) return;
  EXPECT_EQ(run_checker(sealed(document), rule).status, 0) << run_checker(sealed(document), rule).output;
}

inline std::string times(const Json& number, const Rational& factor) {
  return exact_text(parse_exact(number.get<std::string>()) * factor);
}

}  // namespace delcert::checker_tests
