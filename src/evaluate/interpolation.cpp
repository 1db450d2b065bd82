#include "evaluate/interpolation.h"

#include <fmt/format.h>

#include <cmath>
#include <memory>
#include <nlohmann/json.hpp>
#include <numbers>
#include <utility>

#include "base/parallel.h"
#include "evaluate/bench_study.h"
#include "evaluate/shown_picture.h"
#include "evaluate/vtk_cast.h"
#include "live/device/open_device.h"
#include "pictures/output_files.h"
#include "pipeline/trace/environment.h"
#include "scene/choice/preset_choice.h"
#include "scene/lights/light_meter.h"

namespace macula::evaluate {

namespace {

using trace::Filter;
using trace::Look;

// The height of the world in a picture, and an eye so far away that its rays are nearly parallel.
constexpr double kShapeHeightMm = 40.0;
constexpr double kDetailHeightMm = 24.0;
constexpr double kEyeMm = 2000.0;
constexpr int kDetailSize = 96;
constexpr double kMostTurnedDeg = 40.0;
// Samples of ray casting, which has no noise: they only lie at different places in the pixel.
constexpr std::uint32_t kCastSamples = 16;

struct Subject {
    std::string by;
    trace::Settings settings;
    bool hasChance = true;
};

std::vector<Subject> subjects() {
    std::vector<Subject> all;
    for (const Filter filter : trace::kFilters)
        all.push_back({fmt::format("cinematic {}", trace::nameOf(filter)), {.filter = filter}});
    for (const Filter filter : {Filter::trilinear, Filter::smooth, Filter::sharp})
        all.push_back({fmt::format("dvr {}", trace::nameOf(filter)),
                       {.filter = filter, .look = Look::dvr, .shading = trace::Shading::headlight},
                       false});
    return all;
}

trace::View viewOf(double heightMm, int size) {
    const double half = std::atan(0.5 * heightMm / kEyeMm);
    return {.camera = {.positionMm = {0.0, -kEyeMm, 0.0},
                       .targetMm = glm::dvec3(0.0),
                       .verticalFovDeg = glm::degrees(2.0 * half)},
            .width = size,
            .height = size};
}

// A picture of the tracer's scene, from its first sample; luminance before exposure and tone map.
Result<LuminancePicture> draw(trace::PathTracer& tracer, const trace::Settings& settings,
                              std::uint32_t samples, Progress& progress) {
    MACULA_TRY_VOID(tracer.setSettings(settings));
    MACULA_TRY_VOID(traceMore(tracer, samples, progress));
    MACULA_TRY(const trace::TracedImage image, tracer.readback());
    LuminancePicture picture{image.width, image.height, {}};
    for (const glm::vec4& pixel : image.radiance)
        picture.luminance.push_back(scene::brightnessOf(glm::dvec3(pixel)));
    return picture;
}

struct Bench {
    const InterpolationOptions& options;
    std::shared_ptr<gpu::Device> device;
    Progress& progress;
};

BenchStudy studyOf(const Bench& bench, Volume volume, TransferFunction function,
                   trace::Environment environment, const trace::View& view) {
    return {.volume = std::make_shared<const Volume>(std::move(volume)),
            .function = std::move(function),
            .environment = std::move(environment),
            .device = bench.device,
            .view = view,
            .seriesDigest = {},
            .preset = {},
            .lights = {},
            .notes = {},
            .warnings = {},
            .then = {}};
}

std::filesystem::path pictureOf(const InterpolationOptions& options, Shape shape, std::string by) {
    std::replace(by.begin(), by.end(), ' ', '-');
    return options.pictures / fmt::format("{}-{}.png", nameOf(shape), by);
}

Result<void> keepPicture(const Bench& bench, Shape shape, const std::string& by,
                         const image::Image& picture) {
    if (bench.options.pictures.empty()) return {};
    return writePng(pictureOf(bench.options, shape, by), picture);
}

Result<void> measureSurface(const Bench& bench, Shape shape, const TransferFunction& function,
                            const trace::Environment& lights, InterpolationReport& report) {
    const trace::View view = viewOf(kShapeHeightMm, bench.options.size);
    const BenchStudy study = studyOf(bench, make(shape), function, lights, view);
    const auto counts = middleOf(shape, bench.options.size, kShapeHeightMm);
    MACULA_TRY(trace::PathTracer tracer, study.makeTracer());
    for (const Subject& subject : subjects()) {
        trace::Settings settings = subject.settings;
        const std::uint32_t samples = subject.hasChance ? bench.options.samples : kCastSamples;
        MACULA_TRY(const LuminancePicture first, draw(tracer, settings, samples, bench.progress));
        MACULA_TRY(const image::Image shown, study.readShown(tracer));
        MACULA_TRY_VOID(keepPicture(bench, shape, subject.by, shown));
        LuminancePicture second = first;
        if (subject.hasChance) {
            settings.seed = 1;
            MACULA_TRY(second, draw(tracer, settings, samples, bench.progress));
        }
        report.surfaces.push_back({shape, subject.by, rippleOf(first, second, counts)});
    }
    if (report.withoutVtk) return {};
    auto cast = castWithVtk({.volume = study.volume.get(),
                             .function = function,
                             .view = view,
                             .look = Look::dvr,
                             .shading = true,
                             .window = {},
                             .turns = 1,
                             .threads = coreCount()},
                            [] {});
    if (!cast) {
        report.withoutVtk = cast.error();
        return {};
    }
    const LuminancePicture theirs{bench.options.size, bench.options.size, luminancesOf(cast->converged)};
    report.surfaces.push_back({shape, "vtk", rippleOf(theirs, theirs, counts)});
    return keepPicture(bench, shape, "vtk", cast->converged);
}

// White everywhere, and denser with the value, so that brightness rises with the values.
TransferFunction rampOver(double mostValue) {
    TransferFunction function;
    function.name = "ramp";
    function.unit = Unit::raw;
    function.opacity = {{0.0, 0.0}, {mostValue, 0.2}};
    function.colour = {{0.0, glm::dvec3(1.0)}};
    return function;
}

// The mean of each column.
std::vector<double> columnsOf(const LuminancePicture& picture) {
    std::vector<double> columns(std::size_t(picture.width));
    for (std::size_t i = 0; i < picture.luminance.size(); ++i)
        columns[i % std::size_t(picture.width)] += picture.luminance[i] / picture.height;
    return columns;
}

double contrastOf(Detail detail, const std::vector<double>& columns) {
    const double mmPerColumn = kDetailHeightMm / double(columns.size());
    if (detail == Detail::lines) {
        double mean = 0.0;
        glm::dvec2 wave(0.0);
        for (std::size_t x = 0; x < columns.size(); ++x) {
            const double turn = 2.0 * std::numbers::pi * (double(x) + 0.5) * mmPerColumn / kLinePeriodMm;
            mean += columns[x];
            wave += 2.0 * columns[x] * glm::dvec2(std::cos(turn), std::sin(turn));
        }
        return glm::length(wave) / mean;
    }
    // The background is farther than 4 mm from the middle.
    double most = 0.0;
    double around = 0.0;
    int count = 0;
    for (std::size_t x = 0; x < columns.size(); ++x) {
        most = std::max(most, columns[x]);
        if (std::abs((double(x) + 0.5) * mmPerColumn - 0.5 * kDetailHeightMm) < 4.0) continue;
        around += columns[x];
        ++count;
    }
    around /= count;
    return (most - around) / around;
}

Result<void> measureDetail(const Bench& bench, Detail detail, InterpolationReport& report) {
    const trace::View view = viewOf(kDetailHeightMm, kDetailSize);
    const BenchStudy study =
        studyOf(bench, make(detail), rampOver(1000.0), trace::Environment::constant(glm::vec3(1.0f)), view);
    MACULA_TRY(trace::PathTracer tracer, study.makeTracer());
    double trilinear = 0.0;
    for (const Filter filter : trace::kFilters) {
        MACULA_TRY(const LuminancePicture picture,
                   draw(tracer, {.bounces = 1, .filter = filter}, bench.options.samples, bench.progress));
        const double contrast = contrastOf(detail, columnsOf(picture));
        if (filter == Filter::trilinear) trilinear = contrast;
        report.details.push_back({detail, filter, contrast, contrast / trilinear});
    }
    return {};
}

}  // namespace

std::vector<std::uint8_t> middleOf(Shape shape, int size, double heightMm) {
    const double most = kShapeRadiusMm * std::sin(glm::radians(kMostTurnedDeg));
    std::vector<std::uint8_t> counts(std::size_t(size) * std::size_t(size));
    for (std::size_t i = 0; i < counts.size(); ++i) {
        const int column = static_cast<int>(i) % size;
        const int row = static_cast<int>(i) / size;
        const double x = ((column + 0.5) / size - 0.5) * heightMm;
        const double y = (0.5 - (row + 0.5) / size) * heightMm;
        const double away = shape == Shape::plane      ? 0.0
                            : shape == Shape::cylinder ? std::abs(x - y * std::tan(glm::radians(10.0)))
                                                       : std::hypot(x, y);
        counts[i] = away < most ? 1 : 0;
    }
    return counts;
}

Result<void> check(const InterpolationOptions& options) {
    MACULA_TRY_VOID(scene::choosePreset(options.preset));
    MACULA_TRY_VOID(scene::chooseLights(options.lights));
    pictures::OutputFiles files(options.overwrite);
    files.read(options.preset);
    files.read(options.lights);
    if (options.pictures.empty()) return {};
    for (const Shape shape : kShapes) {
        for (const Subject& subject : subjects())
            MACULA_TRY_VOID(files.write(pictureOf(options, shape, subject.by)));
        MACULA_TRY_VOID(files.write(pictureOf(options, shape, "vtk")));
    }
    return {};
}

Result<InterpolationReport> measureInterpolation(const InterpolationOptions& options, Progress& progress) {
    MACULA_TRY(const presets::ImportedPreset preset, scene::choosePreset(options.preset));
    MACULA_TRY(const trace::Environment lights, scene::chooseLights(options.lights));
    MACULA_TRY(const gpu::Instance instance, gpu::Instance::create());
    MACULA_TRY(auto device, gpu::Device::create(instance, live::deviceOptions(options.device)));
    const Bench bench{options, std::move(device), progress};
    InterpolationReport report{
        .device = bench.device->info().name, .surfaces = {}, .details = {}, .withoutVtk = {}};
    // Each shape needs two path-traced pictures for each filter, and one ray-cast picture for three filters.
    const std::size_t ofShape = 2 * trace::kFilters.size() * options.samples + 3 * kCastSamples;
    progress.beginStage(Text("Drawing shapes"), kShapes.size() * ofShape);
    for (const Shape shape : kShapes)
        MACULA_TRY_VOID(measureSurface(bench, shape, preset.function, lights, report));
    progress.beginStage(Text("Drawing fine detail"),
                        kDetails.size() * trace::kFilters.size() * options.samples);
    for (const Detail detail : kDetails) MACULA_TRY_VOID(measureDetail(bench, detail, report));
    return report;
}

nlohmann::ordered_json reportOf(const InterpolationOptions& options, const InterpolationReport& report) {
    nlohmann::ordered_json json{{"benchmark", "interpolation"},
                                {"version", MACULA_VERSION},
                                {"device", report.device},
                                {"preset", scene::publicPresetName(options.preset)},
                                {"lights", scene::publicLightsName(options.lights)},
                                {"picture", {options.size, options.size}},
                                {"samplesPerPixel", options.samples}};
    json["surfaces"] = nlohmann::ordered_json::array();
    for (const SurfaceRow& row : report.surfaces)
        json["surfaces"].push_back({{"shape", nameOf(row.shape)},
                                    {"by", row.by},
                                    {"ripple", row.ripple.relative},
                                    {"least", row.ripple.least},
                                    {"luminance", row.ripple.mean}});
    json["details"] = nlohmann::ordered_json::array();
    for (const DetailRow& row : report.details)
        json["details"].push_back({{"detail", nameOf(row.detail)},
                                   {"filter", trace::nameOf(row.filter)},
                                   {"contrast", row.contrast},
                                   {"kept", row.kept}});
    if (report.withoutVtk) json["withoutVtk"] = report.withoutVtk->message.english();
    return json;
}

}  // namespace macula::evaluate
