#include "proofs/certification/shared_certification.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <ctime>
#include <filesystem>
#include <optional>
#include <tuple>

#include "delcert_version.hpp"
#include "kernel/manifold/any_manifold.hpp"
#include "kernel/manifold/quotient/patch_size.hpp"
#include "kernel/ranks/shared_measures.hpp"
#include "proofs/certificate/chunks.hpp"
#include "proofs/certificate/content.hpp"
#include "proofs/certificate/document.hpp"
#include "proofs/certificate/space_form_claims.hpp"
#include "proofs/certification/chart_family.hpp"
#include "proofs/certification/report_parts.hpp"
#include "support/error.hpp"
#include "support/host.hpp"

namespace delcert {

namespace {

/// Seconds of stages, each of which all ranks begin and end together.
class SharedClock {
 public:
  explicit SharedClock(Communicator& ranks) : ranks_(ranks) {}

  void begin(const char* name) {
    end();
    stages.push_back({name, 0, 0});
    start_ = std::chrono::steady_clock::now();
    processor_start_ = std::clock();
  }
  void end() {
    const double mine = static_cast<double>(std::clock() - processor_start_) / CLOCKS_PER_SEC;
    const double most = combined_everywhere(ranks_, mine, [](double a, double b) { return std::max(a, b); });
    if (stages.empty()) return;
    stages.back().seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
    stages.back().processor_seconds = most;
  }

  std::vector<SharedReport::Stage> stages;

 private:
  Communicator& ranks_;
  std::chrono::steady_clock::time_point start_;
  std::clock_t processor_start_ = std::clock();
};

/// Rows joined as a JSON array has them.
void add_row(std::string& rows, const std::string& row) {
  if (!rows.empty()) rows += ',';
  rows += row;
}

/// The text of a chunk, of which every rank has sent some rows, or nothing.
ChunkText chunk_text(const std::vector<Message>& rows) {
  std::array<std::vector<std::string>, 3> parts;
  for (const Message& message : rows) {
    MessageReader in(message);
    for (std::size_t at = 0; !in.is_at_end(); ++at) {
      if (std::string part = in.get_text(); !part.empty()) parts.at(at).push_back(std::move(part));
    }
  }
  constexpr std::array<const char*, 3> keys{"net", "points", "simplices"};
  ChunkText text;
  for (std::size_t at = 0; at < keys.size(); ++at) {
    text.add_rows(keys[at], parts[at].size(), [&](std::size_t part) { return std::string_view(parts[at][part]); });
    parts[at] = {};
  }
  return text;
}

template <int m>
class SharedCertification {
 public:
  SharedCertification(Communicator& ranks, const SharedOptions& options, SpaceForm form, const Progress& progress)
      : ranks_(ranks), options_(options), form_(std::move(form)), progress_(progress), clock_(ranks) {}

  SharedReport report() {
    const std::filesystem::path folder = options_.certify.output;
    const std::filesystem::path kept = folder.string() + ".progress";
    if (ranks_.rank() == 0) {
      prepare_chunk_folder(folder);
      std::filesystem::create_directories(kept);
    }
    const auto greatest = [](auto a, auto b) { return std::max(a, b); };
    clock_.begin("net");
    make_part(kept);
    report_.memory_of_net_mib = combined_everywhere(ranks_, peak_memory_in_mib(), greatest);
    if (options_.chunks < 2 || options_.chunks > labels_.all)
      throw InputError(fmt::format("{} labels cannot be divided into {} chunks", labels_.all, options_.chunks));

    clock_.begin("separation");
    const ParameterChoice choice = choice_in_charts(Dimension(m), options_.certify, false);
    RunParameters parameters =
        parameters_for(Dimension(m), shared_separation<m>(ranks_, labels_, *atlas_, progress_), choice);
    parameters.origin = options_.certify.origin;

    clock_.begin("points and stars");
    std::optional<BlockLog> log(std::in_place, kept / fmt::format("placed-{}", ranks_.rank()), origin());
    report_.restored_colours = combined_everywhere(ranks_, static_cast<std::uint32_t>(log->pieces().size()),
                                                   [](std::uint32_t a, std::uint32_t b) { return std::min(a, b); });
    RunRequest request;
    request.most_repair_rounds = options_.certify.repair_rounds;
    const SharedRun<m> run = run_shared<m>(ranks_, labels_, *atlas_, geometry_of<m>(*atlas_), parameters.algorithm,
                                           request, &*log, progress_);
    log.reset();

    clock_.begin("stars in other charts");
    const StarStability stability = shared_stability<m>(ranks_, labels_, *atlas_, run, progress_);
    clock_.begin("measures of levels 5 and 6");
    const SpaceFormMeasures measures{stability,
                                     shared_riemannian_simplices<m>(ranks_, labels_, *atlas_, run, progress_),
                                     shared_piecewise_flat<m>(ranks_, labels_, *atlas_, run, progress_)};
    const ComplexCount count = shared_count<m>(ranks_, labels_, run.complex);
    const auto manifold = [&count] {
      return ManifoldClaim{
          static_cast<std::size_t>(count.simplices), static_cast<long>(count.euler_characteristic), true, {}};
    };
    const Claims claims = derive_claims<m>(*atlas_, parameters, run.margins, manifold, run.model, measures,
                                           options_.certify.levels, report_.reasons);
    if (claims.names().empty())
      throw Rejection(fmt::format("no level is reached: {}", fmt::join(report_.reasons, "; ")));

    clock_.begin("write chunks");
    write(folder, run, parameters, claims);
    clock_.end();
    if (ranks_.rank() == 0) std::filesystem::remove_all(kept);

    const auto sum = [](std::uint64_t a, std::uint64_t b) { return a + b; };
    report_.points = labels_.all;
    report_.simplices = count.simplices;
    report_.most_own = combined_everywhere(ranks_, labels_.own.size(), greatest);
    report_.most_here = combined_everywhere(ranks_, labels_.size(), greatest);
    report_.colours = run.colours;
    report_.repair_rounds = run.repair_rounds;
    report_.repaired_points = run.repaired_points;
    report_.bytes_of_perturbation = combined_everywhere(ranks_, run.bytes_sent, sum);
    report_.levels = claims.names();
    report_.stages = std::move(clock_.stages);
    report_.most_memory_mib = combined_everywhere(ranks_, peak_memory_in_mib(), greatest);
    return std::move(report_);
  }

 private:
  /// What kept pieces are of.
  [[nodiscard]] std::string origin() const {
    std::string text = fmt::format("delcert {}, rank {} of {}", version, ranks_.rank(), ranks_.size());
    for (const auto& [name, value] : options_.certify.origin) text += fmt::format(", {}: {}", name, value);
    return text;
  }

  /// The first rank makes the net and divides it.
  void make_part(const std::filesystem::path& kept) {
    std::vector<Vector<Rational, m>> centres;
    Rational radius(1);
    if (ranks_.rank() == 0) {
      BlockLog log(kept / "net", origin());
      if (log.pieces().empty()) {
        std::tie(centres, radius) = options_.certify.source.template net_of<m>(form_, progress_);
        MessageWriter piece;
        piece.put(radius);
        for (const auto& centre : centres) piece.put(centre);
        log.add(piece.take());
      } else {
        MessageReader piece(log.pieces().front());
        radius = piece.get_rational();
        while (!piece.is_at_end()) centres.push_back(piece.get_point<static_cast<std::size_t>(m)>());
      }
    }
    MessageWriter of_radius;
    of_radius.put(radius);
    const Message of_first_rank = of_first(ranks_, of_radius.take());
    radius = MessageReader(of_first_rank).get_rational();
    const int factor = fitting_patch_factor(form_, m, radius);
    PartOfNet<m> part = part_of_net<m>(ranks_, std::move(centres), approximate_double(Rational(factor) * radius));
    labels_ = std::move(part.labels);
    atlas_.emplace(form_, std::move(part.centres), radius, factor);
    return_free_memory();
  }

  /// By names, sorted, those with their least label among own ones; elements are all the identity.
  [[nodiscard]] std::vector<PlacedSimplex<m>> own_simplices(const SharedRun<m>& run) const {
    std::vector<PlacedSimplex<m>> result;
    for (std::uint32_t label = labels_.own.first; label < labels_.own.last; ++label) {
      for (const auto& others : run.complex.star(Label(label))) {
        if (others[0] < label) continue;
        PlacedSimplex<m>& simplex = result.emplace_back(PlacedSimplex<m>{});
        simplex[0] = labels_.names[label];
        for (std::size_t at = 0; at < m; ++at) simplex[at + 1] = labels_.names[others[at]];
      }
    }
    std::sort(result.begin(), result.end());
    return result;
  }

  /// What this rank has of a chunk, for `chunk_text`.
  [[nodiscard]] Message rows_of(const SharedRun<m>& run, const ChunkRanges& chunks, std::size_t chunk,
                                const std::vector<PlacedSimplex<m>>& own,
                                const std::vector<std::uint32_t>& members) const {
    const auto text_of = [](const Vector<Rational, m>& point) { return listed(point, number); };
    const std::size_t begin = labels_.names_begin();
    const auto own_label = [&](std::size_t name) {
      return static_cast<std::uint32_t>(std::clamp(name, begin + labels_.own.first, begin + labels_.own.last) - begin);
    };
    std::string net, points, simplices;
    const std::uint32_t last = own_label(chunks.first_of(chunk + 1));
    for (std::uint32_t label = own_label(chunks.first_of(chunk)); label < last; ++label) {
      add_row(net, text_of(atlas_->centre(Label(label))));
      add_row(points, text_of(run.points.exact(Label(label))));
    }
    for (const std::uint32_t at : members)
      add_row(simplices, listed(own[at], [](std::uint32_t entry) { return std::to_string(entry); }));
    MessageWriter out;
    for (const std::string* rows : {&net, &points, &simplices}) out.put(*rows);
    return out.take();
  }

  /// Chunk after chunk, each rank one at a time, so that none has the text of more than that.
  void write(const std::filesystem::path& folder, const SharedRun<m>& run, const RunParameters& parameters,
             const Claims& claims) {
    const ChunkRanges chunks{labels_.all, options_.chunks};
    const std::vector<PlacedSimplex<m>> own = own_simplices(run);
    // Of each chunk, which of them have a label in it, and how many their least.
    std::vector<std::vector<std::uint32_t>> members(chunks.chunks);
    std::vector<std::uint64_t> own_count(chunks.chunks, 0);
    for (std::uint32_t number = 0; number < own.size(); ++number) {
      ++own_count[chunks.chunk_of(own[number][0])];
      for (std::size_t corner = 0; corner <= m; ++corner) {
        auto& in = members[chunks.chunk_of(own[number][corner])];
        if (in.empty() || in.back() != number) in.push_back(number);
      }
    }
    std::vector<std::vector<std::size_t>> chunks_of(ranks_.size());
    for (std::size_t chunk = 0; chunk < chunks.chunks; ++chunk)
      chunks_of[rank_of(static_cast<std::uint32_t>(chunks.first_of(chunk)), labels_.all, ranks_.size())].push_back(
          chunk);
    std::size_t most = 0;
    for (const auto& of_one : chunks_of) most = std::max(most, of_one.size());
    std::vector<std::string> digests(chunks.chunks);
    for (std::size_t turn = 0; turn < most; ++turn) {
      std::vector<Message> rows(ranks_.size());
      for (std::size_t rank = 0; rank < ranks_.size(); ++rank) {
        if (turn < chunks_of[rank].size())
          rows[rank] = rows_of(run, chunks, chunks_of[rank][turn], own, members[chunks_of[rank][turn]]);
      }
      const auto received = ranks_.exchange(std::move(rows));
      const auto& mine = chunks_of[ranks_.rank()];
      if (turn < mine.size()) digests[mine[turn]] = write_chunk(folder, mine[turn], chunk_text(received).finished());
    }
    MessageWriter written;
    for (std::size_t chunk = 0; chunk < chunks.chunks; ++chunk) {
      written.put(own_count[chunk]);
      written.put(digests[chunk]);
    }
    const auto of_all = gather_at_first(ranks_, written.take());
    if (ranks_.rank() != 0) return;
    std::vector<ChunkEntry> entries(chunks.chunks);
    for (const Message& message : of_all) {
      MessageReader in(message);
      for (std::size_t chunk = 0; chunk < chunks.chunks; ++chunk) {
        entries[chunk].first = chunks.first_of(chunk);
        entries[chunk].own += in.get<std::uint64_t>();
        entries[chunk].digest += in.get_text();
      }
    }
    const CertificateContent<m> content{
        manifold_object(form_), parameters, atlas_->sampling_radius(), claims, labels_.all, {}, {}, {}};
    report_.root = write_chunk_header(folder, labels_.all, entries, certificate_head<m>(content), "[]", "[]");
  }

  Communicator& ranks_;
  const SharedOptions& options_;
  SpaceForm form_;
  const Progress& progress_;
  SharedClock clock_;
  LabelsHere labels_;
  std::optional<SpaceFormAtlas<m>> atlas_;
  SharedReport report_;
};

SpaceForm sphere_of(const std::string& manifold) {
  const AnyManifold found = find_any_manifold(manifold);
  const auto* description = std::get_if<SpaceFormDescription>(&found);
  if (description == nullptr || !description->generators.empty())
    throw InputError(manifold + ": only spheres are divided among ranks");
  SpaceForm form = verify_space_form(*description);
  if (form.form().curvature() != Curvature::positive)
    throw InputError(manifold + ": only spheres are divided among ranks");
  return form;
}

}  // namespace

SharedReport certify_shared(Communicator& ranks, const SharedOptions& given, const Progress& progress) {
  SharedOptions options = given;
  options.certify.choice.seed = options.certify.source.seed;
  SpaceForm form = sphere_of(options.certify.source.manifold);
  if (form.form().dimension() == 2) return SharedCertification<2>(ranks, options, std::move(form), progress).report();
  return SharedCertification<3>(ranks, options, std::move(form), progress).report();
}

}  // namespace delcert
