#include "scene/segments/segmentation_file.h"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include "base/coded_name.h"
#include "base/sha256.h"
#include "dicom/segmentation/segment_codes.h"
#include "dicom/write/segmentation_writer.h"
#include "study/open/slice_images.h"

namespace macula::scene {

namespace {

dicom::WrittenSegmentation gridOf(const Volume& volume, const study::FoundVolume& of) {
    dicom::WrittenSegmentation written;
    written.worldFromVoxel = volume.worldFromVoxel();
    written.size = volume.size();
    written.series.seriesInstanceUid = of.series->seriesInstanceUid;
    written.series.frameOfReferenceUid = study::frameOfReferenceOf(*of.stack);
    for (const study::SliceImage& image : study::imagesOfSlices(volume, *of.stack)) {
        dicom::SegmentedSlice slice{.positionMm = image.positionMm, .of = {}};
        if (image.frame != nullptr && image.frame->instance) {
            const dicom::Instance& instance = *image.frame->instance;
            slice.of = dicom::ReferencedImage{instance.sopClassUid, instance.sopInstanceUid};
            if (instance.multiFrame) slice.of->frames = {image.frame->number + 1};
        }
        written.slices.push_back(std::move(slice));
    }
    return written;
}

// Of vocabularies that everybody has; a person may have typed the words of any other code.
std::optional<CodedName> withoutWords(const std::optional<CodedName>& code) {
    constexpr std::array kPublic{"SCT", "SRT", "SNM3", "DCM", "FMA", "RADLEX", "NCIt", "UMLS"};
    const bool isPublic = code && std::ranges::find(kPublic, code->scheme) != kPublic.end();
    return isPublic ? code : std::nullopt;
}

// Labels, descriptions and names of programs may have been typed by a person.
void leaveWordsOut(dicom::WrittenSegment& written) {
    written.codes = {withoutWords(written.codes.category), withoutWords(written.codes.type)};
    written.segment.label = written.codes.type ? written.codes.type->meaning : std::string();
    written.segment.description.clear();
    written.segment.algorithmName.clear();
}

Error fileHasChanged(const std::filesystem::path& file) {
    return {ErrorCode::inputNotUsable, Text("The file of this segmentation is another one by now."),
            file.string(), Text("Open the study again.")};
}

// Returns how many segments have no voxel here.
Result<std::size_t> addPart(dicom::WrittenSegmentation& to, const SegmentationRequest::Part& part,
                            bool isDeidentified) {
    dicom::CodesOfSegments read;
    if (!part.file.empty()) {
        MACULA_TRY(read, dicom::readSegmentCodes(part.file));
    }
    if (!read.sopInstanceUid.empty() && sha256Hex(read.sopInstanceUid) != part.loaded->digest)
        return fileHasChanged(part.file);
    std::size_t empty = 0;
    for (const study::LoadedSegment& each : part.loaded->segments) {
        if (std::ranges::find(part.numbers, each.segment.number) == part.numbers.end()) continue;
        if (!each.voxels || each.voxels->isEmpty()) {
            ++empty;
            continue;
        }
        dicom::WrittenSegment written{.segment = each.segment, .voxels = each.voxels};
        if (const auto at = read.codes.find(each.segment.number); at != read.codes.end())
            written.codes = at->second;
        if (isDeidentified) leaveWordsOut(written);
        to.segments.push_back(std::move(written));
    }
    return empty;
}

std::vector<Text> notesOn(const SegmentationRequest& request, std::size_t empty) {
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
    // Such as voxels outside of this volume, which are not in the file.
    for (const SegmentationRequest::Part& part : request.parts)
        notes.insert(notes.end(), part.loaded->notes.begin(), part.loaded->notes.end());
    if (empty > 0)
        notes.push_back(Text("{} segments have no voxel in this volume, and are left out.", empty));
    if (request.isDeidentified)
        notes.push_back(
            Text("Without patient and study, the file calls each segment by its code, not by its label."));
    return notes;
}

}  // namespace

std::size_t SegmentationRequest::segments() const {
    std::size_t count = 0;
    for (const Part& part : parts) count += part.numbers.size();
    return count;
}

Result<std::vector<Text>> writeSegmentation(const std::filesystem::path& path,
                                            const SegmentationRequest& request) {
    const study::FoundVolume& of = request.found->volumes().at(request.volumeIndex);
    MACULA_TRY_VOID(dicom::checkReferable(*of.series));
    dicom::WrittenSegmentation written = gridOf(*request.volume, of);
    std::size_t empty = 0;
    for (const SegmentationRequest::Part& part : request.parts) {
        MACULA_TRY(const std::size_t without, addPart(written, part, request.isDeidentified));
        empty += without;
    }
    dicom::NewObject object{
        .image = {}, .isDeidentified = request.isDeidentified, .softwareVersion = MACULA_VERSION};
    if (!of.stack->frames.empty()) {
        const dicom::Instance& middle = *of.stack->frames[of.stack->frames.size() / 2].instance;
        object.image = dicom::SecondaryCapture::Source{middle.file, middle.sopInstanceUid};
    }
    MACULA_TRY_VOID(dicom::writeSegmentation(path, written, object));
    return notesOn(request, empty);
}

}  // namespace macula::scene
