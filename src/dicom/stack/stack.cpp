#include "dicom/stack/stack.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "base/check.h"
#include "dicom/read/sop_class.h"
#include "dicom/read/transfer_syntax.h"
#include "dicom/stack/odd_images.h"
#include "dicom/stack/value_unit.h"

namespace macula::dicom {

namespace {

template <class Predicate>
bool any(const Stack& stack, Predicate predicate) {
    return std::any_of(stack.frames.begin(), stack.frames.end(), predicate);
}

// Whether the image is a mosaic: slices side by side in one image, as in EPI by Siemens.
bool isMosaic(const Frame& frame) {
    return std::ranges::find(frame.imageType, "MOSAIC") != frame.imageType.end();
}

// Reports that images lack the Modality (0008,0060), and which one is used instead: that of their SOP class,
// or of the first file of the series.
void tellMissingModality(Stack& stack) {
    const auto isMissing = [](const Frame& f) { return f.instance->modalityMissing; };
    const auto first = std::ranges::find_if(stack.frames, isMissing);
    if (first == stack.frames.end()) return;
    const auto count = std::ranges::count_if(stack.frames, isMissing);
    // The modality of other images is text from a file, which may be anything, so it is not repeated.
    const std::string& ofClass = first->instance->modality;
    const Text taken = !ofClass.empty()         ? Text("{}, by their kind of object", ofClass)
                       : stack.modality.empty() ? Text("images of an unknown device")
                                                : Text("what others of the series are");
    tell(stack, message(key::kMissingModality, {{"count", std::int64_t(count)},
                                                {"total", std::int64_t(stack.frames.size())},
                                                {"modality", taken}}));
}

// The few frames whose rescale differs from the one that all others share; none where each has its own.
std::vector<const Frame*> deviatingRescales(const std::vector<Frame>& frames) {
    constexpr std::size_t kOneOf = 4;
    const auto rescaleOf = [](const Frame& f) { return std::pair(f.slope, f.intercept); };
    std::map<std::pair<std::optional<double>, std::optional<double>>, std::size_t> counts;
    for (const Frame& frame : frames) ++counts[rescaleOf(frame)];
    const auto usual = std::max_element(counts.begin(), counts.end(),
                                        [](const auto& a, const auto& b) { return a.second < b.second; });
    std::vector<const Frame*> deviating;
    if (kOneOf * (frames.size() - usual->second) > frames.size()) return deviating;
    for (const Frame& frame : frames) {
        if (rescaleOf(frame) != usual->first) deviating.push_back(&frame);
    }
    return deviating;
}

Text bytesText(std::uint64_t bytes) {
    constexpr std::uint64_t kKilo = 1000;
    if (bytes < 10 * kKilo) return Text("{} bytes", bytes);
    if (bytes < 10 * kKilo * kKilo) return Text("{} kB", bytes / kKilo);
    return Text("{} MB", bytes / (kKilo * kKilo));
}

// Reports frames and bytes in files beyond the number of frames that they state.
void tellWhatIsBeyond(Stack& stack) {
    std::set<const Instance*> instances;
    for (const Frame& frame : stack.frames) instances.insert(frame.instance.get());
    std::int64_t files = 0;
    double frames = 0.0;
    std::uint64_t bytes = 0;
    bool isMoreThanImages = false;
    for (const Instance* instance : instances) {
        files += instance->framesBeyond > 0.0 ? 1 : 0;
        frames += instance->framesBeyond;
        bytes = std::max(bytes, instance->strayBytes);
        isMoreThanImages =
            isMoreThanImages || (instance->pixelBytes > 0 && instance->strayBytes >= instance->pixelBytes);
    }
    if (files > 0)
        tell(stack, message(key::kSurplusFrames, {{"files", files}, {"frames", Text("{:.3g}", frames)}}));
    if (bytes > 0) {
        // As many bytes as the images take may be further images.
        tell(stack, message(key::kStrayBytes, isMoreThanImages ? Severity::warning : Severity::info,
                            {{"bytes", bytesText(bytes)}}));
    }
}

// Reports files whose pixels have another encoding than the header names.
void tellContradictedSyntaxes(Stack& stack) {
    std::set<std::pair<std::string, std::string>> pairs;
    for (const Frame& frame : stack.frames) {
        const Instance& instance = *frame.instance;
        if (!instance.contradictedSyntaxUid.empty())
            pairs.emplace(instance.contradictedSyntaxUid, instance.transferSyntaxUid);
    }
    for (const auto& [said, found] : pairs) {
        tell(stack, message(key::kContradictedSyntax, {{"said", describeTransferSyntax(said)},
                                                       {"found", describeTransferSyntax(found)}}));
    }
}

// Reports elements that images have twice, with different values.
void tellRepeatedElements(Stack& stack) {
    std::set<std::string_view> keywords;
    for (const Frame& frame : stack.frames)
        keywords.insert(frame.contradicted.begin(), frame.contradicted.end());
    if (keywords.empty()) return;
    std::string list;
    for (const std::string_view keyword : keywords) list += (list.empty() ? "" : ", ") + std::string(keyword);
    const auto count =
        std::ranges::count_if(stack.frames, [](const Frame& f) { return !f.contradicted.empty(); });
    tell(stack, message(key::kRepeatedElement, {{"count", std::int64_t(count)},
                                                {"total", std::int64_t(stack.frames.size())},
                                                {"attributes", list}}));
}

void assessPixels(Stack& stack) {
    const Frame& first = stack.frames.front();
    if (any(stack, [](const Frame& f) {
            return f.instance->samplesPerPixel != 1 ||
                   !f.instance->photometricInterpretation.starts_with("MONOCHROME");
        })) {
        tell(stack, message(key::kColourImage));
    } else if (any(stack, [](const Frame& f) { return !f.instance->format; })) {
        tell(stack, message(key::kUnsupportedBits));
    } else if (any(stack,
                   [](const Frame& f) { return f.instance->photometricInterpretation == "MONOCHROME1"; })) {
        tell(stack, message(key::kInvertedDisplay));
    }
    if (any(stack, [&](const Frame& f) {
            return f.instance->columns != first.instance->columns || f.instance->rows != first.instance->rows;
        })) {
        tell(stack, message(key::kNotReconstructable, {{"reason", Text("their sizes differ")}}));
    }
    if (stack.columns < 1 || stack.rows < 1) {
        tell(stack, message(key::kNotReconstructable, {{"reason", Text("they have no pixels")}}));
    }
    std::set<std::string> syntaxes;
    for (const Frame& frame : stack.frames) syntaxes.insert(frame.instance->transferSyntaxUid);
    tellContradictedSyntaxes(stack);
    for (const std::string& uid : syntaxes) {
        if (transferSyntaxInfo(uid).codec != Codec::unsupported) continue;
        tell(stack, message(key::kUnsupportedTransferSyntax, {{"syntax", describeTransferSyntax(uid)}}));
    }
    if (any(stack, [](const Frame& f) { return f.instance->greyscaleAssumed; }))
        tell(stack, message(key::kGreyscaleAssumed));
    if (any(stack, isMosaic)) tell(stack, message(key::kMosaic));
    tellWhatIsBeyond(stack);
    if (any(stack, [](const Frame& f) { return f.instance->lossy; })) tell(stack, message(key::kLossySource));
    if (any(stack, [](const Frame& f) { return f.hasDisplayTable; }))
        tell(stack, message(key::kDisplayTable));
    if (any(stack, [](const Frame& f) { return f.windowInvalid; })) tell(stack, message(key::kInvalidWindow));
}

void assessRescale(Stack& stack, const std::string& modality) {
    if (any(stack, [](const Frame& f) { return f.modalityLutInvalid; })) {
        tell(stack, message(key::kInvalidModalityLut));
    } else if (any(stack, [](const Frame& f) { return f.modalityLut != nullptr; })) {
        tell(stack, message(key::kModalityLut));
    }
    if (any(stack, [](const Frame& f) { return f.rescaleInvalid; })) {
        tell(stack, message(key::kInvalidRescale));
        return;
    }
    // CT, PET and dose images require it (PS3.3 C.8.2.1, C.8.9.4, C.8.8.3); for MR its absence is normal,
    // unless other images of the stack have it. One without the other is a fault in any modality.
    const bool anySlope = any(stack, [](const Frame& f) { return f.slope.has_value(); });
    const bool required = modality == "CT" || modality == "PT" || modality == "RTDOSE" || anySlope;
    const auto faulty = [&](const Frame& f) {
        const bool isFloat = f.instance->format && f.instance->format->kind != CellKind::integer;
        return !f.modalityLut && !isFloat &&
               (f.slope.has_value() != f.intercept.has_value() || (required && !f.slope));
    };
    if (const auto count = std::count_if(stack.frames.begin(), stack.frames.end(), faulty); count > 0) {
        tell(stack, message(key::kMissingRescale,
                            {{"count", std::int64_t(count)}, {"total", std::int64_t(stack.frames.size())}}));
    }
    if (modality == "CT") {
        if (const Text why = whyNoHounsfield(stack.frames); !why.empty())
            tell(stack, message(key::kNoHounsfield, {{"reason", why}}));
    }
    const Frame& first = stack.frames.front();
    if (any(stack,
            [&](const Frame& f) { return f.slope != first.slope || f.intercept != first.intercept; })) {
        const std::vector<const Frame*> deviating = deviatingRescales(stack.frames);
        tell(stack, deviating.empty()
                        ? message(key::kPerSliceRescale)
                        : message(key::kDeviatingRescale, {{"numbers", describeNumbers(deviating)}}));
    }
    if (any(stack, [](const Frame& f) { return f.realWorld; })) {
        const Text unit = unitText(valueUnit(modality, stack.frames));
        tell(stack, message(key::kRealWorldValues,
                            {{"unit", unit.empty() ? Text("a unit that is not named") : unit}}));
    }
    if (modality == "RTDOSE") {
        const Text unit = unitText(valueUnit(modality, stack.frames));
        tell(stack, message(key::kDose, {{"unit", unit.empty() ? Text("not named") : unit}}));
    }
    if (modality == "PT") {
        Suv suv = first.instance->suv;
        if (any(stack, [&](const Frame& f) {
                const auto& factor = f.instance->suv.factor;
                return suv.factor && (!factor || std::abs(*factor / *suv.factor - 1.0) > 1e-6);
            })) {
            suv = {{}, Text("a factor that holds for all images")};
        }
        stack.suvFactor = suv.factor;
        if (!suv.factor) tell(stack, message(key::kSuvUnavailable, {{"missing", suv.missing}}));
    }
}

std::string strongest(const glm::dvec3& direction) {
    return orientationLetters(direction).substr(0, 1);
}

std::optional<Message> missingGeometry(const Stack& stack) {
    if (!any(stack, [](const Frame& f) { return !f.plane; })) return {};
    const auto malformed = std::ranges::find_if(
        stack.frames, [](const Frame& f) { return !f.plane && !f.malformedNumber.empty(); });
    if (malformed != stack.frames.end())
        return message(key::kMalformedNumbers, {{"attribute", std::string(malformed->malformedNumber)}});
    const bool multiFrame = any(stack, [](const Frame& f) { return f.instance->multiFrame; });
    const auto either = [&](std::string_view ofFrames, std::string_view ofImages) {
        return message(multiFrame ? ofFrames : ofImages);
    };
    if (any(stack, [](const Frame& f) { return !f.positionMm; })) {
        return either(key::kMultiFrameNoPosition, key::kNoPosition);
    }
    if (any(stack, [](const Frame& f) { return !f.hasOrientation; })) {
        return either(key::kMultiFrameNoOrientation, key::kNoPosition);
    }
    return either(key::kMultiFrameNoPixelMeasures, key::kNoPixelSpacing);
}

void sortWithoutPositions(Stack& stack) {
    const bool byLocation = !any(stack, [](const Frame& f) { return !f.sliceLocation; });
    std::stable_sort(stack.frames.begin(), stack.frames.end(), [&](const Frame& a, const Frame& b) {
        if (byLocation && *a.sliceLocation != *b.sliceLocation) return *a.sliceLocation < *b.sliceLocation;
        return a.instance->instanceNumber.value_or(0) < b.instance->instanceNumber.value_or(0);
    });
}

Text said(PixelSpacingSource source) {
    switch (source) {
        case PixelSpacingSource::imagerPixelSpacing:
            return Text("the spacing at the detector");
        case PixelSpacingSource::nominalScannedPixelSpacing:
            return Text("the nominal spacing of the scanned film");
        case PixelSpacingSource::pixelSpacing:
        case PixelSpacingSource::none:
            break;
    }
    return {};
}

double median(std::vector<double> values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

// The message about slices with gaps between them that are wider than the slices.
std::optional<Message> sparseness(const Stack& stack) {
    constexpr double kMostDistanceOfThickness = 2.0;
    std::vector<double> thicknesses;
    std::vector<double> distances;
    const glm::dvec3 normal = stack.frames.front().plane->normal();
    for (std::size_t f = 0; f < stack.frames.size(); ++f) {
        const Frame& frame = stack.frames[f];
        if (frame.sliceThicknessMm) thicknesses.push_back(*frame.sliceThicknessMm);
        if (f == 0) continue;
        distances.push_back(
            glm::dot(frame.plane->positionMm - stack.frames[f - 1].plane->positionMm, normal));
    }
    if (2 * thicknesses.size() < stack.frames.size() || distances.empty()) return {};
    const double thicknessMm = median(thicknesses);
    const double spacingMm = median(distances);
    if (spacingMm <= kMostDistanceOfThickness * thicknessMm) return {};
    return message(key::kSparseSlices, {{"thicknessMm", thicknessMm},
                                        {"spacingMm", spacingMm},
                                        {"percent", 100.0 * (1.0 - thicknessMm / spacingMm)}});
}

// Reports images whose two statements of the patient's sides disagree: they may be mirrored.
void tellContradictions(Stack& stack) {
    const auto count = std::ranges::count_if(stack.frames, &Frame::orientationContradicted);
    if (count == 0) return;
    tell(stack, message(key::kContradictedOrientation,
                        {{"count", std::int64_t(count)}, {"total", std::int64_t(stack.frames.size())}}));
}

// Reports numbers of positions that are not separated by backslashes, or have decimal commas.
void tellRepairedNumbers(Stack& stack) {
    const auto count = std::ranges::count_if(stack.frames, &Frame::numbersRepaired);
    if (count == 0) return;
    tell(stack, message(key::kRepairedNumbers,
                        {{"count", std::int64_t(count)}, {"total", std::int64_t(stack.frames.size())}}));
}

void assessGeometry(Stack& stack) {
    tellContradictions(stack);
    tellRepairedNumbers(stack);
    if (any(stack, [](const Frame& f) { return f.isInVolumeFrame; }))
        tell(stack, message(key::kSidesUnknown));
    if (any(stack, [](const Frame& f) { return f.isPlacedByOrder; }))
        tell(stack, message(key::kFramesInARow));
    if (any(stack, [](const Frame& f) { return isProjection(f.instance->sopClassUid); })) {
        tell(stack, message(key::kUnsupportedSeries,
                            {{"kind", describeSopClass(stack.frames.front().instance->sopClassUid)}}));
    }
    if (auto missing = missingGeometry(stack)) {
        sortWithoutPositions(stack);
        tell(stack, std::move(*missing));
        return;
    }
    std::vector<StackedPlane> planes;
    for (const Frame& frame : stack.frames) {
        planes.push_back({*frame.plane, frame.instance->instanceNumber.value_or(0)});
    }
    StackGeometry geometry = stackPlanes(planes);
    std::vector<Frame> sorted;
    sorted.reserve(stack.frames.size());
    for (const std::size_t index : geometry.order) sorted.push_back(std::move(stack.frames[index]));
    stack.frames = std::move(sorted);

    const ImagePlane& first = *stack.frames.front().plane;
    stack.firstPositionMm = first.positionMm;
    stack.lastPositionMm = stack.frames.back().plane->positionMm;
    stack.orientation =
        strongest(first.rowDirection) + strongest(first.columnDirection) + strongest(first.normal());
    for (Message& message : geometry.messages) tell(stack, std::move(message));
    const auto estimated = std::ranges::find_if(
        stack.frames, [](const Frame& f) { return f.spacingSource != PixelSpacingSource::pixelSpacing; });
    if (estimated != stack.frames.end()) {
        stack.isCalibrated = false;
        tell(stack, message(key::kUncalibrated, {{"source", said(estimated->spacingSource)}}));
    }
    if (!geometry.worldFromVoxel) return;
    stack.worldFromVoxel = geometry.worldFromVoxel;
    stack.slices = std::move(geometry.slices);
    stack.spacingMm = glm::dvec3(first.columnSpacingMm, first.rowSpacingMm,
                                 glm::length(glm::dvec3((*stack.worldFromVoxel)[2])));
    if (auto sparse = sparseness(stack)) tell(stack, std::move(*sparse));
}

}  // namespace

const Message* Stack::whyNoVolume() const {
    const auto found = std::find_if(messages.begin(), messages.end(),
                                    [](const Message& m) { return m.severity >= Severity::blocksVolume; });
    return found == messages.end() ? nullptr : &*found;
}

bool Stack::canBeVolume() const {
    return whyNoVolume() == nullptr && worldFromVoxel.has_value();
}

bool Stack::isEven() const {
    return canBeVolume() && slices.size() == frames.size() &&
           std::none_of(slices.begin(), slices.end(), [](const SliceSource& s) { return s.interpolated(); });
}

void assess(Stack& stack, const std::string& modality) {
    if (stack.frames.empty()) return;
    std::stable_sort(stack.frames.begin(), stack.frames.end(), [](const Frame& a, const Frame& b) {
        return a.instance->instanceNumber.value_or(0) < b.instance->instanceNumber.value_or(0);
    });
    stack.columns = stack.frames.front().instance->columns;
    stack.rows = stack.frames.front().instance->rows;
    tellMissingModality(stack);
    tellRepeatedElements(stack);
    assessPixels(stack);
    assessRescale(stack, modality);
    if (isLocalizer(stack)) tell(stack, message(key::kLocalizer));
    assessGeometry(stack);
}

std::vector<glm::dvec3> slicePositionsMm(const Stack& stack) {
    MACULA_CHECK(stack.worldFromVoxel.has_value());
    std::vector<glm::dvec3> positions;
    for (std::size_t k = 0; k < stack.slices.size(); ++k) {
        const SliceSource& source = stack.slices[k];
        positions.push_back(source.interpolated()
                                ? transformPoint(*stack.worldFromVoxel, {0.0, 0.0, double(k)})
                                : *stack.frames[source.below].positionMm);
    }
    return positions;
}

bool isLocalizer(const Stack& stack) {
    return any(stack, [](const Frame& f) {
        return std::find(f.imageType.begin(), f.imageType.end(), "LOCALIZER") != f.imageType.end();
    });
}

bool isOriginalPrimary(const Stack& stack) {
    return !any(stack, [](const Frame& f) {
        return f.imageType.size() < 2 || f.imageType[0] != "ORIGINAL" || f.imageType[1] != "PRIMARY";
    });
}

}  // namespace macula::dicom
