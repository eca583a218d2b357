#pragma once

#include <functional>
#include <string>

#include "proofs/checker/chart.hpp"
#include "proofs/checker/report.hpp"

namespace delcert::checker {

// The levels of space forms other than 2, which is that of all families. As those of run.hpp; the group has been
// verified.
std::string check_input_on_space_form(const Certificate& c, const Lifts& lifts, Report& report);          // 0
std::string check_stars_in_charts(const Certificate& c, const Lifts& lifts, Report& report);              // 1
std::string check_stable_stars_in_charts(const Certificate& c, const Lifts& lifts, Report& report);       // 2s
std::string check_delaunay_on_space_form(const Certificate& c, const Lifts& lifts, Report& report);       // 4
std::string check_triangulation_of_space_form(const Certificate& c, const Lifts& lifts, Report& report);  // 5
std::string check_metric_of_space_form(const Certificate& c, const Lifts& lifts, Report& report);         // 6

/// The rules 0.distortion and 0.metric-distortion.
void check_distortion(const Certificate& c, Report& report);

/// reach < 9 epsilon and reach < injectivity radius: a chart shows one lift of a label at most.
bool is_shown_by_charts(const Certificate& c, const Rational& reach);

/// "simplex {3, 17, 90} in the star of 5".
std::string simplex_of_star(const Certificate& c, Label i, const Label* others);

/// For all labels i and all simplices of star(i) of which i is the smallest label: f(chart of i, simplex, the other
/// labels). The chart shows reach_4. Returns a simplex with a label that it does not show, if there is one: 4.lifts
/// rejects it, and it is left out.
std::string for_each_simplex(const Certificate& c, const Lifts& lifts,
                             const std::function<void(const Chart&, const ChartSimplex&, Label, const Label*)>& f);

/// The circumball of a simplex in conformal coordinates, by its centre c and radius R there.
template <class N>
struct ConformalBall {
  N centre_squared;  // |c|^2
  N radius_squared;  // R^2
  N weight;          // w = 1 + K (|c|^2 - R^2) / 4: the radius rho has tan_K rho = R / w
  ConformalBall(const Certificate& certificate, const Simplex<N>& simplex, const Vector<N>& first)
      : centre_squared(squared(add(first, N(1), simplex.centre), certificate.m_size())),
        radius_squared(simplex.radius_squared),
        weight(N(1) + N(certificate.space_form->K) * (centre_squared - radius_squared) / N(4)) {}
};

}  // namespace delcert::checker
