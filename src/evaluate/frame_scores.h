// How near a frame comes to the ground truth, as a whole and where the eye looks.
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

// The ground truth as frames are shown: over black, in 8 bits.
struct FrameTruth {
    Camera camera;
    image::Image shown;
    image::Mask covered;          // pixels with coverage, whatever their colour
    image::Mask middle;           // trace::kFovealFieldDeg around the middle
    image::Mask coveredInMiddle;  // pixels of both masks
    image::Mask silhouetteInMiddle;
};
FrameTruth frameTruthOf(const hybrid::TruthPicture& picture);

// PSNR and SSIM cover pixels where the truth has coverage, FLIP all pixels. Nothing without such pixels, or
// if a PSNR is not finite.
struct RegionScores {
    std::optional<double> maskedPsnrDb;
    std::optional<double> maskedSsim;
    std::optional<double> flip;
};

struct FrameScores {
    RegionScores full;
    RegionScores fovea;            // trace::kFovealFieldDeg around the middle
    std::optional<double> msSsim;  // of the whole picture; nothing if that is too small
};

// `shown` is display-encoded, and as large as the truth.
Result<FrameScores> frameScoresOf(const FrameTruth& truth, const image::Image& shown);

// By view, the PSNR of `ours` minus that of `theirs`; nothing if one is missing.
std::vector<std::optional<double>> gainsDb(std::span<const FrameScores> ours,
                                           std::span<const FrameScores> theirs,
                                           RegionScores FrameScores::*region);

}  // namespace macula::evaluate
