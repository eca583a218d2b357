// Point files: the first byte chooses the dimension; what is accepted is written and read again as the same points.
#include "kernel/sample/point_file.hpp"
#include "properties/fuzz/fuzz_target.hpp"
#include "support/error.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace delcert;
  if (size == 0) return 0;
  const Dimension dimension(1 + data[0] % 4);
  try {
    const PointList points = parse_points(fuzz::text_of(data + 1, size - 1), dimension, "a.txt");
    fuzz::require(parse_points(points_text(points), dimension, "a.txt") == points, "points read back");
  } catch (const InputError& error) {
    fuzz::require_message(error.what(), "a.txt");
  }
  return 0;
}
