// A check in parts, put together from receipts: says what one check says, or that something is not there once.

#include "proofs/checker/program/merge.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <random>

#include "proofs/checker/core/core.hpp"
#include "tests/checker/merge.hpp"
#include "tests/checker/support/forgeries.hpp"
#include "tests/checker/support/metric_field_documents.hpp"
#include "tests/checker/support/run_checker.hpp"
#include "tests/checker/support/samples.hpp"
#include "tests/checker/support/space_form_samples.hpp"
#include "tests/checker/upwards.hpp"
#include "tests/support/temporary_folder.hpp"

namespace delcert::checker_tests {
namespace {

using checker::NamedReceipt;

checker::Outcome outcome_of_share(const std::string& certificate, const checker::Share& share) {
  checker::own_share = share;
  checker::Outcome outcome = checker::check(certificate, {});
  checker::own_share = {};
  return outcome;
}

/// Through its text, as from a file.
NamedReceipt receipt_of_share(const std::string& certificate, const checker::Share& share) {
  const std::string text = checker::receipt_text({"1.0", outcome_of_share(certificate, share)});
  return {std::to_string(share.number) + "of" + std::to_string(share.of), checker::receipt_of(text)};
}

std::vector<NamedReceipt> receipts_of_parts(const std::string& certificate, std::uint64_t number) {
  std::vector<NamedReceipt> all;
  for (std::uint64_t k = 1; k <= number; ++k) all.push_back(receipt_of_share(certificate, {k, number}));
  return all;
}

/// But for how long it took.
std::string words_of(const checker::Outcome& outcome) {
  Json json = Json::parse(checker::as_json("", outcome));
  for (Json& level : json["levels"]) level.erase("seconds");
  const std::string text = checker::as_text(outcome);
  return json.dump() + text.substr(text.rfind('\n', text.size() - 2));
}

/// The rule by which receipts are refused, and the status; nothing if they are not.
std::string refusal(const std::vector<NamedReceipt>& all, const std::string& content = "") {
  try {
    (void)checker::merged(all, "1.0", content);
    return "";
  } catch (const checker::Refused& reason) {
    return reason.rule + " " + std::to_string(reason.status) + ": " + reason.what;
  }
}

const std::string& torus_of_parts() {
  static const std::string bytes = sealed(narrow_torus().document());
  return bytes;
}

}  // namespace

void expect_the_same_in_parts(const std::string& certificate, const std::vector<unsigned>& numbers) {
  const test::Upwards upwards;
  const checker::Outcome whole = outcome_of_share(certificate, {});
  ASSERT_EQ(whole.status, 0) << checker::as_text(whole);
  for (const unsigned number : numbers) {
    std::vector<NamedReceipt> all = receipts_of_parts(certificate, number);
    std::shuffle(all.begin(), all.end(), std::mt19937_64(number));
    EXPECT_EQ(words_of(checker::merged(all, "1.0", whole.content)), words_of(whole)) << number << " parts";
    for (const NamedReceipt& one : all) {
      const std::string text = checker::as_text(one.receipt.outcome);
      EXPECT_EQ(text.find("verified") == std::string::npos, number > 1) << text;
    }
  }
}

namespace {

TEST(MergedReceipts, say_what_one_check_says) {
  for (const Sample* sample : {&wide_torus(), &narrow_torus(), &skewed_torus(), &circle(), &disc()})
    expect_the_same_in_parts(sealed(sample->document()), {1, 2, 3, 7});
  expect_the_same_in_parts(sealed(four_torus().document()), {3});
  for (const SpaceFormSample* sample :
       {&icosphere(), &projective_plane(), &projective_space(), &bolza_surface(), &klein_bottle()})
    expect_the_same_in_parts(sealed(sample->document()), {2, 5});
  expect_the_same_in_parts(sealed(icosphere().claiming({"1", "2", "5"}).document()), {3});
  expect_the_same_in_parts(sealed(flat_document()), {3});
  for (const auto& [name, bytes] : valid_graded_certificates()) expect_the_same_in_parts(bytes, {4});
}

TEST(MergedReceipts, of_more_parts_than_labels_say_what_one_check_says) {
  expect_the_same_in_parts(sealed(circle().document()), {100});
  // Part 1 has nothing to do in loops of less than 100 items: it must be there all the same.
  const test::Upwards upwards;
  std::vector<NamedReceipt> all = receipts_of_parts(sealed(circle().document()), 100);
  for (std::size_t k = 0; k < all.size(); k += 9) {
    std::vector<NamedReceipt> without = all;
    without.erase(without.begin() + static_cast<std::ptrdiff_t>(k));
    EXPECT_EQ(refusal(without).substr(0, 16), "merge.missing 2:") << k;
  }
}

TEST(MergedReceipts, may_be_of_parts_of_different_sizes) {
  const test::Upwards upwards;
  std::vector<NamedReceipt> all{receipt_of_share(torus_of_parts(), {1, 2}), receipt_of_share(torus_of_parts(), {3, 4}),
                                receipt_of_share(torus_of_parts(), {7, 8})};
  EXPECT_EQ(refusal(all).substr(0, 16), "merge.missing 2:");
  all.push_back(receipt_of_share(torus_of_parts(), {8, 8}));
  EXPECT_EQ(words_of(checker::merged(all, "1.0", "")), words_of(outcome_of_share(torus_of_parts(), {})));
}

/// A part that rejects: the whole is rejected, whatever the others say, and whether they are there or not.
TEST(MergedReceipts, are_rejected_if_a_part_is) {
  const test::Upwards upwards;
  std::size_t number = 0, by_one_part = 0;
  for (const auto make :
       {level_0_forgeries, star_forgeries, core_forgeries, configuration_forgeries, space_form_forgeries}) {
    for (const Forgery& forgery : made_once(make)) {
      if (forgery.status != 1 || number++ % 3 != 0) continue;
      const std::vector<NamedReceipt> all = receipts_of_parts(forgery.bytes, 3);
      const auto is_rejected = [](const NamedReceipt& one) { return one.receipt.outcome.status == 1; };
      by_one_part += std::count_if(all.begin(), all.end(), is_rejected) == 1 ? 1U : 0U;
      try {
        EXPECT_EQ(checker::merged(all, "1.0", "").status, 1) << forgery.name;
      } catch (const checker::Refused& reason) {
        // What no part sees alone.
        EXPECT_EQ(reason.rule, "merge.count") << forgery.name << reason.what;
        EXPECT_EQ(forgery.rule, "2.count") << forgery.name;
      }
    }
  }
  EXPECT_GT(number, 20U);
  EXPECT_GT(by_one_part, 5U) << "others are rejected by each of their parts";
}

TEST(MergedReceipts, that_count_too_few_faces_are_refused) {
  const test::Upwards upwards;
  for (const char* key : {"simplices", "euler_characteristic"}) {
    Json document = narrow_torus().document();
    document["levels"]["2"][key] = document["levels"]["2"][key].get<int>() + 1;
    EXPECT_EQ(outcome_of_share(sealed(document), {}).status, 1);
    const std::vector<NamedReceipt> all = receipts_of_parts(sealed(document), 3);
    for (const NamedReceipt& one : all) EXPECT_EQ(one.receipt.outcome.status, 0) << "no part counts all";
    EXPECT_EQ(refusal(all).substr(0, 14), "merge.count 1:") << key;
  }
}

/// In how many of five parts core.hinges seems to hold.
std::size_t parts_that_seem_delaunay(const std::string& certificate) {
  const checker::Certificate c(certificate);
  std::size_t number = 0;
  for (std::uint64_t k = 1; k <= 5; ++k) {
    checker::own_share = {k, 5};
    checker::Report report;
    checker::core::Core core(c);
    core.check_manifold(report);
    EXPECT_TRUE(report.findings.empty());
    number += core.is_delaunay() ? 1U : 0U;
  }
  checker::own_share = {};
  return number;
}

/// Where lifts are found in a shorter way if the complex is Delaunay, that must not be concluded from a part of it.
TEST(MergedReceipts, know_in_every_part_where_hinges_are_not_delaunay_if_no_level_claims_that_they_are) {
  const test::Upwards upwards;
  std::size_t number = 0;
  for (const Forgery& forgery : made_once(core_forgeries)) {
    if (forgery.rule != "core.hinges") continue;
    ++number;
    EXPECT_GT(parts_that_seem_delaunay(forgery.bytes), 0U) << "level 4 is rejected in other parts";
    Json document = Json::parse(forgery.bytes);
    document.erase("sha256");
    for (const char* level : {"4", "5", "6"}) document["levels"].erase(level);
    EXPECT_EQ(parts_that_seem_delaunay(sealed(document)), 0U) << forgery.name;
  }
  EXPECT_GT(number, 0U);
}

/// Receipts in files, of three parts.
class Merge : public testing::Test {
 protected:
  Merge() {
    write("certificate", torus_of_parts());
    for (const char* k : {"1", "2", "3"}) EXPECT_EQ(part(k, "3", "certificate").status, 0);
  }
  [[nodiscard]] std::string at(const std::string& name) const { return (folder_ / name).string(); }
  void write(const std::string& name, const std::string& bytes) const {
    std::ofstream(at(name), std::ios::binary) << bytes;
  }
  [[nodiscard]] std::string read(const std::string& name) const {
    std::ifstream file(at(name), std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
  }
  [[nodiscard]] CheckerRun part(const std::string& number, const std::string& of, const std::string& name) const {
    return run_checker_with("--part " + number + "/" + of + " --receipt " + at(name + number) + " " + at(name));
  }
  [[nodiscard]] CheckerRun merge(const std::vector<std::string>& names, const std::string& options = "") const {
    std::string arguments = options + " --merge";
    for (const std::string& name : names) arguments += " " + at(name);
    return run_checker_with(arguments);
  }
  /// A receipt with a seal that fits.
  void alter(const std::string& from, const std::string& to, const std::function<void(Json&)>& change) const {
    Json json = Json::parse(read(from));
    json.erase("sha256");
    change(json);
    write(to, sealed(json));
  }
  const std::string all_ = "certificate1 certificate2 certificate3";

 private:
  const test::TemporaryFolder folder_;
};

std::string last_line(const std::string& text) { return text.substr(text.rfind('\n', text.size() - 2) + 1); }

TEST_F(Merge, prints_the_line_of_the_whole) {
  const CheckerRun whole = run_checker_with(at("certificate"));
  EXPECT_EQ(last_line(whole.output).substr(0, 16), "verified: levels");
  for (const std::vector<std::string>& names :
       std::vector<std::vector<std::string>>{{"certificate1", "certificate2", "certificate3"},
                                             {"certificate3", "certificate", "certificate1", "certificate2"}}) {
    const CheckerRun run = merge(names);
    EXPECT_EQ(run.status, 0) << run.output;
    EXPECT_EQ(last_line(run.output), last_line(whole.output));
    EXPECT_EQ(run.output.substr(0, run.output.find('\n')), whole.output.substr(0, whole.output.find('\n')));
  }
  EXPECT_EQ(merge({"certificate1", "certificate2", "certificate3"}, "--quiet").output, "");
  const CheckerRun part = this->part("2", "3", "certificate");
  EXPECT_EQ(last_line(part.output).substr(0, 26), "passed, part 2/3: levels 0") << part.output;
  EXPECT_EQ(Json::parse(merge({"certificate1", "certificate2", "certificate3"}, "--json").output)["status"],
            "verified");
}

TEST_F(Merge, works_where_parts_are_checked_by_several_processes) {
  const std::string options = "--threads 2 --part 2/3 --receipt " + at("threads") + " ";
  EXPECT_EQ(run_checker_with(options + at("certificate")).status, 0);
  EXPECT_EQ(last_line(merge({"certificate1", "threads", "certificate3"}).output),
            last_line(run_checker_with(at("certificate")).output));
}

struct WrongReceipts {
  std::string rule;
  int status;
  std::vector<std::string> names;
  std::string message;
};

/// Each is refused by its rule, and accepted without it.
TEST_F(Merge, refuses_what_is_not_one_whole) {
  write("other", sealed(wide_torus().document()));
  EXPECT_EQ(part("2", "3", "other").status, 0);
  EXPECT_EQ(run_checker_with("--part 2/2 --receipt " + at("half2") + " " + at("certificate")).status, 0);
  EXPECT_EQ(run_checker_with("--part 2/3 --receipt " + at("again2") + " " + at("certificate")).status, 0);
  EXPECT_EQ(run_checker_with("--part 1/2 --receipt " + at("half1") + " " + at("certificate")).status, 0);
  alter("certificate2", "old2", [](Json& json) { json["checker"] = "0.0.1"; });
  alter("certificate2", "few2", [](Json& json) {
    for (Json& level : json["levels"]) {
      if (level["level"] == "2") level["ranges"][1]["counts"]["simplices"] = 1;
    }
  });
  alter("certificate2", "without2", [](Json& json) {
    Json& level =
        *std::find_if(json["levels"].begin(), json["levels"].end(), [](Json& one) { return one["level"] == "1"; });
    level["ranges"].clear();
  });
  alter("certificate2", "unclaimed2", [](Json& json) { json["levels"].erase(json["levels"].size() - 1); });
  alter("certificate2", "undone2", [](Json& json) {
    for (Json& level : json["levels"]) level["left"].clear();
  });
  const std::string one = "certificate1", two = "certificate2", three = "certificate3";
  for (const WrongReceipts& wrong : std::vector<WrongReceipts>{
           {"merge.missing", 2, {one, three}, "what lies between 1/3 and 2/3 of each loop is missing"},
           {"merge.missing", 2, {one, two}, "what lies between 2/3 and 1/1 of each loop is missing"},
           {"merge.missing", 2, {two, three}, "part 1, which does what is not divided, is missing"},
           {"merge.doubled", 1, {one, two, three, "again2"}, "are of the same part"},
           {"merge.overlap", 1, {one, two, three, "half2"}, "where another part ends"},
           {"merge.doubled", 1, {"half1", "half2", one}, "has done what is not divided, as"},
           {"merge.certificate", 3, {one, "other2", three}, "of another certificate than"},
           {"merge.certificate", 3, {one, two, three, "other"}, "of a certificate with the SHA-256"},
           {"merge.version", 3, {one, "old2", three}, "by version 0.0.1 of the checker, and this is"},
           {"merge.count", 1, {one, "few2", three}, "level 2: expected are simplices 392, and the receipts add up to"},
           {"merge.rules", 1, {one, "without2", three}, "where"},
           {"merge.rules", 1, {one, "unclaimed2", three}, "has nothing where"},
           {"merge.rules", 1, {one, "undone2", three}, "where"}}) {
    std::string files;
    for (const std::string& name : wrong.names) files += " " + at(name);
    const CheckerRun run = run_checker_with("--merge" + files);
    EXPECT_EQ(run.status, wrong.status) << run.output;
    EXPECT_NE(run.output.find("error: " + wrong.rule + ": "), std::string::npos) << files << "\n" << run.output;
    EXPECT_NE(run.output.find(wrong.message), std::string::npos) << wrong.message << "\n" << run.output;
    EXPECT_EQ(run.output.find("verified"), std::string::npos) << run.output;
    const CheckerRun without = run_crippled_checker_with("--without-rule " + wrong.rule + " --merge" + files);
    EXPECT_EQ(without.output.find(wrong.rule), std::string::npos) << without.output;
  }
  EXPECT_EQ(merge({one, two, three}).status, 0) << "what was changed were copies";
}

/// Whatever is changed in a receipt, one does not get through that covers less. What may change: how much was decided
/// and how long it took, words in summaries, and counts that the certificate does not bound.
TEST_F(Merge, refuses_whatever_is_altered_in_a_receipt) {
  const std::string whole = last_line(run_checker_with(at("certificate")).output);
  Json json = Json::parse(read("certificate2"));
  json.erase("sha256");
  std::vector<Json::json_pointer> leaves;
  const std::function<void(const Json&, const Json::json_pointer&)> collect = [&](const Json& value,
                                                                                  const Json::json_pointer& place) {
    if (!value.is_structured()) leaves.push_back(place);
    for (const auto& [key, below] : value.items()) {
      if (value.is_object()) collect(below, place / key);
      if (value.is_array()) collect(below, place / std::stoul(key));
    }
  };
  collect(json, Json::json_pointer());
  EXPECT_GT(leaves.size(), 60U);
  std::size_t refused = 0;
  const test::Upwards upwards;
  const std::vector<NamedReceipt> others{{"1", checker::receipt_of(read("certificate1"))},
                                         {"3", checker::receipt_of(read("certificate3"))}};
  for (const Json::json_pointer& leaf : leaves) {
    Json altered = json;
    Json& value = altered[leaf];
    value = value.is_string() ? Json(value.get<std::string>() + "0") : Json(value.get<std::int64_t>() + 1);
    const std::string name = leaf.to_string();
    const auto has = [&](const char* word) { return name.find(word) != std::string::npos; };
    const bool may_change = has("/decisions/") || has("/microseconds") || has("/summary") || has("/sets") ||
                            has("/close") ||
                            (has("/manifold/") && !has("manifold_sha256"));  // that of the first part is printed
    std::vector<NamedReceipt> all = others;
    std::string rule;
    try {
      all.push_back({"2", checker::receipt_of(sealed(altered))});
      (void)checker::merged(all, others[0].receipt.checker, "");
    } catch (const checker::Malformed& reason) {
      rule = reason.rule;
    } catch (const checker::Refused& reason) {
      rule = reason.rule;
    }
    EXPECT_EQ(rule.empty(), may_change) << name << " " << rule;
    refused += rule.empty() ? 0U : 1U;
    // Without a new seal no change gets through.
    std::string text = altered.dump();
    text.pop_back();
    const std::string bytes = read("certificate2");
    EXPECT_THROW((void)checker::receipt_of(text + bytes.substr(bytes.rfind(",\"sha256\":"))), checker::Malformed)
        << name;
  }
  EXPECT_GT(refused, 40U);
}

TEST_F(Merge, refuses_files_that_are_no_receipts) {
  const std::string right = read("certificate2");
  std::size_t number = 0;
  for (const std::string& bytes :
       {right.substr(0, right.size() / 2), right.substr(0, right.size() - 1), right + "\n", std::string("{}"),
        std::string(), "{\"format\":\"delcert-receipt\"," + right.substr(1)}) {
    write("wrong", bytes);
    const CheckerRun run = merge({"certificate1", "wrong", "certificate3"});
    EXPECT_EQ(run.status, 3) << number << run.output;
    EXPECT_NE(run.output.find("wrong: merge.receipt: "), std::string::npos) << number << run.output;
    ++number;
  }
  alter("certificate2", "wrong", [](Json& json) { json["levels"][0]["summary"] = "\x1b[2J"; });
  EXPECT_NE(merge({"certificate1", "wrong", "certificate3"}).output.find("cannot be printed"), std::string::npos);
  EXPECT_EQ(merge({"certificate"}).status, 3);
  EXPECT_EQ(merge({"absent"}).status, 3);
  write("broken", torus_of_parts().substr(0, torus_of_parts().size() - 4) + "0\"}\n");
  const CheckerRun run = merge({"certificate1", "certificate2", "certificate3", "broken"});
  EXPECT_EQ(run.status, 3);
  EXPECT_NE(run.output.find("broken: seal: "), std::string::npos) << run.output;
}

TEST_F(Merge, and_parts_check_their_command_line) {
  const std::string file = at("certificate"), receipt = " --receipt " + at("new");
  for (const char* part : {"0/3", "4/3", "1", "1/", "/3", "1/3x", "-1/3", "1/1000001", "a/b"}) {
    const CheckerRun run = run_checker_with("--part " + std::string(part) + receipt + " " + file);
    EXPECT_EQ(run.status, 64) << part;
  }
  for (const std::string& arguments :
       {"--part 1/3 " + file, receipt + " " + file, "--part 1/3" + receipt + " " + file + " " + file,
        "--part 1/3 --levels 1" + receipt + " " + file, "--part 1/3 --expect-manifold " + file + receipt + " " + file,
        "--merge --part 1/3" + receipt + " " + file, "--merge --levels 1 " + file, "--merge --threads 2 " + file,
        std::string("--merge")})
    EXPECT_EQ(run_checker_with(arguments).status, 64) << arguments;
  EXPECT_FALSE(std::filesystem::exists(at("new")));
  write("cut", torus_of_parts().substr(0, 100));
  EXPECT_EQ(run_checker_with("--part 1/3" + receipt + " " + at("cut")).status, 3);
  EXPECT_FALSE(std::filesystem::exists(at("new"))) << "no receipt for what is malformed";
  EXPECT_EQ(run_checker_with("--part 1/3 --receipt " + at("nowhere/receipt") + " " + file).status, 70);
}

}  // namespace
}  // namespace delcert::checker_tests
