#include "kernel/simplex/faces.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace DELCERT_THIS_FILE {

using delcert::Faces;

TEST(Faces, AreAllSubsetsOfTheirSizeOnceInLexicographicOrder) {
  for (std::size_t count = 1; count <= 8; ++count) {
    for (std::size_t size = 1; size <= count; ++size) {
      std::set<std::vector<std::size_t>> expected;
      for (std::size_t mask = 0; mask < (std::size_t{1} << count); ++mask) {
        std::vector<std::size_t> subset;
        for (std::size_t i = 0; i < count; ++i) {
          if ((mask >> i & 1U) != 0) subset.push_back(i);
        }
        if (subset.size() == size) expected.insert(subset);
      }
      std::vector<std::vector<std::size_t>> found;
      for (Faces faces(count, size); faces.has_face(); faces.advance()) found.push_back(faces.vertices());
      EXPECT_TRUE(std::equal(found.begin(), found.end(), expected.begin(), expected.end()))
          << "size " << size << " of " << count;
    }
  }
}

}  // namespace DELCERT_THIS_FILE
