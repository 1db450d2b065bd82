// The one catalogue of coded messages about a folder, a series, a volume or a file, listed in docs/dicom.md.
// Keys never change meaning. Sentences and actions hold no patient data.
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "base/message.h"

namespace macula::dicom {

using macula::Message;
using macula::Severity;
using macula::TextArgument;

// The name of a severity for programs: "info", "warning", "blocks-3d", "blocks-loading".
std::string_view nameOf(Severity severity);

struct CatalogueEntry {
    std::string_view key;
    Severity severity = Severity::info;
    // The number of the display set message of OHIF that has the same meaning; 0 when it has none.
    int ohif = 0;
    std::string_view sentence;  // fmt syntax; its {names} are the arguments, all required
    std::string_view action;    // what to do; empty when there is nothing
};

// All messages by subject, in the order of the documentation.
std::span<const CatalogueEntry> catalogue();

// `key` is in the catalogue, and `arguments` has every name in its sentence; further arguments are kept for
// programs.
Message message(std::string_view key, std::vector<TextArgument> arguments = {});
// The same with another severity, for a case that is more or less serious than usual.
Message message(std::string_view key, Severity severity, std::vector<TextArgument> arguments = {});

namespace key {
// Files and folders.
inline constexpr std::string_view kNoValidInstances = "no-valid-instances";
inline constexpr std::string_view kUnreadableFile = "unreadable-file";
inline constexpr std::string_view kFileOffline = "file-offline";
inline constexpr std::string_view kUnreadableMedium = "unreadable-medium";
inline constexpr std::string_view kPathTooLong = "path-too-long";
inline constexpr std::string_view kDamagedFile = "damaged-file";
inline constexpr std::string_view kTruncatedFile = "truncated-file";
inline constexpr std::string_view kNoPixelData = "no-pixel-data";
inline constexpr std::string_view kInvalidFrameCount = "invalid-frame-count";
inline constexpr std::string_view kMissingFrames = "missing-frames";
inline constexpr std::string_view kSurplusFrames = "surplus-frames";
inline constexpr std::string_view kStrayBytes = "stray-bytes";
inline constexpr std::string_view kRepeatedElement = "repeated-element";
inline constexpr std::string_view kMissingSopClass = "missing-sop-class";
inline constexpr std::string_view kMissingModality = "missing-modality";
inline constexpr std::string_view kUnreadableFolder = "unreadable-folder";
inline constexpr std::string_view kLinksOutside = "links-outside";
inline constexpr std::string_view kArchives = "archives";
inline constexpr std::string_view kDicomdirMissingFiles = "dicomdir-missing-files";
inline constexpr std::string_view kStudyIncomplete = "study-incomplete";
inline constexpr std::string_view kDicomdirOutside = "dicomdir-outside";
inline constexpr std::string_view kDicomdirUnreadable = "dicomdir-unreadable";
inline constexpr std::string_view kDuplicateFiles = "duplicate-files";
inline constexpr std::string_view kDuplicateInstances = "duplicate-instances";
inline constexpr std::string_view kFilesLeftOut = "files-left-out";
inline constexpr std::string_view kCharsetFallback = "charset-fallback";
inline constexpr std::string_view kSeveralPatients = "several-patients";
// How a series is split into stacks.
inline constexpr std::string_view kSplitSeries = "split-series";
inline constexpr std::string_view kInconsistentSize = "inconsistent-size";
inline constexpr std::string_view kInconsistentComponents = "inconsistent-components";
inline constexpr std::string_view kInconsistentOrientation = "inconsistent-orientation";
inline constexpr std::string_view kInconsistentPosition = "inconsistent-position";
inline constexpr std::string_view kInconsistentPixelSpacing = "inconsistent-pixel-spacing";
inline constexpr std::string_view kInconsistentUnits = "inconsistent-units";
inline constexpr std::string_view kPhases = "phases";
inline constexpr std::string_view kPhasesAssumed = "phases-assumed";
inline constexpr std::string_view kPhasesByNumber = "phases-by-number";
inline constexpr std::string_view kUnclearAcquisition = "unclear-acquisition";
inline constexpr std::string_view kIncompletePhases = "incomplete-phases";
inline constexpr std::string_view kDuplicatePositions = "duplicate-positions";
inline constexpr std::string_view kRepeatedSlices = "repeated-slices";
inline constexpr std::string_view kIncompleteConcatenation = "incomplete-concatenation";
inline constexpr std::string_view kMissingAtEnds = "missing-at-ends";
inline constexpr std::string_view kMissingImages = "missing-images";
inline constexpr std::string_view kOthersReachFarther = "others-reach-farther";
inline constexpr std::string_view kContinuesInOtherSeries = "continues-in-other-series";
inline constexpr std::string_view kLocalizer = "localizer";
inline constexpr std::string_view kSplitByNumber = "split-by-number";
inline constexpr std::string_view kInterleavedPositions = "interleaved-positions";
inline constexpr std::string_view kChangesAlongStack = "changes-along-stack";
inline constexpr std::string_view kAcquiredApart = "acquired-apart";
inline constexpr std::string_view kAlternatingValues = "alternating-values";
inline constexpr std::string_view kSeparateBlocks = "separate-blocks";
inline constexpr std::string_view kFrameOfReferencePerSlice = "frame-of-reference-per-slice";
inline constexpr std::string_view kFrameOfReferenceMissing = "frame-of-reference-missing";
inline constexpr std::string_view kStacksJoined = "stacks-joined";
inline constexpr std::string_view kSharedInstanceUid = "shared-instance-uid";
inline constexpr std::string_view kRepeatedImages = "repeated-images";
inline constexpr std::string_view kUidPerSlice = "uid-per-slice";
inline constexpr std::string_view kJoined = "joined";
// Geometry.
inline constexpr std::string_view kSingleSlice = "single-slice";
inline constexpr std::string_view kNoPosition = "no-position";
inline constexpr std::string_view kMultiFrameNoPosition = "multi-frame-no-position";
inline constexpr std::string_view kMultiFrameNoOrientation = "multi-frame-no-orientation";
inline constexpr std::string_view kMultiFrameNoPixelMeasures = "multi-frame-no-pixel-measures";
inline constexpr std::string_view kNoPixelSpacing = "no-pixel-spacing";
inline constexpr std::string_view kSidesUnknown = "sides-unknown";
inline constexpr std::string_view kFramesInARow = "frames-in-a-row";
inline constexpr std::string_view kMalformedNumbers = "malformed-numbers";
inline constexpr std::string_view kRepairedNumbers = "repaired-numbers";
inline constexpr std::string_view kUncalibrated = "uncalibrated";
inline constexpr std::string_view kInvalidOrientation = "invalid-orientation";
inline constexpr std::string_view kContradictedOrientation = "contradicted-orientation";
inline constexpr std::string_view kRepairedOrientation = "repaired-orientation";
inline constexpr std::string_view kOrientationDrift = "orientation-drift";
inline constexpr std::string_view kMissingSlices = "missing-slices";
inline constexpr std::string_view kGapInterpolated = "gap-interpolated";
inline constexpr std::string_view kIrregularSpacing = "irregular-spacing";
inline constexpr std::string_view kSpacingTooIrregular = "spacing-too-irregular";
inline constexpr std::string_view kOddPosition = "odd-position";
inline constexpr std::string_view kUnevenSpacing = "uneven-spacing";
inline constexpr std::string_view kNotParallel = "not-parallel";
inline constexpr std::string_view kNotReconstructable = "not-reconstructable";
inline constexpr std::string_view kTiltedStack = "tilted-stack";
inline constexpr std::string_view kSparseSlices = "sparse-slices";
// Pixels and values.
inline constexpr std::string_view kUnsupportedSopClass = "unsupported-sop-class";
inline constexpr std::string_view kUnsupportedSeries = "unsupported-series";
inline constexpr std::string_view kColourImage = "colour-image";
inline constexpr std::string_view kUnsupportedBits = "unsupported-bits";
inline constexpr std::string_view kUnsupportedTransferSyntax = "unsupported-transfer-syntax";
inline constexpr std::string_view kOddEncoding = "odd-encoding";
inline constexpr std::string_view kContradictedSyntax = "contradicted-syntax";
inline constexpr std::string_view kGreyscaleAssumed = "greyscale-assumed";
inline constexpr std::string_view kMosaic = "mosaic";
inline constexpr std::string_view kDose = "dose";
inline constexpr std::string_view kModalityLut = "modality-lut";
inline constexpr std::string_view kInvalidModalityLut = "invalid-modality-lut";
inline constexpr std::string_view kInvalidRescale = "invalid-rescale";
inline constexpr std::string_view kMissingRescale = "missing-rescale";
inline constexpr std::string_view kNoHounsfield = "no-hounsfield";
inline constexpr std::string_view kOddRescale = "odd-rescale";
inline constexpr std::string_view kDeviatingRescale = "deviating-rescale";
inline constexpr std::string_view kPerSliceRescale = "per-slice-rescale";
inline constexpr std::string_view kRescaleStep = "rescale-step";
inline constexpr std::string_view kOddValues = "odd-values";
inline constexpr std::string_view kOddValuesKept = "odd-values-kept";
inline constexpr std::string_view kUnlikeNeighbours = "unlike-neighbours";
inline constexpr std::string_view kRealWorldValues = "real-world-values";
inline constexpr std::string_view kSuvUnavailable = "suv-unavailable";
inline constexpr std::string_view kBitsExceeded = "bits-exceeded";
inline constexpr std::string_view kBitsDropped = "bits-dropped";
inline constexpr std::string_view kBitsMisplaced = "bits-misplaced";
inline constexpr std::string_view kNonFiniteValues = "non-finite-values";
inline constexpr std::string_view kLossySource = "lossy-source";
inline constexpr std::string_view kDisplayTable = "display-table";
inline constexpr std::string_view kInvertedDisplay = "inverted-display";
inline constexpr std::string_view kInvalidWindow = "invalid-window";
// Segmentations.
inline constexpr std::string_view kSegmentsOverlap = "segments-overlap";
inline constexpr std::string_view kSegmentsOutside = "segments-outside";
inline constexpr std::string_view kSegmentIsPadding = "segment-is-padding";
inline constexpr std::string_view kSegmentZero = "segment-zero";
// Presentation states.
inline constexpr std::string_view kPresentationState = "presentation-state";
inline constexpr std::string_view kPresentationLeftOut = "presentation-left-out";
inline constexpr std::string_view kPresentationApproximated = "presentation-approximated";
inline constexpr std::string_view kPresentationChanged = "presentation-changed";
}  // namespace key

}  // namespace macula::dicom
