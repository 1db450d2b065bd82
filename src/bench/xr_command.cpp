// macula-bench xr [PATH]: whether frames in a headset are in time, and where their time goes.
#include <CLI/App.hpp>

#include "bench/command.h"

#ifdef MACULA_HAS_XR

#include <CLI/Option.hpp>
#include <memory>
#include <nlohmann/json.hpp>

#include "base/progress_bar.h"
#include "cli/shared/interrupt.h"
#include "cli/shared/json_text.h"
#include "cli/shared/number_range.h"
#include "cli/shared/report.h"
#include "cli/shared/study_options.h"
#include "scene/choice/typed_values.h"
#include "xr/study_in_headset.h"

namespace macula::bench {

namespace {

struct BenchXrOptions {
    xr::HeadsetRequest request;
    int frames = 900;
    int warmUpFrames = 90;
    std::string size;
    bool json = false;
};

nlohmann::ordered_json jsonOf(const xr::HeadsetFigures& figures) {
    const xr::FrameFigures& times = figures.times;
    const xr::FrameTimes& mean = times.mean;
    return {{"benchmark", "xr"},
            {"version", MACULA_VERSION},
            {"device", figures.device},
            {"runtime", figures.runtime},
            {"headset", figures.headset},
            {"eyePx", {figures.eyePx.x, figures.eyePx.y}},
            {"results",
             {{"frames", times.frames},
              {"framesEmpty", times.empty},
              {"periodMs", times.periodMs},
              {"inTimePercent", times.inTimePercent()},
              {"timesMissed", times.missed},
              {"framesLate", times.late},
              {"framesUnsubmitted", figures.unsubmitted},
              {"longestMs", times.longestMs},
              {"meanMs",
               {{"wait", mean.waitMs},
                {"look", mean.lookMs},
                {"images", mean.lendMs},
                {"tell", mean.drawMs},
                {"submit", mean.submitMs},
                {"device", mean.deviceMs},
                {"drawn", mean.drawnMs},
                {"work", mean.workMs}}},
              {"governor",
               {{"stepsDown", figures.stepsDown},
                {"stepsUp", figures.stepsUp},
                {"levelAtEnd", times.lastLevel},
                {"levelAtMost", times.worstLevel}}},
              {"sessions", figures.sessions}}}};
}

Result<void> benchXr(BenchXrOptions options) {
    if (!options.size.empty()) {
        MACULA_TRY(options.request.show.eyePx, scene::parseSize(options.size));
    }
    options.request.show.warmUpFrames = std::uint64_t(options.warmUpFrames);
    options.request.show.frames = std::uint64_t(options.frames) + options.request.show.warmUpFrames;
    Progress progress(terminalProgressBar(), cli::interruptToken());
    MACULA_TRY(const xr::HeadsetFigures figures,
               xr::showStudy(
                   options.request, [](const std::string& sentence) { cli::printNote(sentence); }, progress));
    if (options.json) {
        fmt::print("{}\n", cli::jsonText(jsonOf(figures)));
        return {};
    }
    fmt::print(
        "{}, {}, {}x{} pixels for each eye\n{}\nGovernor: {} steps down, {} up\nLost:     {} frames "
        "were begun and not submitted\n",
        figures.headset, figures.device, figures.eyePx.x, figures.eyePx.y, xr::textOf(figures.times),
        figures.stepsDown, figures.stepsUp, figures.unsubmitted);
    return {};
}

}  // namespace

void addXr(CLI::App& app, cli::Action& action) {
    auto options = std::make_shared<BenchXrOptions>();
    BenchXrOptions& o = *options;
    auto* command = app.add_subcommand(
        "xr",
        "Frames in a headset (OpenXR), while the model learns: how many are in time, and what they take");
    cli::addStudyAsOfRender(*command, o.request.path, o.request.series, o.request.how);
    command->add_option("--preset", o.request.state.preset, "As of render");
    command->add_option("--lights", o.request.lights, "Name from macula presets");
    cli::addNumber(*command, "--frames", o.frames, "Frames that are measured", 1, 1'000'000);
    cli::addNumber(*command, "--warm-up", o.warmUpFrames, "Frames before them", 0, 1'000'000);
    command->add_option("--size", o.size, "Of the picture for each eye (default: as the headset wants it)")
        ->option_text("WxH");
    command->add_flag("--room", o.request.show.showsRoom, "As of xr");
    command->add_flag("--json", o.json, "Print JSON instead of lines");
    command->callback([options, &action] { action = [options] { return benchXr(*options); }; });
}

}  // namespace macula::bench

#else

#include "cli/shared/no_headset.h"

namespace macula::bench {

void addXr(CLI::App& app, cli::Action& action) {
    cli::addWithoutHeadset(app, action, "Frames in a headset");
}

}  // namespace macula::bench

#endif
