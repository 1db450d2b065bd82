#include "pictures/picture_effort.h"

#include "pipeline/trace/look.h"
#include "scene/choice/quality_choice.h"

namespace macula::pictures {

Result<Effort> effortOf(const EffortRequest& request, const trace::Settings& settings) {
    Effort effort{.settings = settings};
    // Path tracing needs many samples; ray casting has no noise, and needs a few for smooth edges.
    if (!trace::isPathTraced(settings.look)) effort.samplesPerPixel = 8;
    if (!request.quality.empty()) {
        MACULA_TRY(const trace::Quality quality, scene::chooseQuality(request.quality));
        effort.samplesPerPixel = quality.samplesPerPixel;
        effort.settings.bounces = quality.bounces;
        effort.settings.filter = quality.filter;
        effort.settings.denoising = quality.denoising;
    }
    effort.samplesPerPixel = request.samplesPerPixel.value_or(effort.samplesPerPixel);
    effort.settings.bounces = request.bounces.value_or(effort.settings.bounces);
    effort.settings.filter = request.filter.value_or(effort.settings.filter);
    if (request.denoise)
        effort.settings.denoising = *request.denoise ? trace::Denoising::on : trace::Denoising::off;
    effort.settings.errorThreshold = request.error;
    if (request.error > 0.0) effort.samplesPerPixel = request.samplesPerPixel.value_or(kMostSamplesPerPixel);
    return effort;
}

}  // namespace macula::pictures
