#include "study/open/presented_volume.h"

#include <algorithm>

#include "dicom/read/sop_class.h"
#include "dicom/write/uid.h"

namespace macula::study {

namespace {

enum class Referred { no, byName, byStandIn };  // by the original UIDs, or by those of a deidentified object

bool holds(const std::vector<std::string>& sorted, const std::string& uid) {
    return std::ranges::binary_search(sorted, uid);
}

Referred refersTo(const dicom::OtherObject& object, const dicom::Series& series,
                  const dicom::StandInUids& standIns) {
    const std::string& uid = series.seriesInstanceUid;
    if (uid.empty()) return Referred::no;
    if (holds(object.referencedSeriesUids, uid)) return Referred::byName;
    // Few objects have such UIDs, and hashing each series for each of thousands of objects would be slow.
    const bool mayBeStandIn = std::ranges::any_of(
        object.referencedSeriesUids, [](const std::string& each) { return each.starts_with("2.25."); });
    if (!mayBeStandIn) return Referred::no;
    const bool isOne = std::ranges::any_of(standIns.of(uid), [&](const std::string& standIn) {
        return holds(object.referencedSeriesUids, standIn);
    });
    return isOne ? Referred::byStandIn : Referred::no;
}

using Wanted = std::vector<dicom::ReferencedFrames>;  // by UID

Wanted::const_iterator find(const Wanted& wanted, const std::string& uid) {
    const auto found = std::ranges::lower_bound(wanted, uid, {}, &dicom::ReferencedFrames::sopInstanceUid);
    return found != wanted.end() && found->sopInstanceUid == uid ? found : wanted.end();
}

Wanted::const_iterator find(const Wanted& wanted, const dicom::Instance& image, Referred referred,
                            const dicom::StandInUids& standIns) {
    if (referred != Referred::byStandIn) return find(wanted, image.sopInstanceUid);
    for (const std::string& uid : standIns.of(image.sopInstanceUid))
        if (const auto found = find(wanted, uid); found != wanted.end()) return found;
    return wanted.end();
}

// Counts frames, because a file with several phases has frames in several volumes.
std::size_t imagesIn(const dicom::OtherObject& object, const dicom::Stack& stack, Referred referred,
                     const dicom::StandInUids& standIns) {
    const Wanted& wanted = object.presentation->images;
    // The instance of `image`: frames of one file follow each other.
    const dicom::Instance* instance = nullptr;
    auto image = wanted.end();
    return std::size_t(std::ranges::count_if(stack.frames, [&](const dicom::Frame& frame) {
        if (frame.instance.get() != instance) {
            instance = frame.instance.get();
            image = find(wanted, *instance, referred, standIns);
        }
        return image != wanted.end() && image->holds(frame.number);
    }));
}

// Why there is no volume: the series is missing, belongs to another patient, or lacks the images.
Text whyNone(const dicom::OtherObject& object, int patient, const FoundVolumes& found,
             const dicom::StandInUids& standIns) {
    bool isOfAnother = false;
    for (const dicom::Study& study : found.scan().studies) {
        for (const dicom::Series& series : study.series) {
            const Referred referred = refersTo(object, series, standIns);
            if (referred == Referred::no) continue;
            if (referred == Referred::byStandIn ||
                dicom::mayBeOnePatient(found.scan(), study.patient, patient))
                return Text("The images that it is of are no volume.");
            isOfAnother = true;
        }
    }
    return isOfAnother ? Text("The series that it is of belongs to another patient.")
                       : Text("The series that it is of is not in this folder.");
}

}  // namespace

PresentedVolume presentedVolume(const dicom::OtherObject& object, int patient, const FoundVolumes& found) {
    const bool isKnown = object.sopClassUid == dicom::sop_class::kVolumePresentationState ||
                         object.sopClassUid == dicom::sop_class::kSoftcopyPresentationState;
    if (!object.presentation || !isKnown)
        return {.whyNot = Text("Macula does not show presentation states of this kind.")};
    const dicom::StandInUids standIns;
    std::vector<std::pair<std::size_t, Referred>> candidates;
    for (std::size_t i = 0; i < found.volumes().size(); ++i) {
        const FoundVolume& volume = found.volumes()[i];
        const Referred referred = refersTo(object, *volume.series, standIns);
        const bool isOfOne = dicom::mayBeOnePatient(found.scan(), volume.study->patient, patient);
        if (referred == Referred::byStandIn || (referred == Referred::byName && isOfOne))
            candidates.emplace_back(i, referred);
    }
    if (candidates.empty()) return {.whyNot = whyNone(object, patient, found, standIns)};
    if (candidates.size() == 1) return {.index = candidates.front().first};
    const auto most = std::ranges::max_element(candidates, {}, [&](const auto& candidate) {
        return imagesIn(object, *found.volumes()[candidate.first].stack, candidate.second, standIns);
    });
    return {.index = most->first};
}

}  // namespace macula::study
