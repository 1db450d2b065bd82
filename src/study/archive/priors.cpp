#include "study/archive/priors.h"

#include <algorithm>
#include <set>
#include <string>

#include "dicom/read/placeholder.h"
#include "study/archive/fetched_study.h"
#include "study/open/same_patient.h"

namespace macula::study {

namespace {

// The same day some years before; of a leap day, 1 March at the latest.
std::string yearsBefore(const std::string& day, int years) {
    const int year = std::stoi(day.substr(0, 4)) - years;
    std::string text = std::to_string(std::max(year, 0));
    text.insert(0, 4 - std::min<std::size_t>(text.size(), 4), '0');
    return text + day.substr(4);
}

bool sharesModality(const net::FoundStudy& study, const std::vector<std::string>& modalities) {
    return std::ranges::any_of(study.modalities, [&](const std::string& modality) {
        return std::ranges::count(modalities, modality) > 0;
    });
}

}  // namespace

std::optional<net::StudyQuery> queryForPriors(const Identity& patient) {
    net::StudyQuery query;
    if (!dicom::isPlaceholder(patient.patientId)) {
        query.patientId = patient.patientId;
    } else if (!dicom::isPlaceholder(patient.patientName) && !dicom::isPlaceholderDate(patient.birthDate)) {
        query.patientName = patient.patientName.substr(0, patient.patientName.find('='));
        query.patientBirthDate = patient.birthDate;
    } else {
        return std::nullopt;
    }
    return query;
}

std::vector<ListedStudy> priorsOf(const Identity& patient, const Listing& listing) {
    std::vector<ListedStudy> priors;
    std::set<std::string> seen{patient.studyInstanceUid};
    for (const ListedStudy& listed : listing.studies) {
        const Identity other = identityOf(listed.study);
        const SamePatient same = samePatient(patient, other);
        const bool hasId = !dicom::isPlaceholder(patient.patientId) && patient.patientId == other.patientId;
        if (same == SamePatient::no || (same == SamePatient::unknown && !hasId)) continue;
        if (seen.insert(listed.study.studyInstanceUid).second) priors.push_back(listed);
    }
    std::stable_sort(priors.begin(), priors.end(), [](const ListedStudy& a, const ListedStudy& b) {
        return a.study.date + a.study.time > b.study.date + b.study.time;
    });
    return priors;
}

std::vector<ListedStudy> priorsToFetch(const PriorRule& rule, const Identity& patient,
                                       const std::vector<std::string>& modalities,
                                       const std::vector<ListedStudy>& priors) {
    const std::string day = studyDay(patient);
    std::vector<ListedStudy> toFetch;
    if (day.empty()) return toFetch;
    std::size_t suitable = 0;
    for (const ListedStudy& prior : priors) {
        const std::string priorDay = studyDay(identityOf(prior.study));
        if (priorDay.empty() || priorDay >= day || priorDay < yearsBefore(day, rule.years)) continue;
        if (!sharesModality(prior.study, modalities)) continue;
        if (++suitable > rule.most) break;
        const bool isHere = !prior.folder.empty() && prior.isWhole;
        if (!isHere && !prior.archive.empty()) toFetch.push_back(prior);
    }
    return toFetch;
}

}  // namespace macula::study
