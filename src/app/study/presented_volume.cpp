#include "app/study/presented_volume.h"

#include <algorithm>

#include "dicom/read/sop_class.h"
#include "dicom/uid.h"

namespace macula::app {

namespace {

enum class Referred { no, byName, anew };  // with UIDs as they are, or made anew without a patient

bool holds(const std::vector<std::string>& sorted, const std::string& uid) {
    return std::ranges::binary_search(sorted, uid);
}

Referred refersTo(const dicom::OtherObject& object, const dicom::Series& series) {
    const std::string& uid = series.seriesInstanceUid;
    if (uid.empty()) return Referred::no;
    if (holds(object.referencedSeriesUids, uid)) return Referred::byName;
    // Few have such UIDs, and a hash of each series for each of thousands of objects takes its time.
    const bool mayBeAnew = std::ranges::any_of(
        object.referencedSeriesUids, [](const std::string& each) { return each.starts_with("2.25."); });
    if (!mayBeAnew) return Referred::no;
    return holds(object.referencedSeriesUids, dicom::uidFrom(uid)) ? Referred::anew : Referred::no;
}

// Frames of one file stand in several volumes where it has several phases: each frame counts.
std::size_t imagesIn(const dicom::OtherObject& object, const dicom::Stack& stack, Referred referred) {
    const std::vector<dicom::ReferencedFrames>& wanted = object.presentation->images;
    const dicom::Instance* instance = nullptr;  // of `image`: frames of one file follow each other
    auto image = wanted.end();
    return std::size_t(std::ranges::count_if(stack.frames, [&](const dicom::Frame& frame) {
        if (frame.instance.get() != instance) {
            instance = frame.instance.get();
            const std::string uid = referred == Referred::anew ? dicom::uidFrom(instance->sopInstanceUid)
                                                               : instance->sopInstanceUid;
            image = std::ranges::lower_bound(wanted, uid, {}, &dicom::ReferencedFrames::sopInstanceUid);
            if (image != wanted.end() && image->sopInstanceUid != uid) image = wanted.end();
        }
        return image != wanted.end() && image->holds(frame.number);
    }));
}

// Where there is no volume: whether the series is there at all, and whose it is.
std::string whyNone(const dicom::OtherObject& object, int patient, const FoundVolumes& found) {
    bool isOfAnother = false;
    for (const dicom::Study& study : found.scan().studies) {
        for (const dicom::Series& series : study.series) {
            const Referred referred = refersTo(object, series);
            if (referred == Referred::no) continue;
            if (referred == Referred::anew || dicom::mayBeOnePatient(found.scan(), study.patient, patient))
                return "The images that it is of are no volume.";
            isOfAnother = true;
        }
    }
    return isOfAnother ? "The series that it is of belongs to another patient."
                       : "The series that it is of is not in this folder.";
}

}  // namespace

PresentedVolume presentedVolume(const dicom::OtherObject& object, int patient, const FoundVolumes& found) {
    const bool isKnown = object.sopClassUid == dicom::sop_class::kVolumePresentationState ||
                         object.sopClassUid == dicom::sop_class::kSoftcopyPresentationState;
    if (!object.presentation || !isKnown)
        return {.whyNot = "Macula does not show presentation states of this kind."};
    std::vector<std::pair<std::size_t, Referred>> candidates;
    for (std::size_t i = 0; i < found.volumes().size(); ++i) {
        const FoundVolume& volume = found.volumes()[i];
        const Referred referred = refersTo(object, *volume.series);
        const bool isOfOne = dicom::mayBeOnePatient(found.scan(), volume.study->patient, patient);
        if (referred == Referred::anew || (referred == Referred::byName && isOfOne))
            candidates.emplace_back(i, referred);
    }
    if (candidates.empty()) return {.whyNot = whyNone(object, patient, found)};
    if (candidates.size() == 1) return {.index = candidates.front().first};
    const auto most = std::ranges::max_element(candidates, {}, [&](const auto& candidate) {
        return imagesIn(object, *found.volumes()[candidate.first].stack, candidate.second);
    });
    return {.index = most->first};
}

}  // namespace macula::app
