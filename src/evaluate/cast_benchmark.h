// The looks that are cast, one sample a pixel, beside VTK's CPU mapper where that is installed.
#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "evaluate/bench_study.h"
#include "image/image.h"
#include "pipeline/trace/path_tracer.h"

namespace macula::evaluate {

struct CastSubject {
    std::string_view name;
    trace::Look look;
    trace::Shading shading;
    trace::Filter filter = trace::Filter::trilinear;  // VTK's is that, whatever is asked of ours
};
inline constexpr std::array<CastSubject, 6> kCastSubjects{
    {{"shaded", trace::Look::dvr, trace::Shading::headlight},
     {"smooth", trace::Look::dvr, trace::Shading::headlight, trace::Filter::smooth},
     {"dvr", trace::Look::dvr, trace::Shading::none},
     {"mip", trace::Look::mip, trace::Shading::none},
     {"minip", trace::Look::minip, trace::Shading::none},
     {"average", trace::Look::average, trace::Shading::none}}};

// What one of both needs for a picture, and how good that is.
struct CastTime {
    double firstSeconds = 0.0;       // with what is made once
    double secondsPerPicture = 0.0;  // of each further one; median
    double flip = 0.0;               // of the picture to its own converged one
    image::Image picture{};          // display-encoded RGB, over black
    image::Image converged{};
};

struct VtkCastTime {
    CastTime time;
    double stepMm = 0.0;  // VTK's own choice
    double secondsInThirdSteps = 0.0;
    double flipInThirdSteps = 0.0;
};

struct CastBenchmark {
    std::string_view subject;  // its name
    CastTime ours;
    std::optional<VtkCastTime> vtk;
    double oursOverVtk = 0.0;  // median of the ratios of each turn; 0 without VTK
};

class CastBench {
  public:
    // Fails as BenchStudy::makeTracer. `study` must live as long.
    static Result<CastBench> create(const BenchStudy& study, int turns);

    // Both, in turns; without VTK ours alone.
    Result<CastBenchmark> measure(const CastSubject& subject);

    // Why there is nothing of VTK, once that is known.
    const std::optional<Error>& withoutVtk() const { return withoutVtk_; }

  private:
    CastBench(const BenchStudy& study, trace::PathTracer tracer, int turns)
        : study_(study), tracer_(std::move(tracer)), turns_(turns) {}

    Result<image::Image> draw(const trace::Settings& settings, int samples);
    Result<double> timeOnce(const trace::Settings& settings);

    const BenchStudy& study_;
    trace::PathTracer tracer_;
    int turns_;
    std::optional<Error> withoutVtk_;
};

// SUBJECT-macula.png and SUBJECT-vtk.png, and each with -converged.
Result<void> writePictures(const CastBenchmark& benchmark, const std::filesystem::path& folder);

}  // namespace macula::evaluate
