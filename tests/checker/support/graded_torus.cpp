#include "tests/checker/support/graded_torus.hpp"

namespace delcert::checker_tests {

Sample graded_torus(int N, double stretch) {
  Sample result;
  result.model = kuhn_torus(2, N, stretch, 0.01, 8);
  const double mu = result.model.mu.value() * 8 / 9 * 0.999;
  result.model.mu = at_most(mu);
  result.model.rho = at_most(mu / 4 * 8 / 9);
  result.claims = {{"0", "1", "2", "2s", "3", "4", "5", "6"}, roomy(measure(result.model, 50)), false};
  return result;
}

std::string radius_text(const Sample& sample, long long numerator, long long denominator) {
  const Fraction& epsilon = sample.model.epsilon;
  return Fraction{epsilon.numerator * numerator, epsilon.denominator * denominator}.text();
}

Json graded_document(const Sample& sample) {
  Json result = Json::object();
  const Json uniform = sample.document();
  for (const auto& [key, value] : uniform.items()) {
    result[key] = value;
    if (key != "net") continue;
    for (std::size_t i = 0; i < value.size(); ++i)
      result["radii"].push_back(i == lesser_label ? radius_text(sample, 8, 9) : sample.model.epsilon.text());
  }
  result["parameters"]["radius_variation"] = "1/8";
  return result;
}

}  // namespace delcert::checker_tests
