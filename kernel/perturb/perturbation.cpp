#include "kernel/perturb/perturbation.hpp"

#include <algorithm>

#include "kernel/perturb/colouring.hpp"
#include "kernel/simplex/dimensions.hpp"

namespace delcert {

template <int m>
Perturbation<m>::Perturbation(const Atlas<m>& atlas, const PerturbationParameters& parameters)
    : atlas_(atlas), parameters_(parameters), state_(atlas, parameters) {}

template <int m>
void Perturbation<m>::place_all(const Progress& progress) {
  std::vector<Label> labels;
  labels.reserve(atlas_.size());
  for (std::uint32_t index = 0; index < atlas_.size(); ++index) labels.emplace_back(index);
  place(labels, "perturb", progress);
}

template <int m>
void Perturbation<m>::place_anew(std::vector<Label> labels, const Progress& progress) {
  std::sort(labels.begin(), labels.end());
  labels.erase(std::unique(labels.begin(), labels.end()), labels.end());
  for (const Label label : labels) state_.placed[label.value] = 0;
  place(labels, "repair", progress);
}

template <int m>
void Perturbation<m>::place(const std::vector<Label>& labels, std::string_view stage, const Progress& progress) {
  if (colours_.empty()) colours_ = colours_of<m>(atlas_, Placement<m>::reach(parameters_), progress);
  std::vector<std::vector<Label>> classes;
  for (const Label label : labels) {
    const std::uint32_t colour = colours_[label.value];
    if (colour >= classes.size()) classes.resize(colour + 1);
    classes[colour].push_back(label);
  }
  std::size_t done = 0;
  for (const auto& of_one_colour : classes) {
    statistics_ += place_in_parallel<m>(
        atlas_, parameters_, state_, of_one_colour, stage,
        [&](std::string_view name, std::size_t at, std::size_t) { progress(name, done + at, labels.size()); });
    done += of_one_colour.size();
  }
}

#define DELCERT_INSTANTIATE(m) template class Perturbation<m>;
DELCERT_FOR_EACH_DIMENSION(DELCERT_INSTANTIATE)
#undef DELCERT_INSTANTIATE

}  // namespace delcert
