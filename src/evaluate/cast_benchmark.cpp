#include "evaluate/cast_benchmark.h"

#include <chrono>
#include <string>
#include <utility>

#include "base/elapsed.h"
#include "base/parallel.h"
#include "evaluate/measurement.h"
#include "evaluate/shown_picture.h"
#include "evaluate/vtk_cast.h"
#include "image/metrics.h"
#include "pipeline/volume/volume_fit.h"
#include "pipeline/volume/window.h"

namespace macula::evaluate {

namespace {

// Samples of the converged picture.
constexpr int kConverged = 16;

trace::Settings settingsOf(const CastSubject& subject, const Volume& volume) {
    trace::Settings settings{.filter = subject.filter, .look = subject.look, .shading = subject.shading};
    if (trace::isProjection(subject.look)) {
        settings.window = subject.look == trace::Look::mip
                              ? maximumWindow(volume)
                              : windowOver({volume.unitsFromStored()(volume.storedRange().low),
                                            volume.unitsFromStored()(volume.storedRange().high)});
    }
    return settings;
}

Result<double> flipOf(const image::Image& converged, const image::Image& picture) {
    MACULA_TRY(const image::Flip flip, image::flip(converged, picture));
    return double(flip.mean);
}

Result<VtkCastTime> judged(VtkCast cast) {
    VtkCastTime vtk{.time = {.firstSeconds = cast.firstSeconds, .secondsPerPicture = median(cast.seconds)},
                    .stepMm = cast.stepMm,
                    .secondsInThirdSteps = cast.fineSeconds};
    MACULA_TRY(vtk.time.flip, flipOf(cast.converged, cast.picture));
    MACULA_TRY(vtk.flipInThirdSteps, flipOf(cast.converged, cast.fine));
    vtk.time.picture = std::move(cast.picture);
    vtk.time.converged = std::move(cast.converged);
    return vtk;
}

Result<void> writeBoth(const std::filesystem::path& folder, const std::string& name, const CastTime& time) {
    MACULA_TRY_VOID(writePng(folder / (name + ".png"), time.picture));
    return writePng(folder / (name + "-converged.png"), time.converged);
}

}  // namespace

Result<CastBench> CastBench::create(const BenchStudy& study, int turns) {
    MACULA_TRY(trace::PathTracer tracer, study.makeTracer());
    return CastBench(study, std::move(tracer), turns);
}

// Draws from the first sample on, into a picture on the host.
Result<image::Image> CastBench::draw(const trace::Settings& settings, int samples) {
    MACULA_TRY_VOID(tracer_.setSettings(settings));
    MACULA_TRY([[maybe_unused]] const bool all, tracer_.trace(samples));
    return study_.readShown(tracer_);
}

Result<double> CastBench::timeOnce(const trace::Settings& settings) {
    const auto start = std::chrono::steady_clock::now();
    MACULA_TRY([[maybe_unused]] const image::Image picture, draw(settings, 1));
    return secondsSince(start);
}

Result<CastBenchmark> CastBench::measure(const CastSubject& subject) {
    const trace::Settings settings = settingsOf(subject, *study_.volume);
    CastBenchmark result{.subject = subject.name};
    MACULA_TRY(result.ours.firstSeconds, timeOnce(settings));
    std::vector<double> seconds;
    std::optional<Error> failure;
    const auto turn = [&] {
        auto taken = timeOnce(settings);
        if (!taken) failure = taken.error();
        seconds.push_back(taken ? *taken : 0.0);
    };
    std::optional<VtkCast> theirs;
    if (!withoutVtk_) {
        auto cast = castWithVtk({.volume = study_.volume.get(),
                                 .function = fitted(study_.function, *study_.volume),
                                 .view = study_.view,
                                 .look = subject.look,
                                 .shading = subject.shading != trace::Shading::none,
                                 .window = settings.window.value_or(DisplayWindow{}),
                                 .turns = turns_,
                                 .threads = coreCount()},
                                turn);
        if (cast) {
            theirs = *std::move(cast);
        } else {
            withoutVtk_ = cast.error();
        }
    }
    while (seconds.size() < std::size_t(turns_)) turn();
    if (failure) return *failure;
    result.ours.secondsPerPicture = median(seconds);
    MACULA_TRY(result.ours.picture, draw(settings, 1));
    MACULA_TRY(result.ours.converged, draw(settings, kConverged));
    MACULA_TRY(result.ours.flip, flipOf(result.ours.converged, result.ours.picture));
    if (theirs) {
        std::vector<double> ratios;
        for (std::size_t n = 0; n < theirs->seconds.size(); ++n)
            ratios.push_back(seconds[n] / theirs->seconds[n]);
        result.oursOverVtk = median(std::move(ratios));
        MACULA_TRY(result.vtk, judged(*std::move(theirs)));
    }
    return result;
}

Result<void> writePictures(const CastBenchmark& benchmark, const std::filesystem::path& folder) {
    const std::string name(benchmark.subject);
    MACULA_TRY_VOID(writeBoth(folder, name + "-macula", benchmark.ours));
    return benchmark.vtk ? writeBoth(folder, name + "-vtk", benchmark.vtk->time) : Result<void>();
}

}  // namespace macula::evaluate
