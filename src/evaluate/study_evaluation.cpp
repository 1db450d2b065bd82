#include "evaluate/study_evaluation.h"

#include <algorithm>
#include <utility>

#include "live/device/scene_on_device.h"
#include "scene/choice/clip_choice.h"
#include "scene/choice/lights_choice.h"
#include "scene/choice/study_preset.h"
#include "scene/drawing/shown_clip.h"
#include "study/open/loaded_study.h"

namespace macula::evaluate {

namespace {

// An empty list becomes one empty value, which stands for the default.
template <class T>
std::vector<T> orOne(std::vector<T> values) {
    if (values.empty()) values.emplace_back();
    return values;
}

struct Study {
    study::LoadedStudy input;
    scene::ShownClip shown;
};

Result<Study> openStudy(const StudyEvaluationOptions& options, const std::filesystem::path& path,
                        const std::string& series, const EvaluationListener& listener, Progress& progress) {
    Study study;
    MACULA_TRY(study.input, study::loadStudy(path, series, progress, 0, options.how));
    bringTo16Bits(study.input);
    MACULA_TRY(const ClipPreset clip, scene::chooseClip(options.clip));
    MACULA_TRY(study.shown, scene::shownClip(clip, options.removeTable, *study.input.volume, progress));
    listener.noted(study.shown.notes, {});
    return study;
}

}  // namespace

std::size_t StudyEvaluationOptions::scenes() const {
    return std::max<std::size_t>(paths.size(), 1) * std::max<std::size_t>(presets.size(), 1);
}

Result<void> check(const StudyEvaluationOptions& options) {
    if (options.evaluation.truth.samplesPerPixel % 2 != 0)
        return Error{ErrorCode::usage,
                     Text("What is compared with is traced in two halves."),
                     {},
                     Text("Give --truth-spp an even number.")};
    if (!options.series.empty() && options.series.size() != options.paths.size())
        return Error{ErrorCode::usage,
                     Text("There is not one series for each path."),
                     {},
                     Text("Give --series once for each.")};
    for (const std::string& preset : options.presets)
        MACULA_TRY_VOID(scene::presetToDraw(preset, options.fit));
    MACULA_TRY_VOID(scene::choosePatientLights(options.lights));
    MACULA_TRY_VOID(scene::chooseClip(options.clip));
    return {};
}

Result<void> evaluateStudies(const StudyEvaluationOptions& options, gpu::LastingDevice& device,
                             const EvaluationListener& listener, Progress& progress,
                             EvaluationReport& report) {
    MACULA_TRY(const trace::Environment lights, scene::chooseLights(options.lights));
    const std::vector<std::filesystem::path> paths = orOne(options.paths);
    for (std::size_t place = 0; place < paths.size(); ++place) {
        MACULA_TRY(Study study,
                   openStudy(options, paths[place], options.series.empty() ? "" : options.series[place],
                             listener, progress));
        for (const std::string& typed : orOne(options.presets)) {
            MACULA_TRY(scene::StudyPreset preset, scene::choosePresetFor(study.input, typed, options.fit));
            listener.noted(study.input.notes, study.input.warnings);
            study.input.notes.clear();  // reported only once
            const live::StudyScene scene{.volume = study.input.volume,
                                         .function = std::move(preset.function),
                                         .clip = study.shown.clip,
                                         .environment = lights};
            EvaluatedStudy evaluated{.studyDigest = study.input.seriesDigest,
                                     .preset = preset.publicName,
                                     .voxels = study.input.volume->size(),
                                     .tableRemoved = study.shown.tableRemoved,
                                     .evaluation = {}};
            const auto use = [&](const std::shared_ptr<gpu::Device>& on) -> Result<void> {
                report.device = gpu::describe(on->info());
                MACULA_TRY(evaluated.evaluation, evaluateModel(on, scene, options.evaluation, progress));
                return {};
            };
            MACULA_TRY_VOID(device.run(use));
            MACULA_TRY_VOID(listener.evaluated(report.scenes.size(), evaluated.evaluation));
            evaluated.evaluation.pictures.clear();
            report.scenes.push_back(std::move(evaluated));
        }
    }
    return {};
}

}  // namespace macula::evaluate
