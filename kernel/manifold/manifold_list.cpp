#include "kernel/manifold/manifold_list.hpp"

#include <sstream>
#include <utility>

#include "kernel/manifold/any_manifold.hpp"
#include "kernel/manifold/builtin_manifolds.hpp"

namespace delcert {

namespace {

int dimension_of(const AnyManifold& manifold) {
  return std::visit(
      [](const auto& description) {
        if constexpr (requires { description.form; }) {
          return description.form.dimension();
        } else {
          return description.dimension.value;
        }
      },
      manifold);
}

}  // namespace

std::string first_sentence(const std::string& toml) {
  std::istringstream lines(toml);
  std::string comment;
  for (std::string line; std::getline(lines, line) && line.starts_with("# ");)
    comment += (comment.empty() ? "" : " ") + line.substr(2);
  comment = comment.substr(0, comment.find(". "));
  if (comment.ends_with('.')) comment.pop_back();
  return comment;
}

std::vector<ListedManifold> builtin_manifold_list() {
  std::vector<ListedManifold> list;
  for (const BuiltinKind& kind : builtin_kinds()) {
    for (const BuiltinManifold& builtin : *kind.manifolds) {
      const int dimension = dimension_of(parse_any_manifold(builtin.text, builtin.name));
      list.push_back({builtin.name, std::string(kind.name), dimension, first_sentence(builtin.text)});
    }
  }
  return list;
}

}  // namespace delcert
