#include "proofs/drawing/formats/lattice_format.hpp"

#include <fmt/format.h>

#include <iterator>

#include "kernel/number/exact_text.hpp"
#include "proofs/drawing/formats/number_text.hpp"
#include "proofs/drawing/manifold/manifold_json.hpp"
#include "support/error.hpp"

namespace delcert {

namespace {

using Rows = std::vector<std::vector<Rational>>;

Rows gram_matrix(const CertificateSummary& certificate) {
  Rows result;
  const nlohmann::ordered_json manifold = manifold_json(certificate);
  for (const auto& row : manifold.at("gram")) {
    result.emplace_back();
    for (const auto& entry : row) result.back().push_back(parse_exact(entry.get<std::string>()));
  }
  return result;
}

/// The least integer that makes all entries integers.
Integer common_denominator(const Rows& rows) {
  Integer result = 1;
  for (const auto& row : rows) {
    for (const Rational& entry : row) result = boost::multiprecision::lcm(result, entry.denominator());
  }
  return result;
}

/// A line for each row, times a common denominator.
void append_rows(std::string& text, const Rows& rows, const Integer& denominator) {
  for (const auto& row : rows) {
    for (std::size_t k = 0; k < row.size(); ++k) {
      if (k > 0) text += ' ';
      text += Integer(row[k].numerator() * (denominator / row[k].denominator())).str();
    }
    text += '\n';
  }
}

}  // namespace

void require_lattice(const CertificateSummary& certificate) {
  if (certificate.family != "flat-torus")
    throw InputError("lattice holds triangulations of flat tori, and this one is of the family " + certificate.family);
}

std::string lattice_text(const ExportContent& content) {
  const CertificateSummary& certificate = content.certificate;
  if (!content.note.empty())
    throw InputError("lattice holds the points of the certificate: a simplified complex does not fit them");
  const auto m = static_cast<std::size_t>(certificate.manifold.dimension.value);
  std::string text = "# " + content.origin() + "\n";
  auto out = std::back_inserter(text);
  const Integer period = common_denominator(certificate.points);
  fmt::format_to(out, "delcert-lattice 1\ndimension {}\nperiod {}\ngram\n", m, period.str());
  const Rows gram = gram_matrix(certificate);
  append_rows(text, gram, common_denominator(gram));
  fmt::format_to(out, "points {}\n", certificate.points.size());
  append_rows(text, certificate.points, period);
  fmt::format_to(out, "simplices {}\n", certificate.simplices.size());
  for (const auto& row : certificate.simplices) {
    for (std::size_t k = 0; k <= m; ++k) {
      // m + 1 labels, then the numbers of m elements: of the first vertex it is 0, the identity.
      const std::uint32_t element = k == 0 ? 0 : row.at(m + k);
      if (k > 0) text += "  ";
      append_number(text, row.at(k));
      for (std::size_t axis = 0; axis < m; ++axis) {
        text += ' ';
        append_number(text, element == 0 ? 0 : certificate.elements.at(element - 1).at(axis));
      }
    }
    text += '\n';
  }
  return text;
}

}  // namespace delcert
