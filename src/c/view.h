// What a macula_view is: a volume, and all that was chosen of how it is drawn.
#pragma once

#include <macula.h>

#include <optional>
#include <string>
#include <vector>

#include "app/state/state_wish.h"
#include "app/study/study_input.h"
#include "base/camera.h"
#include "pipeline/volume/clip_json.h"

struct macula_view {
    macula::app::StudyInput study;  // 16 bits; without notes
    // Preset, look, table and direction. What is no name or file is beside it.
    macula::app::StateWish wish;
    std::string lights;  // empty: those for the look
    std::optional<macula::DisplayWindow> window;
    std::optional<macula::ClipPreset> clip;
    std::optional<macula::Camera> camera;

    // Of the last picture.
    std::vector<std::string> notes;
    std::string preset;
    std::string device;
};
