// The program around the checks: its command line, several files, the report that it writes.

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>

#include "tests/checker/support/run_checker.hpp"
#include "tests/checker/support/samples.hpp"

namespace delcert::checker_tests {
namespace {

namespace fs = std::filesystem;

/// A folder of files that is removed at the end: one for each thing that can become of a certificate.
class Program : public testing::Test {
 protected:
  Program() {
    fs::create_directories(folder_);
    write("right", sealed(circle().document()));
    Json document = circle().document();
    document["points"][3][0] = "1/3";
    write("wrong", sealed(document));
    write("cut", sealed(circle().document()).substr(0, 100));
    // The same certificate under another name: what is printed tells files apart.
    write("also-right", sealed(circle().document()));
  }
  ~Program() override { fs::remove_all(folder_); }

  [[nodiscard]] std::string at(const std::string& name) const { return (folder_ / name).string(); }
  void write(const std::string& name, const std::string& bytes) const {
    std::ofstream(at(name), std::ios::binary) << bytes;
  }
  [[nodiscard]] Json report() const {
    std::ifstream file(at("report.json"));
    return Json::parse(std::string((std::istreambuf_iterator<char>(file)), {}));
  }

 private:
  fs::path folder_ = fs::temp_directory_path() / ("delcert-program-" + std::to_string(::getpid()) + "-" +
                                                  testing::UnitTest::GetInstance()->current_test_info()->name());
};

TEST_F(Program, checks_its_command_line) {
  const std::string file = at("right");
  EXPECT_EQ(run_checker_with("").status, 64);
  EXPECT_EQ(run_checker_with("--without-rule seal " + file).status, 64) << "the real program leaves out no rule";
  EXPECT_EQ(run_checker_with(file + " --levels").status, 64);
  EXPECT_EQ(run_checker_with(file + " --levels 7").status, 64);
  EXPECT_EQ(run_checker_with(file + ".absent").status, 3);
  EXPECT_EQ(run_checker_with("--help").status, 0);
  EXPECT_EQ(run_checker_with("--quiet " + file).output, "");
  EXPECT_EQ(run_checker_with("--quiet " + file).status, 0);
  EXPECT_EQ(run_checker_with("--quiet --json " + file).output, "");
  EXPECT_EQ(run_checker_with("--levels 3,0 " + file).status, 0);
  const CheckerRun some = run_checker_with(file + " --levels 3");
  EXPECT_EQ(some.status, 0);
  EXPECT_NE(some.output.find("verified: levels 0 3; claimed but not checked: 1 2 2s 4 5 6"), std::string::npos)
      << some.output;
  write("part", sealed(circle().claiming({"0"}).document()));
  EXPECT_EQ(run_checker_with(at("part") + " --levels 1").status, 64) << "a level that is not claimed is not verified";
}

TEST_F(Program, ends_with_the_status_of_the_worst_file) {
  const auto status = [&](const std::string& names) { return run_checker_with("--quiet " + names).status; };
  const std::string right = at("right"), wrong = at("wrong"), cut = at("cut"), absent = at("absent");
  EXPECT_EQ(status(right + " " + at("also-right")), 0);
  EXPECT_EQ(status(right + " " + wrong), 1);
  EXPECT_EQ(status(wrong + " " + right), 1) << "also where the last one is right";
  EXPECT_EQ(status(right + " " + cut + " " + right), 3);
  EXPECT_EQ(status(cut + " " + wrong), 1) << "a false certificate is worse than none";
  EXPECT_EQ(status(right + " " + absent), 3);
}

TEST_F(Program, says_of_each_file_what_it_says_of_it_alone) {
  const CheckerRun both = run_checker_with(at("right") + " " + at("wrong") + " --json"),
                   first = run_checker_with("--json " + at("right"));
  const std::size_t end = both.output.find('\n');
  ASSERT_NE(end, std::string::npos);
  Json one = Json::parse(both.output.substr(0, end)), alone = Json::parse(first.output);
  const Json two = Json::parse(both.output.substr(end + 1));
  for (Json* object : {&one, &alone}) {
    for (auto& level : (*object)["levels"]) level.erase("seconds");
  }
  EXPECT_EQ(one, alone);
  EXPECT_EQ(two["file"], at("wrong"));
  EXPECT_EQ(two["status"], "rejected");
  const std::string text = run_checker_with(at("right") + " " + at("wrong")).output;
  EXPECT_LT(text.find(at("right") + "\n"), text.find("verified: levels")) << text;
  EXPECT_LT(text.find("verified: levels"), text.find(at("wrong") + "\n")) << text;
}

TEST_F(Program, writes_what_it_has_found_to_a_report) {
  const CheckerRun run =
      run_checker_with(at("right") + " " + at("wrong") + " " + at("absent") + " --quiet --report " + at("report.json"));
  EXPECT_EQ(run.status, 1);
  const Json report = this->report();
  EXPECT_EQ(report["exit"], 1);
  ASSERT_EQ(report["certificates"].size(), 3U);
  EXPECT_EQ(report["certificates"][0]["status"], "verified");
  EXPECT_EQ(report["certificates"][1]["status"], "rejected");
  EXPECT_EQ(report["certificates"][2]["status"], "error");
  EXPECT_EQ(report["certificates"][2]["exit"], 3);
  EXPECT_FALSE(report["checker"]["version"].get<std::string>().empty());
  EXPECT_FALSE(report["host"]["machine"].get<std::string>().empty());
  EXPECT_EQ(report["time"].get<std::string>().size(), std::string("2026-01-01T00:00:00Z").size());
}

TEST_F(Program, that_cannot_write_its_report_says_so_and_leaves_nothing) {
  const CheckerRun run = run_checker_with(at("right") + " --report " + at("nowhere/report.json"));
  EXPECT_EQ(run.status, 70) << "a report that was asked for is not there";
  EXPECT_NE(run.output.find("nowhere/report.json: cannot be written"), std::string::npos) << run.output;
  fs::create_directories(at("report.json"));
  EXPECT_EQ(run_checker_with(at("right") + " --report " + at("report.json")).status, 70);
  std::size_t files = 0;
  for ([[maybe_unused]] const auto& entry : fs::directory_iterator(fs::path(at("right")).parent_path())) ++files;
  EXPECT_EQ(files, 5U) << "the four certificates, and the folder in the place of the report";
}

TEST_F(Program, does_not_let_one_file_s_limit_end_the_next) {
  write("large", sealed(cubic_torus().document()));
  const CheckerRun run = run_checker_with(at("large") + " " + at("right") + " --memory-limit 24 --json");
  EXPECT_EQ(run.status, 2);
  const std::size_t end = run.output.find('\n');
  ASSERT_NE(end, std::string::npos) << run.output;
  EXPECT_EQ(Json::parse(run.output.substr(0, end))["status"], "undecided") << run.output;
  EXPECT_EQ(Json::parse(run.output.substr(end + 1))["status"], "verified") << run.output;
}

}  // namespace
}  // namespace delcert::checker_tests
