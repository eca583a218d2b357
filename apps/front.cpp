// delcert as it is called: it becomes the program that has the subcommand. It uses the C library alone, so that this
// takes half a millisecond; over FLINT, Arb and Calcium the dynamic linker takes some ten times as long, and would do
// so twice.

#include <linux/limits.h>
#include <unistd.h>

#include <cstdio>
#include <cstring>

#include "apps/program_names.hpp"

namespace delcert {
namespace {

const OtherProgram& program_for(std::string_view subcommand) {
  if (is_among(publishing_commands, subcommand)) return publishing_program;
  if (is_among(claim_commands, subcommand)) return claims_program;
  return certifying_program;
}

/// Replaces the name of a program in `path` by that of another one.
bool put_beside(char (&path)[PATH_MAX], const char* name) {
  char* const end = std::strrchr(path, '/');
  if (end == nullptr || static_cast<std::size_t>(end + 1 - path) + std::strlen(name) >= PATH_MAX) return false;
  std::strcpy(end + 1, name);
  return true;
}

}  // namespace
}  // namespace delcert

int main(int argc, char** argv) {
  using namespace delcert;
  char path[PATH_MAX] = "";
  (void)!readlink("/proc/self/exe", path, sizeof path - 1);
  // If a program is not there, delcert-certify says so.
  for (const OtherProgram& program : {program_for(argc > 1 ? argv[1] : ""), certifying_program})
    if (put_beside(path, program.name)) execv(path, argv);
  std::fprintf(stderr, "delcert: error: internal: %s cannot be run, and %s are its part\n", path,
               certifying_program.part);
  return 70;
}
