// How near a frame comes to the truth, in whole and where the eye looks.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "base/camera.h"
#include "base/result.h"
#include "image/image.h"
#include "image/masked_metrics.h"
#include "pipeline/hybrid/views/truth_pictures.h"

namespace macula::evaluate {

// As frames are shown: over black, in 8 bits.
struct FrameTruth {
    Camera camera;
    image::Image shown;
    image::Mask covered;          // where it has coverage, whatever its colour
    image::Mask middle;           // trace::kFovealFieldDeg around the middle
    image::Mask coveredInMiddle;  // both
    image::Mask silhouetteInMiddle;
};
FrameTruth frameTruthOf(const hybrid::TruthPicture& picture);

// PSNR and SSIM are of pixels where the truth has coverage, FLIP of all. Nothing where there is no such
// pixel, or a PSNR is not finite.
struct RegionScores {
    std::optional<double> maskedPsnrDb;
    std::optional<double> maskedSsim;
    std::optional<double> flip;
};

struct FrameScores {
    RegionScores full;
    RegionScores fovea;            // trace::kFovealFieldDeg around the middle
    std::optional<double> msSsim;  // of the whole picture; nothing where that is too small for it
};

// `shown`: display-encoded, as large as the truth.
Result<FrameScores> frameScoresOf(const FrameTruth& truth, const image::Image& shown);

// By view, what the PSNR of `ours` is above that of `theirs`; nothing where one of them is missing.
std::vector<std::optional<double>> gainsDb(std::span<const FrameScores> ours,
                                           std::span<const FrameScores> theirs,
                                           RegionScores FrameScores::*region);

}  // namespace macula::evaluate
