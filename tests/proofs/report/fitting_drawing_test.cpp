#include "proofs/report/fitting_drawing.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "proofs/report/decimation.hpp"
#include "tests/proofs/drawing/drawn_certificates.hpp"

namespace delcert {
namespace DELCERT_THIS_FILE {

using test::drawn_certificates;

std::size_t bytes_of(const PackedDrawing& packed) { return packed.block.size() + packed.description.dump().size(); }

std::vector<std::string> no_coordinates(const Drawing& drawing) {
  return std::vector<std::string>(drawing.labels.size(), "1/3 2/3");
}

PageBudget of_bytes(std::size_t bytes) { return {bytes, 0, bytes, 500000}; }

TEST(FittingDrawing, has_budgets_of_a_simplex_and_of_a_page) {
  const PageBudget budget;
  EXPECT_EQ(budget.bytes(0), 600000U);
  EXPECT_EQ(budget.bytes(66485), 600000U + 598365U);
  EXPECT_EQ(budget.bytes(1000000), 4800000U);
}

TEST(FittingDrawing, has_everything_where_there_is_room) {
  for (const auto& [family, certificate] : drawn_certificates()) {
    const Drawing drawing = drawing_of(certificate, {});
    const FittingDrawing fitting = fitting_drawing(drawing, no_coordinates(drawing));
    EXPECT_TRUE(fitting.notes.empty()) << family;
    EXPECT_EQ(fitting.packed.block, packed_drawing(drawing, no_coordinates(drawing), {}).block) << family;
  }
}

TEST(FittingDrawing, leaves_out_details_and_then_simplices_until_it_fits) {
  for (const auto& [family, certificate] : drawn_certificates()) {
    const Drawing drawing = drawing_of(certificate, {});
    const std::vector<std::string> exact = no_coordinates(drawing);
    const std::size_t least_detail = bytes_of(packed_drawing(drawing, exact, {1, false, false}));
    const Drawing stars = decimated(drawing, 0);
    const std::size_t least = bytes_of(packed_drawing(stars, exact, {1, false, false}));

    const FittingDrawing all = fitting_drawing(drawing, exact, of_bytes(least_detail));
    EXPECT_LE(bytes_of(all.packed), least_detail) << family;
    EXPECT_EQ(all.notes.size(), 1U) << family;

    if (stars.simplex_count() == drawing.simplex_count()) continue;
    for (const std::size_t bytes : {least_detail - 1, (least + least_detail) / 2, least}) {
      const FittingDrawing part = fitting_drawing(drawing, exact, of_bytes(bytes));
      EXPECT_LE(bytes_of(part.packed), bytes) << family;
      ASSERT_EQ(part.notes.size(), 2U) << family;
      EXPECT_NE(part.notes[1].find("of the " + std::to_string(drawing.simplex_count()) + " simplices"),
                std::string::npos)
          << family;
    }
    // What simplices may take is counted for all of them: fewer do not make the budget smaller.
    const std::size_t a_simplex = (least + least_detail) / 2 / drawing.simplex_count();
    const FittingDrawing part = fitting_drawing(drawing, exact, {0, a_simplex, least_detail, 500000});
    if (a_simplex * drawing.simplex_count() > least) {
      EXPECT_GT(10 * bytes_of(part.packed), 8 * a_simplex * drawing.simplex_count()) << family;
    }
    // The stars of the worst are there whatever they take.
    EXPECT_EQ(bytes_of(fitting_drawing(drawing, exact, of_bytes(10)).packed), least) << family;
  }
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert
