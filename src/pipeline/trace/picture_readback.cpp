#include "pipeline/trace/picture_readback.h"

#include <algorithm>
#include <limits>

#include "pipeline/gpu/transfer.h"
#include "pipeline/trace/film.h"

namespace macula::trace {

namespace {

const glm::dvec3 kLuminance(0.2126, 0.7152, 0.0722);  // Rec. 709

// The variances of the means of luminance and of coverage. A sample's coverage is 0 or 1, and so its own
// square.
glm::vec2 varianceOfMean(const glm::vec4& sums, float squares, std::uint32_t count) {
    if (count < 2) return glm::vec2(std::numeric_limits<float>::infinity());
    const glm::dvec2 mean = glm::dvec2(glm::dot(glm::dvec3(sums), kLuminance), sums.w) / double(count);
    const glm::dvec2 meanSquare = glm::dvec2(squares, sums.w) / double(count);
    return glm::max(meanSquare - mean * mean, glm::dvec2(0.0)) / double(count - 1);
}

}  // namespace

Result<TracedImage> readImage(SampledPicture& picture) {
    MACULA_TRY_VOID(picture.prepare());
    MACULA_TRY(const Guides* guides,
               picture.guides());  // only their depths are read, not their normals
    MACULA_TRY(const std::vector<GuidePixel> pixels, guides->read());
    const Film& film = picture.accumulation().film();
    TracedImage image{.width = picture.view().width,
                      .height = picture.view().height,
                      .radiance = {},
                      .depthMm = {},
                      .variance = {},
                      .denoised = isDenoised(picture.settings())};
    MACULA_TRY(image.radiance, gpu::read<glm::vec4>(film.sums()));
    MACULA_TRY(image.samples, gpu::read<std::uint32_t>(film.counts()));
    MACULA_TRY(const auto squares, gpu::read<glm::vec2>(film.squares()));
    image.depthMm.resize(pixels.size(), std::numeric_limits<float>::infinity());
    image.variance.resize(pixels.size(), glm::vec2(std::numeric_limits<float>::infinity()));
    for (std::size_t i = 0; i < pixels.size(); ++i) {
        image.variance[i] = varianceOfMean(image.radiance[i], squares[i].x, image.samples[i]);
        image.radiance[i] /= static_cast<float>(std::max(image.samples[i], 1u));
        if (pixels[i].depthMm >= 0.0f && !isProjection(picture.settings().look))
            image.depthMm[i] = pixels[i].depthMm;
    }
    if (image.denoised) {
        MACULA_TRY(const gpu::Buffer* filtered, picture.denoised());
        MACULA_TRY(image.radiance, gpu::read<glm::vec4>(*filtered));
    }
    return image;
}

Result<TracedColours> readColours(SampledPicture& picture) {
    MACULA_TRY_VOID(picture.prepare());
    if (!picture.device()->hasUnifiedMemory()) {
        ViewReading reading;  // one wait instead of three
        MACULA_TRY_VOID(beginReading(picture, reading, {.colours = true}));
        MACULA_TRY_VOID(reading.finish());
        return reading.colours();
    }
    TracedColours colours{.width = picture.view().width,
                          .height = picture.view().height,
                          .radiance = {},
                          .samples = {},
                          .coverage = {}};
    colours.meanSamples = picture.accumulation().plan().meanSamples();
    MACULA_TRY(const Guides* guides, picture.guides());
    MACULA_TRY(colours.coverage, guides->readCoverage());
    const Film& film = picture.accumulation().film();
    MACULA_TRY(colours.samples, gpu::read<std::uint32_t>(film.counts()));
    if (isDenoised(picture.settings())) {
        MACULA_TRY(const gpu::Buffer* filtered, picture.denoised());
        MACULA_TRY(colours.radiance, gpu::read<glm::vec4>(*filtered));
        return colours;
    }
    MACULA_TRY(colours.radiance, gpu::read<glm::vec4>(film.sums()));
    for (std::size_t i = 0; i < colours.radiance.size(); ++i)
        colours.radiance[i] /= static_cast<float>(std::max(colours.samples[i], 1u));
    return colours;
}

}  // namespace macula::trace
