#include "kernel/manifold/submanifold_file.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "kernel/formula/plain_formula.hpp"
#include "kernel/formula/toml_formula_reader.hpp"
#include "kernel/manifold/exact_entry.hpp"
#include "kernel/manifold/mesh_file.hpp"
#include "kernel/manifold/submanifold/polyhedral_mesh.hpp"
#include "kernel/topology/abelian_group.hpp"

namespace delcert {

namespace {

constexpr int least_submanifold_dimension = 1;
constexpr int greatest_submanifold_dimension = 3;
constexpr std::size_t longest_equation = 4096;

class SubmanifoldReader : TomlFormulaReader {
 public:
  SubmanifoldReader(std::string_view text, const std::string& source)
      : TomlFormulaReader(text, source), folder_(std::filesystem::path(source).parent_path()), table_(parse()) {}

  SubmanifoldDescription read() const {
    const bool is_mesh = table_.contains("mesh");
    if (is_mesh) {
      refuse_unknown(table_, {"name", "family", "dimension", "mesh", "homology"});
    } else {
      refuse_unknown(table_, {"name", "family", "dimension", "variables", "equations", "box", "homology"});
    }
    if (short_string(table_, "family") != "submanifold")
      fail(required(table_, "family"), key_in_words("family"), "\"submanifold\"");
    SubmanifoldDescription result;
    result.name = short_string(table_, "name");
    result.dimension =
        Dimension(integer(table_, "dimension", least_submanifold_dimension, greatest_submanifold_dimension));
    if (is_mesh) {
      if (result.dimension != Dimension(2)) fail(required(table_, "dimension"), key_in_words("dimension"), "2: a mesh");
      result.mesh = mesh();
    } else {
      result.variables = variables();
      result.equations = equations(result);
      result.box = box(result.variables);
    }
    result.homology = homology(static_cast<std::size_t>(result.dimension.value) + 1);
    return result;
  }

 private:
  const toml::array& array_of(std::string_view key, std::size_t least, std::size_t most, const std::string& of) const {
    const std::string count =
        least == most ? std::to_string(least) : std::to_string(least) + " to " + std::to_string(most);
    const toml::node& node = required(table_, key, "an array of " + count + " " + of);
    const auto* result = node.as_array();
    if (result == nullptr || result->size() < least || result->size() > most)
      fail(node, key_in_words(key), "an array of " + count + " " + of);
    return *result;
  }

  TriangleMesh mesh() const {
    const std::filesystem::path path = folder_ / short_string(table_, "mesh");
    std::ifstream stream(path, std::ios::binary);
    if (!stream)
      fail(required(table_, "mesh"), key_in_words("mesh"), "an OFF or OBJ file; " + path.string() + " cannot be read");
    return parse_mesh(std::string(std::istreambuf_iterator<char>(stream), {}), path.string());
  }

  std::vector<std::string> variables() const {
    std::vector<std::string> result;
    for (const toml::node& entry : array_of("variables", 2, most_ambient_dimensions, "names")) {
      const std::string what = "variable " + std::to_string(result.size() + 1);
      const auto* name = entry.as_string();
      if (name == nullptr || !is_name_of_variable(name->get()))
        fail(entry, what, "a name: at most 16 small letters, digits and _, a letter first, and no name of a function");
      if (std::find(result.begin(), result.end(), name->get()) != result.end())
        fail(entry, what, "another name: this one is taken");
      result.push_back(name->get());
    }
    return result;
  }

  std::vector<std::string> equations(const SubmanifoldDescription& manifold) const {
    const std::size_t ambient = manifold.variables.size();
    const auto dimension = static_cast<std::size_t>(manifold.dimension.value);
    if (dimension >= ambient)
      fail(required(table_, "dimension"), key_in_words("dimension"),
           "less than the number of variables, " + std::to_string(ambient));
    const std::size_t count = ambient - dimension;
    std::vector<std::string> result;
    for (const toml::node& entry :
         array_of("equations", count, count, "formulas: as many as there are variables, less the dimension")) {
      const auto* text = entry.as_string();
      if (text == nullptr || text->get().size() > longest_equation)
        fail(entry, "equation " + std::to_string(result.size() + 1), "a string of at most 4096 bytes");
      result.push_back(in_string(entry, "a formula", [&](const std::string& formula) {
        return FormulaMap(manifold.variables, {formula}).canonical_texts()[0];
      }));
    }
    return result;
  }

  std::vector<std::array<Rational, 2>> box(const std::vector<std::string>& variables) const {
    std::vector<std::array<Rational, 2>> result;
    for (const toml::node& entry :
         array_of("box", variables.size(), variables.size(), "pairs of numbers, one for each variable")) {
      result.push_back(exact_interval(*this, entry, "box, " + variables[result.size()]));
    }
    return result;
  }

  std::vector<std::string> homology(std::size_t count) const {
    std::vector<std::string> result;
    if (!table_.contains("homology")) return result;
    for (const toml::node& entry : array_of("homology", count, count, "groups, from degree 0 on")) {
      const auto* group = entry.as_string();
      if (group == nullptr || !is_group_text(group->get()))
        fail(entry, "homology, degree " + std::to_string(result.size()),
             R"(a group such as "Z^2 + Z/3", "(Z/2)^2" or "0")");
      result.push_back(group->get());
    }
    return result;
  }

  std::filesystem::path folder_;
  toml::table table_;
};

}  // namespace

SubmanifoldDescription parse_submanifold(std::string_view text, const std::string& source) {
  return SubmanifoldReader(text, source).read();
}

std::shared_ptr<const EmbeddedManifold> embedded_manifold(const SubmanifoldDescription& description) {
  if (!description.mesh) return std::make_shared<ZeroSet>(description);
  return std::make_shared<PolyhedralMesh>(description.name, *description.mesh, description.homology);
}

}  // namespace delcert
