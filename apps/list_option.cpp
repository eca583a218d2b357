#include "apps/list_option.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <string_view>

#include "kernel/number/exact_text.hpp"

namespace delcert {

namespace {

std::vector<std::string_view> parts_of(std::string_view text) {
  std::vector<std::string_view> parts;
  while (true) {
    const auto comma = text.find(',');
    parts.push_back(text.substr(0, comma));
    if (comma == std::string_view::npos) return parts;
    text.remove_prefix(comma + 1);
  }
}

/// Collects the values of one option.
template <class Value>
class List {
 public:
  explicit List(std::string option) : option_(std::move(option)) {}

  [[noreturn]] void fail(const std::string& message) const { throw CLI::ValidationError(option_, message); }

  void add(Value value, std::string_view text) {
    if (std::find(values_.begin(), values_.end(), value) != values_.end())
      fail(std::string(text) + " lists a value a second time");
    if (values_.size() == longest_list) fail("more than " + std::to_string(longest_list) + " values");
    values_.push_back(std::move(value));
  }

  std::vector<Value> values() && { return std::move(values_); }

 private:
  std::string option_;
  std::vector<Value> values_;
};

std::vector<Rational> exact_list(const std::string& option, const std::string& text) {
  List<Rational> list(option);
  for (const std::string_view part : parts_of(text)) {
    if (part.empty())
      list.fail("an empty part in \"" + text + "\": write numbers with single commas, such as 1/4,1/2,1");
    try {
      list.add(parse_exact(part), part);
    } catch (const ExactTextError& error) {
      list.fail(error.what());
    }
  }
  return std::move(list).values();
}

bool read_integer(std::string_view text, int& value) {
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc{} && end == text.data() + text.size();
}

std::vector<int> integer_list(const std::string& option, const std::string& text) {
  List<int> list(option);
  for (const std::string_view part : parts_of(text)) {
    const auto dots = part.find("..");
    const std::string_view begin = part.substr(0, dots);
    const std::string_view end = dots == std::string_view::npos ? begin : part.substr(dots + 2);
    int first = 0;
    int last = 0;
    if (!read_integer(begin, first) || !read_integer(end, last))
      list.fail("\"" + std::string(part) + "\" is neither an integer nor a range: write 2, 2..6 or 1,3..5");
    if (last < first) list.fail("the range " + std::string(part) + " ends below its beginning");
    for (long value = first; value <= last; ++value) list.add(static_cast<int>(value), part);
  }
  return std::move(list).values();
}

}  // namespace

CLI::Option* add_exact_list_option(CLI::App& command, const std::string& name, std::vector<Rational>& values,
                                   const std::string& help) {
  const auto read = [&values, name](const std::string& text) { values = exact_list(name, text); };
  return command.add_option_function<std::string>(name, read, help)->type_name("NUMBER,…");
}

CLI::Option* add_integer_list_option(CLI::App& command, const std::string& name, std::vector<int>& values,
                                     const std::string& help) {
  const auto read = [&values, name](const std::string& text) { values = integer_list(name, text); };
  return command.add_option_function<std::string>(name, read, help)->type_name("INTEGER,…");
}

}  // namespace delcert
