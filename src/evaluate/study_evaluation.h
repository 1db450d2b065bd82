// Studies, each with one or several presets, and how good their peripheral models are.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "base/progress.h"
#include "base/result.h"
#include "dicom/scan.h"
#include "evaluate/evaluation_report.h"
#include "evaluate/model_evaluation.h"
#include "pipeline/gpu/recovery.h"

namespace macula::evaluate {

struct StudyEvaluationOptions {
    std::vector<std::filesystem::path> paths;  // as study::loadStudy; none is the phantom
    std::vector<std::string> series;           // for each path, or none
    dicom::ScanOptions how;
    std::vector<std::string> presets;  // each for each path; none is the one that suits
    bool fit = false;
    std::string clip;  // empty: none
    bool removeTable = false;
    std::string lights;  // of the patient
    EvaluationOptions evaluation;

    std::size_t scenes() const;  // each path with each preset
};

// All that can be known to be wrong before anything takes time. Fails as scene::presetToDraw,
// scene::choosePatientLights and scene::chooseClip, and with usage for series that are not one for each path
// and samples that cannot be halved.
Result<void> check(const StudyEvaluationOptions& options);

// What is told on the way.
struct EvaluationListener {
    // Sentences, some of them warnings.
    std::function<void(const std::vector<Text>& notes, const std::vector<Text>& warnings)> noted;
    // Of the scene of that number, from 0; its pictures are dropped afterwards. What fails there ends it.
    std::function<Result<void>(std::size_t scene, const SceneEvaluation& evaluation)> evaluated;
};

// Adds each scene to the report as soon as it is finished, so that what fails after hours takes nothing along
// of what was finished before. Fails as study::loadStudy, scene::shownClip and evaluateModel.
Result<void> evaluateStudies(const StudyEvaluationOptions& options, gpu::LastingDevice& device,
                             const EvaluationListener& listener, Progress& progress,
                             EvaluationReport& report);

}  // namespace macula::evaluate
