// What is worth telling about a series or a file: a sentence for a person, and a stable key for programs and
// tests.
#pragma once

#include <string>
#include <string_view>

namespace macula::dicom {

enum class Severity {
    info,          // nothing to do
    warning,       // shown, but look at it before relying on it
    blocksVolume,  // cannot be shown in 3D
};

// `sentence` and `action` (what to do) hold no patient data. The keys are listed below and never change
// meaning.
struct Message {
    Severity severity = Severity::info;
    std::string key;
    std::string sentence;
    std::string action;
};

namespace key {
// Geometry.
inline constexpr std::string_view kSingleSlice = "single-slice";
inline constexpr std::string_view kNoPosition = "no-position";
inline constexpr std::string_view kNoPixelSpacing = "no-pixel-spacing";
inline constexpr std::string_view kInvalidOrientation = "invalid-orientation";
inline constexpr std::string_view kInconsistentSize = "inconsistent-size";
inline constexpr std::string_view kInconsistentOrientation = "inconsistent-orientation";
inline constexpr std::string_view kInconsistentPixelSpacing = "inconsistent-pixel-spacing";
inline constexpr std::string_view kInconsistentFrameOfReference = "inconsistent-frame-of-reference";
inline constexpr std::string_view kDuplicatePositions = "duplicate-positions";
inline constexpr std::string_view kMissingSlices = "missing-slices";
inline constexpr std::string_view kIrregularSpacing = "irregular-spacing";
inline constexpr std::string_view kSlicesNotInLine = "slices-not-in-line";
inline constexpr std::string_view kUnevenSpacing = "uneven-spacing";
inline constexpr std::string_view kTiltedStack = "tilted-stack";
// Pixels and values.
inline constexpr std::string_view kMultiFrame = "multi-frame";
inline constexpr std::string_view kColourImage = "colour-image";
inline constexpr std::string_view kUnsupportedBits = "unsupported-bits";
inline constexpr std::string_view kUnsupportedTransferSyntax = "unsupported-transfer-syntax";
inline constexpr std::string_view kModalityLut = "modality-lut";
inline constexpr std::string_view kInvalidRescale = "invalid-rescale";
inline constexpr std::string_view kMissingRescale = "missing-rescale";
inline constexpr std::string_view kPerSliceRescale = "per-slice-rescale";
inline constexpr std::string_view kLossySource = "lossy-source";
// Files.
inline constexpr std::string_view kDuplicateFiles = "duplicate-files";
inline constexpr std::string_view kUnreadableFile = "unreadable-file";
inline constexpr std::string_view kDamagedFile = "damaged-file";
inline constexpr std::string_view kTruncatedFile = "truncated-file";
inline constexpr std::string_view kNoPixelData = "no-pixel-data";
inline constexpr std::string_view kStrayBytes = "stray-bytes";
inline constexpr std::string_view kUnreadableFolder = "unreadable-folder";
inline constexpr std::string_view kSeveralPatients = "several-patients";
}  // namespace key

}  // namespace macula::dicom
