// How fast the tracer is, beside the scalar C++ reference on the same picture in the same run: a ratio means
// something on every machine, milliseconds only on one.
#pragma once

#include <memory>
#include <vector>

#include "base/progress.h"
#include "base/result.h"
#include "pipeline/trace/path_tracer.h"

namespace macula::evaluate {

struct TraceBenchmarkOptions {
    trace::View view;          // 512 x 512 unless told otherwise
    trace::Settings settings;  // 4 bounces
    std::uint32_t samplesPerPixel = 16;
    int repetitions = 5;  // device and reference take turns, so that a busy neighbour hits both
};

// Medians over the repetitions. CPU time is that of all threads of
// this process: on a CPU device it does not depend on who else is running; on a GPU it is only what the
// driver used.
struct TraceBenchmark {
    struct Contender {
        double secondsPerSample = 0.0;  // of every pixel
        double cpuSecondsPerSample = 0.0;
        double microsecondsPerPixel = 0.0;  // of one sample of one pixel
    };
    trace::Filter filter = trace::Filter::trilinear;
    Contender device;
    Contender reference;
    double wallRatio = 0.0;  // device over reference; median of the ratios of each turn
    double cpuRatio = 0.0;
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
