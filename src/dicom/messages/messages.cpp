#include "dicom/messages/messages.h"

#include <algorithm>
#include <array>

#include "base/check.h"

namespace macula::dicom {

namespace {

constexpr std::string_view kCopySeries = "Copy the whole series again from its source.";
constexpr std::string_view kCopyFile = "Copy the file again from its source.";
constexpr std::string_view kOther = "Choose another series.";
constexpr std::string_view kLookAlone =
    "Look at these images by themselves, or copy the series again from its source.";
constexpr std::string_view kExport = "Export the series again, or choose another.";

constexpr auto kInfo = Severity::info;
constexpr auto kWarning = Severity::warning;
constexpr auto kBlocksVolume = Severity::blocksVolume;
constexpr auto kBlocksLoading = Severity::blocksLoading;

constexpr std::array kCatalogue = std::to_array<CatalogueEntry>({
    // Files and folders.
    {key::kNoValidInstances, kBlocksLoading, 1, "No file of this series can be read; it has {count}.",
     kCopySeries},
    {key::kUnreadableFile, kWarning, 0, "A file cannot be opened.", "Check its permissions."},
    {key::kFileOffline, kWarning, 0,
     "A file is listed in the folder, and its content is not on this machine.",
     "Connect the drive, or make the files available offline."},
    {key::kUnreadableMedium, kWarning, 0,
     "The medium gave an error where something was to be read from it: it is damaged, dirty or failing.",
     "Clean the disc, or check drive and cable, and copy the medium again; else ask for another copy."},
    {key::kPathTooLong, kWarning, 0,
     "A path is longer than this system can open; what lies there is missing here.",
     "Move the folder nearer to the root of the disk, or give the folders shorter names."},
    {key::kDamagedFile, kWarning, 0, "A DICOM file is damaged and cannot be read.", kCopyFile},
    {key::kTruncatedFile, kWarning, 0, "A DICOM file ends before its pixel data do.", kCopyFile},
    {key::kNoPixelData, kWarning, 0, "A DICOM image has no pixel data.", kCopyFile},
    {key::kInvalidFrameCount, kWarning, 0, "A DICOM image does not say in a number how many frames it has.",
     kCopyFile},
    {key::kMissingFrames, kWarning, 7,
     "Frames that the files of this series should have, and that are not there: {missing} of {total}.",
     kCopySeries},
    {key::kSurplusFrames, kWarning, 0,
     "Files that hold more than the number of frames they give (NumberOfFrames): {files}. What is beyond is "
     "not "
     "shown: pixels or descriptions of {frames} frames.",
     "Slices may be missing here; copy the series again from its source."},
    {key::kStrayBytes, kInfo, 0,
     "Bytes follow the pixel data in some files and are no part of the images, which are whole: up to "
     "{bytes}.",
     ""},
    {key::kRepeatedElement, kWarning, 0,
     "Images in which attributes stand twice, with different values: {count} of {total} ({attributes}). Of "
     "each the "
     "first value is used.",
     "Compare values and sizes with those that another program shows; have the images set right."},
    {key::kMissingSopClass, kWarning, 15,
     "Files of this series that do not say what kind of object they are: {count}.",
     "Check that the series is what it seems to be."},
    {key::kMissingModality, kWarning, 0,
     "Images that do not say by what kind of device they were taken (Modality): {count} of {total}; they "
     "were taken for {modality}.",
     "Check that the series is what it seems to be."},
    {key::kUnreadableFolder, kWarning, 0,
     "Folders that could not be read: {count}. Images in them are missing here.",
     "Check the permissions of the folders, or copy the study again."},
    {key::kLinksOutside, kInfo, 0,
     "Links that lead out of the chosen folder, and were not followed: {count}.",
     "Choose the folder they lead to, if it is wanted."},
    {key::kArchives, kInfo, 0, "Archives ({kinds}) in the folder, which were not opened: {count}.",
     "Unpack those that hold images of this study, and open the folder again."},
    {key::kDicomdirMissingFiles, kWarning, 0,
     "Files that the directory of this medium (DICOMDIR) lists and that are not there: {count}.",
     "Copy the medium again; images may be missing."},
    {key::kStudyIncomplete, kInfo, 0,
     "The images say that their study has {total} objects (NumberOfStudyRelatedInstances); {count} of it are "
     "here.",
     "Copy the study again from its source if all of it should be here."},
    {key::kDicomdirOutside, kWarning, 0,
     "Files that the directory of this medium (DICOMDIR) names outside the chosen folder, and that were not "
     "read: {count}.",
     "Take care where this medium comes from."},
    {key::kDicomdirUnreadable, kInfo, 0,
     "The directory of this medium (DICOMDIR) cannot be read; the files themselves were read.", ""},
    {key::kDuplicateFiles, kInfo, 0,
     "Files that are copies of others of this series, and were left out: {count}.", ""},
    {key::kDuplicateInstances, kWarning, 0,
     "Images that have the identifier of another of this series, in a file that differs: {count}. Of each "
     "the first file is used; the others are in a stack of their own.",
     "Compare them before relying on this series."},
    {key::kFilesLeftOut, kWarning, 0, "Files of this series that cannot be read, and were left out: {count}.",
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
    {key::kInconsistentUnits, kWarning, 0,
     "Images whose values are in another unit than those of the others, and that are a stack of their own: "
     "{count} "
     "({unit}).",
     "Look at both; values of one cannot be compared with those of the other."},
    {key::kPhases, kInfo, 0,
     "Every position was imaged {count} times; each is a volume of its own, told apart by "
     "{attribute}.",
     ""},
    {key::kPhasesAssumed, kWarning, 0,
     "Every position was imaged {count} times, and only the order of the image numbers tells them apart.",
     "Check that the volumes of this series are what they seem to be."},
    {key::kPhasesByNumber, kWarning, 0,
     "Images whose {attribute} does not say to which phase they belong, and whose number was asked instead: "
     "{numbers}.",
     "Compare these slices with those beside them before relying on them."},
    {key::kUnclearAcquisition, kWarning, 0,
     "Images of which nothing says for sure to which acquisition or phase they belong: {numbers}. They are "
     "in a stack of their own, and the others lack them.",
     "Look at these images by themselves; part of the scan may have been repeated."},
    {key::kIncompletePhases, kWarning, 0,
     "Phases that have fewer images than the others: {count} of {total}.",
     "Copy the whole series again from its source."},
    {key::kDuplicatePositions, kBlocksVolume, 0,
     "Images that lie at the same position as another: {count} of {total}. Nothing in them says which belong "
     "together.",
     "Which images make a volume? Choose another series, or separate the files of this one by hand."},
    {key::kRepeatedSlices, kWarning, 0,
     "Positions that were imaged more than once: {count}. Of each, the image with the lowest number is in "
     "the volume, and the others are in a stack of their own.",
     "Compare the repeated images before relying on these slices."},
    {key::kIncompleteConcatenation, kWarning, 7,
     "Files of those that make up one image that are not here: {missing} of {total}.", kCopySeries},
    {key::kMissingAtEnds, kWarning, 0,
     "Slices that seem to be missing beyond the end towards the {side}: {count}; {evidence}.",
     "Copy the whole series again from its source; what lies beyond this end is not shown."},
    {key::kMissingImages, kWarning, 0, "Images of this series that seem to be missing: {count}; {evidence}.",
     "Copy the whole series again from its source; the slices may end too early."},
    {key::kOthersReachFarther, kInfo, 0,
     "{other} of this study reaches {mm:.0f} mm farther towards the {side} than these slices.",
     "If both should cover the same, images are missing here: compare with the source."},
    {key::kContinuesInOtherSeries, kInfo, 0,
     "Series {number} of this study continues this stack, with the same slice distance.",
     "Look at both; together they cover more."},
    {key::kLocalizer, kBlocksVolume, 0, "This is a localizer: an overview image, not a slice of a volume.",
     "Choose a series of slices."},
    {key::kSplitByNumber, kWarning, 0,
     "The image numbers run {count} times along the patient, and nothing else tells these sets of slices "
     "apart; each is a stack of its own.",
     "Look at all of them; they may be several acquisitions."},
    {key::kInterleavedPositions, kWarning, 0,
     "The slices are {count} even sets, the first two shifted by {offsetMm:.3f} mm against each other, and "
     "nothing else tells them apart; each is a stack of its own.",
     "Look at all of them; they may be several acquisitions."},
    {key::kChangesAlongStack, kWarning, 0,
     "{attribute} changes along the slices, first at slice {slice}; values may step there.",
     "Do not take a step there for a finding."},
    {key::kAcquiredApart, kWarning, 0,
     "Slices {slices} were acquired {minutes:.1f} min before or after those beside them: the patient may "
     "have "
     "moved, and contrast medium spread.",
     "Do not take a step there for a finding."},
    {key::kAlternatingValues, kWarning, 0,
     "Every other slice differs from those beside it in the same way: two acquisitions may be mixed in this "
     "volume.",
     "Compare the original images, slice by slice, before relying on this volume."},
    {key::kSeparateBlocks, kWarning, 0,
     "The images lie in {count} blocks, up to {gapMm:.0f} mm apart; each is a stack of its own, so what is "
     "shown is one of {count}.",
     "Look at the other blocks too."},
    {key::kFrameOfReferencePerSlice, kWarning, 0,
     "Every image names a coordinate system (FrameOfReferenceUID) of its own, and together they make an even "
     "stack; it was taken for granted that they share one.",
     "Check that the slices fit each other. The series is not shown together with others."},
    {key::kFrameOfReferenceMissing, kWarning, 0,
     "Images that name no coordinate system (FrameOfReferenceUID): {count} of {total}. They continue the "
     "stack of the others, and it was taken for granted that they share theirs.",
     "Check that the slices fit each other. The series is not shown together with others."},
    {key::kStacksJoined, kInfo, 0,
     "The frames belong to {count} stacks (StackID), which make one even volume together and are shown as "
     "one.",
     ""},
    {key::kSharedInstanceUid, kWarning, 0,
     "Images that share one identifier (SOPInstanceUID) and lie at different positions: {count}. All are "
     "kept.",
     "Other programs may show only one of them; have the identifiers set right."},
    {key::kRepeatedImages, kWarning, 0,
     "Images that repeat another at the same position, pixel by pixel, and were left out: {count}.",
     "Nothing is lost; the series was probably sent twice."},
    {key::kUidPerSlice, kWarning, 0,
     "{count} images have a {level} identifier each and would make one even stack together.",
     "Are they one series? Then open the folder with --join."},
    {key::kJoined, kWarning, 0,
     "{count} images with a {level} identifier each were joined to this series because that was asked for.",
     "Check that all of them are of one patient and one examination."},
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
    {key::kSidesUnknown, kWarning, 0,
     "The images say where they lie in a frame of the transducer, and not in the patient: letters of sides, "
     "and "
     "left and right, are not those of the patient.",
     "Do not tell sides from this volume."},
    {key::kFramesInARow, kWarning, 0,
     "Only the first frame says where it lies; it was taken for granted that the others follow it along the "
     "slice normal, at the distance that the file gives.",
     "If they run the other way, the volume is mirrored: compare with a marker of the side."},
    {key::kMalformedNumbers, kBlocksVolume, 0,
     "{attribute} is not written as numbers with backslashes between them, and can be read in no way, or in "
     "several.",
     "Have it set right, or export the series again."},
    {key::kRepairedNumbers, kWarning, 0,
     "Images whose position, orientation or pixel spacing has other signs between its numbers, or in them, "
     "than "
     "it should: {count} of {total}. It was read in the only way that there is.",
     "Measure a known length before relying on sizes."},
    {key::kUncalibrated, kWarning, 0, "The size of a pixel is not calibrated; it was taken from {source}.",
     "Do not measure lengths in these images."},
    {key::kInvalidOrientation, kBlocksVolume, 0,
     "The orientation or pixel spacing of a slice is not a valid one.", kExport},
    {key::kContradictedOrientation, kWarning, 0,
     "The letters of the sides (PatientOrientation) say the opposite of the orientation in space "
     "(ImageOrientationPatient), which is used, in {count} of {total} images.",
     "Left and right, or front and back, may be exchanged: compare with the original images."},
    {key::kRepairedOrientation, kInfo, 0,
     "The row and column directions are {error:.4f} off perpendicular unit vectors, and were set right.", ""},
    {key::kOrientationDrift, kInfo, 0,
     "The slices are turned against each other by up to {degrees:.3f} degrees; they are drawn with the mean "
     "orientation, and a voxel is up to {errorMm:.3f} mm away from where it is drawn.",
     "Allow for this error when measuring."},
    {key::kMissingSlices, kWarning, 7,
     "Slices that are missing: {missing} of {total}, which are {spacingMm:.3f} mm apart.", kCopySeries},
    {key::kGapInterpolated, kWarning, 0,
     "Slices of the volume that are interpolated, because no image was there: {count} ({slices}).",
     "Do not read anything into interpolated slices."},
    {key::kIrregularSpacing, kWarning, 8,
     "The slices are unevenly spaced, {leastMm:.3f} to {mostMm:.3f} mm apart; they were resampled to an even "
     "{spacingMm:.3f} mm.",
     "Look at the original images before measuring across slices."},
    {key::kSpacingTooIrregular, kBlocksVolume, 8,
     "The slices are too unevenly spaced for a volume, {leastMm:.3f} to {mostMm:.3f} mm apart.", kOther},
    {key::kOddPosition, kWarning, 0,
     "Images whose position is missing or cannot be right, and that were left out of the volume: {numbers}.",
     kLookAlone},
    {key::kUnevenSpacing, kWarning, 0,
     "The slices are not quite evenly spaced: a slice is up to {errorMm:.3f} mm away from where it is drawn.",
     "Allow for this error when measuring across slices."},
    {key::kNotParallel, kBlocksVolume, 11, "The images are not parallel to each other.", kOther},
    {key::kNotReconstructable, kBlocksVolume, 3, "The images do not make a volume: {reason}.", kOther},
    {key::kTiltedStack, kInfo, 0,
     "The slices are stacked at an angle of {degrees:.1f} degrees (tilted gantry), and are drawn so.", ""},
    {key::kSparseSlices, kWarning, 0,
     "The slices are {thicknessMm:.2f} mm thick and {spacingMm:.2f} mm apart: {percent:.0f} % of what is "
     "between the first and the last was never imaged, and is interpolated here.",
     "Do not read anything into what lies between the slices."},
    // Pixels and values.
    {key::kUnsupportedSopClass, kInfo, 14, "This is no image, and is not shown in 3D: {kind}.", ""},
    {key::kUnsupportedSeries, kBlocksVolume, 13, "Images of this kind ({kind}) are no slices of a volume.",
     "Choose a series of slices."},
    {key::kColourImage, kBlocksVolume, 0, "The images are in colour; a volume needs one value per voxel.",
     kOther},
    {key::kUnsupportedBits, kBlocksVolume, 0,
     "The images do not say in a usable way which bits of a pixel hold its value: neither whole numbers in "
     "1, "
     "8, 16 or 32 bits nor floating point.",
     kOther},
    {key::kUnsupportedTransferSyntax, kBlocksLoading, 0, "This version cannot decode the images: {syntax}.",
     "Export the series uncompressed or in JPEG 2000."},
    {key::kOddEncoding, kWarning, 0,
     "Images whose pixels this version cannot decode, and that were left out of the volume: {numbers}.",
     "Export the series uncompressed or in JPEG 2000."},
    {key::kContradictedSyntax, kWarning, 0,
     "The images say that their pixels are encoded as {said}, and they are as {found}, which they were read "
     "as.",
     "Have the images exported again; other programs may not read them."},
    {key::kGreyscaleAssumed, kInfo, 0,
     "The images do not say how a value is shown; greater ones were taken as brighter.", ""},
    {key::kMosaic, kBlocksVolume, 0,
     "Each image is a mosaic of many slices (Siemens), which this version does not unpack.",
     "Export the series again as one image for each slice, or convert it with dcm2niix."},
    {key::kDose, kWarning, 0, "These values are a dose distribution (unit: {unit}), and no anatomy.",
     "To see anatomy, choose the images that the treatment was planned on."},
    {key::kModalityLut, kInfo, 0, "The values come from a lookup table in the images, which was applied.",
     ""},
    {key::kInvalidModalityLut, kBlocksVolume, 0,
     "The lookup table that makes values of the pixels is not a usable one.", kExport},
    {key::kInvalidRescale, kBlocksVolume, 0,
     "The rescale slope or intercept of an image is not a usable number.", kExport},
    {key::kMissingRescale, kWarning, 0,
     "Images that do not say how stored numbers become values: {count} of {total}. A missing rescale slope "
     "was taken as 1, a missing intercept as 0.",
     "Do not rely on the values; presets made for Hounsfield units may not fit."},
    {key::kNoHounsfield, kWarning, 0,
     "These CT images do not say that their values are Hounsfield units ({reason}); they are taken as plain "
     "numbers.",
     "Presets for Hounsfield units do not fit, and the table cannot be removed. Use the original images."},
    {key::kOddRescale, kWarning, 0,
     "Images whose rescale slope or intercept is missing or cannot be right, and that were left out of the "
     "volume: {numbers}.",
     kLookAlone},
    {key::kDeviatingRescale, kWarning, 0,
     "Images whose rescale slope or intercept is another than that of all others; it was applied as it is: "
     "{numbers}.",
     "Compare these slices with their neighbours; if they are brighter or darker, copy the series again from "
     "its source."},
    {key::kPerSliceRescale, kInfo, 0,
     "Each image has its own rescale factors; they are applied image by image.", ""},
    {key::kRescaleStep, kWarning, 0,
     "Places where the values jump because the rescale slope or intercept changes and the stored numbers do "
     "not: "
     "{count}, first at slice {slice}, by {step:.4g}. The values on one side are wrong.",
     "Do not rely on values of this volume; export the series again."},
    {key::kOddValues, kWarning, 0,
     "Images whose pixels {fault}, and that were left out of the volume: {numbers}.", kCopySeries},
    {key::kOddValuesKept, kWarning, 0,
     "Images whose pixels {fault}: {count} of {total}. They are shown as the images say.",
     "Do not rely on the values; export the series again."},
    {key::kUnlikeNeighbours, kWarning, 0,
     "Images that differ from both of their neighbours far more than these from each other; they are shown "
     "as "
     "they are: {numbers}.",
     "Compare these slices with their neighbours, and copy the series again from its source."},
    {key::kRealWorldValues, kInfo, 0,
     "The values are the real world values that the images define, in {unit}.", ""},
    {key::kSuvUnavailable, kInfo, 0,
     "Standardised uptake values cannot be worked out: {missing} is missing or not usable.", ""},
    {key::kBitsExceeded, kWarning, 0,
     "Images whose values need more bits than they say, and that were left out of the volume: {numbers}.",
     kCopySeries},
    {key::kBitsDropped, kWarning, 0,
     "Images with bits outside of those that they say hold the values: {count} of {total}. These bits were "
     "dropped.",
     "Compare the values with those that another program shows."},
    {key::kBitsMisplaced, kWarning, 0,
     "Images that say that their values lie higher in a pixel (HighBit) than the bits in use: {count} of "
     "{total}. "
     "They were read from the lowest bit on; as the images say, values would be a fraction of these.",
     "Compare the values with those that another program shows."},
    {key::kNonFiniteValues, kWarning, 0,
     "Pixels that are no finite number: {count}. They are treated as outside of the scan.",
     "Do not read anything into the places where they are."},
    {key::kLossySource, kWarning, 0,
     "The images were compressed with loss; fine detail may be missing or false.",
     "Use the original images for diagnosis."},
    {key::kDisplayTable, kInfo, 0,
     "The images have lookup tables that say how they are shown (VOI LUT); these are not used, only windows "
     "are.",
     ""},
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
    {key::kSegmentIsPadding, kWarning, 0,
     "Segment {number} has the number of the background (Pixel Padding Value): nothing of it is shown.",
     "Look at it in the program that made it."},
    {key::kSegmentZero, kInfo, 0,
     "Segment 0 has the number {number} in the label map, in which 0 is none of the segments.", ""},
    // Presentation states.
    {key::kPresentationState, kInfo, 0,
     "Presentation states: {count}; they are no images, and say how a series is shown.",
     "Open one of them in the list of studies; macula render draws those of 3D views."},
    {key::kPresentationLeftOut, kWarning, 0, "The presentation state has {what}, which cannot be shown.",
     "Compare with what the program shows that made it."},
    {key::kPresentationApproximated, kWarning, 0, "The presentation state has {what}; {how}.",
     "Compare with what the program shows that made it."},
    {key::kPresentationChanged, kInfo, 0,
     "Another program changed this presentation state of Macula; it is shown as its standard attributes "
     "say.",
     ""},
});

}  // namespace

std::string_view nameOf(Severity severity) {
    switch (severity) {
        case Severity::info:
            return "info";
        case Severity::warning:
            return "warning";
        case Severity::blocksVolume:
            return "blocks-3d";
        case Severity::blocksLoading:
            return "blocks-loading";
    }
    return "info";
}

std::span<const CatalogueEntry> catalogue() {
    return kCatalogue;
}

Message message(std::string_view key, Severity severity, std::vector<TextArgument> arguments) {
    const auto entry = std::find_if(kCatalogue.begin(), kCatalogue.end(),
                                    [&](const CatalogueEntry& e) { return e.key == key; });
    MACULA_CHECK(entry != kCatalogue.end());
    const auto nothing = [](const TextArgument&, std::string_view) { return std::string(); };
    MACULA_CHECK(filled(entry->sentence, arguments, nothing).find('{') == std::string::npos);
    return {.severity = severity,
            .key = std::string(key),
            .arguments = arguments,
            .sentence = Text::of(entry->sentence, std::move(arguments)),
            .action = Text::of(entry->action, {})};
}

Message message(std::string_view key, std::vector<TextArgument> arguments) {
    const auto entry = std::find_if(kCatalogue.begin(), kCatalogue.end(),
                                    [&](const CatalogueEntry& e) { return e.key == key; });
    MACULA_CHECK(entry != kCatalogue.end());
    return message(key, entry->severity, std::move(arguments));
}

}  // namespace macula::dicom
