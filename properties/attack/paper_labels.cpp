#include "properties/attack/paper_labels.hpp"

#include <algorithm>

namespace delcert {

namespace {

/// Bounds without a label that claims take from the text name the section.
bool is_section(const std::string& label) { return label.starts_with("sec:"); }

}  // namespace

const std::vector<PaperLabel>& paper_labels() {
  static const std::string parameters =
      "a relation between parameters, without an instance: `delcert constants`, and the steps of parameter-constraints";
  static const std::string domain = "a demand on the domains, met by construction and checked at level 0";
  static const std::string part = "a conclusion of the lemma it stands in";
  static const std::vector<PaperLabel> labels{
      {"def:forbidden.config",
       "a definition: `is_forbidden_configuration`, kernel/simplex/forbidden_configuration.hpp"},
      {"lem:prop.forbid.cfg", ""},
      {"eq:dnobnd", "the hypothesis of lem:prop.forbid.cfg"},
      {"hyp:clean.hoop.bnd", part},
      {"hyp:clean.facet.rad.bnd", part},
      {"hyp:diam.bnd", part},
      {"hyp:good.facets", part},
      {"eq:metric.distortion", "a hypothesis on the input, checked at level 0"},
      {"eq:geom.lipsam", ""},
      {"hyps:input", "hypotheses on the input: kernel/manifold/input_check.hpp, level 0"},
      {"eq:new.pertbnd", parameters},
      {"eq:chart.change.bnd", parameters},
      {"eq:lipsambnd", parameters},
      {"lem:protected.stars", ""},
      {"lem:stable.stars", ""},
      {"lem:hoop.distort", ""},
      {"eq:forbid.cfg.labels", "commented out; the claim containment-radius has the bound"},
      {"eq:bnd.nbr.cplx", ""},
      {"def:extended.good.pert", ""},
      {"hyps:param.bnds", parameters},
      {"lem:loc.eucl.protect", ""},
      {"thm:man.mesh", ""},
      {"thm:output.del.cplx", ""},
      {"eq:locsam.curv.bnd", ""},
      {"eq:exp.distort", ""},
      {"thm:riem.del.tri", ""},
      {"lem:bound.skP", ""},
      {"eq:bound.skP", "commented out; " + part},
      {"eq:upper.bnd.small.sing", ""},
      {"lem:splx.gram", ""},
      {"eq:gram.err.bnd", part},
      {"lem:intrinsic.thick.distortion", ""},
      {"lem:good.isometry", ""},
      {"eq:gram.perturb", "the definition of E in lem:good.isometry"},
      {"eq:A.F", "an identity inside the proof of lem:good.isometry"},
      {"eq:expand.mat.diff", "an identity inside the proof of lem:good.isometry"},
      {"lem:splx.good.isometry", ""},
      {"lem:circ.rad.distort", ""},
      {"lem:circ.ball.distort", ""},
      {"lem:crude.rad.bnd", ""},
      {"lem:bound.cc", ""},
      {"fig:bound.cc", "a figure"},
      {"lem:del.metric.stability", ""},
      {"eq:desired.star.equiv", "the conclusion of lem:stable.stars"},
      {"lem:inclusion.star.equivalences", ""},
      {"eq:domain.req.metric", domain},
      {"lem:protected.stars.appdx", "another label of lem:protected.stars"},
      {"eq:domain.req.forbid", domain},
      {"eq:trans.domain.req", domain},
      {"lem:stable.stars.appdx", "another label of lem:stable.stars"},
      {"lem:raw.hoop.distort", ""},
      {"eq:def.rad.bnd", "commented out; " + part},
      {"lem:hoop.distort.appdx", "another label of lem:hoop.distort"},
  };
  return labels;
}

std::vector<std::string> complaints_about_labels(const std::vector<Claim>& claims) {
  std::vector<std::string> complaints;
  for (const PaperLabel& label : paper_labels()) {
    const bool has_claim =
        std::any_of(claims.begin(), claims.end(), [&](const Claim& claim) { return claim.source == label.label; });
    if (!has_claim && label.reason.empty()) complaints.push_back(label.label + " has neither a claim nor a reason");
    if (has_claim && !label.reason.empty()) complaints.push_back(label.label + " has a claim and a reason why not");
  }
  for (const Claim& claim : claims) {
    const bool is_known = std::any_of(paper_labels().begin(), paper_labels().end(),
                                      [&](const PaperLabel& label) { return label.label == claim.source; });
    if (claim.status != ClaimStatus::user && !is_known && !is_section(claim.source)) {
      complaints.push_back(claim.name + ": the paper has no label " + claim.source);
    }
  }
  return complaints;
}

std::string paper_to_code(const std::vector<Claim>& claims) {
  std::string result = "| label | claims, or why there is none |\n|---|---|\n";
  const auto claims_from = [&](const std::string& source) {
    std::string cell;
    for (const Claim& claim : claims) {
      if (claim.source != source) continue;
      cell += (cell.empty() ? "" : ", ") + claim.name + " (" + std::string(name_of(claim.status)) + ")";
    }
    return cell;
  };
  for (const PaperLabel& label : paper_labels()) {
    const std::string cell = claims_from(label.label);
    result += "| " + label.label + " | " + (cell.empty() ? label.reason : cell) + " |\n";
  }
  std::vector<std::string> sections;
  for (const Claim& claim : claims) {
    if (is_section(claim.source) && std::find(sections.begin(), sections.end(), claim.source) == sections.end()) {
      sections.push_back(claim.source);
    }
  }
  for (const std::string& section : sections) {
    result += "| bounds without a label in " + section + " | " + claims_from(section) + " |\n";
  }
  return result;
}

}  // namespace delcert
