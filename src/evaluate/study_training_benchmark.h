// Measures how fast a step of training is (training_benchmark.h), with a model and a view of a real study.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "base/progress.h"
#include "base/result.h"
#include "evaluate/bench_study.h"
#include "evaluate/training_benchmark.h"
#include "pipeline/hybrid/model/first_model.h"
#include "pipeline/hybrid/views/view_tracing.h"
#include "pipeline/splat/model/splats.h"

namespace macula::evaluate {

struct StudyTrainingOptions {
    std::uint32_t splats = 10000;                         // points on visible matter; there may be fewer
    int shDegree = hybrid::FirstModelOptions{}.shDegree;  // as for first models
    int repetitions = 5;                                  // the report has medians
};

struct SizedTrainingBenchmark {
    glm::ivec2 sizePx{0};  // of the training view
    TrainingBenchmark training;
};

// Times from a volume that is on the device, with compiled kernels.
struct BeginningBenchmark {
    double firstSplatsMs = 0.0;
    double firstPictureMs = 0.0;  // of these splats, from the start
    double tracedViewMs = 0.0;
};

struct StudyTrainingReport {
    std::size_t splats = 0;
    std::vector<SizedTrainingBenchmark> results;
    std::optional<BeginningBenchmark> fromVolume;
};

class StudyTrainingBench {
  public:
    // As in `macula train`.
    static constexpr std::uint32_t kSamplesPerPixel = 2;

    // Makes the model. Fails with inputNotUsable if nothing of the series can be seen. `study` and `progress`
    // must outlive this object.
    static Result<StudyTrainingBench> create(const BenchStudy& study, const StudyTrainingOptions& options,
                                             Progress& progress);

    std::size_t splats() const { return model_.size(); }
    // Measures with the view of the study. Fails as benchmarkTraining and hybrid::traceViews do.
    Result<SizedTrainingBenchmark> measure(const glm::ivec2& sizePx);
    // Measures with pictures of that size.
    Result<BeginningBenchmark> measureBeginning(const glm::ivec2& sizePx);

  private:
    StudyTrainingBench(const BenchStudy& study, const StudyTrainingOptions& options, trace::PathTracer tracer,
                       Progress& progress)
        : study_(study), options_(options), tracer_(std::move(tracer)), progress_(progress) {}

    Result<void> findModel();
    Result<hybrid::TracedView> traceOne(const glm::ivec2& sizePx);

    const BenchStudy& study_;
    StudyTrainingOptions options_;
    trace::PathTracer tracer_;
    Progress& progress_;
    splat::Splats model_;
};

}  // namespace macula::evaluate
