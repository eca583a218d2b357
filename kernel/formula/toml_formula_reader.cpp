#include "kernel/formula/toml_formula_reader.hpp"

#include "kernel/formula/toml_position.hpp"

namespace delcert {

void TomlFormulaReader::fail_in(const toml::node& node, const FormulaError& error) const {
  const auto& begin = node.source().begin;
  const TextPosition where = position_in_toml_string(text(), {begin.line, begin.column}, error.offset());
  fail(where.line, where.column, error.what());
}

}  // namespace delcert
