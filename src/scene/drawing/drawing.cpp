#include "scene/drawing/drawing.h"

namespace macula::scene {

glm::vec3 backgroundInWindow(const Drawing& drawing) {
    return drawing.background ? lightOf(*drawing.background) : kWindowBackground;
}

bool hasGreyFaces(const Drawing& drawing) {
    return drawing.clip && drawing.clip->hasShape() && drawing.clip->greyFaces;
}

trace::Settings settingsOfLight(const Drawing& drawing) {
    trace::Settings settings = drawing.settings;
    const trace::Settings usual;
    settings.seed = usual.seed;
    // Grey values of a clip's faces pass exposure and tone map unchanged: their light depends on both.
    if (!hasGreyFaces(drawing)) {
        settings.exposure = usual.exposure;
        settings.toneMap = usual.toneMap;
    }
    settings.denoising = usual.denoising;
    settings.errorThreshold = usual.errorThreshold;
    settings.window = usual.window;
    return settings;
}

}  // namespace macula::scene
