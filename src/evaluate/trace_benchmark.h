// How fast the tracer is, beside the scalar C++ reference on the same picture in the same run: a ratio means
// something on every machine, milliseconds only on one.
#pragma once

#include <optional>
#include <vector>

#include "base/progress.h"
#include "base/result.h"
#include "evaluate/bench_study.h"
#include "evaluate/measurement.h"
#include "pipeline/trace/settings.h"

namespace macula::evaluate {

// As the stored baselines have, whatever pictures have by default.
inline constexpr int kBenchBounces = 4;

struct TraceBenchmarkOptions {
    int bounces = kBenchBounces;
    std::optional<trace::Filter> filter;  // nothing: trilinear, then stochastic
    std::uint32_t samplesPerPixel = 16;
    int repetitions = 5;  // those that are compared take turns, so that a busy neighbour hits all
};

// Medians over the repetitions, of one sample of every pixel.
struct TraceBenchmark {
    trace::Filter filter = trace::Filter::trilinear;
    Spent device;  // samples alone
    // A whole picture of so many samples, as `macula render` and macula_draw make it
    // (pictures::PictureDrawer) of a scene that is on the device: the view is set, samples are traced in
    // portions, their noise is estimated, and the picture is displayed and read.
    Spent call;
    Spent reference;
    Ratio ratio;  // device over reference
    Ratio calls;  // call over device
};

// One report per filter. The first dispatches, which compile kernels, are not timed.
Result<std::vector<TraceBenchmark>> benchmarkTracing(const BenchStudy& study,
                                                     const TraceBenchmarkOptions& options,
                                                     Progress& progress);

}  // namespace macula::evaluate
