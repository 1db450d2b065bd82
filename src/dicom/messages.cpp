#include "dicom/messages.h"

#include <fmt/args.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "base/check.h"

namespace macula::dicom {

namespace {

constexpr std::string_view kCopySeries = "Copy the whole series again from its source.";
constexpr std::string_view kCopyFile = "Copy the file again from its source.";
constexpr std::string_view kOther = "Choose another series.";
constexpr std::string_view kExport = "Export the series again, or choose another.";

constexpr auto kInfo = Severity::info;
constexpr auto kWarning = Severity::warning;
constexpr auto kBlocksVolume = Severity::blocksVolume;
constexpr auto kBlocksLoading = Severity::blocksLoading;

constexpr std::array kCatalogue = std::to_array<CatalogueEntry>({
    // Files and folders.
    {key::kNoValidInstances, kBlocksLoading, 1, "No file of this series can be read, of {count}.",
     kCopySeries},
    {key::kUnreadableFile, kWarning, 0, "A file cannot be opened.", "Check its permissions."},
    {key::kFileOffline, kWarning, 0,
     "A file is listed in the folder, and its content is not on this machine.",
     "Connect the drive, or make the files available offline."},
    {key::kDamagedFile, kWarning, 0, "A DICOM file is damaged and cannot be read.", kCopyFile},
    {key::kTruncatedFile, kWarning, 0, "A DICOM file ends before its pixel data do.", kCopyFile},
    {key::kNoPixelData, kWarning, 0, "A DICOM image has no pixel data.", kCopyFile},
    {key::kStrayBytes, kInfo, 0,
     "A few stray bytes follow the pixel data in some files; the images are whole.", ""},
    {key::kMissingSopClass, kWarning, 15,
     "{count} files of this series do not say what kind of object they are.",
     "Check that the series is what it seems to be."},
    {key::kUnreadableFolder, kWarning, 0,
     "{count} folders could not be read; images in them are missing here.",
     "Check the permissions of the folders, or copy the study again."},
    {key::kLinksOutside, kInfo, 0, "{count} links lead out of the chosen folder, and were not followed.",
     "Choose the folder they lead to, if it is wanted."},
    {key::kDicomdirMissingFiles, kWarning, 0,
     "The directory of this medium (DICOMDIR) lists {count} files that are not there.",
     "Copy the medium again; images may be missing."},
    {key::kDicomdirOutside, kWarning, 0,
     "The directory of this medium (DICOMDIR) names {count} files outside the chosen folder; they were not "
     "read.",
     "Take care where this medium comes from."},
    {key::kDicomdirUnreadable, kInfo, 0,
     "The directory of this medium (DICOMDIR) cannot be read; the files themselves were read.", ""},
    {key::kDuplicateFiles, kInfo, 0, "{count} files are copies of others of this series, and were left out.",
     ""},
    {key::kDuplicateInstances, kWarning, 0,
     "{count} images have the identifier of another of this series, in a file that differs; of each the "
     "first file is "
     "used, and the others are in a stack of their own.",
     "Compare them before relying on this series."},
    {key::kFilesLeftOut, kWarning, 0, "{count} files of this series cannot be read, and were left out.",
     "Copy the series again from its source."},
    {key::kCharsetFallback, kInfo, 0,
     "Text of this series does not fit the character set it declares; names may be shown wrongly.", ""},
    {key::kSeveralPatients, kWarning, 0,
     "The files of this series name different patients or studies, and were split into {count} series.",
     "Check name, ID, birth date and sex of the patient in every part; slices of this patient may lie in "
     "another "
     "part."},
    // How a series falls into stacks.
    {key::kSplitSeries, kInfo, 0,
     "The images differ in {attributes}, and were separated into {count} stacks.", ""},
    {key::kInconsistentSize, kInfo, 9,
     "The images have different sizes, and were separated into {count} stacks.", ""},
    {key::kInconsistentComponents, kInfo, 10,
     "Some images are in colour and others are not; they were separated into {count} stacks.", ""},
    {key::kInconsistentOrientation, kInfo, 11,
     "The images lie in different orientations, and were separated into {count} stacks.", ""},
    {key::kInconsistentPosition, kInfo, 12,
     "The images do not share one coordinate system, or some have no position; they were separated into "
     "{count} "
     "stacks.",
     ""},
    {key::kInconsistentPixelSpacing, kInfo, 0,
     "The images have different pixel spacings, and were separated into {count} stacks.", ""},
    {key::kPhases, kInfo, 0,
     "Every position was imaged {count} times; each is a volume of its own, told apart by "
     "{attribute}.",
     ""},
    {key::kPhasesAssumed, kWarning, 0,
     "Every position was imaged {count} times, and only the order of the image numbers tells them apart.",
     "Check that the volumes of this series are what they seem to be."},
    {key::kIncompletePhases, kWarning, 0, "{count} of the {total} phases have fewer images than the others.",
     "Copy the whole series again from its source."},
    {key::kDuplicatePositions, kBlocksVolume, 0,
     "{count} of the {total} images lie at the same position as another, and nothing in them says which "
     "belong "
     "together.",
     "Which images make a volume? Choose another series, or separate the files of this one by hand."},
    {key::kRepeatedSlices, kWarning, 0,
     "{count} positions were imaged more than once; of each, the image with the lowest number is in the "
     "volume, and "
     "the others are in a stack of their own.",
     "Compare the repeated images before relying on these slices."},
    {key::kIncompleteConcatenation, kWarning, 7,
     "{missing} of the {total} files that make up one image are not here.", kCopySeries},
    {key::kContinuesInOtherSeries, kInfo, 0,
     "Series {number} of this study continues this stack, with the same slice distance.",
     "Look at both; together they cover more."},
    {key::kLocalizer, kBlocksVolume, 0, "This is a localizer: an overview image, not a slice of a volume.",
     "Choose a series of slices."},
    // Geometry.
    {key::kSingleSlice, kBlocksVolume, 0, "There is only one slice.", "Choose a series with more slices."},
    {key::kNoPosition, kBlocksVolume, 2, "The images do not say where they lie in the patient.",
     "Choose a series of slices."},
    {key::kMultiFrameNoPosition, kBlocksVolume, 6,
     "The frames of this multi-frame image do not say where they lie in the patient.",
     "Choose a series of slices."},
    {key::kMultiFrameNoOrientation, kBlocksVolume, 5,
     "The frames of this multi-frame image do not say how they are oriented in the patient.",
     "Choose a series of slices."},
    {key::kMultiFrameNoPixelMeasures, kBlocksVolume, 4,
     "The frames of this multi-frame image do not say how large a pixel is.", kOther},
    {key::kNoPixelSpacing, kBlocksVolume, 0, "The images do not say how large a pixel is.", kOther},
    {key::kUncalibrated, kWarning, 0, "The size of a pixel is not calibrated; it was taken from {source}.",
     "Do not measure lengths in these images."},
    {key::kInvalidOrientation, kBlocksVolume, 0,
     "The orientation or pixel spacing of a slice is not a valid one.", kExport},
    {key::kRepairedOrientation, kInfo, 0,
     "The row and column directions are {error:.4f} off perpendicular unit vectors, and were set right.", ""},
    {key::kMissingSlices, kWarning, 7,
     "{missing} slices are missing, of {total} that are {spacingMm:.3f} mm apart.", kCopySeries},
    {key::kGapInterpolated, kWarning, 0,
     "{count} slices of the volume ({slices}) are interpolated: no image was "
     "there.",
     "Do not read anything into interpolated slices."},
    {key::kIrregularSpacing, kWarning, 8,
     "The slices are unevenly spaced, {leastMm:.3f} to {mostMm:.3f} mm apart; they were resampled to an even "
     "{spacingMm:.3f} mm.",
     "Look at the original images before measuring across slices."},
    {key::kSpacingTooIrregular, kBlocksVolume, 8,
     "The slices are too unevenly spaced for a volume, {leastMm:.3f} to {mostMm:.3f} mm apart.", kOther},
    {key::kUnevenSpacing, kWarning, 0,
     "The slices are not quite evenly spaced: a slice is up to {errorMm:.3f} mm away from where it is drawn.",
     "Allow for this error when measuring across slices."},
    {key::kNotParallel, kBlocksVolume, 11, "The images are not parallel to each other.", kOther},
    {key::kNotReconstructable, kBlocksVolume, 3, "The images do not make a volume: {reason}.", kOther},
    {key::kTiltedStack, kInfo, 0,
     "The slices are stacked at an angle of {degrees:.1f} degrees (tilted gantry), and are drawn so.", ""},
    // Pixels and values.
    {key::kUnsupportedSopClass, kInfo, 14, "This is no image, and cannot be shown here: {kind}.", ""},
    {key::kUnsupportedSeries, kBlocksVolume, 13, "Images of this kind ({kind}) are no slices of a volume.",
     "Choose a series of slices."},
    {key::kColourImage, kBlocksVolume, 0, "The images are in colour; a volume needs one value per voxel.",
     kOther},
    {key::kUnsupportedBits, kBlocksVolume, 0,
     "The pixels are neither whole numbers of 1, 8, 16 or 32 bits nor floating point.", kOther},
    {key::kUnsupportedTransferSyntax, kBlocksLoading, 0, "This version cannot decode the images: {syntax}.",
     "Export the series uncompressed or in JPEG 2000."},
    {key::kModalityLut, kInfo, 0, "The values come from a lookup table in the images, which was applied.",
     ""},
    {key::kInvalidModalityLut, kBlocksVolume, 0,
     "The lookup table that makes values of the pixels is not a usable one.", kExport},
    {key::kInvalidRescale, kBlocksVolume, 0,
     "The rescale slope or intercept of an image is not a usable number.", kExport},
    {key::kMissingRescale, kWarning, 0,
     "{count} of {total} images do not say how stored numbers become values; a missing rescale slope was "
     "taken as 1, "
     "a missing intercept as 0.",
     "Do not rely on the values; presets made for Hounsfield units may not fit."},
    {key::kPerSliceRescale, kInfo, 0,
     "Each image has its own rescale factors; they are applied image by image.", ""},
    {key::kRealWorldValues, kInfo, 0,
     "The values are the real world values that the images define, in {unit}.", ""},
    {key::kSuvUnavailable, kInfo, 0,
     "Standardised uptake values cannot be worked out: {missing} is missing or not usable.", ""},
    {key::kLossySource, kWarning, 0,
     "The images were compressed with loss; fine detail may be missing or false.",
     "Use the original images for diagnosis."},
    {key::kInvertedDisplay, kInfo, 0,
     "The images are meant to be shown with low values bright (MONOCHROME1); values are as stored.", ""},
    {key::kInvalidWindow, kInfo, 0, "The display window of these images is not usable, and was ignored.", ""},
    // Segmentations.
    {key::kSegmentsOverlap, kWarning, 0,
     "{count} voxels belong to several segments; of each only the last is shown.",
     "Look at the segments one by one in the program that made them."},
    {key::kSegmentsOutside, kWarning, 0,
     "{count} voxels of the segmentation lie outside of the volume, and are not shown.",
     "Check that no slices of the series are missing."},
});

}  // namespace

std::span<const CatalogueEntry> catalogue() {
    return kCatalogue;
}

Message message(std::string_view key, Severity severity, std::vector<MessageArgument> arguments) {
    const auto entry = std::find_if(kCatalogue.begin(), kCatalogue.end(),
                                    [&](const CatalogueEntry& e) { return e.key == key; });
    MACULA_CHECK(entry != kCatalogue.end());
    fmt::dynamic_format_arg_store<fmt::format_context> store;
    for (const MessageArgument& argument : arguments) {
        std::visit([&](const auto& value) { store.push_back(fmt::arg(argument.name.c_str(), value)); },
                   argument.value);
    }
    return {.severity = severity,
            .key = std::string(key),
            .arguments = std::move(arguments),
            .sentence = fmt::vformat(entry->sentence, store),
            .action = std::string(entry->action)};
}

Message message(std::string_view key, std::vector<MessageArgument> arguments) {
    const auto entry = std::find_if(kCatalogue.begin(), kCatalogue.end(),
                                    [&](const CatalogueEntry& e) { return e.key == key; });
    MACULA_CHECK(entry != kCatalogue.end());
    return message(key, entry->severity, std::move(arguments));
}

}  // namespace macula::dicom
