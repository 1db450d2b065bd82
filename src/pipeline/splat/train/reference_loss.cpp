#include "pipeline/splat/train/reference_loss.h"

#include <array>
#include <cmath>
#include <functional>

#include "base/check.h"
#include "base/glsl_in_cpp.h"
#include "base/parallel.h"

namespace macula::splat {

namespace {

#define OUT(type) type&
#define INOUT(type) type&
#define PRECISE

// A class, because the shader functions read their tables as globals, which become its members.
struct Host : GlslInCpp<double> {
    std::span<const glm::dvec4> sources = {};

    vec4 fetchSource(int index) const { return sources[static_cast<std::size_t>(index)]; }

#define float double
#include "lib/picture.glsl"
#include "lib/splat_downsample.glsl"
#include "lib/splat_loss.glsl"
#undef float
};

#undef OUT
#undef INOUT
#undef PRECISE

constexpr int kReach = 5;
constexpr double kC1 = 0.01 * 0.01;
constexpr double kC2 = 0.03 * 0.03;

std::array<double, kReach + 1> tapsOfWindow() {
    std::array<double, kReach + 1> taps{};
    double sum = 0.0;
    for (int i = 0; i <= kReach; ++i) {
        taps[std::size_t(i)] = std::exp(-0.5 * (i / 1.5) * (i / 1.5));
        sum += (i == 0 ? 1.0 : 2.0) * taps[std::size_t(i)];
    }
    for (double& tap : taps) tap /= sum;
    return taps;
}

// Threads cost more than they save for small pictures.
void forEachRow(int width, int height, const std::function<void(std::size_t)>& body) {
    if (width * height > 4096) return parallelFor(std::size_t(height), body);
    for (int row = 0; row < height; ++row) body(std::size_t(row));
}

// The pixels of a picture of this size, and which of them are known.
struct Grid {
    int width;
    int height;
    std::vector<char> known;
    std::array<double, kReach + 1> taps = tapsOfWindow();

    std::size_t at(int x, int y) const { return std::size_t(y) * std::size_t(width) + std::size_t(x); }

    // Calls body(index, tap) for each known pixel of the window around (x, y).
    template <class Body>
    void forEachAround(int x, int y, const Body& body) const {
        for (int dy = -kReach; dy <= kReach; ++dy) {
            if (y + dy < 0 || y + dy >= height) continue;
            for (int dx = -kReach; dx <= kReach; ++dx) {
                if (x + dx < 0 || x + dx >= width) continue;
                const std::size_t i = at(x + dx, y + dy);
                if (known[i] != 0) body(i, taps[std::size_t(std::abs(dx))] * taps[std::size_t(std::abs(dy))]);
            }
        }
    }
};

// The SSIM window around a pixel: 1 - SSIM, and the coefficients of its gradient. With respect to a render's
// pixel x in the window, where the target is y, the gradient is tap * (plain + ofRender x + ofTarget y).
struct Window {
    glm::dvec4 dissimilarity{0.0};
    glm::dvec4 plain{0.0};
    glm::dvec4 ofRender{0.0};
    glm::dvec4 ofTarget{0.0};
};

Window windowAround(const Grid& grid, int x, int y, const std::vector<glm::dvec4>& render,
                    const std::vector<glm::dvec4>& target) {
    double taps = 0.0;
    glm::dvec4 mx(0.0);
    glm::dvec4 my(0.0);
    grid.forEachAround(x, y, [&](std::size_t i, double tap) {
        taps += tap;
        mx += tap * render[i];
        my += tap * target[i];
    });
    mx /= taps;
    my /= taps;
    glm::dvec4 xx(0.0);
    glm::dvec4 yy(0.0);
    glm::dvec4 xy(0.0);
    grid.forEachAround(x, y, [&](std::size_t i, double tap) {
        const glm::dvec4 dx = render[i] - mx;
        const glm::dvec4 dy = target[i] - my;
        xx += tap / taps * dx * dx;
        yy += tap / taps * dy * dy;
        xy += tap / taps * dx * dy;
    });
    const glm::dvec4 a1 = 2.0 * mx * my + kC1;
    const glm::dvec4 b1 = mx * mx + my * my + kC1;
    const glm::dvec4 a2 = 2.0 * xy + kC2;
    const glm::dvec4 b2 = xx + yy + kC2;
    const glm::dvec4 byMean = a2 / b2 * (2.0 * my - 2.0 * mx * a1 / b1) / b1;
    const glm::dvec4 byXx = -a1 / b1 * a2 / b2 / b2;
    const glm::dvec4 byXy = a1 / b1 * 2.0 / b2;
    return {.dissimilarity = 1.0 - a1 / b1 * a2 / b2,
            .plain = -(byMean - 2.0 * byXx * mx - byXy * my) / taps,
            .ofRender = -2.0 * byXx / taps,
            .ofTarget = -byXy / taps};
}

// Adds loss, mean difference and gradient of LossMeasure::squared.
void addSquares(const Grid& grid, std::span<const glm::dvec4> render, std::span<const glm::dvec4> target,
                const LossOptions& options, const LossStep& step, ReferenceLoss& result) {
    const bool display = options.encode == LossEncoding::display;
    const double exposure = display ? double(options.exposure) : 1.0;
    const glm::dvec3 background(step.background);
    const double values = 4.0 * double(render.size());
    const double scale = double(step.viewWeight) * double(kSquaresWeight) / values;
    for (std::size_t i = 0; i < render.size(); ++i) {
        if (grid.known[i] == 0 || !Host{}.isFinite(render[i])) continue;
        const Host::ComparedPixel ours = Host{}.comparedPixel(render[i], background, exposure, display);
        const Host::ComparedPixel theirs = Host{}.comparedPixel(target[i], background, exposure, display);
        const glm::dvec3 colours = step.coverageOnly
                                       ? glm::dvec3(0.0)
                                       : Host{}.comparedChange(ours.over, ours.over - theirs.over, display);
        const glm::dvec4 difference(colours, ours.value.w - theirs.value.w);
        result.l1 += glm::dot(glm::abs(difference), glm::dvec4(1.0)) / values;
        result.loss += scale * glm::dot(difference, difference);
        result.gradient[i] =
            Host{}.comparedPixelBack(ours.over, 2.0 * scale * difference, background, exposure, display);
    }
}

}  // namespace

glm::dvec4 referenceCompared(const glm::dvec4& premultiplied, const LossOptions& options,
                             const glm::dvec3& background) {
    const bool display = options.encode == LossEncoding::display;
    return Host{}
        .comparedPixel(premultiplied, background, display ? double(options.exposure) : 1.0, display)
        .value;
}

ReferenceLoss referenceLoss(int width, int height, std::span<const glm::dvec4> render,
                            std::span<const glm::dvec4> target, const LossOptions& options,
                            const LossStep& step) {
    const std::size_t count = std::size_t(width) * std::size_t(height);
    MACULA_CHECK_EQ(render.size(), count);
    MACULA_CHECK_EQ(target.size(), count);
    const bool display = options.encode == LossEncoding::display;
    const double exposure = display ? double(options.exposure) : 1.0;
    const glm::dvec3 background(step.background);
    ReferenceLoss result;
    result.gradient.resize(count);

    Grid grid{width, height, std::vector<char>(count, 0)};
    std::vector<glm::dvec4> x(count);
    std::vector<glm::dvec4> y(count);
    for (std::size_t i = 0; i < count; ++i) {
        const bool finite = Host{}.isFinite(render[i]);
        grid.known[i] = Host{}.isFinite(target[i]) ? 1 : 0;
        result.unknownPixels += grid.known[i] != 0 ? 0 : 1;
        result.badRendered += finite ? 0 : 1;
        if (grid.known[i] == 0) continue;
        y[i] = referenceCompared(target[i], options, background);
        x[i] = finite ? referenceCompared(render[i], options, background) : y[i];
        if (step.coverageOnly) y[i] = glm::dvec4(glm::dvec3(x[i]), y[i].w);
    }
    if (step.measure == LossMeasure::squared) {
        addSquares(grid, render, target, options, step, result);
        return result;
    }

    const double w = step.measure == LossMeasure::similar ? double(options.dssimWeight) : 0.0;
    std::vector<Window> windows(count);
    forEachRow(width, height, [&](std::size_t row) {
        if (!(w > 0.0)) return;
        for (int column = 0; column < width; ++column) {
            const std::size_t i = grid.at(column, int(row));
            if (grid.known[i] != 0) windows[i] = windowAround(grid, column, int(row), x, y);
        }
    });
    const double values = 4.0 * double(count);
    for (std::size_t i = 0; i < count; ++i) {
        result.l1 += glm::dot(glm::abs(x[i] - y[i]), glm::dvec4(1.0)) / values;
        result.dssim += glm::dot(windows[i].dissimilarity, glm::dvec4(1.0)) / values;
    }
    result.loss = double(step.viewWeight) * ((1.0 - w) * result.l1 + w * result.dssim);

    forEachRow(width, height, [&](std::size_t row) {
        for (int column = 0; column < width; ++column) {
            const std::size_t i = grid.at(column, int(row));
            if (grid.known[i] == 0 || !Host{}.isFinite(render[i])) continue;
            glm::dvec4 ofSsim(0.0);
            grid.forEachAround(column, int(row), [&](std::size_t p, double tap) {
                const Window& window = windows[p];
                ofSsim += tap * (window.plain + window.ofRender * x[i] + window.ofTarget * y[i]);
            });
            const glm::dvec4 back =
                ((1.0 - w) * glm::sign(x[i] - y[i]) + w * ofSsim) * double(step.viewWeight) / values;
            const glm::dvec3 over = Host{}.comparedPixel(render[i], background, exposure, display).over;
            result.gradient[i] = Host{}.comparedPixelBack(over, back, background, exposure, display);
        }
    });
    return result;
}

std::vector<glm::dvec4> referenceDownsample(std::span<const glm::dvec4> pixels, const glm::ivec2& fromSize,
                                            const glm::ivec2& toSize) {
    MACULA_CHECK_EQ(pixels.size(), std::size_t(fromSize.x) * std::size_t(fromSize.y));
    const Host host{{}, pixels};
    std::vector<glm::dvec4> result;
    for (int y = 0; y < toSize.y; ++y)
        for (int x = 0; x < toSize.x; ++x)
            result.push_back(Host(host).downsampledPixel({x, y}, fromSize, toSize));
    return result;
}

}  // namespace macula::splat
