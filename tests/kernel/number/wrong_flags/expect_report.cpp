#include <cstdio>
#include <string_view>

#include "kernel/number/self_test.hpp"

// expect_report any|fma TEXT: succeeds if a failure that the self-test reports contains TEXT; if TEXT is empty, if it
// reports none. With fma, status 77 on a machine without that instruction.
int main(int argument_count, char** arguments) {
  if (argument_count != 3) return 64;
  if (std::string_view(arguments[1]) == "fma" && __builtin_cpu_supports("fma") == 0) return 77;
  const std::string_view expected = arguments[2];
  const auto failures = delcert::arithmetic_self_test();
  bool found = expected.empty() && failures.empty();
  for (const auto& failure : failures) {
    std::printf("reported: %s\n", failure.c_str());
    if (!expected.empty() && failure.find(expected) != std::string_view::npos) found = true;
  }
  if (!found) std::printf("not as expected: %s\n", arguments[2]);
  return found ? 0 : 1;
}
