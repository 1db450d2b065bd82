// macula sheet PATH -o FILE.png: every preset in every look on one sheet, to be judged at a glance.
#include <CLI/App.hpp>
#include <CLI/Validators.hpp>
#include <algorithm>
#include <chrono>
#include <filesystem>
#include <map>
#include <memory>

#include "app/camera/view_directions.h"
#include "app/choice/lights_choice.h"
#include "app/open_device.h"
#include "app/study/study_input.h"
#include "app/study/study_preset.h"
#include "base/progress_bar.h"
#include "cli/command.h"
#include "cli/interrupt.h"
#include "cli/name_option.h"
#include "cli/output_file.h"
#include "cli/report.h"
#include "cli/study_options.h"
#include "image/image_file.h"
#include "pipeline/trace/path_tracer.h"
#include "pipeline/trace/scene.h"
#include "pipeline/volume/window.h"
#include "presets/catalogue.h"

namespace macula::cli {

namespace {

struct Options {
    std::filesystem::path path;
    std::filesystem::path output;
    std::string series;
    dicom::ScanOptions how;
    std::string device;
    int tile = 160;  // pixels
    int panels = 3;  // beside each other, each with its share of the presets
    ViewDirection view = ViewDirection::anterior;
    std::uint32_t samplesPerPixel = 24;
    bool overwrite = false;
};

constexpr std::uint32_t kSamplesOfCast = 4;

struct Sheet {
    int tile = 0;
    int columns = 0;
    std::vector<std::uint8_t> rgba;

    void paste(int column, int row, const std::vector<std::uint8_t>& picture) {
        const auto line = static_cast<std::size_t>(tile) * 4;
        const auto width = line * static_cast<std::size_t>(columns);
        for (int y = 0; y < tile; ++y) {
            std::copy_n(picture.begin() + static_cast<std::ptrdiff_t>(line) * y, line,
                        rgba.begin() + static_cast<std::ptrdiff_t>(width) * (row * tile + y) +
                            static_cast<std::ptrdiff_t>(line) * column);
        }
    }
};

// Presets are drawn as --preset NAME draws them; what is made for other units looks as it does there.
Result<void> drawRow(trace::PathTracer& tracer, const app::StudyInput& study, const TransferFunction& preset,
                     const Options& options, int column, int row, Sheet& sheet) {
    MACULA_TRY_VOID(tracer.setTransferFunction(preset));
    for (const trace::LookTraits& look : trace::kLooks) {
        MACULA_TRY(const trace::Environment lights,
                   app::chooseLights(look.look == trace::Look::clear ? "even" : app::kDefaultLights));
        MACULA_TRY_VOID(tracer.setEnvironment(lights));
        MACULA_TRY_VOID(
            tracer.setSettings({.look = look.look, .window = presetWindow(preset, *study.volume)}));
        MACULA_TRY(const bool whole,
                   tracer.trace(isPathTraced(look.look) ? options.samplesPerPixel : kSamplesOfCast,
                                [] { return !interruptToken().cancelled(); }));
        if (!whole) return Error{ErrorCode::cancelled, "Stopped; nothing was written.", {}, {}};
        MACULA_TRY(const std::vector<std::uint8_t> picture, tracer.readDisplay(glm::vec3(0.0f)));
        sheet.paste(column++, row, picture);
    }
    return {};
}

// What each picture is of, by its column and row from 1, and what there is to say of the study.
image::Metadata metadata(const Options& options, const app::StudyInput& study,
                         const std::vector<TransferFunction>& presets, int rows) {
    const int looks = static_cast<int>(trace::kLooks.size());
    std::string pictures;
    for (int i = 0; i < static_cast<int>(presets.size()); ++i) {
        for (int look = 0; look < looks; ++look)
            pictures += fmt::format("{}column {} row {}: {} {}", pictures.empty() ? "" : "; ",
                                    i / rows * looks + look + 1, i % rows + 1,
                                    presets[static_cast<std::size_t>(i)].name,
                                    trace::kLooks[static_cast<std::size_t>(look)].name);
    }
    return {{"Software", "Macula " MACULA_VERSION},
            {"macula:series", study.seriesDigest},
            {"macula:view", app::nameOf(options.view)},
            {"macula:samples", fmt::to_string(options.samplesPerPixel)},
            {"macula:tilePx", fmt::to_string(options.tile)},
            {"macula:pictures", pictures},
            {"macula:notes", fmt::format("{}", fmt::join(study.notes, " "))}};
}

Result<void> makeSheet(const Options& options) {
    const auto start = std::chrono::steady_clock::now();
    MACULA_TRY_VOID(checkPictureName(options.output));
    if (isExr(options.output))
        return Error{ErrorCode::usage, "A sheet is for the eye.", options.output.string(),
                     "Choose a .png file."};
    OutputFiles files(options.overwrite);
    files.read(options.path);
    MACULA_TRY_VOID(files.write(options.output));
    MACULA_TRY(const std::vector<TransferFunction> presets, presets::builtInPresets());
    MACULA_TRY(gpu::LastingDevice device, app::openDevice(options.device, printNote));
    Progress progress(terminalProgressBar(), interruptToken());
    MACULA_TRY(app::StudyInput study, app::loadStudy(options.path, options.series, progress, 0, options.how));
    bringTo16Bits(study);
    printNotes(study.notes, study.warnings);

    const int looks = static_cast<int>(trace::kLooks.size());
    Sheet sheet{.tile = options.tile, .columns = looks * options.panels, .rgba = {}};
    const int rows = (static_cast<int>(presets.size()) + options.panels - 1) / options.panels;
    sheet.rgba.resize(4 * static_cast<std::size_t>(options.tile * sheet.columns) *
                      static_cast<std::size_t>(options.tile * rows));
    const auto drawAll = [&](const std::shared_ptr<gpu::Device>& on) -> Result<void> {
        const Camera camera = frameBox(study.volume->worldBox(), options.view, 30.0, 1.0);
        MACULA_TRY(trace::PathTracer tracer, trace::PathTracer::create(on));
        MACULA_TRY_VOID(tracer.setVolume(study.volume));
        MACULA_TRY_VOID(tracer.setView({.camera = camera, .width = options.tile, .height = options.tile}));
        progress.beginStage("Drawing", presets.size());
        for (int i = 0; i < static_cast<int>(presets.size()); ++i) {
            MACULA_TRY_VOID(drawRow(tracer, study, presets[static_cast<std::size_t>(i)], options,
                                    i / rows * looks, i % rows, sheet));
            progress.advance(1);
        }
        return {};
    };
    MACULA_TRY_VOID(device.run(drawAll));
    MACULA_TRY_VOID(image::writePng(options.output, options.tile * sheet.columns, options.tile * rows,
                                    sheet.rgba, metadata(options, study, presets, rows)));
    printWritten(options.output, start);
    fmt::print("columns");
    for (const trace::LookTraits& look : trace::kLooks) fmt::print("  {}", look.name);
    fmt::print("\n");
    for (int i = 0; i < static_cast<int>(presets.size()); ++i) {
        const TransferFunction& preset = presets[static_cast<std::size_t>(i)];
        fmt::print("panel {} row {:>2}  {}\n", i / rows + 1, i % rows + 1, preset.name);
        for (const std::string& note : app::notesOf({preset, {}}, *study.volume))
            fmt::print("                {}\n", note);
    }
    return {};
}

}  // namespace

void addSheet(CLI::App& app, Action& action) {
    auto options = std::make_shared<Options>();
    Options& o = *options;
    auto* command = app.add_subcommand("sheet", "Draw every preset in every look on one sheet");
    command->add_option("PATH", o.path, "As of render (default: the phantom)");
    command->add_option("-o,--output", o.output, "Picture to write: OUT.png")->required();
    command->add_option("--series", o.series, "As of render");
    addJoin(*command, o.how);
    command->add_option("--tile", o.tile, "Size of each picture in pixels (default: 160)")
        ->check(CLI::Range(16, 512));
    command->add_option("--panels", o.panels, "Columns of presets (default: 3)")->check(CLI::Range(1, 8));
    command->add_option("--view", o.view, "Where the viewer stands (default: anterior)")
        ->transform(asViewDirection())
        ->option_text(kViewDirectionNames);
    command->add_option("--spp", o.samplesPerPixel, "Samples per pixel of light paths (default: 24)")
        ->check(CLI::Range(1, 4096));
    addOverwrite(*command, o.overwrite);
    command->add_option("--device", o.device, "Number or part of the name, see macula devices");
    command->callback([options, &action] { action = [options] { return makeSheet(*options); }; });
}

}  // namespace macula::cli
