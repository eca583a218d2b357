#include <CLI/CLI.hpp>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>

#include "apps/commands.hpp"
#include "kernel/manifold/manifold_list.hpp"
#include "support/error.hpp"
#include "support/spelling.hpp"
#include "support/text_table.hpp"

namespace delcert {

namespace {

struct ManifoldsOptions {
  std::string word;
  bool names = false, json = false;
};

/// Those in whose name, kind or description the word is. Throws InputError if there are none.
std::vector<ListedManifold> with_word(const std::string& word) {
  const std::vector<ListedManifold> all = builtin_manifold_list();
  std::vector<ListedManifold> found;
  std::vector<std::string> names;
  for (const ListedManifold& one : all) {
    names.push_back(one.name);
    if ((one.name + "\n" + one.kind + "\n" + one.about).find(word) != std::string::npos) found.push_back(one);
  }
  if (found.empty()) throw InputError("no built-in manifold mentions " + shortened(word) + suggestion(word, names));
  return found;
}

void print(const std::vector<ListedManifold>& list, const ManifoldsOptions& options) {
  if (options.json) {
    nlohmann::ordered_json json = nlohmann::ordered_json::array();
    for (const ListedManifold& one : list)
      json.push_back({{"name", one.name}, {"kind", one.kind}, {"dimension", one.dimension}, {"about", one.about}});
    std::cout << json.dump(2) << "\n";
  } else if (options.names) {
    for (const ListedManifold& one : list) std::cout << one.name << "\n";
  } else {
    std::vector<std::vector<std::string>> rows;
    for (const ListedManifold& one : list)
      rows.push_back({one.name, std::to_string(one.dimension), one.kind, one.about});
    std::cout << text_table(rows);
  }
}

}  // namespace

void add_manifolds(CLI::App& program, Action& chosen) {
  const auto options = std::make_shared<ManifoldsOptions>();
  CLI::App* command = program.add_subcommand("manifolds", "List the built-in manifolds");
  command->add_option("WORD", options->word, "List only manifolds whose name, kind or description has this");
  command->add_flag("--names", options->names, "Print names only, one a line");
  command->add_flag("--json", options->json, "Print JSON");
  command->footer(
      "Each is a TOML file in examples/manifolds, a pattern for files of your own.\n\n"
      "Examples:\n"
      "  delcert manifolds\n"
      "  delcert manifolds lens\n"
      "  delcert manifolds 'space form' --names");
  command->callback([options, &chosen] {
    chosen = [options] {
      print(with_word(options->word), *options);
      return ExitStatus::verified;
    };
  });
}

}  // namespace delcert
