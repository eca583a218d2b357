#pragma once

#include <optional>

#include "proofs/checker/certificate/certificate.hpp"
#include "proofs/checker/core/flat_simplices.hpp"

namespace delcert::checker::core {

/// The rules of docs/levels/core.md for levels 2, 4, 5 and 6 of a flat torus or a space form; those of level 2 first,
/// the others only if these hold. Each returns in words what was looked at. Throws Undecided.
class Core {
 public:
  explicit Core(const Certificate& c);
  Core(const Core&) = delete;
  Core& operator=(const Core&) = delete;

  void check_manifold(Report& report);
  /// core.group and core.connected: with levels 4 and 5, and wherever lifts are found. Looked at once.
  void check_quotient(Report& report);
  /// Whether core.hinges holds. Looked at once.
  bool is_delaunay();
  /// Whether those rules hold, too.
  bool is_delaunay_quotient();
  std::string check_delaunay(Report& report);       // 4
  std::string check_triangulation(Report& report);  // 5
  std::string check_metric(Report& report);         // 6

  /// Precondition: check_manifold() has found that the generators are isometries.
  Complex& complex() { return *complex_; }
  /// With all of its edges and facets; none if the generators are no isometries or only a chunk has been read.
  const Complex* with_facets() const { return complex_ && c_.chunk == nullptr ? &*complex_ : nullptr; }
  /// Of a flat torus of dimension 2 or 3, else none. Precondition: core.edges holds.
  FlatSimplices* flat();

 private:
  const Certificate& c_;
  const Data data_;
  std::optional<Complex> complex_;
  std::optional<FlatSimplices> flat_;
  std::optional<Report> quotient_, hinges_;
};

}  // namespace delcert::checker::core
