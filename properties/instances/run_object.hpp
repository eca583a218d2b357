#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "proofs/certificate/claims.hpp"
#include "proofs/certificate/run_parameters.hpp"
#include "proofs/formula/vocabulary.hpp"

namespace delcert {

namespace types {
inline const Type run{"run", false};
}  // namespace types

/// What a run is made of; the run follows from it, the same everywhere.
struct RunRecipe {
  std::string manifold = "torus-2";  ///< a built-in flat torus
  /// Of the Poisson-disk net; for a lattice 0.
  Rational radius;
  /// Of the lattice net; for a Poisson-disk net 0.
  std::uint32_t divisions = 0;
  bool centred = false;
  std::uint64_t net_seed = 0;
  RunMode mode = RunMode::theory;
  /// ρ₀ as a part of μ₀/4, in (0, 1].
  Rational perturbation_share = Rational(1);
  std::uint64_t seed = 0;
};

/// A finished run of the algorithm on a flat torus, with what is certified of it.
class RunObject : public Object {
 public:
  /// Runs. Throws InputError for an invalid recipe, Rejection where there is no net or no good perturbation.
  /// Precondition: rounding to nearest.
  explicit RunObject(RunRecipe recipe);

  [[nodiscard]] const RunRecipe& recipe() const { return recipe_; }
  [[nodiscard]] int dimension() const { return dimension_; }
  [[nodiscard]] const Rational& sampling_radius() const { return sampling_radius_; }
  [[nodiscard]] const Rational& separation() const { return separation_; }
  [[nodiscard]] const Rational& perturbation() const { return perturbation_; }
  /// Hypotheses 1 item by item, Hypotheses 2, and the perturbation is the algorithm's.
  [[nodiscard]] Verdict hypotheses() const { return hypotheses_; }
  /// Whether every star is certified to be one of protected simplices; refuted by a simplex that is not protected.
  [[nodiscard]] Verdict stars() const { return stars_; }
  /// What levels were reached. Empty unless the stars are certified and Hypotheses 1 hold.
  [[nodiscard]] const Claims& claims() const { return claims_; }
  /// Refuted if a set with P1 … P4 was found.
  [[nodiscard]] Verdict no_forbidden() const { return no_forbidden_; }
  /// Bounds of the covering radius and of the least distance of the perturbed points.
  [[nodiscard]] const Rational& covering_lower() const { return covering_lower_; }
  [[nodiscard]] const Rational& covering_upper() const { return covering_upper_; }
  [[nodiscard]] const Rational& distance_lower() const { return distance_lower_; }
  [[nodiscard]] const Rational& distance_upper() const { return distance_upper_; }
  /// The squared edges of each simplex, |p_j − p_i|² for i < j in lexicographic order.
  [[nodiscard]] const std::vector<std::vector<Rational>>& squared_edges() const { return squared_edges_; }

  [[nodiscard]] nlohmann::ordered_json json() const override;
  [[nodiscard]] static ObjectPointer read(const nlohmann::ordered_json& json);

 private:
  template <int m>
  void run();

  RunRecipe recipe_;
  int dimension_ = 0;
  Rational sampling_radius_;
  Rational separation_;
  Rational perturbation_;
  Verdict hypotheses_ = Verdict::undecided;
  Verdict stars_ = Verdict::undecided;
  Verdict no_forbidden_ = Verdict::undecided;
  Claims claims_;
  Rational covering_lower_;
  Rational covering_upper_;
  Rational distance_lower_;
  Rational distance_upper_;
  std::vector<std::vector<Rational>> squared_edges_;
};

}  // namespace delcert
