#include "proofs/drawing/formats/isomorphism_signature.hpp"

#include <algorithm>
#include <numeric>

namespace delcert {

namespace {

using Permutation = Gluings::Permutation;

constexpr std::uint32_t unseen = UINT32_MAX;

char character_of(std::uint32_t value) {
  return "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789+-"[value];
}

void append_characters(std::string& text, std::uint64_t value, std::size_t characters) {
  for (; characters > 0; --characters, value >>= 6U) text += character_of(static_cast<std::uint32_t>(value & 63U));
}

Permutation inverse_of(const Permutation& p, std::size_t size) {
  Permutation result{};
  for (std::size_t k = 0; k < size; ++k) result[p[k]] = static_cast<std::uint8_t>(k);
  return result;
}

/// First b, then a.
Permutation composed(const Permutation& a, const Permutation& b, std::size_t size) {
  Permutation result{};
  for (std::size_t k = 0; k < size; ++k) result[k] = a[b[k]];
  return result;
}

/// The text that begins with one simplex and one numbering of its vertices.
class SignatureWalk {
 public:
  explicit SignatureWalk(const Gluings& gluings) : gluings_(gluings), size_(gluings.dimension() + 1) {}

  std::string text(std::uint32_t start, const Permutation& numbering) {
    number_.assign(gluings_.count(), unseen);
    vertices_.assign(gluings_.count(), {});
    order_.assign(1, start);
    number_[start] = 0;
    vertices_[start] = numbering;
    kinds_.clear();
    targets_.clear();
    permutations_.clear();
    for (std::size_t at = 0; at < order_.size(); ++at) walk(order_[at]);
    return written();
  }

 private:
  void walk(std::uint32_t simplex) {
    const Permutation back = inverse_of(vertices_[simplex], size_);
    for (std::size_t facet = 0; facet < size_; ++facet) {
      const std::size_t own_facet = back[facet];
      const Gluings::Gluing& gluing = gluings_.at(simplex, own_facet);
      if (gluing.simplex == Gluings::boundary) {
        kinds_.push_back(0);
        continue;
      }
      const std::uint32_t other = gluing.simplex;
      if (number_[other] == unseen) {
        number_[other] = static_cast<std::uint32_t>(order_.size());
        order_.push_back(other);
        vertices_[other] = composed(vertices_[simplex], inverse_of(gluing.vertices, size_), size_);
        kinds_.push_back(1);
        continue;
      }
      // From the other side it has been written.
      if (number_[other] < number_[simplex] ||
          (other == simplex && vertices_[simplex][gluing.vertices[own_facet]] < facet))
        continue;
      kinds_.push_back(2);
      targets_.push_back(number_[other]);
      permutations_.push_back(
          lexicographic_index(composed(composed(vertices_[other], gluing.vertices, size_), back, size_), size_));
    }
  }

  [[nodiscard]] std::string written() const {
    std::string text;
    const std::size_t count = order_.size();
    std::size_t characters = 1;
    if (count < 63) {
      append_characters(text, count, 1);
    } else {
      characters = 0;
      for (std::size_t rest = count; rest > 0; rest >>= 6U) ++characters;
      append_characters(text, 63, 1);
      append_characters(text, characters, 1);
      append_characters(text, count, characters);
    }
    for (std::size_t at = 0; at < kinds_.size(); at += 3) {
      std::uint32_t value = 0;
      for (std::size_t k = 0; k < 3 && at + k < kinds_.size(); ++k) value |= std::uint32_t{kinds_[at + k]} << (2 * k);
      text += character_of(value);
    }
    for (const std::uint32_t target : targets_) append_characters(text, target, characters);
    for (const std::uint32_t permutation : permutations_) append_characters(text, permutation, size_ == 5 ? 2 : 1);
    return text;
  }

  const Gluings& gluings_;
  std::size_t size_;
  std::vector<std::uint32_t> number_;
  std::vector<Permutation> vertices_;
  std::vector<std::uint32_t> order_;
  std::vector<std::uint8_t> kinds_;  ///< of facets: boundary, glued to what is new, glued to what is not
  std::vector<std::uint32_t> targets_;
  std::vector<std::uint32_t> permutations_;
};

}  // namespace

std::string isomorphism_signature(const Gluings& gluings) {
  SignatureWalk walk(gluings);
  std::string best;
  const std::size_t size = gluings.dimension() + 1;
  for (std::uint32_t start = 0; start < gluings.count(); ++start) {
    Permutation numbering{};
    std::iota(numbering.begin(), numbering.begin() + static_cast<std::ptrdiff_t>(size), std::uint8_t{0});
    do {
      std::string text = walk.text(start, numbering);
      if (best.empty() || text < best) best = std::move(text);
    } while (std::next_permutation(numbering.begin(), numbering.begin() + static_cast<std::ptrdiff_t>(size)));
  }
  return best;
}

}  // namespace delcert
