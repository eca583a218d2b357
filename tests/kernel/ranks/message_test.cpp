#include "kernel/ranks/message.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace delcert::test {
namespace DELCERT_THIS_FILE {

TEST(Messages, are_read_as_they_were_written) {
  MessageWriter out;
  EXPECT_TRUE(out.is_empty());
  const std::vector<Rational> numbers{Rational(0),
                                      Rational(-3),
                                      Rational(Integer(1), Integer(3)),
                                      Rational::power_of_two(-48),
                                      Rational::power_of_two(-2000),
                                      Rational::exactly(0x1.23456789abcdep-7)};
  out.put(std::uint32_t{7});
  for (const Rational& x : numbers) out.put(x);
  out.put(std::string("a\0b", 3));
  out.put(std::array<Rational, 2>{numbers[2], numbers[3]});
  const Message message = out.take();
  MessageReader in(message);
  EXPECT_EQ(in.get<std::uint32_t>(), 7U);
  for (const Rational& x : numbers) EXPECT_EQ(in.get_rational(), x);
  EXPECT_EQ(in.get_text(), std::string("a\0b", 3));
  EXPECT_EQ(in.get_point<2>(), (std::array<Rational, 2>{numbers[2], numbers[3]}));
  EXPECT_TRUE(in.is_at_end());
}

TEST(Messages, that_are_cut_off_or_no_numbers_are_refused) {
  MessageWriter out;
  out.put(Rational(1));
  Message message = out.take();
  message.pop_back();
  EXPECT_THROW((void)MessageReader(message).get_rational(), std::runtime_error);
  message[0] = 9;
  EXPECT_THROW((void)MessageReader(message).get_rational(), std::runtime_error);
  out.put('\0');
  out.put(std::numeric_limits<double>::infinity());
  const Message infinite = out.take();
  EXPECT_THROW((void)MessageReader(infinite).get_rational(), std::runtime_error);
  out.put(std::uint64_t{1} << 63U);
  const Message long_text = out.take();
  EXPECT_THROW((void)MessageReader(long_text).get_text(), std::runtime_error);
}

}  // namespace DELCERT_THIS_FILE
}  // namespace delcert::test
