#include "cli/addition_options.h"

#include <CLI/Option.hpp>
#include <CLI/Validators.hpp>

#include "cli/shared/name_option.h"

namespace macula::cli {

namespace {

// A second volume in the same picture.
void addSecond(CLI::App& command, pictures::AdditionRequest& o) {
    command.add_option(
        "--second", o.second.path,
        "Folder or file of a second volume, PET or another phase, in one picture with the first");
    command.add_option("--second-series", o.second.series, "As --series, of the second volume");
    command.add_option("--second-preset", o.second.preset,
                       "As --preset, of the second volume (default: the colours it has over slices)");
    command
        .add_option_function<int>(
            "--registration",
            [&o](const int& link) {
                o.second.link = static_cast<scene::SecondPlacement>(link);
                o.secondLinkIsGiven = true;
            },
            "Where the second volume lies: as its positions say (default), or searched for")
        ->transform(oneOf({{"positions", int(scene::SecondPlacement::asItLies)},
                           {"search", int(scene::SecondPlacement::search)}}))
        ->option_text("positions|search");
}

}  // namespace

void addAdditions(CLI::App& command, pictures::AdditionRequest& request) {
    command
        .add_option("--segments", request.segments,
                    "Of segmentations in the folder or of --label-map: draw alone, leave out, or colour")
        ->delimiter(',')
        ->allow_extra_args(false)
        ->option_text("keep:LABEL,hide:LABEL,colour:LABEL,…");
    command
        .add_option("--label-map", request.labelMaps,
                    "NIfTI, NRRD or MetaImage file with segments of the volume, for --segments")
        ->allow_extra_args(false);
    addSecond(command, request);
}

}  // namespace macula::cli
