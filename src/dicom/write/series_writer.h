// Writes a Volume as a DICOM series of single-frame CT or MR images, for the phantom study and for tests.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "base/progress.h"
#include "base/result.h"
#include "base/volume.h"

namespace macula::dicom {

enum class WriteSyntax {
    explicitLittleEndian,
    implicitLittleEndian,
    explicitBigEndian,
    deflated,
    rle,
    jpegLossless,
    jpegLs,
};

enum class PixelSign {
    automatic,
    asUnsigned,
    asSigned
};  // automatic: whichever has the smaller rescale intercept

struct SeriesWriterOptions {
    WriteSyntax syntax = WriteSyntax::explicitLittleEndian;
    PixelSign pixelSign = PixelSign::automatic;
    std::string seriesDescription = "Macula phantom";
    int seriesNumber = 1;
};

// Writes IM00001.dcm … into `folder`, one file per slice, and returns their paths. Reading them back gives
// the same values and, within 1e-6 mm, the same affine, when
//   - the volume's slope and intercept fit the 16 characters of a Decimal String (else values agree to 10
//   digits), and
//   - the volume is right-handed (DICOM has no other: slices of a left-handed one come back in reverse
//   order).
// The patient is PHANTOM^MACULA. UIDs are derived from the content (root 2.25, PS3.5 B.2): the same volume
// gives the same files. All or nothing: files are written to a hidden folder next to it, which is then
// renamed. `folder` must be missing or empty, or hold exactly what would be written. Modality CT or MR; rows
// and columns perpendicular. Fails with usage, outputNotWritable or cancelled.
Result<std::vector<std::filesystem::path>> writeSeries(const Volume& volume,
                                                       const std::filesystem::path& folder,
                                                       const SeriesWriterOptions& options,
                                                       Progress& progress);

}  // namespace macula::dicom
