#include "proofs/certificate/space_form_writer.hpp"

#include <fmt/format.h>

namespace delcert {

namespace {

using Field = FieldElement::Field;

Field field_of(const SpaceForm& form) {
  if (form.form().time().field()) return form.form().time().field();
  std::vector<const FieldMatrix*> matrices{&form.form().gram()};
  for (const FieldMatrix& generator : form.description.generators) matrices.push_back(&generator);
  for (const FieldMatrix* matrix : matrices) {
    for (std::size_t row = 0; row < matrix->order(); ++row) {
      for (std::size_t column = 0; column < matrix->order(); ++column) {
        if ((*matrix)(row, column).field()) return (*matrix)(row, column).field();
      }
    }
  }
  return nullptr;
}

/// The polynomial and two numbers around its root, so close that no other one of it or of its derivative is between.
std::string field_entries(const Field& field) {
  if (!field) return R"("field":["0","1"],"root":["-1","1"])";
  std::vector<Rational> coefficients;
  for (long k = 0; k <= field->degree(); ++k) {
    Rational::Wrapped coefficient;
    fmpq_poly_get_coeff_mpq(coefficient.backend().data(), field->modulus(), k);
    coefficients.emplace_back(coefficient);
  }
  const BigInterval root = field->root();
  return "\"field\":" + listed(coefficients, number) + ",\"root\":[" + number(rounded_down(root.lower(), -64)) + "," +
         number(rounded_up(root.upper(), -64)) + "]";
}

std::string element_text(const FieldElement& x) {
  const std::vector<Rational> coefficients = x.coefficients();
  return coefficients.empty() ? "[\"0\"]" : listed(coefficients, number);
}

std::string field_matrix_text(const FieldMatrix& a) {
  std::vector<std::string> rows;
  for (std::size_t row = 0; row < a.order(); ++row) {
    std::vector<FieldElement> entries;
    for (std::size_t column = 0; column < a.order(); ++column) entries.push_back(a(row, column));
    rows.push_back(listed(entries, element_text));
  }
  return listed(rows, [](const std::string& row) { return row; });
}

std::string levels_text(const SpaceFormClaims& claims) {
  std::vector<std::string> levels;
  if (claims.density) {
    levels.push_back(fmt::format("\"0\":{{\"density\":{},\"distortion\":{},\"metric_distortion\":{}}}",
                                 number(*claims.density), number(claims.distortion), number(claims.metric_distortion)));
  }
  if (claims.stars) levels.push_back("\"1\":" + star_margins_object(*claims.stars));
  if (claims.manifold) levels.push_back("\"2\":" + manifold_claim_object(*claims.manifold));
  if (claims.reach) levels.push_back(fmt::format("\"2s\":{{\"reach\":{}}}", number(*claims.reach)));
  if (claims.delaunay) {
    levels.push_back(fmt::format("\"4\":{{\"protection\":{},\"circumradius\":{}}}", number(claims.delaunay->protection),
                                 number(claims.delaunay->circumradius)));
  }
  if (claims.triangulation) {
    const std::string more = claims.riemannian
                                 ? fmt::format(",\"thickness\":{},\"radius\":{}", number(claims.riemannian->thickness),
                                               number(claims.riemannian->radius))
                                 : std::string();
    levels.push_back("\"5\":{\"route\":\"space-form\"" + more + "}");
  }
  if (claims.metric) {
    const std::string weight = claims.metric->weight ? ",\"weight\":" + number(*claims.metric->weight) : std::string();
    levels.push_back(fmt::format("\"6\":{{\"self_delaunay\":{}{},\"bilipschitz\":[{},{}]}}",
                                 claims.metric->weight.has_value(), weight, number(claims.metric->least_stretch),
                                 number(claims.metric->greatest_stretch)));
  }
  return "{" + fmt::format("{}", fmt::join(levels, ",")) + "}";
}

}  // namespace

std::string_view family_of(Curvature curvature) {
  return curvature == Curvature::positive ? "spherical" : curvature == Curvature::zero ? "flat" : "hyperbolic";
}

std::string manifold_object(const SpaceForm& form) {
  return fmt::format(
      "{{\"name\":{},\"family\":\"{}\",\"dimension\":{},{},\"time\":{},\"gram\":{},\"generators\":{},"
      "\"injectivity_radius\":{}}}",
      quoted(form.description.name), family_of(form.form().curvature()), form.form().dimension(),
      field_entries(field_of(form)), element_text(form.form().time()), field_matrix_text(form.form().gram()),
      listed(form.description.generators, field_matrix_text), number(form.injectivity_radius.lower));
}

template <int m>
void write_space_form_certificate(const std::filesystem::path& path, const SpaceFormContent<m>& content,
                                  const Progress& progress) {
  const std::size_t count = content.centres.size();
  Document document(path, 2 * count + content.complex.simplices.size(), progress);
  document.add(R"({"format":"delcert-certificate","version":2,"software":)" + software_object());
  document.add(",\"manifold\":" + manifold_object(content.form));
  document.add(",\"parameters\":" + parameters_object(content.parameters, content.sampling_radius));
  document.add(",\"levels\":" + levels_text(content.claims));
  document.add_array("net", count, [&](std::size_t at) { return listed(content.centres[at], number); });
  document.add(",\"net_simplices\":[]");
  document.add_array("points", count, [&](std::size_t at) { return listed(content.vectors[at], number); });
  add_complex<m>(document, content.complex);
  document.seal();
}

template void write_space_form_certificate<2>(const std::filesystem::path&, const SpaceFormContent<2>&,
                                              const Progress&);
template void write_space_form_certificate<3>(const std::filesystem::path&, const SpaceFormContent<3>&,
                                              const Progress&);

}  // namespace delcert
