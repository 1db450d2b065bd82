#include "study/segmentation/found_segmentation.h"

#include <algorithm>
#include <set>
#include <utility>

#include "base/exceptions.h"
#include "base/sha256.h"
#include "dicom/read/sop_class.h"

namespace macula::study {

namespace {

struct Candidate {
    const dicom::Study* study;
    const dicom::Series* series;
    const dicom::OtherObject* object;
};

bool isStructureSet(const dicom::OtherObject& object) {
    return object.sopClassUid == dicom::sop_class::kStructureSet;
}

std::vector<Candidate> candidatesOf(const dicom::Scan& scan) {
    std::vector<Candidate> all;
    for (const dicom::Study& study : scan.studies) {
        for (const dicom::Series& series : study.series) {
            for (const dicom::OtherObject& object : series.objects) {
                if (dicom::isSegmentation(object.sopClassUid) || isStructureSet(object))
                    all.push_back({&study, &series, &object});
            }
        }
    }
    return all;
}

bool isDrawnOn(const dicom::Segmentation& header, const dicom::Series& series) {
    return std::ranges::find(header.referencedSeriesUids, series.seriesInstanceUid) !=
           header.referencedSeriesUids.end();
}

// Of a structure set, whose regions may lie in several coordinate systems.
Text whyNoRegionOn(const FoundSegmentation& found, const std::string& frameOfReference,
                   const FoundVolume& volume) {
    const auto& regions = found.structures->regions;
    if (std::ranges::all_of(regions, [](const auto& region) { return region.contours.empty(); }))
        return Text("It has no contours that enclose anything.");
    const bool isKnown = !frameOfReference.empty() && std::ranges::any_of(regions, [](const auto& region) {
        return !region.frameOfReferenceUid.empty();
    });
    if (!isKnown)
        return isDrawnOn(found.header, *volume.series)
                   ? Text()
                   : Text("Nothing says that it lies in the coordinate system of this volume.");
    const bool isHere = std::ranges::any_of(regions, [&](const dicom::StructureRegion& region) {
        return region.frameOfReferenceUid == frameOfReference && !region.contours.empty();
    });
    return isHere ? Text()
                  : Text("It lies in another coordinate system (frame of reference) than this volume.");
}

// The reason why it cannot be shown on the volume; empty if it can.
Text whyNotOn(const FoundSegmentation& found, const dicom::Scan& scan, const dicom::Study& study,
              const FoundVolume& volume) {
    const dicom::Segmentation& header = found.header;
    if (!dicom::mayBeOnePatient(scan, study.patient, volume.study->patient))
        return Text("It is of another patient.");
    if (header.frames.empty() && !found.structures) return Text("It has no frames.");
    const std::string frameOfReference = frameOfReferenceOf(*volume.stack);
    if (found.structures) return whyNoRegionOn(found, frameOfReference, volume);
    if (!frameOfReference.empty() && !header.frameOfReferenceUid.empty()) {
        if (frameOfReference == header.frameOfReferenceUid) return {};
        return Text("It lies in another coordinate system (frame of reference) than this volume.");
    }
    if (isDrawnOn(header, *volume.series)) return {};
    return Text("Nothing says that it lies in the coordinate system of this volume.");
}

Result<void> readInto(FoundSegmentation& found, const dicom::OtherObject& object) {
    if (!isStructureSet(object)) {
        MACULA_TRY(found.header, dicom::readSegmentation(object.file));
        return {};
    }
    MACULA_TRY(dicom::StructureSet structures, dicom::readStructureSet(object.file));
    found.header.file = object.file;
    found.header.sopInstanceUid = structures.sopInstanceUid;
    found.header.contentLabel = structures.label;
    found.header.referencedSeriesUids = structures.referencedSeriesUids;
    for (const dicom::StructureRegion& region : structures.regions)
        found.header.segments.push_back(region.segment);
    found.structures = std::make_shared<const dicom::StructureSet>(std::move(structures));
    return {};
}

FoundSegmentation read(const dicom::Scan& scan, const Candidate& candidate, const FoundVolume& volume) {
    FoundSegmentation found;
    found.title = candidate.series->description;
    if (const Result<void> read = readInto(found, *candidate.object); !read) {
        found.digest = sha256Hex(candidate.object->file.string());
        found.whyNot = Text::joined({read.error().message, read.error().hint}, " ");
    } else {
        const std::string& uid = found.header.sopInstanceUid;
        found.digest = sha256Hex(uid.empty() ? candidate.object->file.string() : uid);
        const std::string& label = found.header.contentLabel;
        if (!label.empty() && label != found.title)
            found.title += found.title.empty() ? label : " (" + label + ")";
        found.whyNot = whyNotOn(found, scan, *candidate.study, volume);
        if (found.canBeShown() && !isDrawnOn(found.header, *volume.series))
            found.note = Text("It was drawn on another series of this coordinate system.");
    }
    if (found.title.empty()) found.title = found.structures ? "Structure set" : "Segmentation";
    return found;
}

}  // namespace

Result<std::vector<FoundSegmentation>> findSegmentations(const FoundVolumes& found, const FoundVolume& volume,
                                                         Progress& progress) try {
    const std::vector<Candidate> candidates = candidatesOf(found.scan());
    std::vector<FoundSegmentation> all;
    if (!candidates.empty())
        progress.beginStage(Text("Reading {} segmentations", candidates.size()), candidates.size());
    std::set<std::string> digests;
    for (const Candidate& candidate : candidates) {
        if (progress.cancelled())
            return Error{ErrorCode::cancelled, Text("Reading segmentations was cancelled."), {}, {}};
        FoundSegmentation each = read(found.scan(), candidate, volume);
        if (digests.insert(each.digest).second) all.push_back(std::move(each));  // copies count once
        progress.advance();
    }
    std::stable_partition(all.begin(), all.end(), std::mem_fn(&FoundSegmentation::canBeShown));
    return all;
} catch (const std::exception& thrown) {
    return errorOf(thrown, Text("read the segmentations"));
}

}  // namespace macula::study
