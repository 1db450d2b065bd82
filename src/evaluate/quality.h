// Measures how near different kinds of frames come to the ground truth, as a whole and where the eye looks:
// path tracing alone, splats alone, both together, and path tracing alone in the time that both together
// take. As in Table 3 of Kleinbeck et al. (IEEE VR 2026); docs/hybrid-frame.md says what each row is.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/progress.h"
#include "base/result.h"
#include "evaluate/bench_study.h"
#include "evaluate/frame_scores.h"
#include "evaluate/view_scores.h"
#include "image/edges.h"
#include "image/frame_metrics.h"
#include "pipeline/hybrid/frame/hybrid_frame.h"
#include "pipeline/hybrid/model/first_model.h"
#include "pipeline/hybrid/model/refinement.h"
#include "pipeline/hybrid/views/pose_sampling.h"

namespace macula::evaluate {

struct QualityOptions {
    glm::ivec2 sizePx{720, 720};
    hybrid::PoseSampling poses = hybrid::wholeFrames();
    std::size_t views = 32;                                             // as for HeldOutViews::trace
    std::uint32_t truthSamples = 256;                                   // not denoised; even
    std::uint32_t foveaSamples = 4;                                     // for Grade::normal, denoised
    std::uint64_t iterations = hybrid::FirstModelOptions{}.iterations;  // of the first model of Grade::normal
    int bounces = trace::kDefaultBounces;                               // of everything traced
};

enum class Grade { normal, high };
inline constexpr std::array kGrades{Grade::normal, Grade::high};

// The settings of a grade.
struct GradePlan {
    std::uint32_t foveaSamples = 0;
    std::uint32_t wholeSamples = 0;  // for path tracing alone
    hybrid::FirstModelOptions model;
    hybrid::RefinementOptions refinement;
};
GradePlan planOf(const QualityOptions& options, Grade grade);

struct QualityView {
    FrameScores scores;
    double frameMs = 0.0;
    std::uint32_t samplesPerPixel = 0;  // MadeFrame
    double resolutionShare = 1.0;
    std::optional<image::SeamVisibility> seam;        // of the fovea's border; nothing without a fovea
    std::optional<image::EdgeVisibility> silhouette;  // along the truth's silhouette in the middle, if any
    std::optional<hybrid::FoveaTimes> foveaTimes;     // MadeFrame
};

// The results of one way to make frames, by view.
struct QualityRow {
    std::string way;         // "pt", "splats", "hybrid", "pt-equal"; with "-hq" for Grade::high
    std::string_view model;  // "fresh", "refined"; empty without a model; for pt-equal the hybrid's
    std::size_t splats = 0;
    std::optional<double> preparationSeconds;  // total time for the model so far
    std::vector<QualityView> views;

    std::vector<FrameScores> scores() const;
};

// The gain of a hybrid row, over the views.
struct QualityGain {
    std::string way;
    std::string_view model;
    std::optional<Spread> foveaDb;           // over pt-equal
    std::optional<Spread> equalTimeShare;    // time of pt-equal over that of the hybrid frame
    std::optional<Spread> fullOverSplatsDb;  // over the "splats" row of this model
};
QualityGain gainOf(const QualityRow& hybrid, const QualityRow& equal, const QualityRow& splats);

struct QualityReport {
    std::vector<QualityRow> rows;
    std::vector<QualityGain> gains;
    std::size_t viewsGivenUp = 0;  // no try showed enough, and the last one was used
};

// Fails with `cancelled`; with inputNotUsable if nothing can be seen; with usage if the samples of the truth
// are odd.
Result<QualityReport> measureQuality(const BenchStudy& study, const QualityOptions& options,
                                     Progress& progress);

}  // namespace macula::evaluate
