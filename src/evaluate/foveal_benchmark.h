// Measures the cost of a picture for the fovea: tracing, guides and denoising compared with the scalar C++
// reference, which only traces; and the time to a given error, denoised and plain.
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
    int repetitions = 5;  // device and reference in alternation; reports medians
    double flip = 0.05;   // the error to be reached
    // Samples of a pixel that are traced in parallel; 0: as many as suit the device.
    std::uint32_t sideBySide = 0;
    // Samples of the converged picture. It has the same `bounces`, so that missing light is not counted as an
    // error.
    std::uint32_t convergedSamples = 512;
};

struct FovealTimes {
    double traceMs = 0.0;
    double guidesMs = 0.0;
    double displayMs = 0.0;  // denoising and tone map
    double referenceTraceMs = 0.0;
    double dispatches = 0.0;  // for samples

    double totalMs() const { return traceMs + guidesMs + displayMs; }
};

// When a picture first has the wanted error.
struct TimeToError {
    bool reached = false;  // within the number of samples of the converged picture
    double samples = 0.0;  // per pixel, on average
    double ms = 0.0;       // for these samples and one display, with guides and denoising
    double flip = 0.0;
};

struct FovealReport {
    FovealTimes times;           // medians of each part
    double totalMs = 0.0;        // median of the sums
    double ratio = 0.0;          // total over reference; median over the turns
    double convergedFlip = 0.0;  // remaining noise: FLIP of the first half of the samples to all
    TimeToError plain;           // even samples, not denoised
    TimeToError denoised;        // the same, denoised
    TimeToError adaptive;        // more samples where noise is, denoised
    // Even samples with the cache of indirect light, filled by pictures of one sample from nearby views, as
    // while a hand moves the view; the time for these does not count.
    TimeToError cached, cachedDenoised;
    TimeToError corrected, correctedDenoised;
};

Result<FovealReport> measureFoveal(const BenchStudy& study, const FovealOptions& options, Progress& progress);

}  // namespace macula::evaluate
