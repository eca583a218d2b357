#include "tests/checker/mutation_campaign.hpp"

#include <array>
#include <cstdlib>
#include <fstream>
#include <iterator>

#include "support/build_commit.hpp"
#include "tests/checker/mutation.hpp"

namespace delcert::checker_tests {
namespace {

/// What became of mutations.
struct Tally {
  int mutations = 0;
  std::array<int, 4> with_status{};
  std::array<int, 4> found_false{};  // by the oracle; where it was asked
};

/// 25 000
std::string grouped(int number) {
  std::string text = std::to_string(number);
  for (std::size_t at = text.size(); at > 3;) text.insert(at -= 3, " ");
  return text;
}
std::string counts_of(const Tally& t) {
  return grouped(t.with_status[0]) + " | " + grouped(t.found_false[0]) + " | " + grouped(t.with_status[1]) + " | " +
         grouped(t.found_false[1]) + " | " + grouped(t.with_status[2]) + " | " + grouped(t.with_status[3]);
}
/// Of the first ones: accepted, rejected, undecided, malformed.
std::string first_counts_of(const Tally& t) {
  std::string text = grouped(t.mutations) + ": ";
  for (std::size_t status = 0; status < 4; ++status) text += (status == 0 ? "" : ", ") + grouped(t.with_status[status]);
  return text;
}

/// The row of the table.
class Row {
 public:
  explicit Row(const std::string& name) {
    std::ifstream file(page_);
    text_.assign(std::istreambuf_iterator<char>(file), {});
    begin_ = text_.find("| " + name + " |");
    if (begin_ == std::string::npos) throw std::logic_error("docs/submanifolds.md has no row for " + name);
    end_ = text_.find('\n', begin_);
  }
  [[nodiscard]] std::string text() const { return text_.substr(begin_, end_ - begin_); }
  void write(const std::string& row) const {
    std::ofstream(page_) << text_.substr(0, begin_) + row + text_.substr(end_);
  }

 private:
  std::string page_ = DELCERT_SOURCE_DIR "/docs/submanifolds.md";
  std::string text_;
  std::size_t begin_ = 0, end_ = 0;
};

double seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

class Campaign {
 public:
  explicit Campaign(const MutationCampaign& of) : of_(of), random_(of.seed) {}

  void run() {
    const int times = number_of_mutations(of_.few);
    Tally first;
    for (int k = 0; k < times; ++k) {
      step(k);
      if (tally_.mutations == of_.few) first = tally_;
      if (tally_.mutations % 1000 == 0) report();
    }
    report();
    for (const std::size_t status : {0U, 1U, 3U}) EXPECT_GT(tally_.with_status[status], 0) << status;
    EXPECT_EQ(tally_.found_false[0], 0);
    // The oracle is no yes-man.
    EXPECT_GT(2 * tally_.found_false[1], tally_.with_status[1]);
    if (times >= of_.few) compare_with_page(first);
  }

 private:
  std::string changed(int k) {
    const auto change = [&](const std::string& bytes) {
      return k % 2 == 0 ? mutated(bytes, random_) : with_other_digits(bytes, random_);
    };
    if (of_.head == std::string::npos || k % 4 < 2) return change(of_.text);
    return change(of_.text.substr(0, of_.head)) + of_.text.substr(of_.head);
  }
  void step(int k) {
    const std::string other = resealed_if_sealed(changed(k));
    const double begin = seconds();
    const auto status = static_cast<std::size_t>(status_of(other));
    const double taken = seconds() - begin;
    EXPECT_LT(taken, 30) << other;
    seconds_.at(status) += taken;
    ++tally_.with_status[status];
    ++tally_.mutations;
    if (status > 1) return;
    const std::string fault = fault_of(other, status == 0);
    seconds_of_oracle_ += seconds() - begin - taken;
    if (fault.empty()) return;
    ++tally_.found_false[status];
    EXPECT_NE(status, 0U) << fault << "\n" << other;
  }
  /// What the oracle cannot read it finds false only if the checker could.
  [[nodiscard]] std::string fault_of(const std::string& text, bool is_accepted) const {
    try {
      return of_.fault(text);
    } catch (const std::exception& error) {
      return is_accepted ? std::string("the oracle cannot read it: ") + error.what() : "";
    }
  }
  void report() const {
    std::cout << tally_.mutations << " mutations of " << of_.name << " sealed anew:";
    for (std::size_t status = 0; status < 4; ++status)
      std::cout << " " << tally_.with_status[status] << " with status " << status << " in " << seconds_[status]
                << " s;";
    std::cout << " the oracle finds " << tally_.found_false[0] << " and " << tally_.found_false[1]
              << " of the first two kinds false, in " << seconds_of_oracle_ << " s" << std::endl;
  }
  void compare_with_page(const Tally& first) const {
    const Row row(of_.name);
    const std::string end = " | " + first_counts_of(first) + " | ";
    if (std::getenv("DELCERT_MUTATIONS") != nullptr && std::getenv("DELCERT_RENEW") != nullptr)
      row.write("| " + of_.name + " | " + grouped(tally_.mutations) + " | " + counts_of(tally_) + end +
                std::string(build_commit()).substr(0, 8) + " |");
    EXPECT_NE(Row(of_.name).text().find(end), std::string::npos) << end << "\n" << Row(of_.name).text();
  }

  const MutationCampaign& of_;
  std::mt19937_64 random_;
  Tally tally_;
  std::array<double, 4> seconds_{};
  double seconds_of_oracle_ = 0;
};

}  // namespace

void run_campaign(const MutationCampaign& campaign) {
  ASSERT_EQ(status_of(campaign.text), 0);
  ASSERT_EQ(campaign.fault(campaign.text), "");
  Campaign(campaign).run();
}

}  // namespace delcert::checker_tests
