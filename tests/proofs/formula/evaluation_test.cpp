#include "proofs/formula/evaluation.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "support/error.hpp"
#include "tests/proofs/formula/random_formulas.hpp"
#include "tests/proofs/formula/triangle_scene.hpp"
#include "tests/support/contains.hpp"

namespace delcert {
namespace DELCERT_THIS_FILE {

using namespace triangle_scene;

TEST(TermsOverSets, sums_products_least_and_greatest) {
  EXPECT_EQ(decided("sum(p in vertices(s): altitude(s, p)) = 3 + 4 + 12/5"), Verdict::proved);
  EXPECT_EQ(decided("sum(p in vertices(s): altitude(s, p)) < 3 + 4 + 12/5"), Verdict::refuted);
  EXPECT_EQ(decided("product(i in 1 .. 4: i) = 24"), Verdict::proved);
  EXPECT_EQ(decided("min(e in edges(s): longest_edge(e)) = 3"), Verdict::proved);
  EXPECT_EQ(decided("max(e in edges(s): longest_edge(e)) = 5"), Verdict::proved);
  EXPECT_EQ(decided("max(e in edges(s): longest_edge(e)) = 4"), Verdict::refuted);
  EXPECT_EQ(decided("sum(f in faces_of_dimension(s, 0): 1) = 3"), Verdict::proved);
  EXPECT_EQ(decided("sum(f in faces_of_dimension(s, 3): 1) = 0"), Verdict::proved);
}

TEST(TermsOverSets, nest_and_see_the_variables_outside) {
  EXPECT_EQ(decided("sum(i in 0 .. k, j in 0 .. i - 1: edge(s, i, j)) = 12"), Verdict::proved);
  EXPECT_EQ(decided("forall i in 1 .. 3: sum(j in 1 .. i: j) = i*(i + 1)/2"), Verdict::proved);
  EXPECT_EQ(decided("max(i in 0 .. k: min(j in 0 .. k: i + j)) = 2"), Verdict::proved);
  EXPECT_EQ(decided("forall e in edges(s): longest_edge(e) <= sum(g in edges(s): longest_edge(g))/2"), Verdict::proved);
}

TEST(TermsOverSets, of_empty_sets_and_of_terms_without_value) {
  EXPECT_EQ(decided("sum(i in 1 .. 0: i) = 0"), Verdict::proved);
  EXPECT_EQ(decided("product(i in 1 .. 0: i) = 1"), Verdict::proved);
  EXPECT_EQ(decided("max(i in 1 .. 0: i) >= 0"), Verdict::undecided);
  EXPECT_EQ(decided("min(i in 1 .. 0: i) >= 0"), Verdict::undecided);
  EXPECT_EQ(decided("sum(i in 0 .. 1: 1/i) > 0"), Verdict::undecided) << "no value at 0";
}

TEST(TermsOverSets, have_ratios) {
  const auto ratio = [](std::string_view text) {
    Scene scene(bindings());
    return ratio_bounds(*typed(text, types::truth), scene, true);
  };
  const auto half = ratio("sum(i in 1 .. 3: i) <= 12");
  ASSERT_TRUE(half.has_value());
  EXPECT_EQ(half->lower, 0.5);
  EXPECT_EQ(half->upper, 0.5);
}

template <class S>
Verdict on_rung(std::string_view text) {
  const auto statement = typed(text, types::truth);
  Scene scene(bindings());
  if constexpr (std::same_as<S, Interval>) {
    const RoundingGuard guard;
    return Evaluation<S>(scene).truth(*statement);
  } else {
    return Evaluation<S>(scene).truth(*statement);
  }
}

template <class S>
Partial<S> value(std::string_view text) {
  const auto term = typed(text, types::number);
  Scene scene(bindings());
  if constexpr (std::same_as<S, Interval>) {
    const RoundingGuard guard;
    return Evaluation<S>(scene).number(*term);
  } else {
    return Evaluation<S>(scene).number(*term);
  }
}

RC_GTEST_PROP(Evaluation, every_rung_encloses_the_exact_value_of_a_rational_term, ()) {
  const auto [term, expected] = formulas::rational_term(*rc::gen::inRange(0, 6));
  const auto checked = type_checked(term, vocabulary(), {}, types::number);
  const Bindings none;
  Scene scene(none);
  {
    const RoundingGuard guard;
    const auto enclosure = Evaluation<Interval>(scene).number(*checked);
    // Only a divisor that is nearly 0 may be taken for 0.
    if (enclosure) RC_ASSERT(contains(*enclosure, expected));
    if (!enclosure) RC_ASSERT(is_undecided(enclosure.exists()));
  }
  const auto big = Evaluation<BigInterval>(scene).number(*checked);
  if (big) RC_ASSERT(big->lower() <= expected && expected <= big->upper());
  if (!big) RC_ASSERT(is_undecided(big.exists()));
  const auto surd = Evaluation<Surd>(scene).number(*checked);
  RC_ASSERT(surd && surd->rational() == expected);
  const auto algebraic = Evaluation<Algebraic>(scene).number(*checked);
  RC_ASSERT(algebraic && algebraic->rational() == expected);
}

RC_GTEST_PROP(Evaluation, rungs_never_contradict_each_other, ()) {
  const auto [left, x] = formulas::rational_term(*rc::gen::inRange(0, 5));
  const auto [right, y] = formulas::rational_term(*rc::gen::inRange(0, 5));
  const auto operation = *rc::gen::element(Operation::less, Operation::less_equal, Operation::equal);
  const auto statement = type_checked(formulas::made(operation, {left, right}), vocabulary(), {}, types::truth);
  const Verdict expected = operation == Operation::less         ? less(x, y)
                           : operation == Operation::less_equal ? less_equal(x, y)
                                                                : verdict_of(x == y);
  const Bindings none;
  Scene scene(none);
  Verdict filtered = Verdict::undecided;
  {
    const RoundingGuard guard;
    filtered = Evaluation<Interval>(scene).truth(*statement);
  }
  const Verdict big = Evaluation<BigInterval>(scene).truth(*statement);
  RC_ASSERT(filtered == expected || is_undecided(filtered));
  RC_ASSERT(big == expected || is_undecided(big));
  RC_ASSERT(Evaluation<Algebraic>(scene).truth(*statement) == expected);
  RC_ASSERT(decide_statement(*statement, scene) == expected);
}

TEST(Evaluation, powers_have_integer_and_half_integer_exponents) {
  EXPECT_EQ(exactly("2^10"), Rational(1024));
  EXPECT_EQ(exactly("2^-2"), Rational(Integer(1), Integer(4)));
  EXPECT_EQ(exactly("4^(3/2)"), Rational(8));
  EXPECT_EQ(exactly("4^-(3/2)"), Rational(Integer(1), Integer(8)));
  EXPECT_EQ(exactly("(-2)^3"), Rational(-8));
  EXPECT_EQ(exactly("-2^2"), Rational(-4));
  EXPECT_EQ(exactly("zero^0"), Rational(1));
  EXPECT_EQ(exactly("zero^(1/2)"), Rational(0));
  EXPECT_EQ(exactly("2^(k^2 + 1)"), Rational(32));
  EXPECT_EQ(exactly("9^(k/4)"), Rational(3));
  EXPECT_EQ(exactly("2^n"), Rational(Integer(1), Integer(2)));
}

TEST(Evaluation, what_has_no_value_is_refuted_on_the_exact_rung_and_never_proved_below) {
  for (const char* text :
       {"1/zero", "1/(k - 2)", "zero^-1", "0^n", "sqrt(n)", "(-2)^(1/2)", "2^(1/(k - 2))", "2^(k/3)", "log2(zero)",
        "log2(n)", "circumradius(t)", "1/(sqrt(2)*sqrt(2) - 2)", "sqrt(sqrt(2)*sqrt(2) - 3)", "shortest_edge(v)"}) {
    EXPECT_TRUE(is_refuted(value<Algebraic>(text).exists())) << text;
    EXPECT_FALSE(is_proved(value<Interval>(text).exists())) << text;
    EXPECT_FALSE(is_proved(value<BigInterval>(text).exists())) << text;
    EXPECT_TRUE(is_undecided(decided(std::string(text) + " < 1"))) << text;
    EXPECT_TRUE(is_undecided(decided("not " + std::string(text) + " < 1"))) << text;
    EXPECT_TRUE(is_undecided(decided("abs(" + std::string(text) + ") >= 0"))) << text;
    EXPECT_TRUE(is_undecided(decided("(" + std::string(text) + ")^2 >= 0"))) << text;
    EXPECT_TRUE(is_undecided(decided("min(0, " + std::string(text) + ") <= 0"))) << text;
    EXPECT_TRUE(is_undecided(decided("0*(" + std::string(text) + ") = 0"))) << text;
    EXPECT_EQ(exactly(text), std::nullopt) << text;
  }
}

TEST(Evaluation, a_guard_decides_what_is_undefined_behind_it) {
  EXPECT_TRUE(is_proved(decided("has_circumcentre(t) implies circumradius(t) < 1")));
  EXPECT_TRUE(is_refuted(decided("has_circumcentre(t) and circumradius(t) < 1")));
  EXPECT_TRUE(is_refuted(decided("circumradius(t) < 1 and has_circumcentre(t)")));
  EXPECT_TRUE(is_proved(decided("has_circumcentre(s) implies circumradius(s) = 5/2")));
}

TEST(Evaluation, connectives_follow_kleene) {
  // T, F, U: certain, certain, undefined.
  const std::vector<std::pair<std::string, Verdict>> atoms{
      {"0 < 1", Verdict::proved}, {"1 < 0", Verdict::refuted}, {"1/zero < 1", Verdict::undecided}};
  for (const auto& [a, x] : atoms) {
    EXPECT_EQ(decided("not " + a), negation(x));
    for (const auto& [b, y] : atoms) {
      EXPECT_EQ(decided(a + " and " + b), conjunction(x, y)) << a << ", " << b;
      EXPECT_EQ(decided(a + " or " + b), disjunction(x, y)) << a << ", " << b;
      EXPECT_EQ(decided("(" + a + ") implies " + b), disjunction(negation(x), y)) << a << ", " << b;
    }
  }
}

TEST(Evaluation, quantifiers_over_the_empty_set) {
  EXPECT_TRUE(is_proved(decided("forall i in 1..0: i < 0")));
  EXPECT_TRUE(is_refuted(decided("exists i in 1..0: i > 0")));
  EXPECT_TRUE(is_proved(decided("forall i in 1..0: 1/zero < 1")));
}

TEST(Evaluation, quantifiers_are_repeated_connectives) {
  EXPECT_TRUE(is_proved(decided("forall i in 1..3: i < 4")));
  EXPECT_TRUE(is_refuted(decided("forall i in 1..3: i < 3")));
  EXPECT_TRUE(is_proved(decided("exists i in 1..3: i > 2")));
  EXPECT_TRUE(is_refuted(decided("exists i in 1..3: i > 3")));
  EXPECT_TRUE(is_refuted(decided("forall i in 0..2: 1/i < 1/2")));  // refuted at 1, undefined at 0
  EXPECT_TRUE(is_undecided(decided("forall i in 0..2: 1/i <= 1")));
  EXPECT_TRUE(is_proved(decided("exists i in 0..2: 1/i = 1/2")));
  EXPECT_TRUE(is_undecided(decided("exists i in 0..2: 1/i > 1")));
  EXPECT_TRUE(is_proved(decided("forall i in 1..3, j in i..3: i <= j")));
  EXPECT_TRUE(is_proved(decided("forall f in proper_faces(s): thickness(f) <= 1")));
}

TEST(Evaluation, parts_that_need_different_rungs_are_joined) {
  // The logarithm is beyond the algebraic rung, the tie beyond all others.
  EXPECT_TRUE(is_undecided(on_rung<BigInterval>("log2(3) > 1 and sqrt(5 + 2*sqrt(6)) = sqrt(2) + sqrt(3)")));
  EXPECT_TRUE(is_proved(decided("log2(3) > 1 and sqrt(5 + 2*sqrt(6)) = sqrt(2) + sqrt(3)")));
  EXPECT_TRUE(is_refuted(decided("log2(3) > 2 or not sqrt(5 + 2*sqrt(6)) = sqrt(2) + sqrt(3)")));
  EXPECT_TRUE(is_proved(decided("forall i in 2..4: log2(i) <= 2 and sqrt(5 + 2*sqrt(6)) = sqrt(2) + sqrt(3)")));
}

const std::string large_degree = "sqrt(2) + sqrt(3) + sqrt(5) + sqrt(7) + sqrt(11) + sqrt(13) + sqrt(17) + sqrt(19)";

TEST(Evaluation, numbers_of_too_large_a_degree_leave_ties_undecided) {
  EXPECT_TRUE(is_undecided(decided(large_degree + " = " + large_degree)));
  EXPECT_TRUE(is_proved(decided(large_degree + " > 22")));
  // They do not keep the rest from being decided.
  EXPECT_TRUE(is_proved(decided(large_degree + " = " + large_degree + " or sqrt(5 + 2*sqrt(6)) = sqrt(2) + sqrt(3)")));
  EXPECT_EQ(exactly(large_degree), std::nullopt);
}

TEST(Evaluation, after_a_number_of_too_large_a_degree_names_still_mean_what_they_did) {
  // The exception comes from within a definition that has a parameter called gamma0.
  const std::string inside = "hoop_bound(" + large_degree + ", x)";
  EXPECT_TRUE(is_proved(decided("forall i in 1..2: (" + inside +
                                " = 1 or i*x < 1) and sqrt(5 + 2*sqrt(6)) = sqrt(2) + "
                                "sqrt(3)")));
}

TEST(Evaluation, powers_that_no_memory_could_hold_are_left_undecided) {
  EXPECT_TRUE(is_proved(decided("(3^1000000)^1000000 > 1")));
  EXPECT_TRUE(is_undecided(decided("(3^1000000)^1000000 = (3^1000000)^1000000")));
  EXPECT_TRUE(is_undecided(decided("((1 + sqrt(2))^1000000)^1000000 = ((1 + sqrt(2))^1000000)^1000000")));
  EXPECT_TRUE(is_undecided(decided("(sqrt(2)^1000000)^999999 = (sqrt(2)^1000000)^999999")));
}

TEST(Evaluation, integers_beyond_the_range_are_refused_not_cut_off) {
  EXPECT_THROW((void)decided("edge(s, 0, 100000000000000000000) > 0"), InputError);
  EXPECT_THROW((void)decided("forall i in 1..10^30: i > 0"), InputError);
  EXPECT_THROW((void)decided("2^((k*10^18)^64) > 0"), InputError);
  EXPECT_TRUE(is_proved(decided("10^64 > 10^63")));
  EXPECT_TRUE(is_proved(decided("forall i in 10^18 - 1..10^18: i > 10^17")));
}

TEST(Evaluation, indices_beyond_the_simplex_are_refused_unless_guarded) {
  EXPECT_THROW((void)decided("edge(s, 0, 3) > 0"), InputError);
  EXPECT_TRUE(is_proved(decided("k >= 3 implies edge(s, 0, 3) > 0")));
}

TEST(Evaluation, predicates_take_integers_for_numbers) {
  EXPECT_FALSE(is_undecided(decided("is_good(s, 1)")));
  EXPECT_TRUE(is_proved(decided("is_good(s, 1/10)")));
  EXPECT_TRUE(is_undecided(decided("is_good(s, 1/zero)")));
}

TEST(Evaluation, definitions_see_their_parameters_only) {
  // k of the instance is 2; the parameter m is 3.
  EXPECT_TRUE(is_proved(decided("constant_c(3, 1) = 3^(3/2)*2^(4*3^2 + 5*3 + 21)")));
  EXPECT_TRUE(is_proved(decided("constant_c(k + 1, 1) = 3^(3/2)*2^72")));
  EXPECT_TRUE(is_proved(decided("forall m in 2..3: flake_parameter(m, 1/2, 1/4) = 1/4/constant_c(m, 1/2)")));
  EXPECT_TRUE(is_proved(decided("hoop_bound(hoop_bound(x, 1), 1) = 2^26*x")));
}

TEST(Evaluation, without_the_filter_the_rungs_agree_on_a_simplex) {
  for (const char* text : {"circumradius(s) = 5/2", "longest_edge(s) = 5", "altitude(s, 0) = 12/5",
                           "thickness(s) = 6/25", "forall i in 0..k: altitude(s, i) >= 12/5"}) {
    EXPECT_TRUE(is_proved(on_rung<Algebraic>(text))) << text;
    EXPECT_FALSE(is_refuted(on_rung<Interval>(text))) << text;
    EXPECT_FALSE(is_refuted(on_rung<BigInterval>(text))) << text;
    EXPECT_TRUE(is_proved(decided(text))) << text;
  }
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
