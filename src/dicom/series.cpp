#include "dicom/series.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "dicom/transfer_syntax.h"

namespace macula::dicom {

namespace {

void block(Series& series, std::string_view key, std::string sentence, std::string action) {
    series.messages.push_back(
        {Severity::blocksVolume, std::string(key), std::move(sentence), std::move(action)});
}

template <class Predicate>
bool any(const Series& series, Predicate predicate) {
    return std::any_of(series.instances.begin(), series.instances.end(), predicate);
}

void assessPixels(Series& series) {
    const Instance& first = series.instances.front();
    if (any(series, [](const Instance& i) { return i.frames != 1 || i.perFrameGeometry; })) {
        block(series, key::kMultiFrame,
              "The images of this series hold several frames each, which this version cannot read.",
              "Export the series as single-frame images.");
    }
    if (any(series, [](const Instance& i) {
            return i.samplesPerPixel != 1 || !i.photometricInterpretation.starts_with("MONOCHROME");
        })) {
        block(series, key::kColourImage,
              "The images of this series are in colour; a volume needs one value per voxel.",
              "Choose another series.");
    } else if (any(series, [](const Instance& i) { return !i.format; })) {
        block(series, key::kUnsupportedBits,
              "The pixels of this series are not whole numbers of 8 or 16 bits.", "Choose another series.");
    }
    if (any(series, [&](const Instance& i) { return i.columns != first.columns || i.rows != first.rows; })) {
        block(series, key::kInconsistentSize, "The images of this series have different sizes.",
              "Choose another series.");
    }
    for (const std::string& uid : series.transferSyntaxUids) {
        if (transferSyntaxInfo(uid).codec != Codec::unsupported) continue;
        block(series, key::kUnsupportedTransferSyntax,
              fmt::format("This version cannot decode the images of this series: {}.",
                          describeTransferSyntax(uid)),
              "Export the series uncompressed or in JPEG 2000.");
    }
    if (any(series, [](const Instance& i) { return i.strayBytes; })) {
        series.messages.push_back(
            {Severity::info, std::string(key::kStrayBytes),
             "A few stray bytes follow the pixel data in some files; the images are whole.",
             "Nothing to do."});
    }
    if (any(series, [](const Instance& i) { return i.lossy; })) {
        series.messages.push_back(
            {Severity::warning, std::string(key::kLossySource),
             "The images were compressed with loss; fine detail may be missing or false.",
             "Use the original images for diagnosis."});
    }
}

void assessRescale(Series& series) {
    if (any(series, [](const Instance& i) { return i.hasModalityLut; })) {
        block(series, key::kModalityLut,
              "The values of this series need a lookup table, which this version cannot apply.",
              "Choose another series.");
    }
    if (any(series, [](const Instance& i) { return i.rescaleInvalid; })) {
        block(series, key::kInvalidRescale,
              "The rescale slope or intercept of an image is not a usable number.",
              "Export the series again, or choose another.");
        return;
    }
    // The CT Image Module requires both (PS3.3 C.8.2.1); for MR their absence is normal. One without the
    // other is a fault in any modality.
    const bool required = series.modality == "CT";
    const auto faulty = [&](const Instance& i) {
        return i.slope.has_value() != i.intercept.has_value() || (required && !i.slope);
    };
    if (const auto count = std::count_if(series.instances.begin(), series.instances.end(), faulty);
        count > 0) {
        const std::string sentence = fmt::format(
            "{} of {} images do not say how stored numbers become values; a missing rescale slope was taken "
            "as 1, a missing intercept as 0.",
            count, series.instances.size());
        series.assumptions.push_back(sentence);
        series.messages.push_back(
            {Severity::warning, std::string(key::kMissingRescale), sentence,
             "Do not rely on the values; presets made for Hounsfield units may not fit."});
    }
    const Instance& first = series.instances.front();
    if (any(series,
            [&](const Instance& i) { return i.slope != first.slope || i.intercept != first.intercept; })) {
        series.messages.push_back({Severity::info, std::string(key::kPerSliceRescale),
                                   "Each image has its own rescale factors; they are applied image by image.",
                                   "Nothing to do."});
    }
}

std::string strongest(const glm::dvec3& direction) {
    return orientationLetters(direction).substr(0, 1);
}

void assessGeometry(Series& series) {
    std::vector<StackedPlane> planes;
    for (const Instance& instance : series.instances) {
        if (instance.plane) planes.push_back({*instance.plane, instance.instanceNumber.value_or(0)});
    }
    if (planes.size() != series.instances.size()) {
        if (any(series, [](const Instance& i) { return i.perFrameGeometry; })) return;  // lies elsewhere
        if (any(series, [](const Instance& i) { return i.positionMm && !i.hasPixelSpacing; })) {
            block(series, key::kNoPixelSpacing, "The images of this series do not say how large a pixel is.",
                  "Choose another series.");
        } else {
            block(series, key::kNoPosition,
                  "The images of this series do not say where they lie in the patient.",
                  "Choose a series of slices.");
        }
        return;
    }
    Stack stack = stackPlanes(planes);
    std::vector<Instance> sorted;
    sorted.reserve(series.instances.size());
    for (const std::size_t index : stack.order) sorted.push_back(std::move(series.instances[index]));
    series.instances = std::move(sorted);
    series.messages.insert(series.messages.end(), stack.messages.begin(), stack.messages.end());

    const ImagePlane& first = *series.instances.front().plane;
    series.firstPositionMm = first.positionMm;
    series.lastPositionMm = series.instances.back().plane->positionMm;
    series.orientation =
        strongest(first.rowDirection) + strongest(first.columnDirection) + strongest(first.normal());
    if (any(series, [&](const Instance& i) {
            return i.frameOfReferenceUid != series.instances[0].frameOfReferenceUid;
        })) {
        block(series, key::kInconsistentFrameOfReference,
              "The images of this series do not share one coordinate system.", "Choose another series.");
        return;
    }
    if (!stack.worldFromVoxel) return;
    series.worldFromVoxel = stack.worldFromVoxel;
    series.spacingMm = glm::dvec3(first.columnSpacingMm, first.rowSpacingMm,
                                  glm::length(glm::dvec3((*stack.worldFromVoxel)[2])));
    for (const Message& message : stack.messages) {
        if (message.severity == Severity::warning) series.assumptions.push_back(message.sentence);
    }
}

}  // namespace

const Message* Series::whyNoVolume() const {
    const auto found = std::find_if(messages.begin(), messages.end(),
                                    [](const Message& m) { return m.severity == Severity::blocksVolume; });
    return found == messages.end() ? nullptr : &*found;
}

bool Series::canBeVolume() const {
    return whyNoVolume() == nullptr && worldFromVoxel.has_value();
}

void assess(Series& series) {
    if (series.instances.empty()) return;
    std::stable_sort(series.instances.begin(), series.instances.end(),
                     [](const Instance& a, const Instance& b) {
                         return a.instanceNumber.value_or(0) < b.instanceNumber.value_or(0);
                     });
    std::set<std::string> syntaxes;
    series.slices = 0;
    for (const Instance& instance : series.instances) {
        syntaxes.insert(instance.transferSyntaxUid);
        series.slices += instance.frames;
    }
    series.transferSyntaxUids.assign(syntaxes.begin(), syntaxes.end());
    series.columns = series.instances.front().columns;
    series.rows = series.instances.front().rows;
    assessPixels(series);
    assessRescale(series);
    assessGeometry(series);
}

bool isLocalizer(const Series& series) {
    return any(series, [](const Instance& i) {
        return std::find(i.imageType.begin(), i.imageType.end(), "LOCALIZER") != i.imageType.end();
    });
}

bool isOriginalPrimary(const Series& series) {
    return !any(series, [](const Instance& i) {
        return i.imageType.size() < 2 || i.imageType[0] != "ORIGINAL" || i.imageType[1] != "PRIMARY";
    });
}

}  // namespace macula::dicom
