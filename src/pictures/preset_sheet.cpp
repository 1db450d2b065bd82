#include "pictures/preset_sheet.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <string>

#include "pictures/render_record.h"
#include "pipeline/trace/device_scene.h"
#include "pipeline/trace/path_tracer.h"
#include "pipeline/volume/window.h"
#include "scene/camera/view_directions.h"
#include "scene/choice/lights_choice.h"

namespace macula::pictures {

namespace {

constexpr std::uint32_t kSamplesOfCast = 4;
constexpr int kLookCount = static_cast<int>(trace::kLooks.size());

int rowsOf(const SheetRequest& request) {
    return (static_cast<int>(request.presets.size()) + request.panels - 1) / request.panels;
}

struct Sheet {
    int tilePx = 0;
    int columns = 0;
    std::vector<std::uint8_t> rgba;

    void paste(int column, int row, const std::vector<std::uint8_t>& picture) {
        const auto line = static_cast<std::size_t>(tilePx) * 4;
        const auto width = line * static_cast<std::size_t>(columns);
        for (int y = 0; y < tilePx; ++y) {
            std::copy_n(picture.begin() + static_cast<std::ptrdiff_t>(line) * y, line,
                        rgba.begin() + static_cast<std::ptrdiff_t>(width) * (row * tilePx + y) +
                            static_cast<std::ptrdiff_t>(line) * column);
        }
    }
};

// One for each of trace::kLooks that has lights; all presets share them.
using LightsOfLooks = std::vector<std::optional<trace::Environment>>;

Result<LightsOfLooks> lightsOfLooks() {
    LightsOfLooks all;
    for (const trace::LookTraits& look : trace::kLooks) {
        auto& lights = all.emplace_back();
        if (!isPathTraced(look.look)) continue;
        MACULA_TRY(lights, scene::chooseLights(std::string(scene::defaultLightsFor(look.look))));
    }
    return all;
}

Result<void> drawRow(trace::PathTracer& tracer, const SheetRequest& request, const LightsOfLooks& lights,
                     const TransferFunction& preset, const SheetPlace& place, const Progress& progress,
                     Sheet& sheet) {
    MACULA_TRY_VOID(tracer.scene().setTransferFunction(preset));
    int column = place.panel * kLookCount;
    for (std::size_t i = 0; i < trace::kLooks.size(); ++i) {
        const trace::LookTraits& look = trace::kLooks[i];
        if (lights[i]) {
            MACULA_TRY_VOID(tracer.scene().setEnvironment(*lights[i]));
        }
        MACULA_TRY_VOID(
            tracer.setSettings({.look = look.look, .window = presetWindow(preset, *request.volume)}));
        MACULA_TRY(const bool whole,
                   tracer.trace(isPathTraced(look.look) ? request.samplesPerPixel : kSamplesOfCast,
                                [&] { return !progress.cancelled(); }));
        if (!whole) return Error{ErrorCode::cancelled, Text("Stopped; nothing was written."), {}, {}};
        MACULA_TRY(const std::vector<std::uint8_t> picture, tracer.readDisplay(glm::vec3(0.0f)));
        sheet.paste(column++, place.row, picture);
    }
    return {};
}

}  // namespace

SheetPlace placeOf(const SheetRequest& request, std::size_t preset) {
    const int rows = rowsOf(request);
    return {.panel = static_cast<int>(preset) / rows, .row = static_cast<int>(preset) % rows};
}

glm::ivec2 sizeOf(const SheetRequest& request) {
    return {request.tilePx * kLookCount * request.panels, request.tilePx * rowsOf(request)};
}

Result<std::vector<std::uint8_t>> drawSheet(const std::shared_ptr<gpu::Device>& device,
                                            const SheetRequest& request, Progress& progress) {
    const glm::ivec2 size = sizeOf(request);
    Sheet sheet{.tilePx = request.tilePx, .columns = kLookCount * request.panels, .rgba = {}};
    sheet.rgba.resize(4 * static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y));
    MACULA_TRY(trace::PathTracer tracer, trace::PathTracer::create(device));
    MACULA_TRY_VOID(tracer.scene().setVolume(request.volume));
    MACULA_TRY_VOID(tracer.setView({.camera = frameBox(request.volume->worldBox(), request.view, 30.0, 1.0),
                                    .width = request.tilePx,
                                    .height = request.tilePx}));
    MACULA_TRY(const LightsOfLooks lights, lightsOfLooks());
    // Looks that use no lights need an environment all the same.
    MACULA_TRY_VOID(tracer.scene().setEnvironment(trace::Environment::constant(glm::vec3(0.0f))));
    progress.beginStage(Text("Drawing"), request.presets.size());
    for (std::size_t i = 0; i < request.presets.size(); ++i) {
        MACULA_TRY_VOID(
            drawRow(tracer, request, lights, request.presets[i], placeOf(request, i), progress, sheet));
        progress.advance(1);
    }
    return std::move(sheet.rgba);
}

image::Metadata metadata(const SheetRequest& request, const study::LoadedStudy& study) {
    std::string pictures;
    for (std::size_t i = 0; i < request.presets.size(); ++i) {
        const SheetPlace place = placeOf(request, i);
        for (int look = 0; look < kLookCount; ++look)
            pictures +=
                fmt::format("{}column {} row {}: {} {}", pictures.empty() ? "" : "; ",
                            place.panel * kLookCount + look + 1, place.row + 1, request.presets[i].name,
                            trace::kLooks[static_cast<std::size_t>(look)].name);
    }
    return {{"Software", "Macula " MACULA_VERSION},
            {"macula:series", publicSeries(study.seriesDigest)},
            {"macula:view", scene::nameOf(request.view)},
            {"macula:samples", fmt::to_string(request.samplesPerPixel)},
            {"macula:tilePx", fmt::to_string(request.tilePx)},
            {"macula:pictures", pictures},
            {"macula:notes", Text::joined(study.notes, " ").english()}};
}

}  // namespace macula::pictures
