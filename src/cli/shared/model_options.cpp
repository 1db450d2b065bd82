#include "cli/shared/model_options.h"

#include <CLI/Option.hpp>
#include <CLI/Validators.hpp>

#include "pipeline/trace/settings.h"

namespace macula::cli {

namespace {

// More is refused by the loss on lavapipe, after all views were traced (splat/loss.h).
constexpr int kMostSizePx = 1400;

}  // namespace

ModelOptionsAdded addModelOptions(CLI::App& command, hybrid::FirstModelOptions& m) {
    ModelOptionsAdded added;
    const auto add = [&](const char* name, auto& value, const char* help, const CLI::Range& range) {
        auto* option = command.add_option(name, value, help)->capture_default_str()->check(range);
        added.ofTheStart.push_back(option);
    };
    add("--points", m.points.count, "Points on what can be seen, that the model begins with",
        CLI::Range(1u, trace::kMaxSurfacePoints));
    add("--point-paths", m.points.paths, "Paths of light for each of them", CLI::Range(1, 4096));
    add("--views", m.views, "Views that are traced to learn from", CLI::Range(0, kMostViews));
    add("--spp", m.samplesPerPixel, "Samples per pixel of these; few will do, because views light each other",
        CLI::Range(1, kMostSamplesOfView));
    add("--directions", m.directions,
        "Sides in all to learn from: those beyond --views are only lit with what these found, at little cost",
        CLI::Range(0, kMostViews));
    add("--size", m.sizePx, "Width and height in pixels of what is learnt from", CLI::Range(16, kMostSizePx));
    add("--bounces", m.bounces, "Vertices of a path", CLI::Range(1, trace::kMaxBounces));
    add("--degree", m.shDegree, "Of spherical harmonics: 1 for colours that differ by direction",
        CLI::Range(0, 1));
    add("--seed,--trial", m.trial, "Another draw of the views, their noise, and their order in training",
        CLI::Range(0, 1 << 20));
    added.iterations =
        command.add_option("--iterations", m.iterations, "Steps of training; 0: the model of points")
            ->capture_default_str()
            ->check(CLI::Range(0, kMostIterations));
    return added;
}

Result<void> checkModelOptions(const hybrid::FirstModelOptions& options) {
    if (options.iterations > 0 && options.views == 0)
        return Error{ErrorCode::usage,
                     Text("Nothing can be learnt without views."),
                     {},
                     Text("Give --views above 0, or --iterations 0.")};
    return {};
}

}  // namespace macula::cli
