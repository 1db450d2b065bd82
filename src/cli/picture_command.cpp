// macula picture PATH -o FILE.png: one image as it is shown on its own.
#include <CLI/App.hpp>
#include <CLI/Validators.hpp>
#include <memory>
#include <vector>

#include "base/progress_bar.h"
#include "cli/command.h"
#include "cli/shared/interrupt.h"
#include "cli/shared/output_options.h"
#include "cli/shared/report.h"
#include "cli/shared/study_options.h"
#include "pictures/output_files.h"
#include "pictures/planar_picture.h"

namespace macula::cli {

namespace {

struct PictureOptions {
    pictures::PlanarPictureRequest request;
    std::vector<double> window;
    bool hidesOverlays = false;
    bool overwrite = false;
};

Result<void> writePicture(const PictureOptions& options) {
    pictures::PlanarPictureRequest request = options.request;
    request.hasOverlays = !options.hidesOverlays;
    if (options.window.size() == 2) request.window = std::pair(options.window[0], options.window[1]);
    pictures::OutputFiles outputs(options.overwrite);
    outputs.read(request.path);
    outputs.read(request.presentation);
    MACULA_TRY_VOID(outputs.write(request.output));
    if (request.output.extension() != ".png")
        return Error{ErrorCode::usage, Text("The picture is a PNG file."), request.output.string(),
                     Text("Give -o a name that ends with .png.")};
    Progress progress(terminalProgressBar(), interruptToken());
    MACULA_TRY(const pictures::PlanarPictureWritten written, pictures::writePlanarPicture(request, progress));
    printNotes(written.notes);
    fmt::print("Wrote image {} of {}: {} x {} pixels\n", request.image, written.images, written.columns,
               written.rows);
    return {};
}

}  // namespace

void addPicture(CLI::App& app, Action& action) {
    auto options = std::make_shared<PictureOptions>();
    pictures::PlanarPictureRequest& request = options->request;
    auto* command = app.add_subcommand(
        "picture", "Write an image that is no volume (an X-ray, a frame of ultrasound) to a PNG file");
    command->add_option("PATH", request.path, "Folder with DICOM files, or one image")->required();
    command->add_option("-o,--output", request.output, "PNG file to write, without anything but pixels")
        ->required();
    command->add_option(
        "--series", request.series,
        "Place in the list of macula info, or series UID (default: the one with most images)");
    command->add_option("--image", request.image, "Which image or frame of the series, from 1 (default: 1)")
        ->check(CLI::Range(1, 10000000));
    command
        ->add_option("--window", options->window, "Centre and width, as 40,400 (default: as the file says)")
        ->delimiter(',')
        ->expected(2);
    command->add_option("--presentation-state", request.presentation,
                        "Show it as this Grayscale Softcopy Presentation State says, but its graphics");
    command->add_flag("--no-overlays", options->hidesOverlays, "Leave out the overlays of the file");
    addOverwrite(*command, options->overwrite);
    addJoin(*command, request.how);
    command->callback([options, &action] { action = [options] { return writePicture(*options); }; });
}

}  // namespace macula::cli
