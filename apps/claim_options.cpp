#include "apps/claim_options.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>

#include "properties/attack/claim_library.hpp"
#include "properties/attack/claim_shapes.hpp"
#include "support/error.hpp"

namespace delcert {

namespace {

int dimension_from(const std::string& text, const std::string& whole) {
  int result = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), result);
  constexpr int largest = 16;
  if (error != std::errc{} || end != text.data() + text.size() || result < 0 || result > largest) {
    throw InputError("--shape " + whole + ": expected k,m such as 2,3, or m such as 2");
  }
  return result;
}

Shape shape_from(const std::string& text) {
  const std::size_t comma = text.find(',');
  if (comma == std::string::npos) return {0, dimension_from(text, text)};
  return {dimension_from(text.substr(0, comma), text), dimension_from(text.substr(comma + 1), text)};
}

}  // namespace

void add_claim_options(CLI::App& command, ClaimOptions& options) {
  command.add_option("claims", options.names, "Claims: names of the library (delcert claims lists them) or TOML files");
  command.add_flag("--all", options.all, "All claims of the library");
  command.add_option("--shape", options.shapes,
                     "Only k-simplices in R^m, as k,m, or nets in R^m, as m; may be repeated");
}

std::vector<Claim> claims_about_instances(const ClaimOptions& options) {
  if (options.all && options.names.empty()) return builtin_claim_list();
  std::vector<Claim> result = claims_of(options);
  for (const Claim& claim : result) {
    if (claim.instance.empty()) {
      throw InputError(claim.name + " has steps only, which are proved and not attacked: delcert prove " + claim.name);
    }
  }
  return result;
}

std::vector<Claim> claims_of(const ClaimOptions& options) {
  if (options.all && !options.names.empty())
    throw InputError("--all means all claims: name some claims, or give --all");
  if (options.all) return builtin_files();
  if (options.names.empty()) throw InputError("no claim: name some, or say --all");
  std::vector<Claim> result;
  for (const std::string& name : options.names) {
    Claim claim = find_claim(name);
    const auto same =
        std::find_if(result.begin(), result.end(), [&](const Claim& one) { return one.name == claim.name; });
    if (same == result.end()) {
      result.push_back(std::move(claim));
    } else if (same->file != claim.file) {
      throw InputError(same->file + " and " + claim.file + " are both called " + claim.name);
    }
  }
  return result;
}

std::vector<Shape> shapes_of(const ClaimOptions& options, const Claim& claim) {
  const std::vector<Shape> usual = usual_shapes(claim);
  if (options.shapes.empty()) return usual;
  std::vector<Shape> result;
  for (const std::string& text : options.shapes) {
    const Shape shape = shape_from(text);
    if (has_shape(claim, shape)) {
      if (std::find(result.begin(), result.end(), shape) == result.end()) result.push_back(shape);
    } else if (!options.all) {
      std::string known;
      for (const Shape& listed : usual) known += (known.empty() ? "" : "; ") + text_of(listed);
      throw InputError("--shape " + text + ": the class " + claim.instance + " of " + claim.name + " has " + known);
    }
  }
  return result;
}

}  // namespace delcert
