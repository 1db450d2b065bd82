// The phase of a study that the 3D picture shows.
#pragma once

#include <QString>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "base/volume.h"
#include "live/frame/frame_input.h"

namespace macula::viewer {

class Viewport;

struct PhaseIn3d {
    std::uint64_t number = 0;                   // from 1; 0: the study without its phases
    std::shared_ptr<const Volume> volume = {};  // null: that of the open study
    std::vector<std::string> names = {};        // as in Viewport::setStudy; empty: those of the open study
    std::vector<std::string> notes = {};  // over each picture of it: which phase it is, and what is left out
    bool isPlaying = false;               // see live::FrameInput::playsPhases
    std::shared_ptr<const live::PhaseScenes> phases = {};  // see live::FrameInput
    bool learns = false;                                   // see live::FrameInput::learnsPhases

    bool operator==(const PhaseIn3d&) const = default;
};

// Why nothing can be saved of the 3D picture as a picture of the open study: it shows another phase. Empty:
// it does not.
QString whyNotOfOpenPhase(const Viewport& viewport);

}  // namespace macula::viewer
