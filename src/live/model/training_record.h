// A record of what a model was trained on, and of its progress.
#pragma once

#include <cstdint>
#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>

#include "live/model/model_training.h"
#include "pipeline/hybrid/model/first_model.h"

namespace macula::live {

// Holds no patient data: the series is a digest, and the user's own files are named by kind only.
struct TrainingRecord {
    std::string seriesDigest;
    std::string preset;
    std::string lights;
    std::string clip;
    bool tableRemoved = false;
    // The options of a training that began here; a saved training does not record all of them.
    std::optional<hybrid::FirstModelOptions> begun;
    double budgetSeconds = 0.0;     // 0: none
    std::uint64_t stepsBefore = 0;  // steps of the training that was resumed
};

nlohmann::ordered_json toJson(const TrainingRecord& record, const Trained& trained);

// A sentence on how a training with a budget spent its time, and how many of `views` were traced.
std::string howTimeWasSpent(const Trained& trained, std::size_t views);
// Sentences on a training that stopped before all of its `steps`; its model was written to `path`.
std::string whatIsWritten(const Trained& trained, std::uint64_t steps, const std::filesystem::path& path);

}  // namespace macula::live
