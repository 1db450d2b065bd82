// macula splat-render MODEL --cameras FILE -o DIR: pictures of a model of Gaussians, ours or another's.
#include <CLI/App.hpp>
#include <CLI/Option.hpp>
#include <CLI/Validators.hpp>
#include <chrono>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>

#include "base/progress_bar.h"
#include "cli/command.h"
#include "cli/shared/interrupt.h"
#include "cli/shared/name_option.h"
#include "cli/shared/number_range.h"
#include "cli/shared/output_options.h"
#include "cli/shared/report.h"
#include "live/device/open_device.h"
#include "pictures/model_picture.h"
#include "pictures/output_files.h"
#include "pictures/picture_names.h"
#include "scene/camera/framed_model.h"
#include "scene/camera/splat_cameras.h"
#include "scene/camera/view_directions.h"
#include "scene/choice/typed_values.h"

namespace macula::cli {
namespace {

namespace fs = std::filesystem;

using Cameras = std::vector<scene::SplatCamera>;

struct SplatRenderOptions {
    fs::path model;
    std::vector<std::string> camera;
    fs::path cameras;
    std::vector<ViewDirection> from;
    fs::path output;
    std::string background = "0,0,0";
    std::string size;
    std::optional<double> near;  // in the unit of the model
    std::optional<double> exposure;
    std::optional<splat::LowPass> lowPass;
    bool depth = false;
    bool overwrite = false;
    std::string device;
};

// Of models made elsewhere.
const std::map<std::string, splat::LowPass> kForeignLowPasses{{"3dgs", splat::LowPass::classic},
                                                              {"antialiased", splat::LowPass::compensated},
                                                              {"mip", splat::LowPass::mip}};

struct Shot {
    std::string name;
    splat::RasterView view;
    fs::path png;
    fs::path exr;  // empty: not wanted
};

Result<std::optional<glm::ivec2>> sizeOf(const SplatRenderOptions& options) {
    if (options.size.empty()) return std::optional<glm::ivec2>();
    MACULA_TRY(const glm::ivec2 size, scene::parseSize(options.size));
    return std::optional(size);
}

Result<std::vector<Shot>> shotsOf(const Cameras& cameras, const SplatRenderOptions& options) {
    std::vector<std::string> requests;
    for (const scene::SplatCamera& camera : cameras) requests.push_back(camera.name);
    const std::vector<std::string> names = pictures::pictureNames(requests);
    std::vector<Shot> shots;
    pictures::OutputFiles files(options.overwrite);
    files.read(options.model);
    files.read(options.cameras);
    for (const std::string& camera : options.camera) files.read(camera);
    std::error_code error;
    const bool isThere = fs::is_directory(options.output, error);
    for (std::size_t i = 0; i < cameras.size(); ++i) {
        Shot shot{.name = names[i],
                  .view = cameras[i].view,
                  .png = options.output / (names[i] + ".png"),
                  .exr = options.depth ? options.output / (names[i] + ".exr") : fs::path()};
        if (isThere) {
            MACULA_TRY_VOID(files.write(shot.png));
            MACULA_TRY_VOID(files.write(shot.exr));
        }
        shots.push_back(std::move(shot));
    }
    return shots;
}

Error aboutShot(Error error, const Shot& shot) {
    if (error.code == ErrorCode::outOfMemory)
        error.hint = Text("{} --size sets it for all cameras.", error.hint);
    if (error.where.empty()) error.where = shot.name;
    return error;
}

// Around the model, for which no camera was given.
Result<Cameras> camerasAround(const splat::Splats& splats, const SplatRenderOptions& options,
                              const std::optional<glm::ivec2>& size) {
    MACULA_TRY(Cameras cameras,
               scene::framedCameras(splats, options.from, size.value_or(scene::kDefaultCameraSize)));
    if (splats.axes == splat::Axes::unknown)
        printNote(
            "This model does not say which way is up: it is drawn along its own +z, -y up. --camera or "
            "--cameras draw it from elsewhere.");
    return cameras;
}

// Each of a few; of many how many, and where.
void printShots(const std::vector<Shot>& shots, const fs::path& folder,
                std::chrono::steady_clock::time_point begin) {
    constexpr std::size_t kFew = 8;
    if (shots.size() > kFew) {
        printWritten(folder, begin, fmt::format("{} pictures", shots.size()));
        return;
    }
    for (const Shot& shot : shots) {
        printWritten(shot.png, begin);
        if (!shot.exr.empty()) printWritten(shot.exr, begin);
    }
}

Result<void> splatRender(const SplatRenderOptions& options) {
    const auto begin = std::chrono::steady_clock::now();
    MACULA_TRY(const glm::vec3 background, scene::parseBackground(options.background));
    MACULA_TRY(const std::optional<glm::ivec2> size, sizeOf(options));
    MACULA_TRY(Cameras cameras, scene::readSplatCameras(options.cameras, options.camera, size));
    const bool isGiven = !cameras.empty();
    MACULA_TRY(std::vector<Shot> shots, shotsOf(cameras, options));
    MACULA_TRY(const pictures::ModelToDraw model, pictures::readModelToDraw(options.model, options.lowPass));
    const splat::Splats& splats = model.splats;
    printNotes(model.notes);
    if (options.exposure && splats.colourSpace == splat::ColourSpace::display)
        printNote("The colours of this model are those of the display: --exposure does nothing.");
    if (!isGiven) {
        MACULA_TRY(cameras, camerasAround(splats, options, size));
        MACULA_TRY(shots, shotsOf(cameras, options));
    }
    for (Shot& shot : shots) {
        shot.view.eyeMm -= splats.originMm;
        shot.view.nearMm = options.near.value_or(isGiven ? scene::usualNearOf(splats) : shot.view.nearMm);
        MACULA_TRY_VOID(splat::validate(shot.view));
    }
    MACULA_TRY(gpu::LastingDevice device, live::openDevice(options.device, printNote));

    Progress progress(terminalProgressBar(), interruptToken());
    progress.beginStage(Text("Drawing"), shots.size());
    const splat::DisplayOptions display{background, static_cast<float>(options.exposure.value_or(1.0))};
    std::size_t done = 0;
    std::vector<std::string> empty;
    const auto stopped = [&] {
        return Error{ErrorCode::cancelled,
                     Text("Stopped; {} of {} pictures were written.", done, shots.size())};
    };
    const auto drawRest = [&](const std::shared_ptr<gpu::Device>& on) -> Result<void> {
        MACULA_TRY(splat::ModelPainter painter, splat::ModelPainter::create(on, splats));
        for (; done < shots.size(); ++done) {
            if (progress.cancelled()) return stopped();
            const Shot& shot = shots[done];
            const Result<pictures::ModelPicture> drawn =
                pictures::drawModel(painter, shot.view, splats.colourSpace, display, options.depth, progress);
            if (!drawn)
                return drawn.error().code == ErrorCode::cancelled ? stopped()
                                                                  : aboutShot(drawn.error(), shot);
            // Not before there is something to put in.
            MACULA_TRY_VOID(pictures::makePictureFolder(options.output));
            MACULA_TRY_VOID(
                writeModelPicture(*drawn, shot.view.sizePx, shot.png, shot.exr,
                                  pictures::metadata(splats, display, gpu::describe(on->info()))));
            if (splats.size() > 0 && drawn->isEmpty) empty.push_back(shot.name);
            progress.advance();
        }
        return {};
    };
    MACULA_TRY_VOID(device.run(drawRest));
    printShots(shots, options.output, begin);
    if (!empty.empty())
        printNote(
            fmt::format("Nothing of the model is in {} of {} pictures ({} first): check that camera and "
                        "model have the same axes and unit, and --near.",
                        empty.size(), shots.size(), empty.front()));
    return {};
}

}  // namespace

void addSplatRender(CLI::App& app, Action& action) {
    auto options = std::make_shared<SplatRenderOptions>();
    SplatRenderOptions& o = *options;
    auto* command = app.add_subcommand("splat-render", "Draw a model of 3D Gaussians, Macula's or another's");
    command->add_option("MODEL", o.model, "Model: .ply (in the manner of 3DGS), .spz, .glb or .macula")
        ->required();
    auto* camera =
        command
            ->add_option("--camera", o.camera,
                         "JSON file: positionMm, targetMm, up, verticalFovDeg; in the model's axes and unit. "
                         "May be repeated")
            ->allow_extra_args(false);  // one each: what follows is the model
    auto* cameras = command
                        ->add_option("--cameras", o.cameras,
                                     "cameras.json as trainers write it beside a model; one picture for each")
                        ->excludes(camera);
    command
        ->add_option(
            "--from", o.from,
            "Where the viewer stands, all of the model in view; Macula's models only. May be repeated "
            "(default without cameras: anterior; of others along their own +z)")
        ->allow_extra_args(false)
        ->transform(asViewDirection())
        ->option_text(kViewDirectionNames)
        ->excludes(camera)
        ->excludes(cameras);
    command
        ->add_option(
            "-o,--output", o.output,
            "Folder for the pictures, named by img_name, camera file or direction; made if it is not there")
        ->required();
    addOverwrite(*command, o.overwrite);
    command->add_option("--background", o.background, "As displayed, each 0 to 1 (default: 0,0,0)")
        ->option_text("R,G,B");
    command
        ->add_option("--size", o.size,
                     "Picture size, same vertical field of view (default: the camera's, or 768x768)")
        ->option_text("WxH");
    command
        ->add_option("--near", o.near,
                     "What is nearer to the eye is not drawn; in the model's unit (default: 0.2, or 2 mm for "
                     "Macula's models)")
        ->check(between(1e-3, 1e6));
    command
        ->add_option("--low-pass", o.lowPass,
                     "How the model was trained to be drawn, where its file does not tell: 3dgs; antialiased "
                     "(3DGS and gsplat with antialiasing); mip (Mip-Splatting whose filter is fused)")
        ->transform(CLI::CheckedTransformer(kForeignLowPasses))
        ->option_text("NAME");
    command
        ->add_option("--exposure", o.exposure,
                     "Multiplies the picture before the tone map (default: 1); Macula's models only")
        ->check(between(1e-6, 1e6));
    command->add_flag("--depth", o.depth,
                      "Write NAME.exr too: linear premultiplied radiance, and mean depth along the view (Z)");
    command->add_option("--device", o.device, "Number or part of the name, see macula devices");
    command->callback([options, &action] { action = [options] { return splatRender(*options); }; });
}

}  // namespace macula::cli
