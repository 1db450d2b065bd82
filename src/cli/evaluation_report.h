// What macula evaluate tells: a table for a person, JSON for what comes after.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "cli/initial_evaluation.h"

namespace macula::cli {

// A scene and what came of it. No names that may say whose it is.
struct EvaluatedStudy {
    std::string studyDigest;  // see StudyInput::seriesDigest
    std::string preset;       // public names
    glm::ivec3 voxels{0};
    bool tableRemoved = false;
    SceneEvaluation evaluation;
};

struct EvaluationReport {
    std::string device;
    std::string lights;
    std::string clip;
    InitialEvaluationOptions options;
    std::vector<EvaluatedStudy> scenes;
};

nlohmann::ordered_json toJson(const EvaluationReport& report);
std::string tableOf(const EvaluationReport& report);  // lines of text

}  // namespace macula::cli
