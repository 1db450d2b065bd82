#include "pipeline/splat/draw/host_projection.h"

#include <algorithm>
#include <array>

#include "base/parallel.h"
#include "pipeline/splat/draw/reference_host.h"
#include "shared/splat_frame.h"

namespace macula::splat {

namespace {

using Host = reference::HostSingle;

constexpr std::size_t kSplatsAtOnce = 1 << 14;

glm::vec3 colourSum(Host& host, const Splats& splats, std::size_t i) {
    glm::vec3 sum = host.colourOfBand0(splats.dc[i]);
    if (splats.shDegree == 0) return sum;
    const glm::vec3 d = host.directionTo(splats.position[i], host.frame);
    const glm::vec3* s = &splats.sh[i * shCount(splats.shDegree)];
    sum += host.colourOfBand1(d, s[0], s[1], s[2]);
    if (splats.shDegree >= 2) sum += host.colourOfBand2(d, s[3], s[4], s[5], s[6], s[7]);
    if (splats.shDegree >= 3) sum += host.colourOfBand3(d, s[8], s[9], s[10], s[11], s[12], s[13], s[14]);
    return sum;
}

}  // namespace

std::vector<glm::vec4> projectOnHost(const Splats& splats, const RasterView& view, const Blending& blending) {
    std::vector<std::vector<glm::vec4>> parts((splats.size() + kSplatsAtOnce - 1) / kSplatsAtOnce);
    parallelFor(parts.size(), [&](std::size_t part) {
        Host host(view, blending);
        const std::size_t end = std::min(splats.size(), (part + 1) * kSplatsAtOnce);
        for (std::size_t i = part * kSplatsAtOnce; i < end; ++i) {
            const Host::ScreenSplat s = host.projectSplat(
                {splats.position[i], splats.logScale[i], splats.rotation[i], splats.opacityLogit[i]},
                host.frame);
            if (!(s.opacity > 0.0f)) continue;
            const glm::vec3 sum = colourSum(host, splats, i);
            if (!host.isFinite(glm::vec4(sum, 0.0f))) continue;
            parts[part].insert(parts[part].end(), {glm::vec4(s.mean, s.conic.x, s.conic.y),
                                                   glm::vec4(s.conic.z, s.opacity, s.depthMm, s.extent.x),
                                                   glm::vec4(host.visibleColour(sum), s.extent.y)});
        }
    });
    std::size_t count = 0;
    for (const auto& part : parts) count += part.size();
    std::vector<glm::vec4> screen;
    screen.reserve(count);
    for (auto& part : parts) {
        screen.insert(screen.end(), part.begin(), part.end());
        part = {};
    }
    return screen;
}

}  // namespace macula::splat
