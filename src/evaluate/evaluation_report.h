// What macula-bench evaluate tells: a table for a person, JSON for what comes after.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "evaluate/model_evaluation.h"

namespace macula::evaluate {

// A scene and what came of it. No names that may say whose it is.
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

// Of each scene the mean over its views, as the protocol has it.
std::optional<Spread> spreadOverScenes(const EvaluationReport& report,
                                       std::optional<double> ViewScores::*value);

nlohmann::ordered_json toJson(const EvaluationReport& report);
std::string tableOf(const EvaluationReport& report);  // lines of text

}  // namespace macula::evaluate
