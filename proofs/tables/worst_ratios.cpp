#include "proofs/tables/worst_ratios.hpp"

#include <cmath>
#include <nlohmann/json.hpp>

#include "support/error.hpp"

namespace delcert {

std::string dimension_name(int k, int m) { return k > 0 ? "k=" + std::to_string(k) : "m=" + std::to_string(m); }

WorstRatios parse_worst_ratios(const std::string& json, const std::string& file) {
  WorstRatios result;
  try {
    const auto list = nlohmann::json::parse(json);
    if (!list.is_array()) throw InputError(file + ": not what delcert tighten --json prints: no list");
    for (const auto& one : list) {
      const std::string name = one.at("claim").get<std::string>() + "/" + one.at("conclusion").get<std::string>();
      if (!one.contains("lower")) continue;
      const auto lower = one.at("lower").get<double>();
      if (!std::isfinite(lower)) throw InputError(file + ": the ratio of " + name + " is not finite");
      const WorstRatio ratio{Rational::exactly(lower), one.at("note") == "equality, exactly"};
      const auto [known, is_new] =
          result[name].emplace(dimension_name(one.at("k").get<int>(), one.at("m").get<int>()), ratio);
      if (is_new) continue;
      known->second.is_equality = known->second.is_equality || ratio.is_equality;
      if (ratio.lower > known->second.lower) known->second.lower = ratio.lower;
    }
  } catch (const nlohmann::json::exception& error) {
    throw InputError(file + ": not what delcert tighten --json prints: " + error.what());
  }
  return result;
}

}  // namespace delcert
