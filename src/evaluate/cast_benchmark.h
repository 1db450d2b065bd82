// Compares the looks that are ray cast, with one sample per pixel, with VTK's CPU mapper, if that is
// installed.
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
    trace::Filter filter = trace::Filter::trilinear;  // ours; VTK's is always trilinear
};
inline constexpr std::array<CastSubject, 6> kCastSubjects{
    {{"shaded", trace::Look::dvr, trace::Shading::headlight},
     {"smooth", trace::Look::dvr, trace::Shading::headlight, trace::Filter::smooth},
     {"dvr", trace::Look::dvr, trace::Shading::none},
     {"mip", trace::Look::mip, trace::Shading::none},
     {"minip", trace::Look::minip, trace::Shading::none},
     {"average", trace::Look::average, trace::Shading::none}}};

// The time that Macula or VTK needs for a picture, and its error.
struct CastTime {
    double firstSeconds = 0.0;       // with one-time preparation
    double secondsPerPicture = 0.0;  // of each later picture; median
    double flip = 0.0;               // between the picture and its own converged one
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
    std::string_view subject;  // CastSubject::name
    CastTime ours;
    std::optional<VtkCastTime> vtk;
    double oursOverVtk = 0.0;  // median of the ratios of each turn; 0 without VTK
};

class CastBench {
  public:
    // Fails as BenchStudy::makeTracer does. `study` must outlive this object.
    static Result<CastBench> create(const BenchStudy& study, int turns);

    // Measures Macula and VTK in alternation; without VTK only Macula.
    Result<CastBenchmark> measure(const CastSubject& subject);

    // Why VTK could not be measured, if it could not.
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

// Writes SUBJECT-macula.png and SUBJECT-vtk.png, and both with -converged.
Result<void> writePictures(const CastBenchmark& benchmark, const std::filesystem::path& folder);

}  // namespace macula::evaluate
