#include "tests/checker/support/model.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>
#include <random>
#include <set>

#include "tests/checker/support/short_row.hpp"

namespace delcert::checker_tests {
namespace {

std::size_t index(int i) { return static_cast<std::size_t>(i); }

/// The solution of a x = b by elimination with pivots.
ShortRow solve(std::vector<ShortRow> a, ShortRow b) {
  const std::size_t k = b.size();
  for (std::size_t p = 0; p < k; ++p) {
    std::size_t best = p;
    for (std::size_t i = p; i < k; ++i) best = std::abs(a[i][p]) > std::abs(a[best][p]) ? i : best;
    std::swap(a[p], a[best]);
    std::swap(b[p], b[best]);
    for (std::size_t i = 0; i < k; ++i) {
      if (i == p) continue;
      const double factor = a[i][p] / a[p][p];
      for (std::size_t j = 0; j < k; ++j) a[i][j] -= factor * a[p][j];
      b[i] -= factor * b[p];
    }
  }
  for (std::size_t p = 0; p < k; ++p) b[p] /= a[p][p];
  return b;
}

double product(const Model& model, const ShortRow& x, const ShortRow& y) {
  double sum = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    for (std::size_t j = 0; j < x.size(); ++j) {
      sum += (model.torus ? model.gram[i][j] : (i == j ? 1 : 0)) * x[i] * y[j];
    }
  }
  return sum;
}

ShortRow coordinates(const std::vector<Fraction>& point) {
  ShortRow row;
  for (const Fraction& x : point) row.push_back(x.value());
  return row;
}

/// The vectors from label i to the lifts of j with coordinates within one of the nearest in every direction.
std::vector<ShortRow> offsets(const Model& model, int i, int j) {
  const ShortRow a = coordinates(model.points[index(i)]), b = coordinates(model.points[index(j)]);
  std::vector<ShortRow> all{ShortRow{}};
  for (std::size_t k = 0; k < a.size(); ++k) {
    std::vector<ShortRow> longer;
    const double nearest = b[k] - a[k] - (model.torus ? std::round(b[k] - a[k]) : 0);
    for (const ShortRow& row : all) {
      for (int shift = model.torus ? -1 : 0; shift <= (model.torus ? 1 : 0); ++shift) {
        longer.push_back(row);
        longer.back().push_back(nearest + shift);
      }
    }
    all = std::move(longer);
  }
  return all;
}

ShortRow shortest_of(const Model& model, const std::vector<ShortRow>& all) {
  return *std::min_element(all.begin(), all.end(), [&](const ShortRow& x, const ShortRow& y) {
    return product(model, x, x) < product(model, y, y);
  });
}
ShortRow shortest(const Model& model, int i, int j) { return shortest_of(model, offsets(model, i, j)); }

/// Moves every coordinate by a random multiple of 2^-30 of absolute value <= size.
void perturb(Model& model, double size, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  const auto range = static_cast<std::uint64_t>(size * 0x1p30);
  model.points = model.net;
  for (auto& point : model.points) {
    for (Fraction& x : point) {
      const auto step = static_cast<long long>(random() % (2 * range + 1)) - static_cast<long long>(range);
      x = x + Fraction{step, 1ll << 30};
    }
  }
}

}  // namespace

std::string Fraction::text() const {
  const std::string sign = numerator < 0 ? "-" : "";
  const unsigned long long magnitude = static_cast<unsigned long long>(std::llabs(numerator));
  if (denominator == 1) return sign + std::to_string(magnitude);
  if ((denominator & (denominator - 1)) != 0)
    return sign + std::to_string(magnitude) + "/" + std::to_string(denominator);
  std::array<char, 64> buffer{};
  std::snprintf(buffer.data(), buffer.size(), "0x%llxp-%d", magnitude,
                static_cast<int>(std::log2(static_cast<double>(denominator))));
  return sign + buffer.data();
}

Fraction operator+(const Fraction& a, const Fraction& b) {
  const long long common = std::lcm(a.denominator, b.denominator);
  const long long sum = a.numerator * (common / a.denominator) + b.numerator * (common / b.denominator);
  const long long divisor = std::gcd(sum, common);
  return {sum / divisor, common / divisor};
}

Fraction at_most(double value) {
  return Fraction{static_cast<long long>(std::floor(value * 0x1p40)), 1ll << 40} + Fraction{};
}

std::vector<std::vector<Labels>> stars_of(const std::vector<Labels>& simplices, const std::vector<bool>& interior) {
  std::vector<std::vector<Labels>> stars(interior.size());
  for (const Labels& simplex : simplices) {
    for (const int i : simplex) {
      if (!interior[index(i)]) continue;
      Labels rest;
      std::copy_if(simplex.begin(), simplex.end(), std::back_inserter(rest), [&](int j) { return j != i; });
      std::sort(rest.begin(), rest.end());
      stars[index(i)].push_back(rest);
    }
  }
  for (auto& star : stars) std::sort(star.begin(), star.end());
  return stars;
}

std::vector<Labels> simplices_of(const std::vector<std::vector<Labels>>& stars) {
  std::set<Labels> all;
  for (std::size_t i = 0; i < stars.size(); ++i) {
    for (Labels simplex : stars[i]) {
      simplex.push_back(static_cast<int>(i));
      std::sort(simplex.begin(), simplex.end());
      all.insert(simplex);
    }
  }
  return {all.begin(), all.end()};
}

std::vector<std::vector<int>> nearest_shifts(const Model& model, const Labels& simplex) {
  const auto times = [](const std::vector<std::vector<int>>& matrix, const auto& x) {
    auto result = x;
    for (std::size_t i = 0; i < x.size() && !matrix.empty(); ++i) {
      result[i] = 0;
      for (std::size_t k = 0; k < x.size(); ++k) result[i] += matrix[i][k] * x[k];
    }
    return result;
  };
  Model reduced;
  reduced.torus = model.torus;
  reduced.gram = model.basis.empty() ? model.gram : model.reduced_gram;
  std::vector<ShortRow> place;
  for (const int j : simplex) {
    place.push_back(times(model.basis, coordinates(model.points[index(j)])));
    auto& point = reduced.points.emplace_back();
    for (const double x : place.back()) point.push_back({static_cast<long long>(std::floor(x * 0x1p40)), 1ll << 40});
  }
  std::vector<std::vector<int>> result;
  for (std::size_t k = 1; k < simplex.size(); ++k) {
    const ShortRow offset = shortest(reduced, 0, static_cast<int>(k));
    std::vector<int> shift;
    for (std::size_t axis = 0; axis < offset.size(); ++axis)
      shift.push_back(static_cast<int>(std::lround(offset[axis] - place[k][axis] + place[0][axis])));
    result.push_back(times(model.inverse, shift));
  }
  return result;
}

std::pair<long long, long long> count(const std::vector<std::vector<Labels>>& stars) {
  std::set<Labels> faces;
  long long simplices = 0, euler = 0;
  for (std::size_t i = 0; i < stars.size(); ++i) {
    for (Labels simplex : stars[i]) {
      simplex.push_back(static_cast<int>(i));
      std::sort(simplex.begin(), simplex.end());
      if (faces.contains(simplex)) continue;
      ++simplices;
      for (unsigned subset = 1; subset < 1u << simplex.size(); ++subset) {
        Labels face;
        for (std::size_t k = 0; k < simplex.size(); ++k) {
          if ((subset >> k & 1) != 0) face.push_back(simplex[k]);
        }
        if (faces.insert(face).second) euler += face.size() % 2 == 1 ? 1 : -1;
      }
    }
  }
  return {simplices, euler};
}

Model kuhn_torus(int m, int N, double stretch, double size, std::uint64_t seed) {
  Model model;
  model.m = m;
  model.gram.assign(index(m), std::vector<int>(index(m), -1));
  for (int k = 0; k < m; ++k) model.gram[index(k)][index(k)] = m;
  const double epsilon = stretch * std::sqrt(m * (m + 2) / 12.0) / N;
  model.epsilon = at_most(epsilon);
  model.mu = at_most(std::min(1.0, 0.999 * std::sqrt(m) / N / epsilon));
  model.rho = at_most(model.mu.value() / 4);
  int n = 1;
  for (int k = 0; k < m; ++k) n *= N;
  const auto digit = [&](int label, int k) {
    for (; k > 0; --k) label /= N;
    return label % N;
  };
  for (int label = 0; label < n; ++label) {
    auto& point = model.net.emplace_back();
    for (int k = 0; k < m; ++k) point.push_back(Fraction{digit(label, k), N} + Fraction{});
    Labels order(index(m));
    std::iota(order.begin(), order.end(), 0);
    do {
      Labels simplex{label}, corner;
      for (int k = 0; k < m; ++k) corner.push_back(digit(label, k));
      int inversions = 0;
      for (std::size_t k = 0; k < order.size(); ++k) {
        for (std::size_t j = 0; j < k; ++j) inversions += order[j] > order[k] ? 1 : 0;
        corner[index(order[k])] = (corner[index(order[k])] + 1) % N;
        int next = 0;
        for (int a = m - 1; a >= 0; --a) next = next * N + corner[index(a)];
        simplex.push_back(next);
      }
      if (inversions % 2 == 1) std::swap(simplex[0], simplex[1]);
      model.net_simplices.push_back(simplex);
    } while (std::next_permutation(order.begin(), order.end()));
  }
  model.interior.assign(index(n), true);
  model.stars = stars_of(model.net_simplices, model.interior);
  perturb(model, size / N, seed);
  return model;
}

Model staggered_disc(int N, double size, std::uint64_t seed) {
  Model model;
  model.m = 2;
  model.torus = false;
  const double h = 1.0 / N;
  model.epsilon = Fraction{19, 32ll * N} + Fraction{};  // 0.594 h; the circumradius is 0.581 h
  const double epsilon = model.epsilon.value();
  model.mu = {1, 1};
  model.rho = {1, 8};
  model.radius = {11 * model.epsilon.numerator, model.epsilon.denominator};
  std::map<std::pair<int, int>, int> labels;
  const int reach = static_cast<int>(13 * epsilon / h / 0.875) + 1;
  for (int row = -reach; row <= reach; ++row) {
    for (int column = -reach; column <= reach; ++column) {
      const bool odd = row % 2 != 0;
      const Fraction x = Fraction{2 * column + (odd ? 1 : 0), 2 * N} + Fraction{},
                     y = Fraction{7 * row, 8 * N} + Fraction{};
      if (std::hypot(x.value(), y.value()) > 13 * epsilon) continue;
      labels[{row, column}] = static_cast<int>(model.net.size());
      model.net.push_back({x, y});
      model.interior.push_back(std::hypot(x.value(), y.value()) + 8 * epsilon <= model.radius.value());
    }
  }
  const auto triangle = [&](std::array<std::pair<int, int>, 3> corners) {
    Labels simplex;
    for (const auto& corner : corners) {
      if (!labels.contains(corner)) return;
      simplex.push_back(labels[corner]);
    }
    model.net_simplices.push_back(simplex);
  };
  for (const auto& [place, label] : labels) {
    const auto [row, column] = place;
    const int shift = row % 2 != 0 ? 1 : 0;
    triangle({{{row, column}, {row, column + 1}, {row + 1, column + shift}}});
    triangle({{{row, column}, {row + 1, column + shift}, {row + 1, column + shift - 1}}});
  }
  model.stars = stars_of(model.net_simplices, model.interior);
  perturb(model, size / N, seed);
  return model;
}

Model in_basis(const Model& model, const std::vector<std::vector<int>>& basis,
               const std::vector<std::vector<int>>& inverse) {
  Model result = model;
  result.basis = basis;
  result.inverse = inverse;
  result.reduced_gram = model.gram;
  const std::size_t m = index(model.m);
  for (std::size_t i = 0; i < m; ++i) {
    for (std::size_t j = 0; j < m; ++j) {
      result.gram[i][j] = 0;
      for (std::size_t a = 0; a < m; ++a) {
        for (std::size_t b = 0; b < m; ++b) result.gram[i][j] += basis[a][i] * model.gram[a][b] * basis[b][j];
      }
    }
  }
  for (auto* set : {&result.net, &result.points}) {
    for (auto& point : *set) {
      const std::vector<Fraction> old = point;
      for (std::size_t i = 0; i < m; ++i) {
        point[i] = {};
        for (std::size_t j = 0; j < m; ++j)
          point[i] = point[i] + Fraction{inverse[i][j] * old[j].numerator, old[j].denominator};
      }
    }
  }
  return result;
}

Margins measure(const Model& model, int labels) {
  Margins margins{1e300, 1e300, 0};
  const int n = static_cast<int>(model.points.size());
  const double square_of_reach = std::pow(5 * model.epsilon.value(), 2);
  for (int i = 0; i < std::min(n, labels); ++i) {
    std::vector<std::pair<int, ShortRow>> near;
    std::map<int, ShortRow> nearest;
    for (int j = 0; j < n && !model.stars[index(i)].empty(); ++j) {
      const std::vector<ShortRow> all = offsets(model, i, j);
      for (const ShortRow& x : all) {
        if (product(model, x, x) < square_of_reach) near.emplace_back(j, x);
      }
      nearest[j] = shortest_of(model, all);
    }
    for (const Labels& simplex : model.stars[index(i)]) {
      std::vector<ShortRow> edges;
      for (const int j : simplex) edges.push_back(nearest[j]);
      const std::size_t k = edges.size();
      std::vector<ShortRow> gram(k, ShortRow(k));
      ShortRow half(k);
      double longest = 0;
      for (std::size_t a = 0; a < k; ++a) {
        for (std::size_t b = 0; b < k; ++b) gram[a][b] = product(model, edges[a], edges[b]);
        half[a] = gram[a][a] / 2;
        for (std::size_t b = 0; b <= a; ++b)
          longest = std::max(longest, b == a ? gram[a][a] : gram[a][a] + gram[b][b] - 2 * gram[a][b]);
      }
      const ShortRow weights = solve(gram, half);
      ShortRow centre(k, 0);
      for (std::size_t a = 0; a < k; ++a) {
        for (std::size_t b = 0; b < k; ++b) centre[b] += weights[a] * edges[a][b];
      }
      const double radius = std::sqrt(product(model, centre, centre));
      ShortRow all(k, 1);
      const ShortRow dual = solve(gram, all);
      double inverse = std::accumulate(dual.begin(), dual.end(), 0.0);
      for (std::size_t a = 0; a < k; ++a) {
        ShortRow unit(k, 0);
        unit[a] = 1;
        inverse = std::max(inverse, solve(gram, unit)[a]);
      }
      margins.circumradius = std::max(margins.circumradius, radius);
      margins.thickness = std::min(margins.thickness, 1 / std::sqrt(inverse * longest) / static_cast<double>(k));
      for (const auto& [j, x] : near) {
        if (j == i && product(model, x, x) == 0) continue;
        const auto place = std::find(simplex.begin(), simplex.end(), j);
        if (place != simplex.end() && x == edges[static_cast<std::size_t>(place - simplex.begin())]) continue;
        ShortRow offset = x;
        for (std::size_t b = 0; b < k; ++b) offset[b] -= centre[b];
        margins.protection = std::min(margins.protection, std::sqrt(product(model, offset, offset)) - radius);
      }
    }
  }
  return margins;
}

}  // namespace delcert::checker_tests
