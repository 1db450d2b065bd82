// How fast the tracer is, compared with the scalar C++ reference on the same picture in the same run: ratios
// are comparable between machines, milliseconds are not.
#pragma once

#include <optional>
#include <vector>

#include "base/progress.h"
#include "base/result.h"
#include "evaluate/bench_study.h"
#include "evaluate/measurement.h"
#include "pipeline/trace/settings.h"

namespace macula::evaluate {

// Those of the stored baselines, independent of the default for pictures.
inline constexpr int kBenchBounces = 4;

struct TraceBenchmarkOptions {
    int bounces = kBenchBounces;
    std::optional<trace::Filter> filter;  // nothing: trilinear, then stochastic
    std::uint32_t samplesPerPixel = 16;
    int repetitions = 5;  // contenders alternate, so that other load affects all of them
};

// Medians over the repetitions, for one sample of every pixel.
struct TraceBenchmark {
    trace::Filter filter = trace::Filter::trilinear;
    Spent device;  // only samples
    // A whole picture with samplesPerPixel, as `macula render` and macula_draw make it
    // (pictures::PictureDrawer) of a scene on the device: sets the view, traces samples in portions,
    // estimates their noise, displays and reads the picture.
    Spent call;
    Spent reference;
    Ratio ratio;  // device over reference
    Ratio calls;  // call over device
};

// One report for each filter. Does not time the first dispatches, which compile kernels.
Result<std::vector<TraceBenchmark>> benchmarkTracing(const BenchStudy& study,
                                                     const TraceBenchmarkOptions& options,
                                                     Progress& progress);

}  // namespace macula::evaluate
