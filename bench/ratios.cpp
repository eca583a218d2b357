// ratios [REPETITIONS [FILTER]]: runs the two kernels' stages in turn, several times, and prints one table in Markdown:
// median processor times, and how they relate to CGAL's periodic Delaunay triangulation of the same points.
// FILTER: a regular expression on the names of the benchmarks, as for --benchmark_filter.

#include <fmt/format.h>
#include <sys/wait.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

/// Processor times in milliseconds, by net and stage, one entry for each repetition.
using Times = std::map<std::string, std::map<std::string, std::vector<double>>>;

std::string output_of(const std::string& command) {
  std::FILE* pipe = popen(command.c_str(), "r");
  if (pipe == nullptr) throw std::runtime_error("cannot run " + command);
  std::string text;
  for (int c = std::fgetc(pipe); c != EOF; c = std::fgetc(pipe)) text.push_back(static_cast<char>(c));
  if (pclose(pipe) != 0) throw std::runtime_error("failed: " + command);
  return text;
}

/// Adds one measurement of every benchmark of a program; returns the number of points of each net.
std::map<std::string, double> measure(const std::filesystem::path& program, const std::string& filter, Times& times) {
  const std::string command = fmt::format(
      "'{}' --benchmark_format=json --benchmark_min_time=0.1 --benchmark_filter='{}'", program.string(), filter);
  std::map<std::string, double> points;
  for (const auto& one : nlohmann::json::parse(output_of(command)).at("benchmarks")) {
    const std::string name = one.at("name");
    if (one.value("error_occurred", false)) {
      throw std::runtime_error(fmt::format("{}: {}", name, one.at("error_message").get<std::string>()));
    }
    const std::size_t slash = name.find('/');
    const std::string net = name.substr(0, slash);
    times[net][name.substr(slash + 1)].push_back(one.at("cpu_time"));
    if (one.contains("points")) points[net] = one.at("points");
  }
  return points;
}

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const std::size_t middle = values.size() / 2;
  return values.size() % 2 == 1 ? values[middle] : (values[middle - 1] + values[middle]) / 2;
}

void print_row(const std::string& net, const std::string& stage, double certified, double plain, double cgal) {
  fmt::print("| {} | {} | {:.1f} | {:.1f} | {:.2f} : 1 | {:.2f} : {:.2f} : 1 |\n", net, stage, certified, plain,
             certified / plain, certified / cgal, plain / cgal);
}

void print_table(const Times& certified, const Times& plain, const std::map<std::string, double>& points) {
  static const std::vector<std::string> order{"sample",      "measure_density", "perturb",
                                              "triangulate", "certify_stars",   "search_forbidden"};
  fmt::print("| net | stage | certified, ms | plain doubles, ms | certified : plain | certified : plain : CGAL |\n");
  fmt::print("|---|---|--:|--:|--:|--:|\n");
  for (const auto& [net, stages] : certified) {
    const double cgal = median(stages.at("cgal_periodic_delaunay"));
    double certified_sum = 0;
    double plain_sum = 0;
    const auto found = points.find(net);
    const std::string name =
        found == points.end() ? net : fmt::format("{}, {} points", net, std::lround(found->second));
    for (const std::string& stage : order) {
      if (!stages.contains(stage)) continue;
      const double ours = median(stages.at(stage));
      const double theirs = median(plain.at(net).at(stage));
      print_row(name, stage, ours, theirs, cgal);
      if (stage == "search_forbidden") continue;
      certified_sum += ours;
      plain_sum += theirs;
    }
    print_row(name, "all but search_forbidden", certified_sum, plain_sum, cgal);
    fmt::print("| {} | CGAL's periodic Delaunay | {:.1f} | | | 1 |\n", name, cgal);
  }
}

}  // namespace

int main(int argc, char** argv) {
  try {
    const int repetitions = argc > 1 ? std::stoi(argv[1]) : 5;
    const std::string filter = argc > 2 ? argv[2] : ".";
    const auto folder = std::filesystem::canonical(argv[0]).parent_path();
    Times certified;
    Times plain;
    std::map<std::string, double> points;
    for (int repetition = 0; repetition < repetitions; ++repetition) {
      points = measure(folder / "stages_certified", filter, certified);
      if (measure(folder / "stages_plain", filter, plain) != points) throw std::runtime_error("the nets differ");
    }
    print_table(certified, plain, points);
    return 0;
  } catch (const std::exception& error) {
    fmt::print(stderr, "ratios: {}\n", error.what());
    return 1;
  }
}
