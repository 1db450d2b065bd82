#include "dicom/read/instance.h"

#include <algorithm>
#include <limits>

#include "dicom/read/frame_plane.h"
#include "dicom/read/frame_values.h"
#include "dicom/read/sop_class.h"
#include "dicom/read/transfer_syntax.h"
#include "dicom/split/frame_lists.h"
#include "dicom/split/split_rules.h"

namespace macula::dicom {

namespace {

// No real object has as many; a header that says so costs memory and nothing else.
constexpr int kMostFrames = 100'000;

std::optional<CellFormat> readFormat(const Dataset& header) {
    if (header.has(tag::kFloatPixelData)) return floatFormat(CellKind::float32);
    if (header.has(tag::kDoubleFloatPixelData)) return floatFormat(CellKind::float64);
    const auto allocated = header.integer(tag::kBitsAllocated);
    const auto stored = header.integer(tag::kBitsStored);
    const auto highBit = header.integer(tag::kHighBit);
    const auto representation = header.integer(tag::kPixelRepresentation);
    if (!allocated || !stored || !highBit || !representation) return {};
    const CellFormat format{*allocated, *stored, *highBit, *representation == 1};
    if (!isUsable(format)) return {};
    return format;
}

// The most frames that the file has room for. At least one, so that a file without its pixels is still
// reported.
int mostFrames(const std::filesystem::path& file, const HeaderFile& read) {
    const Dataset& header = *read.header;
    std::uint64_t most = 1;
    if (read.pixels && read.pixels->encapsulated) {
        constexpr std::uint64_t kFragmentHeader = 8;
        std::error_code error;
        const std::uintmax_t size = std::filesystem::file_size(file, error);
        if (!error) most = size / kFragmentHeader;
    } else if (read.pixels) {
        const auto number = [&](Tag tag) {
            return static_cast<std::uint64_t>(std::max(header.integer(tag).value_or(0), 0));
        };
        const std::uint64_t bits =
            std::max<std::uint64_t>(1, number(tag::kRows) * number(tag::kColumns) *
                                           std::min<std::uint64_t>(number(tag::kBitsAllocated), 64));
        // One more than the pixel data hold, so that a frame that is missing is noticed.
        most = 8 * read.pixels->bytesPresent / bits + 1;
    }
    return static_cast<int>(std::clamp<std::uint64_t>(most, 1, kMostFrames));
}

bool hasOverlayInPixels(const Dataset& header) {
    for (std::uint16_t group = 0x6000; group <= 0x601E; group += 2) {
        if (header.integer(Tag{group, tag::kOverlayBitPositionElement}).value_or(0) > 0) return true;
    }
    return false;
}

std::shared_ptr<Instance> readShared(const std::filesystem::path& file, const HeaderFile& read) {
    const Dataset& header = *read.header;
    auto instance = std::make_shared<Instance>();
    instance->file = file;
    instance->sopClassUid = header.text(tag::kSopClassUid).value_or("");
    instance->sopInstanceUid = header.text(tag::kSopInstanceUid).value_or("");
    instance->transferSyntaxUid = header.transferSyntaxUid();
    instance->modality = header.text(tag::kModality).value_or("");
    instance->modalityMissing = instance->modality.empty();
    if (instance->modalityMissing) instance->modality = modalityOfClass(instance->sopClassUid);
    instance->photometricInterpretation = header.text(tag::kPhotometricInterpretation).value_or("");
    instance->instanceNumber = header.integer(tag::kInstanceNumber);
    instance->acquisitionNumber = header.integer(tag::kAcquisitionNumber);
    instance->imagesInAcquisition = header.integer(tag::kImagesInAcquisition);
    instance->slicesOfVolume = header.integer(tag::kNumberOfSlices);
    instance->seriesRelatedInstances = header.integer(tag::kNumberOfSeriesRelatedInstances);
    instance->studyRelatedInstances = header.integer(tag::kNumberOfStudyRelatedInstances);
    instance->columns = header.integer(tag::kColumns).value_or(0);
    instance->rows = header.integer(tag::kRows).value_or(0);
    instance->framesClaimed = header.frameCount();
    instance->frames = std::min(instance->framesClaimed, mostFrames(file, read));
    instance->samplesPerPixel = header.integer(tag::kSamplesPerPixel).value_or(1);
    if (instance->photometricInterpretation.empty() && instance->samplesPerPixel == 1) {
        instance->photometricInterpretation = "MONOCHROME2";
        instance->greyscaleAssumed = true;
    }
    instance->format = readFormat(header);
    instance->multiFrame = header.has(tag::kNumberOfFrames) && header.frameCount() > 1;
    instance->multiFrame = instance->multiFrame || header.has(tag::kPerFrameFunctionalGroups);
    instance->lossy =
        header.text(tag::kLossyImageCompression) == "01" || isLossy(instance->transferSyntaxUid);
    instance->strayBytes = read.strayBytes;
    instance->overlayInPixels = hasOverlayInPixels(header);
    instance->concatenationUid = header.text(tag::kConcatenationUid).value_or("");
    instance->concatenationTotal = header.integer(tag::kInConcatenationTotalNumber).value_or(0);
    instance->suv = suvOf(header);
    return instance;
}

Frame readFrame(const Dataset& header, const Dataset& dataset, std::shared_ptr<const Instance> instance,
                int number, double offsetMm) {
    Frame frame{.instance = std::move(instance), .number = number};
    frame.imageType = dataset.shortTexts(tag::kFrameType);
    if (frame.imageType.empty()) frame.imageType = dataset.shortTexts(tag::kImageType);
    frame.frameOfReferenceUid = dataset.shortText(tag::kFrameOfReferenceUid);
    readPlane(header, dataset, offsetMm, frame);
    readValues(dataset, frame);
    frame.attributes = readAttributes(splitRules(), dataset);
    return frame;
}

// Keeps of what lists say only what tells frames of the file apart, or of the files that it is continued in.
void dropWhatAllShare(const FrameLists& lists, std::vector<Frame>& frames) {
    if (!frames.front().instance->concatenationUid.empty()) return;
    for (std::size_t a = 0; a < frames.front().attributes.size(); ++a) {
        const std::string first = frames.front().attributes[a];
        if (first.empty() || !lists.mayHave(a)) continue;
        if (std::ranges::all_of(frames, [&](const Frame& f) { return f.attributes[a] == first; })) {
            for (Frame& frame : frames) frame.attributes[a].clear();
        }
    }
}

}  // namespace

std::vector<Frame> readFrames(const std::filesystem::path& file, const HeaderFile& read) {
    const Dataset& header = *read.header;
    const std::shared_ptr<const Instance> instance = readShared(file, read);
    std::vector<Frame> frames;
    frames.reserve(static_cast<std::size_t>(instance->frames));
    const FrameOffsets offsets = frameOffsets(header);
    const FrameLists lists(splitRules(), header);
    for (int i = 0; i < instance->frames; ++i) {
        const auto at = static_cast<std::size_t>(i);
        // The position of frames beyond the list is unknown.
        const double beyond = offsets.mm.empty() ? 0.0 : std::numeric_limits<double>::quiet_NaN();
        const double offsetMm = at < offsets.mm.size() ? offsets.mm[at] : beyond;
        const Dataset dataset = instance->multiFrame ? header.frame(i) : header;
        frames.push_back(readFrame(header, dataset, instance, i, offsetMm));
        frames.back().isPlacedByOrder = offsets.isByOrder;
        lists.apply(dataset, i, frames.back().attributes);
        // A table that all frames share is kept once.
        if (i > 0 && frames[at].modalityLut && frames[at - 1].modalityLut &&
            *frames[at].modalityLut == *frames[at - 1].modalityLut) {
            frames[at].modalityLut = frames[at - 1].modalityLut;
        }
    }
    dropWhatAllShare(lists, frames);
    return frames;
}

SliceIntensity sliceIntensity(const Frame& frame) {
    return {.format = frame.instance->format.value_or(CellFormat{}),
            .slope = frame.slope.value_or(1.0),
            .intercept = frame.intercept.value_or(0.0),
            .padding = frame.padding,
            .floatPadding = frame.floatPadding,
            .modalityLut = frame.modalityLut};
}

}  // namespace macula::dicom
