#include "kernel/manifold/mesh_file.hpp"

#include <gtest/gtest.h>

#include "support/error.hpp"
#include "tests/support/message_of.hpp"
#include "tests/support/ratio.hpp"

namespace delcert::test {
namespace DELCERT_THIS_FILE {

const std::string tetrahedron =
    "OFF # a comment\n4 4 6\n\n0 0 0\n1.5 0 0\n0 -2.5e-1 0\r\n0 0 1/3\n3 0 2 1\n3 0 1 3 255 0 0\n3 1 2 3\n3 0 3 2\n";

std::string refusal(const std::string& text, const std::string& name = "m.off") {
  return message_of<InputError>([&] { (void)parse_mesh(text, name); });
}

TEST(Decimals, are_the_fractions_that_they_are_written_as) {
  EXPECT_EQ(parse_decimal("0.1"), ratio(1, 10));
  EXPECT_EQ(parse_decimal("-12.50"), ratio(-25, 2));
  EXPECT_EQ(parse_decimal("+.5"), ratio(1, 2));
  EXPECT_EQ(parse_decimal("5."), Rational(5));
  EXPECT_EQ(parse_decimal("1e3"), Rational(1000));
  EXPECT_EQ(parse_decimal("1.25E-2"), ratio(1, 80));
  EXPECT_EQ(parse_decimal("-0"), Rational(0));
  EXPECT_EQ(parse_decimal("3/4"), ratio(3, 4));
  EXPECT_EQ(parse_decimal("0x3p-2"), ratio(3, 4));
  EXPECT_NE(parse_decimal("0.1"), Rational::exactly(0.1));
  for (const std::string_view text :
       {"", ".", "-", "1.2.3", "1e", "1e401", "1e-401", "nan", "inf", "1,5", "1.5f", "--1", "1e2.5"})
    EXPECT_THROW((void)parse_decimal(text), InputError) << text;
}

TEST(MeshFile, reads_off) {
  const TriangleMesh mesh = parse_mesh(tetrahedron, "m.off");
  ASSERT_EQ(mesh.points.size(), 4U);
  EXPECT_EQ(mesh.points[1][0], ratio(3, 2));
  EXPECT_EQ(mesh.points[2][1], ratio(-1, 4));
  EXPECT_EQ(mesh.points[3][2], ratio(1, 3));
  ASSERT_EQ(mesh.triangles.size(), 4U);
  EXPECT_EQ(mesh.triangles[1], (std::array<std::uint32_t, 3>{0, 1, 3}));
}

TEST(MeshFile, reads_obj_as_the_same) {
  const TriangleMesh off = parse_mesh(tetrahedron, "m.off");
  const TriangleMesh obj = parse_mesh(
      "o thing\nv 0 0 0\nv 1.5 0 0\nv 0 -0.25 0\nv 0 0 1/3\nvn 0 0 1\nf 1 3 2\nf 1//1 2//1 4//1\nf 2/1/1 3/2/1 "
      "4/3/1\nf -4 -1 -2\n",
      "m.obj");
  EXPECT_EQ(obj.points, off.points);
  EXPECT_EQ(obj.triangles, off.triangles);
}

TEST(MeshFile, says_what_is_wrong_and_where) {
  EXPECT_EQ(refusal("COFF\n1 1 0\n"), "m.off:1: expected the word OFF");
  EXPECT_EQ(refusal("OFF\n4\n"), "m.off:2: expected the numbers of vertices, faces and edges");
  EXPECT_TRUE(mentions(refusal("OFF\n-4 4 0\n"), "m.off:2: numbers of vertices and faces that no mesh"));
  EXPECT_EQ(refusal("OFF\n3 1 0\n0 0 0\n1 0\n"), "m.off:4: vertex 1: found 2 words, expected three coordinates");
  EXPECT_EQ(refusal("OFF\n3 1 0\n0 0 0\n1 0 0 1\n"), "m.off:4: vertex 1: found 4 words, expected three coordinates");
  EXPECT_TRUE(mentions(refusal("OFF\n3 1 0\n0 0 1.x\n"), "m.off:3: coordinate 3: found \"1.x\""));
  const std::string vertices = "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n";
  EXPECT_EQ(refusal(vertices), "m.off:5: the end of the file at face 0 of 1");
  EXPECT_EQ(refusal(vertices + "4 0 1 2 0\n"), "m.off:6: a face that is no triangle: expected 3 and three vertices");
  EXPECT_EQ(refusal(vertices + "3 0 1 3\n"), "m.off:6: vertex 3 of a face, counted from 0, where there are 3");
  EXPECT_EQ(refusal(vertices + "3 0 1 1\n"), "m.off:6: a face that has a vertex twice");
  EXPECT_EQ(refusal(vertices + "3 0 1 2\n3 0 1 2\n"), "m.off:7: more than the faces that were announced");
  EXPECT_EQ(refusal(vertices + "3 0 1 a\n"), "m.off:6: found \"a\", expected a vertex");
  EXPECT_EQ(refusal(vertices + "3 0 1 2\n"), "accepted");
  EXPECT_EQ(refusal("OFF\n4 1 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 1 2\n"),
            "m.off: vertex 3, counted from 0, is in no face");
  EXPECT_EQ(refusal("OFF\n0 0 0\n"), "m.off: no triangles");
  EXPECT_EQ(refusal("v 1 2\n", "m.obj"), "m.obj:1: a vertex without exactly three coordinates");
  EXPECT_EQ(refusal("v 0 0 0\nf 1 1 2\n", "m.obj"), "m.obj:2: vertex 1 of a face, counted from 0, where there are 1");
  EXPECT_TRUE(mentions(refusal("curv 1 2\n", "m.obj"), "m.obj:1: found \"curv\""));
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
