#include "pipeline/splat/model/splat_components.h"

#include "base/check.h"

namespace macula::splat {

namespace {

// Calls body(component, number) for each parameter of a splat, in the order of shared/splat_layout.h.
template <class Model, class Body>
void forEachParameter(Model& splats, std::size_t i, const Body& body) {
    using namespace shared;
    for (int c = 0; c < 3; ++c) body(kSplatPosition + c, splats.position[i][c]);
    for (int c = 0; c < 3; ++c) body(kSplatLogScale + c, splats.logScale[i][c]);
    for (int c = 0; c < 4; ++c) body(kSplatRotation + c, splats.rotation[i][c]);
    body(kSplatOpacity, splats.opacityLogit[i]);
    for (int c = 0; c < 3; ++c) body(kSplatDc + c, splats.dc[i][c]);
    const std::size_t perSplat = shCount(splats.shDegree);
    for (std::size_t k = 0; k < perSplat; ++k)
        for (int c = 0; c < 3; ++c)
            body(kSplatSh + 3 * static_cast<int>(k) + c, splats.sh[i * perSplat + k][c]);
}

}  // namespace

std::vector<float> componentsOf(const Splats& splats) {
    const std::size_t count = splats.size();
    std::vector<float> components(count * static_cast<std::size_t>(componentCount(splats.shDegree)));
    for (std::size_t i = 0; i < count; ++i)
        forEachParameter(splats, i, [&](int component, float number) {
            components[static_cast<std::size_t>(component) * count + i] = number;
        });
    return components;
}

Splats splatsOf(std::span<const float> components, const Splats& like) {
    const auto perSplat = static_cast<std::size_t>(componentCount(like.shDegree));
    MACULA_CHECK_EQ(components.size() % perSplat, 0u);
    const std::size_t count = components.size() / perSplat;
    Splats splats{.originMm = like.originMm,
                  .axes = like.axes,
                  .colourSpace = like.colourSpace,
                  .lowPass = like.lowPass,
                  .shDegree = like.shDegree};
    splats.resize(count);
    for (std::size_t i = 0; i < count; ++i)
        forEachParameter(splats, i, [&](int component, float& number) {
            number = components[static_cast<std::size_t>(component) * count + i];
        });
    return splats;
}

}  // namespace macula::splat
