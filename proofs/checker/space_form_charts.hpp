#pragma once

#include "proofs/checker/chart_stars.hpp"
#include "proofs/checker/lifts.hpp"

namespace delcert::checker {

/// The charts of a space form: about an original point p_i, the inverse of exp.
class SpaceFormCharts : public StarCharts<Ball> {
 public:
  SpaceFormCharts(const Certificate& c, const Lifts& lifts) : StarCharts(c), lifts_(lifts) {}

  ShownPoints<Ball> shown(Label i, const Quantity& radius) const override;
  Vector<Interval> home(Label i, In<Interval>) const override { return lifts_.vector_of<Interval>(i); }
  Vector<Ball> home(Label i, In<Ball>) const override { return lifts_.vector_of<Ball>(i); }
  std::string fault_of_patches(Level level) const override;
  bool are_isometric() const override { return c_.space_form->K == 0; }

 private:
  const Lifts& lifts_;
};

}  // namespace delcert::checker
