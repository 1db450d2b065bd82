#include "pipeline/splat/draw/reference_rasterizer.h"

#include <algorithm>
#include <array>

#include "base/check.h"
#include "base/parallel.h"
#include "pipeline/splat/draw/reference_host.h"

namespace macula::splat {

namespace {

using reference::HostSingle;
using reference::HostTwofold;

// Bands of rows that are differentiated in parallel, each into its own sums. Their number is fixed, so that
// the sums do not depend on the number of cores.
constexpr std::size_t kBands = 4;

template <class Host>
typename Host::Splat splatAt(const ReferenceSplats& splats, std::size_t i) {
    using Real = typename Host::Real;
    return {splats.position[i], splats.logScale[i], splats.rotation[i], Real(splats.opacityLogit[i])};
}

// The colour of a splat before it is clamped at 0.
template <class Host>
typename Host::vec3 colourSum(Host& host, const ReferenceSplats& splats, std::size_t i) {
    using vec3 = typename Host::vec3;
    vec3 sum = host.colourOfBand0(vec3(splats.dc[i]));
    if (splats.shDegree == 0) return sum;
    const vec3 d = host.directionTo(vec3(splats.position[i]), host.frame);
    std::array<vec3, shCount(kMaxShDegree)> s{};
    const std::size_t count = shCount(splats.shDegree);
    for (std::size_t k = 0; k < count; ++k) s[k] = vec3(splats.sh[i * count + k]);
    sum += host.colourOfBand1(d, s[0], s[1], s[2]);
    if (splats.shDegree >= 2) sum += host.colourOfBand2(d, s[3], s[4], s[5], s[6], s[7]);
    if (splats.shDegree >= 3) sum += host.colourOfBand3(d, s[8], s[9], s[10], s[11], s[12], s[13], s[14]);
    return sum;
}

// A splat in the picture, and the pixels that it may touch.
template <class Host>
struct Layer {
    std::uint32_t index = 0;
    typename Host::ScreenSplat screen{};
    typename Host::vec3 colourSum{};
    typename Host::vec3 colour{};
    glm::ivec2 first{0};  // pixels
    glm::ivec2 end{0};
};

template <class Host>
Layer<Host> layerOf(Host& host, const ReferenceSplats& splats, std::size_t i) {
    Layer<Host> layer{.index = static_cast<std::uint32_t>(i)};
    layer.screen = host.projectSplat(splatAt<Host>(splats, i), host.frame);
    if (!(layer.screen.opacity > 0)) return layer;
    layer.colourSum = colourSum(host, splats, i);
    if (!host.isFinite(typename Host::vec4(layer.colourSum, 0))) return {};
    layer.colour = host.visibleColour(layer.colourSum);
    host.pixelsOf(layer.screen, host.frame.sizePx, layer.first, layer.end);
    return layer;
}

template <class Host>
std::vector<Layer<Host>> layersOf(Host& host, const ReferenceSplats& splats,
                                  std::span<const std::uint32_t> order) {
    std::vector<Layer<Host>> layers;
    const std::size_t count = order.empty() ? splats.size() : order.size();
    for (std::size_t n = 0; n < count; ++n) {
        const Layer<Host> layer = layerOf(host, splats, order.empty() ? n : order[n]);
        if (layer.screen.opacity > 0) layers.push_back(layer);
    }
    if (order.empty())
        std::stable_sort(layers.begin(), layers.end(),
                         [](const auto& a, const auto& b) { return a.screen.depthMm < b.screen.depthMm; });
    return layers;
}

template <class Host>
typename Host::vec2 centreOf(int column, int row) {
    using Real = typename Host::Real;
    return {Real(column) + Real(0.5), Real(row) + Real(0.5)};
}

// Calls body(layer, column) for all pixels of a row that a splat may touch, front to back.
template <class Host, class Body>
void forEachInRow(const std::vector<Layer<Host>>& layers, int row, const Body& body) {
    for (std::size_t n = 0; n < layers.size(); ++n) {
        if (row < layers[n].first.y || row >= layers[n].end.y) continue;
        for (int column = layers[n].first.x; column < layers[n].end.x; ++column) body(n, column);
    }
}

template <class Host>
RasterImage rasterizeOn(Host prototype, const ReferenceSplats& splats, std::span<const std::uint32_t> order) {
    using Real = typename Host::Real;
    const glm::ivec2 size = prototype.frame.sizePx;
    const std::vector<Layer<Host>> layers = layersOf(prototype, splats, order);
    const auto width = static_cast<std::size_t>(size.x);
    RasterImage image{.sizePx = size,
                      .rgba = std::vector<glm::dvec4>(width * static_cast<std::size_t>(size.y)),
                      .depth = std::vector<double>(width * static_cast<std::size_t>(size.y))};
    parallelFor(static_cast<std::size_t>(size.y), [&](std::size_t row) {
        struct Pixel {
            Real transmittance = 1;
            typename Host::vec3 colour{0};
            Real depth = 0;
        };
        Host host = prototype;
        std::vector<Pixel> pixels(width);
        forEachInRow(layers, static_cast<int>(row), [&](std::size_t n, int column) {
            const Layer<Host>& layer = layers[n];
            Pixel& pixel = pixels[static_cast<std::size_t>(column)];
            const Real raw = host.rawAlphaAt(layer.screen, centreOf<Host>(column, static_cast<int>(row)));
            const Real weight =
                host.takeWeight(pixel.transmittance, host.limitedAlpha(raw, host.frame), host.frame);
            pixel.colour += layer.colour * weight;
            pixel.depth += layer.screen.depthMm * weight;
        });
        for (std::size_t x = 0; x < width; ++x) {
            image.rgba[row * width + x] = {glm::dvec3(pixels[x].colour), double(1 - pixels[x].transmittance)};
            image.depth[row * width + x] = double(pixels[x].depth);
        }
    });
    return image;
}

// The derivative of the loss by the projected splats, from rows [firstRow, endRow).
template <class Host>
std::vector<typename Host::ScreenGradient> screenGradients(Host host, const std::vector<Layer<Host>>& layers,
                                                           const RasterImage& image,
                                                           const RasterGradient& gradient, int firstRow,
                                                           int endRow) {
    using Real = typename Host::Real;
    using vec4 = typename Host::vec4;
    const auto width = static_cast<std::size_t>(image.sizePx.x);
    std::vector<typename Host::ScreenGradient> sums(layers.size(), host.noGradient());
    struct Pixel {
        typename Host::PixelGradient gradient{};
        Real transmittance = 1;
        Real remaining = 0;
    };
    std::vector<Pixel> pixels(width);
    for (int row = firstRow; row < endRow; ++row) {
        for (std::size_t x = 0; x < width; ++x) {
            const std::size_t i = static_cast<std::size_t>(row) * width + x;
            const typename Host::PixelGradient g{vec4(gradient.rgba[i]),
                                                 Real(gradient.depth.empty() ? 0.0 : gradient.depth[i])};
            pixels[x] = {g, 1, host.dot(vec4(image.rgba[i]), g.rgba) + Real(image.depth[i]) * g.depth};
        }
        forEachInRow(layers, row, [&](std::size_t n, int column) {
            Pixel& pixel = pixels[static_cast<std::size_t>(column)];
            host.addPixelGradient(layers[n].screen, layers[n].colour, centreOf<Host>(column, row),
                                  pixel.gradient, host.frame, pixel.transmittance, pixel.remaining, sums[n]);
        });
    }
    return sums;
}

template <class Host>
void add(typename Host::ScreenGradient& sum, const typename Host::ScreenGradient& g) {
    sum.mean += g.mean;
    sum.conic += g.conic;
    sum.opacity += g.opacity;
    sum.colour += g.colour;
    sum.depthMm += g.depthMm;
}

// The derivative by the parameters of one splat, from that by the projected splat.
template <class Host>
void writeGradient(Host& host, const ReferenceSplats& splats, const Layer<Host>& layer,
                   const typename Host::ScreenGradient& g, ReferenceSplats& result) {
    using vec3 = typename Host::vec3;
    const std::size_t i = layer.index;
    const auto bySplat = host.projectionGradient(splatAt<Host>(splats, i), host.frame, layer.screen, g);
    vec3 byPosition = bySplat.position;
    const vec3 bySum = host.sumGradient(layer.colourSum, g.colour);
    result.dc[i] = bySum * host.band0Slope();
    if (splats.shDegree == 1) {
        const vec3 position(splats.position[i]);
        const auto bySh = host.band1Gradient(host.directionTo(position, host.frame), bySum);
        result.sh[3 * i] = bySh.s1;
        result.sh[3 * i + 1] = bySh.s2;
        result.sh[3 * i + 2] = bySh.s3;
        byPosition +=
            host.colourPositionGradient(position, host.frame, vec3(splats.sh[3 * i]),
                                        vec3(splats.sh[3 * i + 1]), vec3(splats.sh[3 * i + 2]), bySum);
    }
    result.position[i] = byPosition;
    result.logScale[i] = bySplat.logScale;
    result.rotation[i] = bySplat.rotation;
    result.opacityLogit[i] = double(bySplat.opacityLogit);
}

template <class Host>
ReferenceSplats backwardOn(Host host, const ReferenceSplats& splats, const RasterImage& image,
                           const RasterGradient& gradient, std::span<const std::uint32_t> order) {
    const std::vector<Layer<Host>> layers = layersOf(host, splats, order);
    const int rows = image.sizePx.y;
    std::array<std::vector<typename Host::ScreenGradient>, kBands> bands;
    parallelFor(kBands, [&](std::size_t band) {
        const int first = static_cast<int>(band) * rows / int(kBands);
        const int end = static_cast<int>(band + 1) * rows / int(kBands);
        bands[band] = screenGradients(host, layers, image, gradient, first, end);
    });
    ReferenceSplats result(splats.size(), splats.shDegree);
    for (std::size_t n = 0; n < layers.size(); ++n) {
        typename Host::ScreenGradient sum = host.noGradient();
        for (const auto& band : bands) add<Host>(sum, band[n]);
        writeGradient(host, splats, layers[n], sum, result);
    }
    return result;
}

// Calls use(host) with the host class of that precision.
template <class Use>
auto withHost(const RasterView& view, const Blending& blending, Precision precision, const Use& use) {
    MACULA_CHECK(validate(view).ok());
    MACULA_CHECK(validate(blending).ok());
    if (precision == Precision::twofold) return use(HostTwofold(view, blending));
    return use(HostSingle(view, blending));
}

}  // namespace

std::vector<ProjectedSplat> projectSplats(const ReferenceSplats& splats, const RasterView& view,
                                          const Blending& blending, Precision precision) {
    return withHost(view, blending, precision, [&](auto host) {
        std::vector<ProjectedSplat> projected(splats.size());
        for (std::size_t i = 0; i < splats.size(); ++i) {
            const auto layer = layerOf(host, splats, i);
            projected[i] = {.mean = layer.screen.mean,
                            .conic = layer.screen.conic,
                            .opacity = double(layer.screen.opacity),
                            .depthMm = double(layer.screen.depthMm),
                            .extent = layer.screen.extent,
                            .colour = layer.colour};
        }
        return projected;
    });
}

RasterImage rasterize(const ReferenceSplats& splats, const RasterView& view, const Blending& blending,
                      Precision precision, std::span<const std::uint32_t> order) {
    return withHost(view, blending, precision, [&](auto host) { return rasterizeOn(host, splats, order); });
}

ReferenceSplats rasterizeBackward(const ReferenceSplats& splats, const RasterView& view,
                                  const Blending& blending, const RasterImage& image,
                                  const RasterGradient& gradient, Precision precision,
                                  std::span<const std::uint32_t> order) {
    MACULA_CHECK_LE(splats.shDegree, 1);
    MACULA_CHECK(image.sizePx == view.sizePx);
    MACULA_CHECK_EQ(gradient.rgba.size(), image.rgba.size());
    MACULA_CHECK(gradient.depth.empty() || gradient.depth.size() == image.rgba.size());
    return withHost(view, blending, precision,
                    [&](auto host) { return backwardOn(host, splats, image, gradient, order); });
}

}  // namespace macula::splat
