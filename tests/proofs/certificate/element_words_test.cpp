#include "proofs/certificate/element_words.hpp"

#include <gtest/gtest.h>

#include <random>
#include <stdexcept>

#include "kernel/manifold/space_form_file.hpp"

namespace delcert {
namespace DELCERT_THIS_FILE {

/// The product of the letters that the table has for the element.
FieldMatrix spelled(const ElementWords& words, std::uint32_t number) {
  if (number == 0) return words.matrix(0);
  const auto [parent, letter] = words.words().at(number - 1);
  EXPECT_LT(static_cast<std::uint32_t>(parent), number);
  return spelled(words, static_cast<std::uint32_t>(parent)) * words.letter(letter);
}

TEST(ElementWords, SpellRandomElementsOfEveryCurvature) {
  for (const char* name : {"lens-space-5-2", "poincare-sphere", "klein-bottle", "hantzsche-wendt", "bolza-surface",
                           "seifert-weber-space"}) {
    SCOPED_TRACE(name);
    const SpaceFormDescription description = find_space_form(name);
    ElementWords words(description.form, description.generators);
    std::mt19937 random(1);
    for (int k = 0; k < 10; ++k) {
      FieldMatrix element = words.matrix(0);
      for (int length = 0; length < 4; ++length) {
        const auto letter = static_cast<std::int32_t>(random() % words.letter_count()) + 1;
        element = element * words.letter(random() % 2 == 0 ? letter : -letter);
      }
      const std::uint32_t number = words.number_of(element);
      EXPECT_TRUE(words.matrix(number) == element);
      EXPECT_TRUE(spelled(words, number) == element);
      EXPECT_EQ(words.number_of(element), number);
      EXPECT_EQ(number == 0, is_identity(element));
    }
  }
}

TEST(ElementWords, OfFlatFormsHaveTranslationsAsLetters) {
  const SpaceFormDescription bottle = find_space_form("klein-bottle");
  const ElementWords words(bottle.form, bottle.generators);
  ASSERT_EQ(words.letter_count(), bottle.generators.size() + 2);
  const FieldMatrix& last = words.letter(static_cast<std::int32_t>(words.letter_count()));
  EXPECT_EQ(last(2, 0), FieldElement(1));
  EXPECT_TRUE(is_identity(last * words.letter(-static_cast<std::int32_t>(words.letter_count()))));
}

TEST(ElementWords, RefuseWhatIsNotInTheGroup) {
  const SpaceFormDescription lens = find_space_form("lens-space-5-2"), bolza = find_space_form("bolza-surface");
  ElementWords finite(lens.form, lens.generators);
  FieldMatrix reflection = finite.matrix(0);
  reflection(0, 0) = FieldElement(-1);
  EXPECT_THROW((void)finite.number_of(reflection), std::logic_error);
  ElementWords infinite(bolza.form, bolza.generators);
  FieldMatrix turned = infinite.matrix(0);
  turned(1, 1) = FieldElement(-1);
  EXPECT_THROW((void)infinite.number_of(turned), std::logic_error);
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
