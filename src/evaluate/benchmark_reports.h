// The results of benchmarks as JSON. Each report begins with `describe` of its study; none contains patient
// data.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "evaluate/bench_study.h"
#include "evaluate/cast_benchmark.h"
#include "evaluate/edits.h"
#include "evaluate/foveal_benchmark.h"
#include "evaluate/load_benchmark.h"
#include "evaluate/motion.h"
#include "evaluate/quality.h"
#include "evaluate/study_training_benchmark.h"
#include "evaluate/trace_benchmark.h"
#include "evaluate/tradeoff.h"

namespace macula::evaluate {

nlohmann::ordered_json reportOf(const BenchStudy& study, const TraceBenchmarkOptions& options,
                                std::span<const TraceBenchmark> results);
nlohmann::ordered_json reportOf(const BenchStudy& study, const FovealOptions& options,
                                const FovealReport& result);
nlohmann::ordered_json reportOf(const BenchStudy& study, const EditsOptions& options,
                                const EditsReport& result);
nlohmann::ordered_json reportOf(const BenchStudy& study, const MotionOptions& options,
                                const MotionReport& result);
nlohmann::ordered_json reportOf(const BenchStudy& study, const QualityOptions& options,
                                const QualityReport& result);
nlohmann::ordered_json toJson(const QualityRow& row);
nlohmann::ordered_json reportOf(const BenchStudy& study, const TradeoffOptions& options,
                                const Tradeoff& result);
nlohmann::ordered_json reportOf(const BenchStudy& study, int turns, std::span<const CastBenchmark> results);
// `seriesDigest` is that of study::LoadedStudy.
nlohmann::ordered_json reportOf(std::string_view seriesDigest, const HeaderBenchmark& headers,
                                const LoadBenchmarkOptions& options, const LoadBenchmark& loading);

// The report in two parts, what is measured and the results: a baseline of something else can then be
// rejected before hours of measuring.
nlohmann::ordered_json beginningOf(const BenchStudy& study, const StudyTrainingOptions& options);
nlohmann::ordered_json toJson(const StudyTrainingReport& report);

// The stages by name, in the order of a step.
std::vector<std::pair<const char*, StageBenchmark>> stagesOf(const TrainingBenchmark& benchmark);
double stepsPerSecond(const TrainingBenchmark& benchmark);

// The ratio by which reports of this device are compared: processor time says little about the work of a
// device that is not a CPU.
std::string_view trainingRatioOf(const gpu::Device& device);
inline constexpr std::string_view kTraceRatios[] = {"cpuRatio"};
// Larger is better.
inline constexpr std::string_view kLoadRatios[] = {"headersOverDcmtk", "itkOverOurs", "dcmtkOverOurs"};

}  // namespace macula::evaluate
