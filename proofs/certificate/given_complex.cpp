#include "proofs/certificate/given_complex.hpp"

#include <algorithm>
#include <map>

#include "support/error.hpp"

namespace delcert {

namespace {

constexpr std::size_t most_places_for_loops = 50000;

/// Generators and, for curvature 0, translations.
std::vector<FieldMatrix> letters_of(const ComplexDescription& description) {
  const InvariantForm& form = description.form;
  std::vector<FieldMatrix> result = description.generators;
  for (std::size_t at = 0; at < result.size(); ++at) {
    const std::string name = description.name + ": generator " + description.generator_names[at];
    if (const auto reason = form.why_no_isometry(result[at])) throw Rejection(name + ": " + *reason);
    if (is_identity(result[at])) throw Rejection(name + " is the identity");
  }
  for (std::size_t axis = 1; form.curvature() == Curvature::zero && axis < form.matrix().order(); ++axis) {
    result.push_back(FieldMatrix::identity(form.matrix().order()));
    result.back()(axis, 0) = FieldElement(1);
  }
  return result;
}

/// Products of letters, each element once.
class WordTable {
 public:
  WordTable(const InvariantForm& form, std::vector<FieldMatrix> letters) : letters_(std::move(letters)) {
    for (const FieldMatrix& letter : letters_) inverses_.push_back(form.inverse_of(letter));
    elements.push_back(FieldMatrix::identity(form.matrix().order()));
    numbers_.emplace(elements.front(), 0);
  }

  [[nodiscard]] const std::vector<FieldMatrix>& letters() const { return letters_; }

  std::uint32_t number_of(const std::vector<std::int32_t>& word) {
    std::uint32_t number = 0;
    for (const std::int32_t letter : word) number = after(number, letter);
    return number;
  }

  std::vector<FieldMatrix> elements;
  std::vector<std::vector<std::int32_t>> words;  ///< of the elements 1, 2, …: parent and letter

 private:
  std::uint32_t after(std::uint32_t parent, std::int32_t letter) {
    const auto [known, is_new_step] = steps_.try_emplace({parent, letter}, 0);
    if (!is_new_step) return known->second;
    const std::size_t at = static_cast<std::size_t>(std::abs(letter)) - 1;
    FieldMatrix product = elements[parent] * (letter > 0 ? letters_[at] : inverses_[at]);
    const auto [number, is_new] = numbers_.try_emplace(product, static_cast<std::uint32_t>(elements.size()));
    if (is_new) {
      elements.push_back(std::move(product));
      words.push_back({static_cast<std::int32_t>(parent), letter});
    }
    return known->second = number->second;
  }

  std::vector<FieldMatrix> letters_, inverses_;
  std::map<std::pair<std::uint32_t, std::int32_t>, std::uint32_t> steps_;
  std::map<FieldMatrix, std::uint32_t, Precedes> numbers_;
};

/// v⁻¹w, without letters that cancel each other.
std::vector<std::int32_t> quotient(const std::vector<std::int32_t>& v, const std::vector<std::int32_t>& w) {
  std::vector<std::int32_t> result;
  const auto append = [&result](std::int32_t letter) {
    if (!result.empty() && result.back() == -letter) {
      result.pop_back();
    } else {
      result.push_back(letter);
    }
  };
  std::for_each(v.rbegin(), v.rend(), [&](std::int32_t letter) { append(-letter); });
  std::for_each(w.begin(), w.end(), append);
  return result;
}

}  // namespace

template <int m>
GivenComplex<m> place_complex(const ComplexDescription& description) {
  WordTable table(description.form, letters_of(description));
  GivenComplex<m> result;
  for (const auto& coordinates : description.points) {
    result.points.emplace_back();
    std::copy(coordinates.begin(), coordinates.end(), result.points.back().begin());
  }
  for (const auto& vertices : description.simplices) {
    PlacedSimplex<m>& placed = result.complex.simplices.emplace_back();
    for (std::size_t corner = 0; corner <= m; ++corner) {
      placed[corner] = vertices[corner].label;
      if (corner > 0) placed[m + corner] = table.number_of(quotient(vertices[0].word, vertices[corner].word));
    }
  }
  std::sort(result.complex.simplices.begin(), result.complex.simplices.end());
  const auto loops = loops_along<m>(description.form, result.points, table.elements, table.letters(),
                                    result.complex.simplices, most_places_for_loops);
  for (std::size_t at = 0; at < loops.size(); ++at) {
    result.complex.loops.push_back(loops[at].value_or(std::vector<LoopStep>()));
    if (!loops[at]) result.without_loop.push_back(description.letter_name(at + 1));
  }
  result.complex.elements = std::move(table.words);
  result.elements = std::move(table.elements);
  return result;
}

template GivenComplex<2> place_complex<2>(const ComplexDescription&);
template GivenComplex<3> place_complex<3>(const ComplexDescription&);

}  // namespace delcert
