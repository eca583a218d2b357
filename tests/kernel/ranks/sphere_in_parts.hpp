#pragma once

#include <functional>

#include "kernel/manifold/quotient/patch_size.hpp"
#include "kernel/manifold/quotient/space_form_atlas.hpp"
#include "kernel/manifold/space_form_file.hpp"
#include "kernel/ranks/part_of_net.hpp"
#include "kernel/ranks/thread_ranks.hpp"
#include "kernel/run/chart_run.hpp"
#include "kernel/sample/space_form_net.hpp"
#include "tests/support/ratio.hpp"

// Nets of spheres, whole and divided among ranks.
namespace delcert::test {

template <int m>
struct WholeSphere {
  explicit WholeSphere(const Rational& given_radius, std::uint64_t seed = 1)
      : form(verify_space_form(find_space_form(m == 2 ? "sphere-2" : "sphere-3"))),
        radius(given_radius),
        patch_factor(fitting_patch_factor(form, m, radius)),
        centres(space_form_net<m>(form, radius, seed, no_progress()).centres),
        atlas(form, centres, radius, patch_factor) {}

  SpaceForm form;
  Rational radius;
  int patch_factor;
  std::vector<Vector<Rational, m>> centres;
  SpaceFormAtlas<m> atlas;
};

/// One rank's part of it.
template <int m>
struct PartOfSphere {
  PartOfSphere(Communicator& ranks, const WholeSphere<m>& whole)
      : part(part_of_net<m>(ranks, ranks.rank() == 0 ? whole.centres : std::vector<Vector<Rational, m>>(),
                            approximate_double(whole.atlas.patch_radius()))),
        labels(part.labels),
        atlas(whole.form, part.centres, whole.radius, whole.patch_factor) {}

  PartOfNet<m> part;
  const LabelsHere& labels;
  SpaceFormAtlas<m> atlas;
};

/// Does to messages what a network does not do.
class AlteredMessages final : public Communicator {
 public:
  using Alter = std::function<void(std::size_t exchange, std::vector<Message>& messages)>;

  AlteredMessages(Communicator& ranks, Alter alter) : ranks_(ranks), alter_(std::move(alter)) {}

  [[nodiscard]] std::size_t rank() const override { return ranks_.rank(); }
  [[nodiscard]] std::size_t size() const override { return ranks_.size(); }
  [[nodiscard]] std::vector<Message> exchange(std::vector<Message> messages) override {
    alter_(count_++, messages);
    return ranks_.exchange(std::move(messages));
  }

 private:
  Communicator& ranks_;
  Alter alter_;
  std::size_t count_ = 0;
};

}  // namespace delcert::test
