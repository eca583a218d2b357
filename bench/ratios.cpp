// ratios [REPETITIONS]: runs the two kernels' stages in turn, several times, and prints one table in Markdown:
// median processor times, and how they relate to CGAL's periodic Delaunay triangulation of the same points.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <map>
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
std::map<std::string, double> measure(const std::filesystem::path& program, Times& times) {
  const std::string command = fmt::format("'{}' --benchmark_format=json --benchmark_min_time=0.1", program.string());
  const auto report = nlohmann::json::parse(output_of(command));
  std::map<std::string, double> points;
  for (const auto& one : report.at("benchmarks")) {
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

/// "torus-2:1_24" is the torus-2 at ε = 1/24.
std::string title(std::string net, double points) {
  std::replace(net.begin(), net.end(), '_', '/');
  const std::size_t colon = net.find(':');
  return fmt::format("{}, ε = {}, {} points", net.substr(0, colon), net.substr(colon + 1), std::lround(points));
}

void print_table(const Times& certified, const Times& plain, const std::map<std::string, double>& points) {
  static const std::vector<std::string> order{"sample",      "measure_density", "perturb",
                                              "triangulate", "certify_stars",   "search_forbidden"};
  fmt::print("| net | stage | certified, ms | plain doubles, ms | certified : plain | certified : plain : CGAL |\n");
  fmt::print("|---|---|--:|--:|--:|--:|\n");
  std::vector<std::pair<double, std::string>> by_size;
  for (const auto& [net, count] : points) by_size.emplace_back(count, net);
  std::sort(by_size.begin(), by_size.end());
  for (const auto& [count, net] : by_size) {
    const auto& stages = certified.at(net);
    const double cgal = median(stages.at("cgal_periodic_delaunay"));
    const std::string name = title(net, count);
    double certified_sum = 0;
    double plain_sum = 0;
    for (const std::string& stage : order) {
      const double ours = median(stages.at(stage));
      const double theirs = median(plain.at(net).at(stage));
      if (stage == "search_forbidden") print_row(name, "all but the search", certified_sum, plain_sum, cgal);
      print_row(name, stage, ours, theirs, cgal);
      certified_sum += ours;
      plain_sum += theirs;
    }
    print_row(name, "all", certified_sum, plain_sum, cgal);
    fmt::print("| {} | cgal_periodic_delaunay | | {:.1f} | | 1 |\n", name, cgal);
  }
}

}  // namespace

int main(int argc, char** argv) {
  try {
    const int repetitions = argc > 1 ? std::stoi(argv[1]) : 5;
    const auto folder = std::filesystem::canonical(argv[0]).parent_path();
    Times certified;
    Times plain;
    std::map<std::string, double> points;
    for (int repetition = 0; repetition < repetitions; ++repetition) {
      points = measure(folder / "stages_certified", certified);
      if (measure(folder / "stages_plain", plain) != points) throw std::runtime_error("the nets differ");
    }
    print_table(certified, plain, points);
    return 0;
  } catch (const std::exception& error) {
    fmt::print(stderr, "ratios: {}\n", error.what());
    return 1;
  }
}
