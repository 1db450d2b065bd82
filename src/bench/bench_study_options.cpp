#include "bench/bench_study_options.h"

#include <CLI/App.hpp>
#include <CLI/Option.hpp>
#include <CLI/Validators.hpp>

#include "cli/shared/number_range.h"
#include "cli/shared/study_options.h"
#include "scene/choice/lights_choice.h"

namespace macula::bench {

void addBenchStudyOptions(CLI::App& command, evaluate::BenchStudyOptions& options, int size) {
    options.size = size;
    options.lights = scene::kDefaultLights;
    command.add_option("path", options.path, "Folder or file with DICOM; the built-in phantom when absent");
    command.add_option("--series", options.series, "Which series: its number in `macula info`, or its UID");
    cli::addJoin(command, options.how);
    command.add_option("--preset", options.preset, "Preset by name, number or file; default by modality");
    command.add_option("--lights", options.lights, "Light rig by name or file")->capture_default_str();
    cli::addNumber(command, "--size", options.size, "Width and height in pixels", 8, 4096);
    command.add_option("--device", options.device, "Device by number or part of its name");
}

void addBenchCamera(CLI::App& command, evaluate::BenchStudyOptions& options) {
    command
        .add_option(
            "--camera", options.camera,
            "JSON file as of macula render (default: from the front, all of the volume in the picture)")
        ->option_text("FILE")
        ->check(CLI::ExistingFile);
}

}  // namespace macula::bench
