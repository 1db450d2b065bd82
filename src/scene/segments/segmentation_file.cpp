#include "scene/segments/segmentation_file.h"

#include <algorithm>
#include <utility>

#include "dicom/segmentation/segment_codes.h"
#include "dicom/write/segmentation_writer.h"

namespace macula::scene {

namespace {

dicom::WrittenSegmentation gridOf(const Volume& volume, const study::FoundVolume& of) {
    dicom::WrittenSegmentation written;
    written.worldFromVoxel = volume.worldFromVoxel();
    written.size = volume.size();
    written.series.seriesInstanceUid = of.series->seriesInstanceUid;
    written.series.frameOfReferenceUid = study::frameOfReferenceOf(*of.stack);
    const std::vector<glm::dvec3> positionsMm = dicom::slicePositionsMm(*of.stack);
    for (std::size_t k = 0; k < of.stack->slices.size() && k < positionsMm.size(); ++k) {
        dicom::SegmentedSlice slice{.positionMm = positionsMm[k], .of = {}};
        const dicom::SliceSource& source = of.stack->slices[k];
        const dicom::Frame& frame = of.stack->frames.at(source.below);
        if (!source.interpolated() && frame.instance) {
            slice.of = dicom::ReferencedImage{frame.instance->sopClassUid, frame.instance->sopInstanceUid};
            if (frame.instance->multiFrame) slice.of->frames = {frame.number + 1};
        }
        written.slices.push_back(std::move(slice));
    }
    return written;
}

// Labels, descriptions and names of programs may have been typed by a person.
Segment withoutWords(Segment segment, const dicom::SegmentCodes& codes) {
    segment.label = codes.type ? codes.type->meaning : std::string();
    segment.description.clear();
    segment.algorithmName.clear();
    return segment;
}

Result<void> addPart(dicom::WrittenSegmentation& to, const SegmentationRequest::Part& part,
                     bool isDeidentified) {
    MACULA_TRY(const auto codes, dicom::readSegmentCodes(part.file));
    for (const study::LoadedSegment& each : part.loaded->segments) {
        dicom::WrittenSegment written{.segment = each.segment, .voxels = each.voxels};
        if (const auto at = codes.find(each.segment.number); at != codes.end()) written.codes = at->second;
        if (isDeidentified) written.segment = withoutWords(written.segment, written.codes);
        to.segments.push_back(std::move(written));
    }
    return {};
}

std::vector<Text> notesOn(const SegmentationRequest& request) {
    const auto any = [&](bool study::LoadedSegmentation::*is) {
        return std::ranges::any_of(
            request.parts, [is](const SegmentationRequest::Part& part) { return (*part.loaded).*is; });
    };
    std::vector<Text> notes;
    if (any(&study::LoadedSegmentation::isResampled))
        notes.push_back(
            Text("The file has the segments on the voxels of this volume, not on those that they "
                 "were drawn on."));
    if (any(&study::LoadedSegmentation::hasFractions))
        notes.push_back(Text("The file has no fractions: what was half or more is the segment."));
    if (request.isDeidentified)
        notes.push_back(
            Text("Without patient and study, the file calls each segment by its code, not by its label."));
    return notes;
}

}  // namespace

std::size_t SegmentationRequest::segments() const {
    std::size_t count = 0;
    for (const Part& part : parts) count += part.loaded->segments.size();
    return count;
}

Result<std::vector<Text>> writeSegmentation(const std::filesystem::path& path,
                                            const SegmentationRequest& request) {
    const study::FoundVolume& of = request.found->volumes().at(request.volumeIndex);
    dicom::WrittenSegmentation written = gridOf(*request.volume, of);
    for (const SegmentationRequest::Part& part : request.parts)
        MACULA_TRY_VOID(addPart(written, part, request.isDeidentified));
    dicom::SegmentationOwner owner{
        .image = {}, .isDeidentified = request.isDeidentified, .softwareVersion = MACULA_VERSION};
    if (!of.stack->frames.empty()) {
        const dicom::Instance& middle = *of.stack->frames[of.stack->frames.size() / 2].instance;
        owner.image = dicom::SecondaryCapture::Source{middle.file, middle.sopInstanceUid};
    }
    MACULA_TRY_VOID(dicom::writeSegmentation(path, written, owner));
    return notesOn(request);
}

}  // namespace macula::scene
