#include "app/frame/drawing.h"

namespace macula::app {

bool hasGreyFaces(const Drawing& drawing) {
    return drawing.clip && drawing.clip->hasShape() && drawing.clip->greyFaces;
}

trace::Settings settingsOfLight(const Drawing& drawing) {
    trace::Settings settings = drawing.settings;
    const trace::Settings usual;
    settings.seed = usual.seed;
    // Grey values of a clip's faces pass the exposure unchanged: their light depends on it.
    if (!hasGreyFaces(drawing)) settings.exposure = usual.exposure;
    settings.denoising = usual.denoising;
    settings.errorThreshold = usual.errorThreshold;
    settings.window = usual.window;
    return settings;
}

}  // namespace macula::app
