#include <pybind11/stl.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <thread>

#include "proofs/certificate/summary_json.hpp"
#include "proofs/formula/latex.hpp"
#include "properties/attack/attack_report.hpp"
#include "properties/attack/claim_library.hpp"
#include "properties/attack/claim_shapes.hpp"
#include "properties/attack/refutations.hpp"
#include "properties/attack/search_plan.hpp"
#include "properties/attack/twins.hpp"
#include "properties/attack/witness_points.hpp"
#include "python/bindings/call.hpp"
#include "python/bindings/conversion.hpp"
#include "python/bindings/parts.hpp"
#include "support/error.hpp"

namespace delcert::python {

namespace py = pybind11;

namespace {

using Json = nlohmann::ordered_json;

unsigned number_of(unsigned threads) {
  return threads > 0 ? threads : std::max(1U, std::thread::hardware_concurrency());
}

Json json_of(const Claim& claim) {
  Json json{{"name", claim.name},         {"title", claim.title},
            {"source", claim.source},     {"status", name_of(claim.status)},
            {"instance", claim.instance}, {"note", claim.note},
            {"steps", claim.steps.size()}};
  json["given"] = Json::array();
  for (const Hypothesis& one : claim.hypotheses) json["given"].push_back({{"name", one.name}, {"claim", one.text}});
  json["show"] = Json::array();
  for (const Conclusion& one : claim.conclusions) json["show"].push_back({{"name", one.name}, {"claim", one.text}});
  return json;
}

/// A claim of the library, of a file or of a text.
class ReadClaim {
 public:
  explicit ReadClaim(Claim claim) : claim_(std::move(claim)) {}

  [[nodiscard]] std::string summary() const { return ascii_text(json_of(claim_)); }
  [[nodiscard]] std::string latex() const { return latex_of(claim_); }
  [[nodiscard]] std::vector<std::pair<int, int>> shapes() const {
    std::vector<std::pair<int, int>> result;
    for (const Shape& shape : its_class().shapes()) result.emplace_back(shape.k, shape.m);
    return result;
  }

  [[nodiscard]] std::string attack(std::uint64_t samples, const std::vector<std::pair<int, int>>& shapes,
                                   std::uint64_t seed, unsigned threads, const py::object& told) const {
    CampaignPlan plan;
    for (const Shape& shape : checked(shapes)) plan.targets.push_back({claim_, shape, spread(samples, shape, true)});
    plan.seed = seed;
    plan.threads = number_of(threads);
    return apart(told, [&](const Progress& progress) {
      const std::vector<Tally> tallies = run_campaign(plan, progress).tallies;
      Json json{{"targets", attack_json(plan.targets, tallies, usual_least_instances)},
                {"totals", totals_json(attack_totals(plan.targets, tallies), usual_least_instances)},
                {"refutations", Json::array()}};
      for (const FoundRefutation& found : refutations_in(plan.targets, tallies, seed, progress)) {
        const Shape& shape = plan.targets[found.target].shape;
        json["refutations"].push_back({{"conclusion", claim_.conclusions[found.conclusion].name},
                                       {"k", shape.k},
                                       {"m", shape.m},
                                       {"sample", found.sample},
                                       {"witness", witness_text(found.witness)}});
      }
      return json.dump();
    });
  }

  [[nodiscard]] std::string tighten(std::size_t conclusion, const std::pair<int, int>& shape, std::uint64_t evaluations,
                                    std::uint64_t seed, unsigned threads, const py::object& told) const {
    const Shape its_shape = checked({shape}).front();
    SearchPlan plan;
    plan.targets = {{claim_, conclusion, its_shape, spread(evaluations, its_shape, false)}};
    plan.seed = seed;
    plan.threads = number_of(threads);
    return apart(told, [&](const Progress& progress) {
      const std::optional<Tightest> found = run_searches(plan, progress).front();
      if (!found) return std::string();
      const Json json{{"lower", found->ratio.lower},
                      {"upper", found->ratio.upper},
                      {"is_equality", found->is_equality},
                      {"verdict", name_of(found->verdict)},
                      {"evaluations", found->evaluations},
                      {"witness", witness_text(witness_of(claim_, conclusion, found->bindings))}};
      return json.dump();
    });
  }

  /// What the claim says of the instance in the text of a witness file.
  [[nodiscard]] std::string verdict_on(const std::string& witness) const {
    return apart([&] {
      const Witness read = parse_witness(witness, "the witness");
      require_witness_of(claim_, read);
      return std::string(name_of(decide_witness(claim_, read)));
    });
  }

 private:
  [[nodiscard]] const InstanceClass& its_class() const {
    if (claim_.instance.empty())
      throw InputError(claim_.name + " has steps only, which are proved and not attacked: delcert prove " +
                       claim_.name);
    return instance_class(claim_.instance);
  }

  [[nodiscard]] std::vector<Shape> checked(const std::vector<std::pair<int, int>>& shapes) const {
    (void)its_class();
    if (shapes.empty()) return usual_shapes(claim_);
    std::vector<Shape> result;
    for (const auto& [k, m] : shapes) {
      const Shape shape{k, m};
      if (!has_shape(claim_, shape)) {
        std::string known;
        for (const Shape& one : usual_shapes(claim_)) known += (known.empty() ? "" : "; ") + text_of(one);
        throw InputError("the class " + its_class().name() + " has no shape " + text_of(shape) + ", it has " + known);
      }
      if (std::find(result.begin(), result.end(), shape) == result.end()) result.push_back(shape);
    }
    return result;
  }

  /// Fewer where an instance is costly.
  [[nodiscard]] std::uint64_t spread(std::uint64_t number, const Shape& shape, bool round_up) const {
    const std::uint64_t cost = std::max<std::uint64_t>(1, its_class().cost(shape));
    return std::max<std::uint64_t>(1, (number + (round_up ? cost - 1 : 0)) / cost);
  }

  Claim claim_;
};

std::string claims() {
  Json list = Json::array();
  for (const Claim& claim : builtin_files()) list.push_back(json_of(claim));
  return ascii_text(list);
}

}  // namespace

void add_claims(py::module_& module) {
  py::class_<ReadClaim>(module, "ReadClaim")
      .def("summary", &ReadClaim::summary)
      .def("latex", &ReadClaim::latex)
      .def("shapes", &ReadClaim::shapes)
      .def("attack", &ReadClaim::attack)
      .def("tighten", &ReadClaim::tighten)
      .def("verdict_on", &ReadClaim::verdict_on);
  module.def("claim_of_text", [](const std::string& text, const std::string& name) {
    return ReadClaim(apart([&] { return parse_claim(text, name, full_vocabulary(), all_signatures()); }));
  });
  module.def("find_claim", [](const std::string& name_or_file) {
    return ReadClaim(apart([&] { return find_claim(name_or_file); }));
  });
  // Empty where there is nothing to draw.
  module.def("witness_svg", [](const std::string& text) {
    return apart([&]() -> std::string {
      const std::vector<DrawnSet> sets = drawn_sets(parse_witness(text, "the witness"));
      return sets.empty() ? "" : svg_of(figure_of(sets));
    });
  });
  module.def("claims", [] { return apart([] { return claims(); }); });
}

}  // namespace delcert::python
