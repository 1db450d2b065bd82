// What an edit shows before anything of it is traced: the model of before, estimated as live::EstimatedModel
// does it for a window, beside a small traced picture scaled up, each compared with what is traced of the
// same settings.
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
    std::filesystem::path pictures = {};  // a folder for NAME.png, NAME-small.png, NAME-traced.png; none
};

struct EditScore {
    double flip = 0.0;
    // Pixels that show background where the traced picture is opaque, and the other way round, as parts of
    // the picture.
    double lacks = 0.0;
    double remains = 0.0;
};

struct Edit {
    std::string name;  // "clip 0.25", "shift 50", "preset ct-bone"; may be told
    // From the settings to a model that can be drawn. That of "opening" goes through the volume first, and
    // that of "none" through the model.
    double estimateMs = 0.0;
    std::vector<StageTimes> stages;  // of estimateMs
    double drawMs = 0.0;             // of a frame of it
    std::size_t splats = 0;
    EditScore estimated;
    EditScore small;
};

struct EditsReport {
    glm::ivec2 smallPx{0};  // what a window shows while an edit is not learnt, on a CPU
    std::vector<Edit> edits;
};

// From the front: "opening", before anything was learnt; and of a model, "none", a plane that goes into what
// can be seen, its face in grey values too, the curve shifted both ways by part of the width of what it
// shows, and the study's second preset where it has one. `cancelled`; inputNotUsable when nothing can be
// seen; usage for a preset with a gradient opacity, which is not estimated.
Result<EditsReport> measureEdits(const BenchStudy& study, const EditsOptions& options, Progress& progress);

}  // namespace macula::evaluate
