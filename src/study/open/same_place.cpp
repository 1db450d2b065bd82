#include "study/open/same_place.h"

#include <algorithm>
#include <vector>

#include "base/frames.h"
#include "study/open/found_volumes.h"
#include "study/open/phases.h"
#include "study/open/same_patient.h"

namespace macula::study {

namespace {

bool haveSameGrid(const Volume& a, const Volume& b) {
    if (a.size() != b.size()) return false;
    constexpr double kRoundingMm = 1e-3;
    for (const glm::dvec3& corner :
         {glm::dvec3(0.0), glm::dvec3(a.size() - 1), glm::dvec3(a.size().x - 1, 0.0, 0.0),
          glm::dvec3(0.0, a.size().y - 1, 0.0)}) {
        const glm::dvec3 apart =
            transformPoint(a.worldFromVoxel(), corner) - transformPoint(b.worldFromVoxel(), corner);
        if (!(glm::length(apart) < kRoundingMm)) return false;
    }
    return true;
}

// Whether both are among the phases of one thing in a folder.
bool areAmongPhases(const OpenedStudy& a, const OpenedStudy& b) {
    if (!a.found || a.found != b.found) return false;
    const std::vector<Phase> phases = phasesOf(*a.found, a.volumeIndex);
    return std::ranges::find(phases, b.volumeIndex, &Phase::volume) != phases.end();
}

bool isPhase(const OpenedStudy& study) {
    return study.found && study.volumeIndex < study.found->volumes().size() &&
           study.found->volumes()[study.volumeIndex].stack->phases > 1;
}

}  // namespace

bool shareFrameOfReference(const OpenedStudy& study, const OpenedStudy& second) {
    return !study.frameOfReferenceUid.empty() && study.frameOfReferenceUid == second.frameOfReferenceUid &&
           samePatient(study.identity, second.identity) != SamePatient::no;
}

bool shareGrid(const OpenedStudy& a, const OpenedStudy& b) {
    if (!a.volume || !b.volume || samePatient(a.identity, b.identity) == SamePatient::no) return false;
    const bool isOneSeries = !a.seriesDigest.empty() && a.seriesDigest == b.seriesDigest;
    return (isOneSeries || shareFrameOfReference(a, b)) && haveSameGrid(*a.volume, *b.volume);
}

bool staysInPlace(const OpenedStudy& from, const OpenedStudy& to) {
    const bool isSame = from.seriesDigest == to.seriesDigest && from.volumeIndex == to.volumeIndex;
    return !isSame && shareGrid(from, to);
}

bool arePhases(const OpenedStudy& a, const OpenedStudy& b) {
    const bool areOfOneSeries = isPhase(a) && isPhase(b) && a.seriesDigest == b.seriesDigest;
    return (areOfOneSeries || areAmongPhases(a, b)) && a.volume->unit() == b.volume->unit() &&
           a.volume->unitName() == b.volume->unitName() && shareGrid(a, b);
}

}  // namespace macula::study
