#pragma once

#include <CLI/CLI.hpp>
#include <algorithm>
#include <string>
#include <utility>
#include <vector>

namespace delcert {

/// An option whose value is one of a few words, each of which stands for a value of `target`. Unlike
/// CLI::CheckedTransformer, CLI::Option::results keeps the word that was typed, so that a command line that is recorded
/// can be typed again.
template <class T, class Target>
CLI::Option* add_choice_option(CLI::App& command, const std::string& name, Target& target,
                               const std::vector<std::pair<std::string, T>>& choices, const std::string& description) {
  std::vector<std::string> words;
  for (const auto& choice : choices) words.push_back(choice.first);
  const auto take = [&target, choices](const std::string& word) {
    const auto found =
        std::find_if(choices.begin(), choices.end(), [&word](const auto& choice) { return choice.first == word; });
    target = found->second;
  };
  return command.add_option_function<std::string>(name, take, description)
      ->check(CLI::IsMember(words).description(""))
      ->type_name(CLI::detail::join(words, "|"));
}

}  // namespace delcert
