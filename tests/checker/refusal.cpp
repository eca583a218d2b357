// Built with flags under which the arithmetic is not what the checker needs: says why the self-test refuses.

#include <cstdio>

#include "proofs/checker/program/self_test.hpp"

int main() {
  const std::string fault = delcert::checker::self_test();
  std::printf("%s\n", fault.empty() ? "accepted" : ("refused: " + fault).c_str());
  return fault.empty() ? 0 : 70;
}
