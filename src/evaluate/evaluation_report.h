// The report of macula-bench evaluate: a table for a person, JSON for further processing.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "evaluate/model_evaluation.h"

namespace macula::evaluate {

// A scene and its results, without names that might identify a patient.
struct EvaluatedStudy {
    std::string studyDigest;  // see study::LoadedStudy::seriesDigest
    std::string preset;       // public names
    glm::ivec3 voxels{0};
    bool tableRemoved = false;
    SceneEvaluation evaluation;
};

struct EvaluationReport {
    std::string device;
    std::string lights;
    std::string clip;
    EvaluationOptions options;
    std::vector<EvaluatedStudy> scenes;
};

// The spread over scenes of each scene's mean over its views, as in the protocol.
std::optional<Spread> spreadOverScenes(const EvaluationReport& report,
                                       std::optional<double> ViewScores::*value);

nlohmann::ordered_json toJson(const EvaluationReport& report);
std::string tableOf(const EvaluationReport& report);  // lines of text

}  // namespace macula::evaluate
