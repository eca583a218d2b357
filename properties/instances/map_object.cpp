#include "properties/instances/map_object.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "kernel/manifold/any_manifold.hpp"
#include "kernel/number/exact_text.hpp"
#include "kernel/number/ladder.hpp"
#include "kernel/simplex/gram_elimination.hpp"
#include "kernel/simplex/matrix_norm.hpp"
#include "support/error.hpp"

namespace delcert {

namespace {

using Json = nlohmann::ordered_json;

template <class... F>
struct Overloaded : F... {
  using F::operator()...;
};
template <class... F>
Overloaded(F...) -> Overloaded<F...>;

ExactPoint translated(const ExactPoint& a, const ExactPoint& b) {
  ExactPoint result = a;
  for (std::size_t axis = 0; axis < a.size(); ++axis) result[axis] += b[axis];
  return result;
}

std::size_t dimension_of(const MapObject::Form& form) {
  return std::visit(Overloaded{[](const LinearMap& map) { return map.translation.size(); },
                               [](const InversionMap& map) { return map.pole.size(); },
                               [](const SmoothMap& map) { return map.bumps.front().shift.size(); },
                               [](const TransitionMap& map) { return map.translation.size(); },
                               [](const FiniteMap& map) { return map.points.front().size(); }},
                    form);
}

std::optional<ExactPoint> image_under(const LinearMap& map, const ExactPoint& x) {
  ExactPoint result = map.translation;
  for (std::size_t row = 0; row < result.size(); ++row) result[row] += pairing(map.rows[row], x);
  return result;
}

std::optional<ExactPoint> image_under(const InversionMap& map, const ExactPoint& x) {
  const Rational squared = squared_distance_between(x, map.pole);
  if (squared == Rational(0)) return std::nullopt;
  ExactPoint result = map.pole;
  for (std::size_t axis = 0; axis < x.size(); ++axis) {
    result[axis] += map.squared_power * (x[axis] - map.pole[axis]) / squared;
  }
  return result;
}

std::optional<ExactPoint> image_under(const SmoothMap& map, const ExactPoint& x) {
  ExactPoint result = x;
  for (const auto& bump : map.bumps) {
    const Rational height = Rational(1) / (Rational(1) + square(pairing(bump.covector, x) + bump.offset));
    for (std::size_t axis = 0; axis < x.size(); ++axis) result[axis] += height * bump.shift[axis];
  }
  return result;
}

std::optional<ExactPoint> image_under(const TransitionMap& map, const ExactPoint& x) {
  return translated(x, map.translation);
}

std::optional<ExactPoint> image_under(const FiniteMap& map, const ExactPoint& x) {
  const auto found = std::find(map.points.begin(), map.points.end(), x);
  if (found == map.points.end()) return std::nullopt;
  return map.images[static_cast<std::size_t>(found - map.points.begin())];
}

/// (1 − ξ)²I ≤ AᵀA ≤ (1 + ξ)²I.
bool is_certified(const LinearMap& map, const Rational& xi) {
  std::vector<ExactPoint> columns(map.rows.size(), ExactPoint(map.rows.size()));
  for (std::size_t row = 0; row < map.rows.size(); ++row) {
    for (std::size_t column = 0; column < map.rows.size(); ++column) columns[column][row] = map.rows[row][column];
  }
  const auto gram = gram_of_columns(std::span<const ExactPoint>(columns));
  const auto semidefinite = [](const SymmetricMatrix<Rational>& matrix) {
    return is_proved(decide([&]<class S>() { return GramElimination<S>(matrix_from<S>(matrix)).semidefinite(); }));
  };
  const bool is_short = semidefinite(gram.negated().shifted(square(Rational(1) + xi)));
  return is_short && (xi >= Rational(1) || semidefinite(gram.shifted(-square(Rational(1) - xi))));
}

/// Distances change by the factor ρ²/(|x − q||y − q|).
bool is_certified(const InversionMap& map, const Rational& xi) {
  const Rational least = map.distance - map.radius;
  const Rational greatest = map.distance + map.radius;
  return map.squared_power <= (Rational(1) + xi) * square(least) &&
         map.squared_power >= (Rational(1) - xi) * square(greatest);
}

bool is_certified(const SmoothMap& map, const Rational& xi) { return lipschitz_bound(map) <= xi; }

bool is_certified(const TransitionMap&, const Rational& xi) { return xi >= Rational(0); }

bool is_certified(const FiniteMap& map, const Rational& xi) {
  for (std::size_t i = 0; i < map.domain_count; ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const Rational before = squared_distance_between(map.points[i], map.points[j]);
      const Rational after = squared_distance_between(map.images[i], map.images[j]);
      if (after > square(Rational(1) + xi) * before) return false;
      if (xi < Rational(1) && after < square(Rational(1) - xi) * before) return false;
    }
  }
  return true;
}

Json json_of_points(const std::vector<ExactPoint>& points) {
  Json result = Json::array();
  for (const auto& point : points) result.push_back(json_of(point));
  return result;
}

std::vector<ExactPoint> points_from(const Json& json, const std::string& where) {
  if (!json.is_array() || json.empty()) throw InputError(where + " is not a list of points");
  std::vector<ExactPoint> result;
  for (const Json& point : json) {
    result.push_back(rationals_from(point, where));
    if (result.back().empty() || result.back().size() != result.front().size()) {
      throw InputError(where + " has points of different dimensions, or of dimension 0");
    }
  }
  return result;
}

const Json& member(const Json& json, const std::string& key) {
  if (!json.contains(key)) throw InputError("a map lacks " + key);
  return json.at(key);
}

Rational rational_from(const Json& json, const std::string& key) {
  const Json& value = member(json, key);
  if (!value.is_string()) throw InputError(key + " of a map is not an exact number in quotes");
  return parse_exact(value.get<std::string>());
}

ExactPoint point_from(const Json& json, const std::string& key) {
  auto result = rationals_from(member(json, key), key);
  if (result.empty()) throw InputError(key + " of a map is a point of dimension 0");
  return result;
}

void require_same_dimension(const ExactPoint& a, const ExactPoint& b) {
  if (a.size() != b.size()) throw InputError("a map has points of different dimensions");
}

LinearMap linear_from(const Json& json) {
  LinearMap result{points_from(member(json, "rows"), "rows"), point_from(json, "translation")};
  require_same_dimension(result.rows.front(), result.translation);
  if (result.rows.size() != result.translation.size()) throw InputError("a linear map is not square");
  return result;
}

InversionMap inversion_from(const Json& json) {
  InversionMap result{point_from(json, "pole"), rational_from(json, "squared_power"), point_from(json, "centre"),
                      rational_from(json, "radius"), rational_from(json, "distance")};
  require_same_dimension(result.pole, result.centre);
  if (square(result.distance) != squared_distance_between(result.pole, result.centre) ||
      result.distance <= result.radius || result.radius < Rational(0) || result.squared_power <= Rational(0)) {
    throw InputError("an inversion whose pole does not lie outside the ball at the distance given");
  }
  return result;
}

SmoothMap smooth_from(const Json& json) {
  SmoothMap result;
  const Json& bumps = member(json, "bumps");
  if (!bumps.is_array() || bumps.empty()) throw InputError("a smooth map has no bumps");
  for (const Json& bump : bumps) {
    result.bumps.push_back({point_from(bump, "shift"), point_from(bump, "covector"), rational_from(bump, "offset")});
    require_same_dimension(result.bumps.back().shift, result.bumps.front().shift);
    require_same_dimension(result.bumps.back().covector, result.bumps.front().shift);
  }
  return result;
}

TransitionMap transition_from(const Json& json) {
  TransitionMap result;
  const Json& name = member(json, "manifold");
  if (!name.is_string()) throw InputError("the manifold of a transition is not a name");
  result.manifold = name.get<std::string>();
  const auto basis = rational_lattice(result.manifold);
  if (!basis) throw InputError("the lattice of " + result.manifold + " has no rational Cartesian coordinates");
  const Json& lift = member(json, "lift");
  if (!lift.is_array() || lift.size() != basis->size()) throw InputError("the lift of a transition does not fit");
  result.translation = point_from(json, "translation");
  ExactPoint expected(result.translation.size(), Rational(0));
  for (std::size_t i = 0; i < lift.size(); ++i) {
    if (!lift[i].is_number_integer()) throw InputError("the lift of a transition is not made of integers");
    result.lift.push_back(lift[i].get<long>());
    require_same_dimension((*basis)[i], expected);
    for (std::size_t axis = 0; axis < expected.size(); ++axis) {
      expected[axis] += Rational(result.lift.back()) * (*basis)[i][axis];
    }
  }
  if (expected != result.translation) throw InputError("the translation of a transition is not that of its lift");
  return result;
}

FiniteMap finite_from(const Json& json) {
  FiniteMap result{points_from(member(json, "points"), "points"), points_from(member(json, "images"), "images"), 0};
  const Json& count = member(json, "domain_count");
  if (!count.is_number_unsigned()) throw InputError("domain_count of a map is not a number");
  result.domain_count = count.get<std::size_t>();
  require_same_dimension(result.points.front(), result.images.front());
  if (result.points.size() != result.images.size() || result.domain_count > result.points.size()) {
    throw InputError("a finite map has not as many images as points");
  }
  return result;
}

}  // namespace

Rational squared_distance_between(const ExactPoint& a, const ExactPoint& b) {
  Rational result(0);
  for (std::size_t axis = 0; axis < a.size(); ++axis) result += square(a[axis] - b[axis]);
  return result;
}

Rational lipschitz_bound(const SmoothMap& map) {
  constexpr unsigned bits = 60;
  Rational sum(0);
  for (const auto& bump : map.bumps) {
    sum += square_root_upper(pairing(bump.shift, bump.shift) * pairing(bump.covector, bump.covector), bits);
  }
  return Rational(13) / Rational(20) * sum;
}

std::optional<std::vector<ExactPoint>> rational_lattice(const std::string& manifold) {
  const ManifoldDescription description = find_manifold(manifold);
  if (description.family == ManifoldFamily::euclidean_ball) return std::vector<ExactPoint>{};
  const std::size_t order = description.gram.size();
  std::vector<ExactPoint> basis(order, ExactPoint(order, Rational(0)));
  for (std::size_t row = 0; row < order; ++row) {
    for (std::size_t column = 0; column <= row; ++column) {
      Rational rest = description.gram[row][column];
      for (std::size_t before = 0; before < column; ++before) rest -= basis[row][before] * basis[column][before];
      if (column < row) {
        basis[row][column] = rest / basis[column][column];
        continue;
      }
      const Rational root(boost::multiprecision::sqrt(rest.numerator()),
                          boost::multiprecision::sqrt(rest.denominator()));
      if (square(root) != rest) return std::nullopt;
      basis[row][row] = root;
    }
  }
  return basis;
}

std::optional<ExactPoint> MapObject::image(const ExactPoint& x) const {
  if (x.size() != dimension_of(form_)) return std::nullopt;
  return std::visit([&](const auto& map) { return image_under(map, x); }, form_);
}

bool MapObject::is_in_domain(const ExactPoint& x) const {
  if (x.size() != dimension_of(form_)) return false;
  if (const auto* inversion = std::get_if<InversionMap>(&form_)) {
    return squared_distance_between(x, inversion->centre) <= square(inversion->radius);
  }
  if (const auto* finite = std::get_if<FiniteMap>(&form_)) {
    const auto end = finite->points.begin() + static_cast<std::ptrdiff_t>(finite->domain_count);
    return std::find(finite->points.begin(), end, x) != end;
  }
  return true;
}

bool MapObject::has_distortion(const Rational& xi) const {
  return std::visit([&](const auto& map) { return is_certified(map, xi); }, form_);
}

std::string MapObject::form_name() const {
  return std::visit(
      Overloaded{[](const LinearMap&) { return "linear"; }, [](const InversionMap&) { return "inversion"; },
                 [](const SmoothMap&) { return "smooth"; }, [](const TransitionMap&) { return "transition"; },
                 [](const FiniteMap&) { return "finite"; }},
      form_);
}

Json MapObject::json() const {
  Json result;
  result["form"] = form_name();
  std::visit(Overloaded{[&](const LinearMap& map) {
                          result["rows"] = json_of_points(map.rows);
                          result["translation"] = json_of(map.translation);
                        },
                        [&](const InversionMap& map) {
                          result["pole"] = json_of(map.pole);
                          result["squared_power"] = exact_text(map.squared_power);
                          result["centre"] = json_of(map.centre);
                          result["radius"] = exact_text(map.radius);
                          result["distance"] = exact_text(map.distance);
                        },
                        [&](const SmoothMap& map) {
                          result["bumps"] = Json::array();
                          for (const auto& bump : map.bumps) {
                            Json entry;
                            entry["shift"] = json_of(bump.shift);
                            entry["covector"] = json_of(bump.covector);
                            entry["offset"] = exact_text(bump.offset);
                            result["bumps"].push_back(std::move(entry));
                          }
                        },
                        [&](const TransitionMap& map) {
                          result["manifold"] = map.manifold;
                          result["lift"] = map.lift;
                          result["translation"] = json_of(map.translation);
                        },
                        [&](const FiniteMap& map) {
                          result["points"] = json_of_points(map.points);
                          result["images"] = json_of_points(map.images);
                          result["domain_count"] = map.domain_count;
                        }},
             form_);
  return result;
}

ObjectPointer MapObject::read(const Json& json) {
  if (!json.is_object() || !json.contains("form") || !json.at("form").is_string()) {
    throw InputError("a map has a form: linear, inversion, smooth, transition or finite");
  }
  const auto form = json.at("form").get<std::string>();
  if (form == "linear") return std::make_shared<MapObject>(linear_from(json));
  if (form == "inversion") return std::make_shared<MapObject>(inversion_from(json));
  if (form == "smooth") return std::make_shared<MapObject>(smooth_from(json));
  if (form == "transition") return std::make_shared<MapObject>(transition_from(json));
  if (form == "finite") return std::make_shared<MapObject>(finite_from(json));
  throw InputError("no map is " + form + ": linear, inversion, smooth, transition or finite");
}

}  // namespace delcert
