#include "pictures/picture_effort.h"

#include "pipeline/trace/look.h"
#include "scene/choice/quality_choice.h"

namespace macula::app {

Result<Effort> effortOf(const EffortWish& wish, const trace::Settings& settings) {
    Effort effort{.settings = settings};
    // Path tracing needs many samples; ray casting has no noise, and needs a few for smooth edges.
    if (!trace::isPathTraced(settings.look)) effort.samplesPerPixel = 8;
    if (!wish.quality.empty()) {
        MACULA_TRY(const trace::Quality quality, chooseQuality(wish.quality));
        effort.samplesPerPixel = quality.samplesPerPixel;
        effort.settings.bounces = quality.bounces;
        effort.settings.filter = quality.filter;
        effort.settings.denoising = quality.denoising;
    }
    effort.samplesPerPixel = wish.samplesPerPixel.value_or(effort.samplesPerPixel);
    effort.settings.bounces = wish.bounces.value_or(effort.settings.bounces);
    effort.settings.filter = wish.filter.value_or(effort.settings.filter);
    if (wish.denoise)
        effort.settings.denoising = *wish.denoise ? trace::Denoising::on : trace::Denoising::off;
    effort.settings.errorThreshold = wish.error;
    if (wish.error > 0.0) effort.samplesPerPixel = wish.samplesPerPixel.value_or(kMostSamplesPerPixel);
    return effort;
}

}  // namespace macula::app
