#include "proofs/certification/certification.hpp"

#include <pybind11/pybind11.h>

#include <functional>
#include <map>

#include "kernel/manifold/manifold_list.hpp"
#include "proofs/certification/report_json.hpp"
#include "python/bindings/call.hpp"
#include "python/bindings/conversion.hpp"
#include "python/bindings/parts.hpp"
#include "support/build_commit.hpp"
#include "support/error.hpp"

namespace delcert::python {

namespace py = pybind11;

namespace {

/// An option by its name, as python/delcert/certification.py passes it: all are checked there.
using Setter = std::function<void(CertifyOptions&, const py::handle&)>;

std::optional<Rational> exact(const py::handle& value) { return rational_of(py::cast<std::string>(value)); }

template <class Value>
Value one_of(const std::map<std::string, Value>& values, const py::handle& value) {
  return values.at(py::cast<std::string>(value));
}

const std::map<std::string, Setter>& setters() {
  using Options = CertifyOptions;
  using Value = py::handle;
  static const std::map<std::string, Setter> result{
      {"manifold", [](Options& o, const Value& v) { o.source.manifold = py::cast<std::string>(v); }},
      {"radius", [](Options& o, const Value& v) { o.source.radius = exact(v); }},
      {"lattice", [](Options& o, const Value& v) { o.source.lattice = py::cast<std::uint32_t>(v); }},
      {"centred", [](Options& o, const Value& v) { o.source.centred = py::cast<bool>(v); }},
      {"displace", [](Options& o, const Value& v) { o.source.displacement_exponent = py::cast<unsigned>(v); }},
      {"points", [](Options& o, const Value& v) { o.source.points_file = py::cast<std::string>(v); }},
      {"icosphere", [](Options& o, const Value& v) { o.source.icosphere_frequency = py::cast<std::uint32_t>(v); }},
      {"relax", [](Options& o, const Value& v) { o.source.relaxation_steps = py::cast<std::uint32_t>(v); }},
      {"sizing", [](Options& o, const Value& v) { o.source.sizing.text = py::cast<std::string>(v); }},
      {"seed", [](Options& o, const Value& v) { o.source.seed = py::cast<std::uint64_t>(v); }},
      {"complex", [](Options& o, const Value& v) { o.complex = py::cast<std::string>(v); }},
      {"mode",
       [](Options& o, const Value& v) {
         o.choice.mode = one_of<RunMode>({{"theory", RunMode::theory}, {"measured", RunMode::measured}}, v);
         o.mode_is_given = true;
       }},
      {"hypotheses",
       [](Options& o, const Value& v) {
         o.choice.constraints = one_of<ParameterConstraints>(
             {{"printed", ParameterConstraints::printed}, {"sharper", ParameterConstraints::sharper}}, v);
       }},
      {"candidates",
       [](Options& o, const Value& v) {
         o.choice.candidates = one_of<CandidateRule>(
             {{"pruned", CandidateRule::pruned}, {"whole", CandidateRule::whole}, {"printed", CandidateRule::printed}},
             v);
       }},
      {"perturbation", [](Options& o, const Value& v) { o.choice.perturbation = exact(v); }},
      {"tolerance", [](Options& o, const Value& v) { o.choice.tolerance = exact(v); }},
      {"clearance", [](Options& o, const Value& v) { o.choice.clearance = exact(v); }},
      {"choices", [](Options& o, const Value& v) { o.choice.choices = py::cast<std::uint32_t>(v); }},
      {"required_protection", [](Options& o, const Value& v) { o.required_protection = exact(v); }},
      {"repair_rounds", [](Options& o, const Value& v) { o.repair_rounds = py::cast<int>(v); }},
      {"refine", [](Options& o, const Value& v) { o.refinement_rounds = py::cast<int>(v); }},
      {"no_perturbation", [](Options& o, const Value& v) { o.no_perturbation = py::cast<bool>(v); }},
      {"levels",
       [](Options& o, const Value& v) {
         o.levels.clear();
         for (const auto level : v) o.levels.push_back(py::cast<std::string>(level));
       }},
      {"threads", [](Options& o, const Value& v) { o.threads = py::cast<unsigned>(v); }}};
  return result;
}

std::string certify(const py::dict& options, const std::string& output, const std::string& command,
                    const py::object& told) {
  CertifyOptions asked;
  for (const auto& [name, value] : options) setters().at(py::cast<std::string>(name))(asked, value);
  asked.output = output;
  asked.origin = {{"command", command}};
  if (build_commit()[0] != '\0') asked.origin.emplace_back("commit", build_commit());
  return apart(told, [&](const Progress& progress) { return report_json(certified_run(asked, progress)); });
}

py::list manifolds() {
  py::list result;
  for (const ListedManifold& one : apart([] { return builtin_manifold_list(); })) {
    py::dict row;
    row["name"] = one.name;
    row["kind"] = one.kind;
    row["dimension"] = one.dimension;
    row["about"] = one.about;
    result.append(row);
  }
  return result;
}

}  // namespace

void add_certification(py::module_& module) {
  module.def("certify", &certify, py::arg("options"), py::arg("output"), py::arg("command"), py::arg("told"));
  module.def("manifolds", &manifolds);
  module.def("all_levels", [] { return py::cast(std::vector<py::str>(all_levels().begin(), all_levels().end())); });
  // What a text says exactly; the same texts as on the command line.
  module.def("exact", [](const std::string& text) { return fraction_of(rational_of(text)); });
}

}  // namespace delcert::python
