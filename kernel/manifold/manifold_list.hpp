#pragma once

#include <string>
#include <vector>

namespace delcert {

/// A built-in manifold as a list shows it.
struct ListedManifold {
  std::string name;
  std::string kind;  ///< of which model: "flat", "space form", "metric field", "atlas", "submanifold"
  int dimension = 0;
  std::string about;  ///< the first sentence of the comment at the head of its file
};

/// All built-in manifolds, by kind and then by name.
[[nodiscard]] std::vector<ListedManifold> builtin_manifold_list();

/// The first sentence of the comment that a TOML text begins with, without its full stop; empty if there is none.
[[nodiscard]] std::string first_sentence(const std::string& toml);

}  // namespace delcert
