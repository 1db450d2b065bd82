// macula sheet PATH -o FILE.png: every preset in every look on one sheet, to be judged at a glance.
#include <CLI/App.hpp>
#include <CLI/Validators.hpp>
#include <chrono>
#include <filesystem>
#include <memory>

#include "base/progress_bar.h"
#include "cli/command.h"
#include "cli/shared/interrupt.h"
#include "cli/shared/name_option.h"
#include "cli/shared/output_options.h"
#include "cli/shared/report.h"
#include "cli/shared/study_options.h"
#include "image/image_file.h"
#include "live/device/open_device.h"
#include "pictures/output_files.h"
#include "pictures/picture_file.h"
#include "pictures/preset_sheet.h"
#include "pipeline/trace/look.h"
#include "presets/catalogue.h"
#include "scene/choice/study_preset.h"
#include "study/open/loaded_study.h"

namespace macula::cli {

namespace {

struct SheetOptions {
    std::filesystem::path path;
    std::filesystem::path output;
    std::string series;
    dicom::ScanOptions how;
    std::string device;
    pictures::SheetRequest sheet;
    bool overwrite = false;
};

Result<void> makeSheet(const SheetOptions& options) {
    const auto start = std::chrono::steady_clock::now();
    MACULA_TRY_VOID(pictures::checkPictureName(options.output));
    if (pictures::isExr(options.output))
        return Error{ErrorCode::usage, Text("A sheet is for the eye."), options.output.string(),
                     Text("Choose a .png file.")};
    pictures::OutputFiles files(options.overwrite);
    files.read(options.path);
    MACULA_TRY_VOID(files.write(options.output));
    pictures::SheetRequest sheet = options.sheet;
    MACULA_TRY(sheet.presets, presets::builtInPresets());
    MACULA_TRY(gpu::LastingDevice device, live::openDevice(options.device, printNote));
    Progress progress(terminalProgressBar(), interruptToken());
    MACULA_TRY(study::LoadedStudy study,
               study::loadStudy(options.path, options.series, progress, 0, options.how));
    bringTo16Bits(study);
    printNotes(study.notes, study.warnings);
    sheet.volume = study.volume;

    std::vector<std::uint8_t> rgba;
    MACULA_TRY_VOID(device.run([&](const std::shared_ptr<gpu::Device>& on) -> Result<void> {
        MACULA_TRY(rgba, pictures::drawSheet(on, sheet, progress));
        return {};
    }));
    const glm::ivec2 size = sizeOf(sheet);
    MACULA_TRY_VOID(image::writePng(options.output, size.x, size.y, rgba, metadata(sheet, study)));
    printWritten(options.output, start);
    fmt::print("columns");
    for (const trace::LookTraits& look : trace::kLooks) fmt::print("  {}", look.name);
    fmt::print("\n");
    for (std::size_t i = 0; i < sheet.presets.size(); ++i) {
        const pictures::SheetPlace place = placeOf(sheet, i);
        fmt::print("panel {} row {:>2}  {}\n", place.panel + 1, place.row + 1, sheet.presets[i].name);
        for (const Text& note : scene::notesOf({sheet.presets[i], {}}, *study.volume))
            fmt::print("                {}\n", note.english());
    }
    return {};
}

}  // namespace

void addSheet(CLI::App& app, Action& action) {
    auto options = std::make_shared<SheetOptions>();
    SheetOptions& o = *options;
    auto* command = app.add_subcommand("sheet", "Draw every preset in every look on one sheet");
    addStudyAsOfRender(*command, o.path, o.series, o.how);
    command->add_option("-o,--output", o.output, "Picture to write: OUT.png")->required();
    command->add_option("--tile", o.sheet.tilePx, "Size of each picture in pixels (default: 160)")
        ->check(CLI::Range(16, 512));
    command->add_option("--panels", o.sheet.panels, "Columns of presets (default: 3)")
        ->check(CLI::Range(1, 8));
    command->add_option("--view", o.sheet.view, "Where the viewer stands (default: anterior)")
        ->transform(asViewDirection())
        ->option_text(kViewDirectionNames);
    command->add_option("--spp", o.sheet.samplesPerPixel, "Samples per pixel of light paths (default: 24)")
        ->check(CLI::Range(1, 4096));
    addOverwrite(*command, o.overwrite);
    command->add_option("--device", o.device, "Number or part of the name, see macula devices");
    command->callback([options, &action] { action = [options] { return makeSheet(*options); }; });
}

}  // namespace macula::cli
