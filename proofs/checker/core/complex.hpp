#pragma once

#include <string>

#include "proofs/checker/core/elements.hpp"
#include "proofs/checker/core/frame.hpp"
#include "proofs/checker/report/report.hpp"

namespace delcert::checker::core {

/// A vertex j beside another one, i: with i at p_i, it is at phi p_j.
struct Neighbour {
  Label label = 0;
  Elements::Id phi = 0;
};

/// Two simplices with a facet in common, and which of their vertices are not on it.
struct Hinge {
  std::array<std::uint32_t, 2> simplex{};
  std::array<std::uint8_t, 2> apex{};
};

/// Lists of items, one for each label.
template <class Item>
struct Lists {
  std::vector<std::uint64_t> begin;
  std::vector<Item> items;
  std::size_t size(Label i) const { return begin[i + 1] - begin[i]; }
  const Item* of(Label i) const { return items.data() + begin[i]; }
};

/// The complex with what its rules find out one after the other.
class Complex {
 public:
  /// Keeps a reference. Precondition: as Elements.
  explicit Complex(const Data& given);

  const Data& data;
  Elements elements;
  std::vector<std::int8_t> sign;  // of each simplex: of the determinant of its lifts
  Lists<Neighbour> neighbours;
  std::vector<Hinge> hinges;
  std::vector<std::uint32_t> facets;  // of each label, how many have it as the least one
  /// The simplices with a label, each with the place that it has there.
  struct Place {
    std::uint32_t simplex = 0, vertex = 0;
  };
  Lists<Place> star;

  Label size() const { return static_cast<Label>(data.filter.size()); }
  std::size_t vertices() const { return data.m + 1; }
  Label label(std::size_t s, std::size_t k) const { return data.labels[s * vertices() + k]; }
  Elements::Id element(std::size_t s, std::size_t k) const {
    return k == 0 ? 0 : elements.of(data.elements[s * data.m + k - 1]);
  }
  /// "simplex {3, 17, 90}".
  std::string name(std::size_t s) const;

  template <class N>
  Vector<N> point(Label j) const {
    if constexpr (std::is_same_v<N, Interval>) {
      return data.filter[j];
    } else if constexpr (std::is_same_v<N, Rational>) {
      return data.exact(j);
    } else {
      return data.enclosed(j);
    }
  }
  template <class N>
  Vector<N> lift(std::size_t s, std::size_t k) {
    return elements.moved(element(s, k), point<N>(label(s, k)));
  }
  template <class N>
  Lifts<N> lifts(std::size_t s) {
    Lifts<N> result{};
    for (std::size_t k = 0; k < vertices(); ++k) result[k] = lift<N>(s, k);
    return result;
  }
  /// The vertex beyond the hinge, moved to its first simplex.
  Elements::Id element_beyond(const Hinge& hinge);
  template <class N>
  Vector<N> beyond(const Hinge& hinge) {
    return elements.moved(element_beyond(hinge), point<N>(label(hinge.simplex[1], hinge.apex[1])));
  }

  /// By the filter; else exactly, where the data are rational, or by balls. Throws Undecided.
  template <class Predicate>
  bool decide(const Predicate& predicate) const {
    return data.exact ? checker::decide(predicate) : decide_enclosed(predicate);
  }
};

}  // namespace delcert::checker::core
