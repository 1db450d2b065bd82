// macula segment PATH -o FILE: one segment of a volume, by its values, as a file for other programs.
#include <CLI/App.hpp>
#include <memory>
#include <nlohmann/json.hpp>

#include "base/progress_bar.h"
#include "cli/command.h"
#include "cli/segment_options.h"
#include "cli/shared/interrupt.h"
#include "cli/shared/json_text.h"
#include "cli/shared/report.h"
#include "pictures/output_files.h"

namespace macula::cli {

namespace {

void print(const std::string& label, const scene::WrittenRecipe& written) {
    fmt::print("{}: {} voxels, {:.3f} ml\n", label, written.found.voxels, written.found.ml);
    if (const auto& values = written.found.values)
        fmt::print("  mean {:.2f}, SD {:.2f}, from {:.2f} to {:.2f} {}\n", values->mean, values->deviation,
                   values->least, values->most, written.unit);
}

Result<void> makeSegment(const SegmentOptions& options) {
    const scene::RecipeFile file = options.whole();
    MACULA_TRY(const auto files, filesOf(file));
    pictures::OutputFiles outputs(options.overwrite);
    outputs.read(options.path);
    for (const auto& each : files) MACULA_TRY_VOID(outputs.write(each));
    Progress progress(terminalProgressBar(), interruptToken());
    const auto source = options.path == "phantom:" ? study::StudySource() : study::StudySource(options.path);
    MACULA_TRY(const study::OpenedStudy study,
               study::openStudy(source, progress, {.series = options.series, .asksWhichPatient = true}));
    if (!study.volume)
        return Error{
            ErrorCode::inputNotUsable, study.joinQuestion, {}, Text("Choose a series with --series.")};
    MACULA_TRY(const scene::WrittenRecipe written, writeRecipe(file, study, progress));
    printNotes(written.notes);
    if (options.json) {
        fmt::print("{}\n", jsonText(toJson(written)));
    } else {
        print(file.label, written);
    }
    return {};
}

}  // namespace

void addSegment(CLI::App& app, Action& action) {
    auto options = std::make_shared<SegmentOptions>();
    auto* command = app.add_subcommand(
        "segment", "Make a segment of a volume by its values, and write it as a label map, DICOM or surface");
    addSegmentOptions(*command, *options);
    command->callback([options, &action] { action = [options] { return makeSegment(*options); }; });
}

}  // namespace macula::cli
