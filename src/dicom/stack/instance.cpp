#include "dicom/stack/instance.h"

#include <algorithm>
#include <array>
#include <limits>

#include "dicom/read/sop_class.h"
#include "dicom/read/transfer_syntax.h"
#include "dicom/stack/frame_parts.h"
#include "dicom/stack/split_rules.h"

namespace macula::dicom {

namespace {

// No real object has as many; the limit bounds the memory that a false header takes.
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
    const bool isRead = transferSyntaxInfo(header.transferSyntaxUid()).codec != Codec::unsupported;
    if (read.pixels && read.pixels->encapsulated && read.pixels->whole && read.pixels->fragments > 1 &&
        isRead) {
        // One fragment may hold several frames; each of several fragments begins a frame or continues one.
        most = read.pixels->streams > 0 ? read.pixels->streams : read.pixels->fragments;
    } else if (read.pixels && read.pixels->encapsulated) {
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

std::uint16_t overlayBitsOf(const Dataset& header) {
    unsigned bits = 0;
    for (std::uint16_t group = 0x6000; group <= 0x601E; group += 2) {
        const int bit = header.integer(Tag{group, tag::kOverlayBitPositionElement}).value_or(0);
        if (bit > 0 && bit < 16) bits |= 1u << bit;
    }
    return static_cast<std::uint16_t>(bits);
}

// The number of frames beyond NumberOfFrames for which the file has pixels or functional groups.
double framesBeyond(const Instance& instance, const HeaderFile& read) {
    const auto claimed = static_cast<double>(instance.framesClaimed);
    auto there = static_cast<double>(read.header->itemCount(tag::kPerFrameFunctionalGroups));
    if (read.pixels && read.pixels->encapsulated) {
        there = std::max(there, static_cast<double>(read.pixels->streams));
    } else if (read.pixels && instance.rows > 0) {
        // Less than a row is padding.
        const auto bits = static_cast<double>(bitsPerFrame(instance, *read.header));
        const double held = bits > 0.0 ? 8.0 * static_cast<double>(read.pixels->bytesPresent) / bits : 0.0;
        if (held >= claimed + 1.0 / instance.rows) there = std::max(there, held);
    }
    return std::max(0.0, there - claimed);
}

// Elements that determine the values and places of voxels, or the patient.
struct Decisive {
    Tag tag;
    std::string_view keyword;
};

constexpr std::array kDecisive = std::to_array<Decisive>({
    {tag::kImageType, "ImageType"},
    {tag::kSopClassUid, "SOPClassUID"},
    {tag::kModality, "Modality"},
    {tag::kPatientName, "PatientName"},
    {tag::kPatientId, "PatientID"},
    {tag::kPatientBirthDate, "PatientBirthDate"},
    {tag::kPatientWeight, "PatientWeight"},
    {tag::kSliceThickness, "SliceThickness"},
    {tag::kSpacingBetweenSlices, "SpacingBetweenSlices"},
    {tag::kImagerPixelSpacing, "ImagerPixelSpacing"},
    {tag::kStudyInstanceUid, "StudyInstanceUID"},
    {tag::kSeriesInstanceUid, "SeriesInstanceUID"},
    {tag::kInstanceNumber, "InstanceNumber"},
    {tag::kPatientOrientation, "PatientOrientation"},
    {tag::kImagePositionPatient, "ImagePositionPatient"},
    {tag::kImageOrientationPatient, "ImageOrientationPatient"},
    {tag::kFrameOfReferenceUid, "FrameOfReferenceUID"},
    {Tag{0x0020, 0x9113}, "PlanePositionSequence"},
    {Tag{0x0020, 0x9116}, "PlaneOrientationSequence"},
    {tag::kSamplesPerPixel, "SamplesPerPixel"},
    {tag::kPhotometricInterpretation, "PhotometricInterpretation"},
    {tag::kNumberOfFrames, "NumberOfFrames"},
    {tag::kRows, "Rows"},
    {tag::kColumns, "Columns"},
    {tag::kPixelSpacing, "PixelSpacing"},
    {tag::kBitsAllocated, "BitsAllocated"},
    {tag::kBitsStored, "BitsStored"},
    {tag::kHighBit, "HighBit"},
    {tag::kPixelRepresentation, "PixelRepresentation"},
    {tag::kPixelPaddingValue, "PixelPaddingValue"},
    {tag::kPixelPaddingRangeLimit, "PixelPaddingRangeLimit"},
    {tag::kRescaleIntercept, "RescaleIntercept"},
    {tag::kRescaleSlope, "RescaleSlope"},
    {tag::kRescaleType, "RescaleType"},
    {tag::kModalityLutSequence, "ModalityLUTSequence"},
    {Tag{0x0028, 0x9110}, "PixelMeasuresSequence"},
    {Tag{0x0028, 0x9145}, "PixelValueTransformationSequence"},
    {tag::kRealWorldValueMapping, "RealWorldValueMappingSequence"},
    {tag::kRadiopharmaceuticalInformation, "RadiopharmaceuticalInformationSequence"},
    {tag::kUnits, "Units"},
    {tag::kDecayCorrection, "DecayCorrection"},
    {tag::kDoseUnits, "DoseUnits"},
    {tag::kGridFrameOffsetVector, "GridFrameOffsetVector"},
    {tag::kDoseGridScaling, "DoseGridScaling"},
    {tag::kSharedFunctionalGroups, "SharedFunctionalGroupsSequence"},
    {tag::kPerFrameFunctionalGroups, "PerFrameFunctionalGroupsSequence"},
});

std::vector<std::string_view> contradictedOf(const Dataset& dataset) {
    static const std::vector<Tag> tags = [] {
        std::vector<Tag> all;
        for (const Decisive& decisive : kDecisive) all.push_back(decisive.tag);
        return all;
    }();
    std::vector<std::string_view> keywords;
    for (const Tag& found : dataset.contradicted(tags))
        keywords.push_back(std::ranges::find(kDecisive, found, &Decisive::tag)->keyword);
    return keywords;
}

// Code Strings are in capitals (PS3.5 6.2), but not for all writers.
std::string inCapitals(std::string text) {
    std::ranges::transform(text, text.begin(),
                           [](char c) { return c >= 'a' && c <= 'z' ? char(c - 32) : c; });
    return text;
}

std::shared_ptr<Instance> readShared(const std::filesystem::path& file, const HeaderFile& read) {
    const Dataset& header = *read.header;
    auto instance = std::make_shared<Instance>();
    instance->file = file;
    instance->sopClassUid = header.text(tag::kSopClassUid).value_or("");
    instance->sopInstanceUid = header.text(tag::kSopInstanceUid).value_or("");
    instance->transferSyntaxUid = header.transferSyntaxUid();
    instance->contradictedSyntaxUid = read.contradictedSyntaxUid;
    instance->modality = inCapitals(header.text(tag::kModality).value_or(""));
    instance->modalityMissing = instance->modality.empty();
    if (instance->modalityMissing) instance->modality = modalityOfClass(instance->sopClassUid);
    instance->photometricInterpretation =
        inCapitals(header.text(tag::kPhotometricInterpretation).value_or(""));
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
    if (read.pixels && !read.pixels->encapsulated) instance->pixelBytes = read.pixels->bytesPresent;
    instance->framesBeyond = framesBeyond(*instance, read);
    instance->overlayBits = overlayBitsOf(header);
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
    frame.contradicted = contradictedOf(dataset);
    return frame;
}

// Clears attributes from lists that are equal in all frames, unless the image continues in other files.
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

std::uint64_t bitsPerFrame(const Instance& instance, const Dataset& header) {
    const int bits = header.integer(tag::kBitsAllocated).value_or(0);
    if (instance.rows <= 0 || instance.columns <= 0 || bits <= 0 || bits > 64) return 0;
    // Two pixels share their chroma samples: PS3.3 C.7.6.3.1.2.
    const bool halfChroma = instance.photometricInterpretation.ends_with("_422");
    const int samples = halfChroma ? 2 : std::clamp(instance.samplesPerPixel, 1, 4);
    return static_cast<std::uint64_t>(instance.rows) * static_cast<std::uint64_t>(instance.columns) *
           static_cast<std::uint64_t>(samples) * static_cast<std::uint64_t>(bits);
}

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
    if (read.pixels && read.pixels->repeated) {
        for (Frame& frame : frames) frame.contradicted.emplace_back("PixelData");
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
