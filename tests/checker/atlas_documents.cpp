#include "tests/checker/atlas_documents.hpp"

#include <fstream>
#include <iterator>

#include "tests/proofs/certificate/atlas_run.hpp"
#include "tests/support/temporary_folder.hpp"

namespace delcert::checker_tests {
namespace {

Json document_of(const test::AtlasSample<2>& sample) {
  const test::TemporaryFolder folder;
  std::vector<std::string> reasons;
  sample.write(folder / "run.json", sample.claims(reasons));
  std::ifstream file(folder / "run.json", std::ios::binary);
  Json result = Json::parse(std::string(std::istreambuf_iterator<char>(file), {}));
  result.erase("sha256");
  return result;
}
Json document_of(const std::string& atlas, const Rational& radius) {
  return document_of(test::certified_atlas_run<2>(test::atlas_named(atlas), radius));
}

}  // namespace

const Json& sphere_document() {
  static const Json document = document_of(test::glued_sphere_run());
  return document;
}
const Json& coarse_sphere_document() {
  static const Json document = document_of("sphere-2-stereographic", test::ratio(1, 12));
  return document;
}
const Json& torus_document() {
  static const Json document = document_of("torus-2-by-charts", test::ratio(1, 30));
  return document;
}
const Json& cone_document() {
  static const Json document = document_of("cone-torus", test::ratio(1, 36));
  return document;
}

}  // namespace delcert::checker_tests
