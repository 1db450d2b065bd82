#include "dicom/stack/examination.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <string_view>

#include "dicom/documents/read_document.h"
#include "dicom/manifest/imaging_manifest.h"
#include "dicom/read/presentation_tags.h"
#include "dicom/read/random_file.h"
#include "dicom/read/sop_class.h"
#include "dicom/read/transfer_syntax.h"

namespace macula::dicom {

namespace {

using namespace std::string_view_literals;

struct Kind {
    std::string_view name;
    std::size_t at = 0;
    std::string_view magic;
    std::array<std::string_view, 5> endings;  // that names may have, besides none and those of DICOM
};

constexpr std::array kKinds = std::to_array<Kind>({
    {"zip", 0, "PK\x03\x04"sv, {".zip"}},
    {"gzip", 0, "\x1f\x8b\x08"sv, {".gz", ".tgz"}},
    {"bzip2", 0, "BZh"sv, {".bz2", ".tbz2", ".tbz"}},
    {"xz", 0, "\xfd\x37zXZ\0"sv, {".xz", ".txz"}},
    {"Zstandard", 0, "\x28\xb5\x2f\xfd"sv, {".zst", ".tzst"}},
    {"7z", 0, "7z\xbc\xaf\x27\x1c"sv, {".7z"}},
    {"RAR", 0, "Rar!\x1a\x07"sv, {".rar"}},
    {"tar", 257, "ustar"sv, {".tar"}},
});

std::string lowerCase(std::string text) {
    std::ranges::transform(text, text.begin(), [](unsigned char c) { return std::tolower(c); });
    return text;
}

bool fits(const Kind& kind, const std::filesystem::path& file) {
    const std::string ending = lowerCase(file.extension().string());
    constexpr std::array kOfImages{""sv, ".dcm"sv, ".dicom"sv, ".ima"sv, ".img"sv};
    if (std::ranges::find(kind.endings, ending) == kind.endings.end() &&
        std::ranges::find(kOfImages, ending) == kOfImages.end())
        return false;
    // Compressed files of other kinds, such as volume.nii.gz, are not archives.
    const std::string inside = lowerCase(file.stem().extension().string());
    return inside != ".nii" && inside != ".nrrd" && inside != ".spz" && inside != ".svg";
}

// Recognises archives, which may hold images and are not opened.
// "zip", "gzip", "bzip2", "xz", "Zstandard", "tar", "7z" or "RAR", for a person; empty for any other file.
// The file's first bytes decide; but a name extension of another kind of file makes it empty: programs and
// documents on discs are zips as well, and NIfTI volumes are compressed by gzip.
std::string_view archiveKind(const std::filesystem::path& file) {
    constexpr std::size_t kHead = 262;
    const RandomFile opened(file);
    std::array<std::byte, kHead> head{};
    std::size_t size = head.size();
    if (!opened.read(0, head)) {
        // A shorter file cannot have the magic that lies far behind its beginning.
        constexpr std::size_t kShort = 6;
        size = kShort;
        if (!opened.read(0, std::span(head).first(kShort))) return {};
    }
    const std::string_view begin(reinterpret_cast<const char*>(head.data()), size);
    for (const Kind& kind : kKinds) {
        if (begin.size() > kind.at && begin.substr(kind.at).starts_with(kind.magic))
            return fits(kind, file) ? kind.name : std::string_view();
    }
    return {};
}

// Frames after the end of the file are dropped. An image that loses all of them is truncated.
void dropFramesCutOff(Examination& found, const HeaderFile& read) {
    if (!read.pixels) return;
    const PixelDataExtent& pixels = *read.pixels;
    if (pixels.encapsulated) {
        // Decoding finds which frames are whole; a single one is certainly cut off.
        if (found.state == FileState::truncated && found.frames.size() > 1) found.state = FileState::complete;
        return;
    }
    const Instance& instance = *found.frames.front().instance;
    const std::uint64_t bits = bitsPerFrame(instance, *read.header);
    if (bits == 0) return;
    const std::uint64_t whole = 8 * pixels.bytesPresent / bits;
    if (whole >= found.frames.size()) {
        if (found.state == FileState::truncated)
            found.state = FileState::complete;  // only padding is missing
        return;
    }
    found.frames.erase(found.frames.begin() + static_cast<std::ptrdiff_t>(whole), found.frames.end());
    found.state = found.frames.empty() ? FileState::truncated : FileState::complete;
}

// Whether NumberOfFrames is unusable; an empty one counts as absent.
bool hasInvalidFrameCount(const Dataset& header) {
    const auto count = header.text(tag::kNumberOfFrames);
    if (!count || count->find_first_not_of(' ') == std::string::npos) return false;
    return !header.integer(tag::kNumberOfFrames);
}

// The items of Referenced Series Sequence, and those of Studies Containing Other Referenced Instances.
std::vector<Dataset> referencedSeriesOf(const Dataset& header) {
    std::vector<Dataset> all = header.items(tag::kReferencedSeries);
    for (const Dataset& study : header.items(presentation_tag::kStudiesContainingOtherInstances)) {
        for (const Dataset& item : study.items(tag::kReferencedSeries)) all.push_back(item);
    }
    return all;
}

template <class T>
void sortOut(std::vector<T>& values) {
    std::sort(values.begin(), values.end());
    values.erase(std::unique(values.begin(), values.end()), values.end());
}

PresentationHeading headingOf(const Dataset& header, const std::vector<Dataset>& referencedSeries) {
    namespace tags = presentation_tag;
    PresentationHeading heading{.label = header.shortText(tags::kContentLabel),
                                .description = header.shortText(tags::kContentDescription),
                                .date = header.shortText(tags::kCreationDate),
                                .time = header.shortText(tags::kCreationTime),
                                .creator = header.text(tags::kContentCreatorName).value_or(""),
                                .images = {}};
    std::vector<ReferencedFrames> images;
    for (const Dataset& series : referencedSeries) {
        // States of slices refer to images, those of volumes to instances (PS3.3 C.11.11 and C.12.2).
        for (const Tag named : {tags::kReferencedImages, tags::kReferencedInstances}) {
            for (ReferencedFrames& image : referencedFrames(series.items(named)))
                images.push_back(std::move(image));
        }
    }
    heading.images = byImage(std::move(images));
    return heading;
}

OtherObject readObject(const std::filesystem::path& file, const Dataset& header,
                       const std::string& sopClass) {
    OtherObject object{.file = file, .sopClassUid = sopClass, .kind = describeSopClass(sopClass)};
    if (isImagingManifest(header)) object.kind = imagingManifestKind();
    const bool isPresentation = isPresentationState(sopClass);
    const std::vector<Dataset> series =
        isPresentation ? referencedSeriesOf(header) : header.items(tag::kReferencedSeries);
    for (const Dataset& item : series) {
        if (auto uid = item.text(tag::kSeriesInstanceUid))
            object.referencedSeriesUids.push_back(std::move(*uid));
    }
    sortOut(object.referencedSeriesUids);
    object.label = documentTitleOf(header);
    if (isPresentation) {
        object.presentation = headingOf(header, series);
        const PresentationHeading& heading = *object.presentation;
        object.label = heading.description.empty() ? heading.label : heading.description;
    }
    return object;
}

}  // namespace

Examination examine(const std::filesystem::path& file, const CancelToken& cancel) {
    Examination found;
    const HeaderFile read = readHeader(file, cancel);
    found.state = read.state;
    if (read.state == FileState::notDicom) found.archive = archiveKind(file);
    if (!read.header) return found;
    const Dataset& header = *read.header;
    const auto text = [&](Tag tag) { return header.text(tag).value_or(""); };
    const std::string sopClass = text(tag::kSopClassUid);
    if (sopClass == sop_class::kMediaDirectory || header.has(tag::kDirectoryRecords)) {
        found.kind = Examination::Kind::directory;
        return found;
    }
    found.studyInstanceUid = text(tag::kStudyInstanceUid);
    found.studyDate = text(tag::kStudyDate);
    found.studyDescription = text(tag::kStudyDescription);
    found.patientName = text(tag::kPatientName);
    found.patient = patientIdentity(header);
    found.sopInstanceUid = text(tag::kSopInstanceUid);
    found.seriesInstanceUid = text(tag::kSeriesInstanceUid);
    found.modality = text(tag::kModality);
    found.seriesDescription = text(tag::kSeriesDescription);
    found.patientPosition = text(tag::kPatientPosition);
    found.seriesNumber = header.integer(tag::kSeriesNumber);

    const bool hasImage = header.has(tag::kRows) && header.has(tag::kColumns) && !isSegmentation(sopClass) &&
                          sopClass != sop_class::kMrSpectroscopy;
    if (!hasImage && isImage(sopClass)) {
        found.state = FileState::damaged;  // cut off between two elements, before rows and columns
    } else if (!hasImage) {
        found.kind = Examination::Kind::other;
        found.object = readObject(file, header, sopClass);
    } else if (!read.pixels) {
        found.kind = Examination::Kind::imageWithoutPixels;
    } else if (hasInvalidFrameCount(header)) {
        found.kind = Examination::Kind::image;
        found.invalidFrameCount = true;
    } else {
        found.kind = Examination::Kind::image;
        found.frames = readFrames(file, read);
        const auto claimed = static_cast<std::size_t>(found.frames.front().instance->framesClaimed);
        dropFramesCutOff(found, read);
        found.framesMissing = claimed - found.frames.size();
    }
    found.charsetFallback = header.charsetFallback();
    return found;
}

}  // namespace macula::dicom
