// Counts the pixels of a denoised picture with few samples that stand out from the converged picture.
#pragma once

#include <cstddef>
#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "base/progress.h"
#include "base/result.h"
#include "evaluate/bench_study.h"
#include "image/image.h"
#include "pipeline/trace/settings.h"

namespace macula::evaluate {

// A pixel is a bright speck if its luminance is more than a tenth above the largest of the converged 5 x 5
// pixels around it, and a dark one if it is more than a tenth below their smallest. Luminance is Rec. 709 in
// linear light; differences of less than one 8-bit step, display-encoded, do not count.
struct Specks {
    std::size_t bright = 0;
    std::size_t dark = 0;
    std::size_t pixels = 0;   // those with light in either picture
    double worst = 0.0;       // largest ratio to that largest pixel; 0 without a bright speck
    double lightRatio = 1.0;  // sum of luminance, over that of the converged picture
};
// Both must be display-encoded over black, with three channels and the same size.
Specks specksOf(const image::Image& shown, const image::Image& converged);

struct SpecksOptions {
    std::vector<std::uint32_t> samples{1, 2, 4, 16, 64, 256};  // ascending
    std::uint32_t convergedSamples = 1024;                     // not denoised, with another seed
    trace::Filter filter = trace::Filter::trilinear;
    int bounces = trace::kDefaultBounces;
};

struct SpecksRow {
    std::uint32_t samples = 0;
    Specks specks;
    double flip = 0.0;  // to the converged picture
};

struct SpecksReport {
    std::vector<SpecksRow> rows;
    double convergedFlip = 0.0;  // remaining noise: of half of its samples to all
};

// Fails with usage if samples do not ascend from at least 1, or are not below those of the converged picture.
Result<void> check(const BenchStudyOptions& study, const SpecksOptions& options);
Result<SpecksReport> measureSpecks(const BenchStudy& study, const SpecksOptions& options, Progress& progress);
nlohmann::ordered_json reportOf(const BenchStudy& study, const SpecksOptions& options,
                                const SpecksReport& report);

}  // namespace macula::evaluate
