#include <map>

#include "tests/checker/support/forgeries.hpp"

namespace delcert::checker_tests {

const std::vector<Forgery>& made_once(std::vector<Forgery> (*make)()) {
  static std::map<std::vector<Forgery> (*)(), std::vector<Forgery>> made;
  const auto place = made.find(make);
  return place != made.end() ? place->second : made.emplace(make, make()).first->second;
}

}  // namespace delcert::checker_tests
