// What one picture for the fovea costs, and how soon it is good: tracing, guides and denoising beside the
// scalar C++ reference, which only traces; and the time to a given error, denoised and plain.
#pragma once

#include <cstdint>
#include <vector>

#include "base/progress.h"
#include "base/result.h"
#include "evaluate/bench_study.h"
#include "evaluate/trace_benchmark.h"

namespace macula::evaluate {

struct FovealOptions {
    std::uint32_t samples = 4;
    int bounces = kBenchBounces;
    trace::Filter filter = trace::Filter::trilinear;
    int repetitions = 5;  // device and reference take turns; medians are told
    double flip = 0.05;   // the error that is to be reached
    // Samples of a pixel that are traced side by side; 0: as many as the device likes.
    std::uint32_t sideBySide = 0;
    // Of the picture that counts as converged. It has as many bounces: what fewer leave out is another
    // matter.
    std::uint32_t convergedSamples = 512;
};

struct FovealTimes {
    double traceMs = 0.0;
    double guidesMs = 0.0;
    double displayMs = 0.0;  // denoising and tone map
    double referenceTraceMs = 0.0;
    double dispatches = 0.0;  // of samples

    double totalMs() const { return traceMs + guidesMs + displayMs; }
};

// The first number of samples whose picture is as near as was asked for.
struct TimeToError {
    bool reached = false;  // with the samples of the converged picture at most
    double samples = 0.0;  // of a pixel, on average
    double ms = 0.0;       // for these samples, and for showing them once; guides and denoising with it
    double flip = 0.0;
};

struct FovealReport {
    FovealTimes times;           // medians, each by itself
    double totalMs = 0.0;        // median of the sums
    double ratio = 0.0;          // of the sum over the reference; median of the ratios of each turn
    double convergedFlip = 0.0;  // what chance leaves: FLIP of the first half of the samples to all of them
    TimeToError plain;           // even samples, as they come
    TimeToError denoised;        // the same, filtered
    TimeToError adaptive;        // samples where noise is, filtered
    // Even samples with the cache of indirect light, which pictures of one sample from nearby views have
    // filled as those of a moving hand do; their time does not count.
    TimeToError cached, cachedDenoised;
    TimeToError corrected, correctedDenoised;
};

Result<FovealReport> measureFoveal(const BenchStudy& study, const FovealOptions& options, Progress& progress);

}  // namespace macula::evaluate
