// How fast the tracer is, beside the scalar C++ reference on the same picture in the same run: a ratio means
// something on every machine, milliseconds only on one.
#pragma once

#include <memory>
#include <vector>

#include "base/progress.h"
#include "base/result.h"
#include "evaluate/measurement.h"
#include "pipeline/trace/path_tracer.h"

namespace macula::evaluate {

// As the stored baselines have, whatever pictures have by default.
inline constexpr int kBenchBounces = 4;

struct TraceBenchmarkOptions {
    trace::View view;  // 512 x 512 unless told otherwise
    trace::Settings settings{.bounces = kBenchBounces};
    std::uint32_t samplesPerPixel = 16;
    int repetitions = 5;  // device and reference take turns, so that a busy neighbour hits both
};

// Medians over the repetitions.
struct TraceBenchmark {
    trace::Filter filter = trace::Filter::trilinear;
    Spent device;  // on one sample of every pixel
    Spent reference;
    Ratio ratio;  // device over reference
};

// One report per filter, `settings.filter` is not used. The first dispatches, which compile the kernel, are
// not timed.
Result<std::vector<TraceBenchmark>> benchmarkTracing(const std::shared_ptr<gpu::Device>& device,
                                                     const std::shared_ptr<const Volume>& volume,
                                                     const TransferFunction& function,
                                                     const trace::Environment& environment,
                                                     const TraceBenchmarkOptions& options,
                                                     Progress& progress);

}  // namespace macula::evaluate
