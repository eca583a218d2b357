#pragma once

#include <set>
#include <string>
#include <vector>

namespace delcert::checker_tests {

/// A certificate with something false in it and a seal that fits.
struct Forgery {
  std::string name;
  std::string rule;  // a rule that rejects it
  std::string bytes;
  int status = 1;
  std::set<std::string> others{};  // the other rules that reject it; if there are none, this forgery tests the rule
};

std::vector<Forgery> form_forgeries();
std::vector<Forgery> level_0_forgeries();
std::vector<Forgery> star_forgeries();  // levels 1, 2, 2s
std::vector<Forgery> core_forgeries();
std::vector<Forgery> configuration_forgeries();
std::vector<Forgery> space_form_forgeries();
/// In metric_field_test.cpp and metric_field_delaunay_test.cpp, as they are made from a run.
std::vector<Forgery> metric_field_forgeries();
std::vector<Forgery> metric_field_delaunay_forgeries();
/// In atlas_test.cpp.
std::vector<Forgery> atlas_forgeries();
/// In submanifold_test.cpp.
std::vector<Forgery> submanifold_forgeries();

/// What one of these makes: made when it is first asked for, and kept.
const std::vector<Forgery>& made_once(std::vector<Forgery> (*make)());

/// The certificates from which the forgeries are made, by name; they are valid.
std::vector<std::pair<std::string, std::string>> valid_certificates();
/// Tori with radii that vary.
std::vector<std::pair<std::string, std::string>> valid_graded_certificates();
std::vector<std::pair<std::string, std::string>> valid_space_form_certificates();
/// Of an octahedron that claims levels 2, 4, 5 and 6 and no injectivity radius.
std::pair<std::string, std::string> valid_certificate_of_a_complex();

}  // namespace delcert::checker_tests
