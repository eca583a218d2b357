#include "tests/checker/weaker_claims.hpp"

#include <algorithm>

#include "kernel/number/exact_text.hpp"
#include "tests/checker/support/certificate_text.hpp"

namespace delcert::checker_tests {
namespace {

bool begins_with_any(const std::string& path, const std::vector<std::string>& beginnings) {
  return std::any_of(beginnings.begin(), beginnings.end(),
                     [&](const std::string& beginning) { return path.starts_with(beginning); });
}

Rational number(const Json& j, const std::string& path) {
  return parse_exact(j.at(Json::json_pointer(path)).get<std::string>());
}

/// Whether the leaf at the path may have changed as it did.
bool is_no_stronger(const Json& truth, const Json& other, const std::string& path) {
  const std::string words[] = {"/software",
                               "/manifold/name",
                               "/sha256",
                               "/parameters/candidates",
                               "/parameters/seed",
                               "/parameters/tolerance",
                               "/parameters/flake_parameter_squared"};
  if (begins_with_any(path, {std::begin(words), std::end(words)})) return true;
  const Json::json_pointer at(path);
  if (!truth.contains(at) || !other.contains(at) || !other.at(at).is_string()) return false;
  const std::string before = truth.at(at).get<std::string>(), after = other.at(at).get<std::string>();
  if (before.empty() || after.empty() || path == "/parameters/mode") return false;
  const Rational old = number(truth, path), now = number(other, path);
  if (old == now) return true;  // in another spelling
  const std::vector<std::string> lower = {
      "/levels/1/protection",    "/levels/1/thickness", "/levels/4/protection",   "/levels/6/weight",
      "/levels/6/bilipschitz/0", "/levels/5/thickness", "/parameters/separation", "/manifold/injectivity_radius"};
  const std::vector<std::string> upper = {"/levels/0/",       "/levels/1/circumradius",  "/levels/4/circumradius",
                                          "/levels/5/radius", "/levels/6/bilipschitz/1", "/parameters/perturbation"};
  if (begins_with_any(path, lower)) return now < old;
  if (begins_with_any(path, upper)) return old < now;
  // The ends around t = 0, the only root of the polynomial t.
  if (path == "/manifold/root/0") return now < Rational(0);
  if (path == "/manifold/root/1") return Rational(0) < now;
  if (path == "/parameters/sampling_radius") {
    // The unit of perturbation, and of level 0 the unit of separation and where charts end.
    const auto product = [&](const Json& j, const char* key) { return number(j, key) * number(j, path); };
    if (product(other, "/parameters/perturbation") < product(truth, "/parameters/perturbation")) return false;
    return !other["levels"].contains("0") ||
           (!(product(truth, "/parameters/separation") < product(other, "/parameters/separation")) &&
            !(number(other, "/manifold/injectivity_radius") < Rational(12) * now));
  }
  return false;
}

}  // namespace

std::string stronger_claims(const std::string& truth, const std::string& text) {
  const Json before = Json::parse(truth), after = Json::parse(text);
  std::string result;
  // A level that is claimed no more takes nothing with it but its claims.
  for (const auto& change : Json::diff(before, after)) {
    const std::string path = change.at("path").get<std::string>();
    const bool less = change.at("op") == "remove" && path.starts_with("/levels/");
    if (!less && !is_no_stronger(before, after, path)) result += path + " ";
  }
  return result;
}

}  // namespace delcert::checker_tests
