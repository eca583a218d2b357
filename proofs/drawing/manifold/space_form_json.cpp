#include "proofs/drawing/manifold/space_form_json.hpp"

#include <cstdlib>

#include "kernel/number/exact_text.hpp"
#include "proofs/drawing/manifold/manifold_json.hpp"
#include "support/error.hpp"

namespace delcert {

namespace {

using Json = nlohmann::ordered_json;

std::vector<Rational> rationals_of(const Json& texts) {
  std::vector<Rational> result;
  for (const auto& text : texts) result.push_back(parse_exact(text.get<std::string>()));
  return result;
}

FieldMatrix matrix_of(const Json& rows, const FieldElement::Field& field, std::size_t order) {
  FieldMatrix result(order);
  if (rows.size() != order) throw InputError("manifold: a matrix is not of the order of the dimension");
  for (std::size_t row = 0; row < order; ++row) {
    if (rows[row].size() != order) throw InputError("manifold: a matrix is not square");
    for (std::size_t column = 0; column < order; ++column)
      result(row, column) = FieldElement(field, rationals_of(rows[row][column]));
  }
  return result;
}

FieldMatrix translation(std::size_t order, std::size_t axis) {
  FieldMatrix result = FieldMatrix::identity(order);
  result(axis + 1, 0) = FieldElement(1);
  return result;
}

}  // namespace

SpaceFormDescription space_form_of(const CertificateSummary& certificate) {
  const Json json = manifold_json(certificate);
  const auto m = static_cast<std::size_t>(certificate.manifold.dimension.value);
  const std::vector<Rational> root = rationals_of(json.at("root"));
  if (root.size() != 2) throw InputError("manifold.root is not two numbers");
  const auto field = std::make_shared<const NumberField>(rationals_of(json.at("field")), root[0], root[1]);
  SpaceFormDescription result{
      certificate.manifold.name,
      InvariantForm(FieldElement(field, rationals_of(json.at("time"))), matrix_of(json.at("gram"), field, m)),
      {},
      std::nullopt,
      std::nullopt};
  for (const auto& generator : json.at("generators")) result.generators.push_back(matrix_of(generator, field, m + 1));
  return result;
}

std::vector<FieldMatrix> elements_of(const CertificateSummary& certificate, const SpaceFormDescription& description) {
  const auto m = static_cast<std::size_t>(description.form.dimension());
  std::vector<FieldMatrix> letters = description.generators;
  if (description.form.curvature() == Curvature::zero) {
    for (std::size_t axis = 0; axis < m; ++axis) letters.push_back(translation(m + 1, axis));
  }
  std::vector<FieldMatrix> result{FieldMatrix::identity(m + 1)};
  for (const auto& entry : certificate.elements) {
    const auto parent = static_cast<std::size_t>(entry.at(0));
    const std::int32_t letter = entry.at(1);
    const auto number = static_cast<std::size_t>(std::abs(std::int64_t{letter}));
    if (parent >= result.size() || number == 0 || number > letters.size())
      throw InputError("elements: one is no product of an earlier one and a letter");
    const FieldMatrix& matrix = letters[number - 1];
    result.push_back(result[parent] * (letter > 0 ? matrix : description.form.inverse_of(matrix)));
  }
  return result;
}

}  // namespace delcert
