#include "proofs/checker/space_forms/group.hpp"

#include <algorithm>

#include "proofs/checker/arithmetic/abelian_group.hpp"
#include "proofs/checker/arithmetic/smith_form.hpp"

namespace delcert::checker {
namespace {

bool is_integer(const FieldElement& x) { return x.is_rational() && fmpz_is_one(fmpq_denref(x.constant_term().raw())); }

/// Why the matrix is no isometry of the model space other than the identity; empty if it is one.
std::string fault_of(const SpaceForm& form, const FieldMatrix& a) {
  const std::size_t size = form.m + 1;
  if (a == FieldMatrix::identity(size)) return "is the identity";
  if (form.K != 0) {
    const FieldMatrix J = form.form();
    if (!(a.transposed() * J * a == J)) return "does not preserve the form";
    return form.K < 0 && a(0, 0).sign() <= 0 ? "takes x_0 > 0 to x_0 < 0" : "";
  }
  FieldMatrix linear(form.m);
  for (std::size_t i = 0; i < size; ++i) {
    if (!(a(0, i) == FieldElement(i == 0 ? 1 : 0))) return "has not the first row 1, 0, ..., 0";
    if (!a(i, 0).is_rational()) return "has a translation that is not rational";
    for (std::size_t k = 1; i > 0 && k < size; ++k) {
      if (!is_integer(a(i, k))) return "does not preserve the lattice";
      linear(i - 1, k - 1) = a(i, k);
    }
  }
  return linear.transposed() * form.gram * linear == form.gram ? "" : "does not preserve the form";
}

}  // namespace

Group check_group(const SpaceForm& form, Report& report) {
  for (std::size_t g = 0; g < form.generators.size(); ++g) {
    const std::string fault = fault_of(form, form.generators[g]);
    if (!fault.empty())
      report.reject("group.generator", [&] { return "generator " + std::to_string(g) + " " + fault; });
  }
  if (!report.findings.empty()) return {};
  return form.K > 0    ? spherical_group(form, report)
         : form.K == 0 ? flat_group(form, report)
                       : hyperbolic_group(form, report);
}

bool keeps_orientation(const SpaceForm& form) {
  return std::all_of(form.generators.begin(), form.generators.end(),
                     [](const FieldMatrix& g) { return g.leading_minor(g.order()).sign() > 0; });
}

std::string first_homology(const Group& group) {
  std::vector<Column> columns;
  for (const std::vector<std::int64_t>& relation : group.relations) {
    Column column;
    for (std::size_t k = group.letters; k-- > 0;) {
      if (relation[k] != 0) column.push_back({static_cast<std::uint32_t>(k), relation[k]});
    }
    columns.push_back(std::move(column));
  }
  std::vector<bool> used_rows(group.letters), used_columns(columns.size());
  const SmithForm form = reduce(std::move(columns), group.letters, used_rows, used_columns);
  return group_text(group.letters - form.rank, form.torsion);
}

}  // namespace delcert::checker
