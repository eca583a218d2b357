#include "kernel/topology/homology.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>

#include "apps/commands.hpp"
#include "kernel/topology/components.hpp"
#include "kernel/topology/orientation.hpp"
#include "proofs/certificate/simplex_file.hpp"

namespace delcert {

namespace {

struct HomologyOptions {
  std::string file;
  bool json = false;
};

ExitStatus print_homology(const HomologyOptions& options) {
  const PureComplex complex = read_simplices(options.file);
  const FacetDegrees degrees = facet_degrees(complex);
  const std::optional<bool> orientable = is_orientable(complex);
  std::vector<std::size_t> counts;
  for (int k = 0; k <= complex.dimension(); ++k) counts.push_back(complex.count(k));
  std::vector<std::string> groups;
  for (const AbelianGroup& group : homology(complex)) groups.push_back(group_text(group));
  if (options.json) {
    nlohmann::ordered_json json;
    json["dimension"] = complex.dimension();
    json["faces"] = counts;
    json["components"] = component_count(complex);
    json["facets_in_one_simplex"] = degrees.one;
    json["facets_in_three_or_more"] = degrees.more;
    json["orientable"] = orientable ? nlohmann::ordered_json(*orientable) : nlohmann::ordered_json();
    json["euler_characteristic"] = complex.euler_characteristic();
    json["homology"] = groups;
    std::cout << json.dump(2) << "\n";
    return ExitStatus::verified;
  }
  std::cout << fmt::format(
      "faces        {}, of dimension 0 to {}\n"
      "components   {}\n"
      "facets       {} in one simplex, {} in three or more\n"
      "orientable   {}\n"
      "Euler        {}\n"
      "homology     {}\n",
      fmt::join(counts, ", "), complex.dimension(), component_count(complex), degrees.one, degrees.more,
      !orientable   ? "undefined"
      : *orientable ? "yes"
                    : "no",
      complex.euler_characteristic(), fmt::join(groups, ", "));
  return ExitStatus::verified;
}

}  // namespace

void add_homology(CLI::App& program, Action& chosen) {
  const auto options = std::make_shared<HomologyOptions>();
  CLI::App* command = program.add_subcommand(
      "homology", "Homology of the complex in a certificate, from the labels of its simplices alone");
  command->add_option("FILE", options->file, "A certificate, plain or compressed, or {\"simplices\": ...} alone")
      ->required();
  command->add_flag("--json", options->json, "Print JSON");
  command->footer(
      "Reads only the key \"simplices\" of the file: rows of m + 1 labels and m more integers, which do not matter.\n\n"
      "Examples:\n"
      "  delcert homology lens-space-5-2.json.zst\n"
      "  echo '{\"simplices\": [[0,1,0], [0,2,0], [1,2,0]]}' > triangle.json; delcert homology triangle.json");
  command->callback([options, &chosen] { chosen = [options] { return print_homology(*options); }; });
}

}  // namespace delcert
