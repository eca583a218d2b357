#include <iostream>

#include "apps/program.hpp"

namespace delcert {
namespace {

constexpr AddCommand commands[] = {add_constants, add_sample,    add_certify,   add_check,    add_split,  add_info,
                                   add_cite,      add_figure,    add_bundle,    add_homology, add_export, add_claims,
                                   add_attack,    add_campaign,  add_tighten,   add_power,    add_prove,  add_errata,
                                   add_tables,    add_formalise, add_manifolds, add_report};

}  // namespace
}  // namespace delcert

int main(int argc, char** argv) {
  using namespace delcert;
  return static_cast<int>(run_reporting([&] { return run_program(argc, argv, commands); }, std::cerr));
}
