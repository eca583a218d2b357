#include "properties/instances/net_lipschitz.hpp"

#include <nlohmann/json.hpp>

#include "kernel/number/exact_text.hpp"
#include "proofs/formula/simplex_object.hpp"
#include "support/error.hpp"

namespace delcert {

namespace {

template <class S>
S distance_of(const std::vector<Rational>& a, const std::vector<Rational>& b) {
  if (a.size() != b.size()) throw InputError("points of different dimensions");
  Rational squared(0);
  for (std::size_t axis = 0; axis < a.size(); ++axis) squared += square(a[axis] - b[axis]);
  return square_root(scalar_from<S>(squared));
}

}  // namespace

SizingObject::SizingObject(Rational slope, std::vector<Cone> cones)
    : slope_(std::move(slope)), cones_(std::move(cones)) {
  if (slope_ < Rational(0)) throw InputError("the slope of a sizing function is negative");
  if (cones_.empty()) throw InputError("a sizing function has a cone");
  for (const Cone& cone : cones_) {
    if (cone.height <= Rational(0)) throw InputError("the height of a cone is not above 0");
    if (cone.apex.empty() || cone.apex.size() != cones_.front().apex.size()) {
      throw InputError("apexes of different dimensions");
    }
  }
}

nlohmann::ordered_json SizingObject::json() const {
  nlohmann::ordered_json result;
  result["slope"] = exact_text(slope_);
  result["cones"] = nlohmann::ordered_json::array();
  for (const Cone& cone : cones_) {
    result["cones"].push_back({{"apex", json_of(cone.apex)}, {"height", exact_text(cone.height)}});
  }
  return result;
}

ObjectPointer SizingObject::read(const nlohmann::ordered_json& json) {
  try {
    std::vector<Cone> cones;
    for (const auto& cone : json.at("cones")) {
      cones.push_back({rationals_from(cone.at("apex"), "apex"), parse_exact(cone.at("height").get<std::string>())});
    }
    return std::make_shared<SizingObject>(parse_exact(json.at("slope").get<std::string>()), std::move(cones));
  } catch (const nlohmann::json::exception& error) {
    throw InputError(std::string("a sizing function: ") + error.what());
  }
}

void add_sizing_quantities(Vocabulary& vocabulary) {
  vocabulary.add_kind("sizing", SizingObject::read);
  vocabulary.add(number_function("sizing", {types::sizing, types::point}, "The value of a sizing function, a length.",
                                 "{#1}(#2)", []<class S>(Evaluation<S>&, Arguments<S> a) -> Partial<S> {
                                   const auto& function = object_of<SizingObject>(a[0]);
                                   const auto& x = object_of<PointObject>(a[1]).coordinates();
                                   std::optional<S> least;
                                   for (const auto& cone : function.cones()) {
                                     const S value = scalar_from<S>(cone.height) +
                                                     scalar_from<S>(function.slope()) * distance_of<S>(x, cone.apex);
                                     least = least ? S(minimum(*least, value)) : value;
                                   }
                                   return *least;
                                 }));
  vocabulary.add(number_function(
      "point_distance", {types::point, types::point}, "The distance of two points, a length.", "\\lVert #1 - #2\\rVert",
      []<class S>(Evaluation<S>&, Arguments<S> a) -> Partial<S> {
        return distance_of<S>(object_of<PointObject>(a[0]).coordinates(), object_of<PointObject>(a[1]).coordinates());
      }));
}

}  // namespace delcert
