// macula xr PATH: a study in a headset; macula xr --check: what is missing for that.
#include <CLI/App.hpp>

#include "cli/command.h"

#ifdef MACULA_HAS_XR

#include <CLI/Option.hpp>
#include <memory>

#include "base/progress_bar.h"
#include "cli/shared/interrupt.h"
#include "cli/shared/report.h"
#include "cli/shared/study_options.h"
#include "xr/study_in_headset.h"

namespace macula::cli {

namespace {

struct XrOptions {
    bool onlyCheck = false;
    xr::HeadsetRequest request;
};

Result<void> check() {
    const xr::Check found = xr::checkHeadset();
    const auto tell = [](const char* what, const std::string& text) {
        if (!text.empty()) fmt::print("{:<10}{}\n", what, text);
    };
    tell("Software:", found.offer.runtime);
    tell("Headset:", found.offer.headset);
    if (!found.missing) {
        fmt::print("{:<10}{}x{} pixels for each eye\n{:<10}{}\n", "Pictures:", found.offer.eyePx.x,
                   found.offer.eyePx.y, "Gaze:", found.offer.hasGaze ? "followed" : "not followed");
        if (found.offer.hasInsets)
            tell("Insets:",
                 fmt::format("{}x{} pixels for each eye", found.offer.insetPx.x, found.offer.insetPx.y));
        tell("Depths:", found.offer.takesDepth ? "taken" : "not taken");
        tell("Lenses:", found.offer.hasMask ? "what they hide is told" : "what they hide is not told");
        tell("Room:", found.offer.isSeeThrough ? "is always seen behind what is shown"
                      : found.offer.showsRoom  ? "can be seen behind what is shown"
                                               : "cannot be seen");
        fmt::print("Studies can be shown in it.\n");
        return {};
    }
    return *found.missing;
}

Result<void> show(const XrOptions& options) {
    Progress progress(terminalProgressBar(), interruptToken());
    MACULA_TRY(const xr::HeadsetFigures figures,
               xr::showStudy(
                   options.request, [](const std::string& sentence) { printNote(sentence); }, progress));
    fmt::print("{}\n", xr::textOf(figures).english());
    return {};
}

}  // namespace

void addXr(CLI::App& app, Action& action) {
    auto options = std::make_shared<XrOptions>();
    xr::HeadsetRequest& o = options->request;
    auto* command =
        app.add_subcommand("xr", "Show a study in a headset (OpenXR), or tell what is missing for it");
    addStudyAsOfRender(*command, o.path, o.series, o.how);
    auto* only = command->add_flag("--check", options->onlyCheck,
                                   "Only tell what software and headset there are, and what is missing");
    addSavedView(*command, o.state.savedView);
    command->add_option("--preset", o.state.preset, "As of render");
    command->add_option("--lights", o.lights, "Name from macula presets");
    command->add_option("--clip", o.state.clip, "As of render");
    command->add_flag("--remove-table", o.state.removeTable, "Leave out the table; CT only");
    command->add_flag("--room", o.show.showsRoom,
                      "Show the room behind the anatomy (passthrough), where the headset can");
    command->add_option("--pictures", o.pictures, "Folder for pictures that are taken in the headset");
    command->add_option("--frames", o.show.frames,
                        "End after so many frames (default: when it is ended there)");
    for (CLI::Option* option : command->get_options())
        if (option != only && option != command->get_help_ptr()) only->excludes(option);
    command->callback(
        [options, &action] { action = [options] { return options->onlyCheck ? check() : show(*options); }; });
}

}  // namespace macula::cli

#else

#include "cli/shared/no_headset.h"

namespace macula::cli {

void addXr(CLI::App& app, Action& action) {
    addWithoutHeadset(app, action, "Show a study in a headset");
}

}  // namespace macula::cli

#endif
