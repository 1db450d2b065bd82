// Other studies of a patient, to compare with: those of the same archive and on this machine.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "net/archive/query.h"
#include "study/archive/study_search.h"
#include "study/open/identity.h"

namespace macula::study {

// Finds them by the patient's ID, or without one by name and date of birth. Nothing where the images name
// neither: such a study belongs to nobody in particular.
std::optional<net::StudyQuery> queryForPriors(const Identity& patient);

// Those of this patient other than the patient's study itself, latest first, each once. One that names
// another name, date of birth or sex under the same ID is left out: IDs are given twice by mistake, and by
// different hospitals.
std::vector<ListedStudy> priorsOf(const Identity& patient, const Listing& listing);

// Which priors are fetched without being asked for.
struct PriorRule {
    std::size_t most = 2;
    int years = 5;  // not older than this before the study
};
// Earlier ones that share a modality with the study, latest first, which are not on this machine yet.
std::vector<ListedStudy> priorsToFetch(const PriorRule& rule, const Identity& patient,
                                       const std::vector<std::string>& modalities,
                                       const std::vector<ListedStudy>& priors);

}  // namespace macula::study
