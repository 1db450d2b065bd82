// Evaluates the peripheral models of studies, each with one or several presets.
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
    std::vector<std::filesystem::path> paths;  // for study::loadStudy; empty: the phantom
    std::vector<std::string> series;           // one for each path, or empty
    dicom::ScanOptions how;
    std::vector<std::string> presets;  // all for each path; empty: the one that suits
    bool fit = false;
    std::string clip;  // empty: none
    bool removeTable = false;
    std::string lights;  // fixed to the patient
    EvaluationOptions evaluation;

    std::size_t scenes() const;  // number of pairs of path and preset
};

// Finds errors before any measurement. Fails as scene::presetToDraw, scene::choosePatientLights and
// scene::chooseClip do, and with usage if there is not one series for each path, or samples are odd.
Result<void> check(const StudyEvaluationOptions& options);

// Receives news during an evaluation.
struct EvaluationListener {
    // Called with sentences about a study; warnings separately.
    std::function<void(const std::vector<Text>& notes, const std::vector<Text>& warnings)> noted;
    // Called after each scene, numbered from 0; its pictures are dropped afterwards. An error ends the
    // evaluation.
    std::function<Result<void>(std::size_t scene, const SceneEvaluation& evaluation)> evaluated;
};

// Adds each scene to the report as soon as it is finished, so that a failure after hours does not lose
// earlier scenes. Fails as study::loadStudy, scene::shownClip and evaluateModel do.
Result<void> evaluateStudies(const StudyEvaluationOptions& options, gpu::LastingDevice& device,
                             const EvaluationListener& listener, Progress& progress,
                             EvaluationReport& report);

}  // namespace macula::evaluate
