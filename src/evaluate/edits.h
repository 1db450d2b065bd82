// Measures what a person sees just after an edit: the earlier model, estimated as live::EstimatedModel does
// for a window, or a small traced picture scaled up. Both are compared with a traced picture of the same
// settings.
#pragma once

#include <cstdint>
#include <filesystem>
#include <glm/glm.hpp>
#include <string>
#include <vector>

#include "base/progress.h"
#include "base/result.h"
#include "base/timeline.h"
#include "evaluate/bench_study.h"
#include "pipeline/hybrid/model/first_model.h"

namespace macula::evaluate {

struct EditsOptions {
    glm::ivec2 sizePx{512, 512};
    double verticalFovDeg = 40.0;
    std::uint32_t truthSamples = 128;  // not denoised
    hybrid::FirstModelOptions model;
    std::filesystem::path pictures = {};  // folder for NAME.png, NAME-small.png, NAME-traced.png; empty: none
};

struct EditScore {
    double flip = 0.0;
    // The parts of the picture that show background where the traced one is opaque (`lacks`), and the other
    // way round (`remains`).
    double lacks = 0.0;
    double remains = 0.0;
};

struct Edit {
    std::string name;  // "clip 0.25", "shift 50", "preset ct-bone"; nothing private
    // From the settings to a drawable model. That of "opening" includes a pass over the volume, and that of
    // "none" one over the model.
    double estimateMs = 0.0;
    std::vector<StageTimes> stages;  // of estimateMs
    double drawMs = 0.0;             // of a frame of the estimate
    std::size_t splats = 0;
    EditScore estimated;
    EditScore small;
};

struct EditsReport {
    glm::ivec2 smallPx{0};  // size of the small pictures, as on a CPU
    std::vector<Edit> edits;
};

// From the front. "opening" is before anything was learnt. With a model: "none", no edit; a plane at two
// depths in the visible matter, the deeper also with grey faces; the curve shifted both ways by part of its
// effective range; and the study's second preset, if it has one. Fails with `cancelled`; with inputNotUsable
// if nothing can be seen; with usage for a preset with a gradient opacity, which is not estimated.
Result<EditsReport> measureEdits(const BenchStudy& study, const EditsOptions& options, Progress& progress);

}  // namespace macula::evaluate
