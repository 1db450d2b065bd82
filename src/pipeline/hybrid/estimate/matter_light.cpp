#include "pipeline/hybrid/estimate/matter_light.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "base/parallel.h"
#include "base/timeline.h"

namespace macula::hybrid {

namespace {

constexpr std::size_t kSides = 6;

// Lights are large, so each layer blurs a beam: kStraight of it continues straight, and kBeside spreads to
// each of the four neighbours.
constexpr float kStraight = 0.4f;
constexpr float kBeside = 0.15f;

constexpr double kSidesOfSurface = 3.0;

// Finds the extinction and the opacity of each cell, without light.
LitMatter shownMatterOf(const CoarseMatter& matter, const ShownMatter& shown) {
    LitMatter matterOf{.extinctionPerMm = std::vector<float>(matter.cellCount()),
                       .opacity = std::vector<float>(matter.cellCount()),
                       .light = {}};
    const auto edge = float(matter.edgeMm());
    std::vector<float> extinction;
    for (const glm::vec4& optics : shown.optics) extinction.push_back(optics.w);
    forEachCell(matter, shown, 0, [&](std::size_t cell, PartShown part) {
        if (part == PartShown::nothing) return;
        const bool isWhole = part == PartShown::all && !shown.mask;
        const auto entries = matter.entriesOf(cell);
        float sum = 0.0f;
        for (std::size_t s = 0; s < CoarseMatter::kSamples; ++s) {
            const float one = shown.steep.empty()
                                  ? extinction[entries[s]]
                                  : shown.opticsAt(matter, entries[s], matter.voxelOf(cell, s)).w;
            if (!(one > 0.0f)) continue;
            if (isWhole || shown.shows(matter.volume(), glm::dvec3(matter.voxelOf(cell, s)))) sum += one;
        }
        if (!(sum > 0.0f)) return;
        matterOf.extinctionPerMm[cell] = sum / float(CoarseMatter::kSamples);
        matterOf.opacity[cell] = -std::expm1(-edge * matterOf.extinctionPerMm[cell]);
    });
    return matterOf;
}

// Carries the light of one side through the grid, layer by layer.
class Sweep {
  public:
    Sweep(const CoarseMatter& matter, const std::vector<float>& extinction, std::size_t side)
        : matter_(matter), extinction_(extinction), side_(side), axis_(int(side / 2)) {}

    void run(std::vector<SideLight>& light) const {
        const int u = (axis_ + 1) % 3;
        const int v = (axis_ + 2) % 3;
        const int width = matter_.size()[u];
        const int height = matter_.size()[v];
        const int depth = matter_.size()[axis_];
        const auto step = float(matter_.cellMm()[axis_]);
        std::vector<float> arriving(std::size_t(width) * std::size_t(height), 1.0f);
        std::vector<float> leaving(arriving.size());
        for (int layer = 0; layer < depth; ++layer) {
            glm::ivec3 cell{0};
            cell[axis_] = side_ % 2 == 0 ? layer : depth - 1 - layer;
            for (cell[v] = 0; cell[v] < height; ++cell[v]) {
                for (cell[u] = 0; cell[u] < width; ++cell[u]) {
                    const std::size_t at = std::size_t(cell[v]) * std::size_t(width) + std::size_t(cell[u]);
                    const std::size_t index = matter_.indexOf(cell);
                    light[index][side_] = arriving[at];
                    const float depthOfCell = extinction_[index] * step;
                    leaving[at] = depthOfCell > 0.0f ? arriving[at] * std::exp(-depthOfCell) : arriving[at];
                }
            }
            spread(leaving, width, height, arriving);
        }
    }

  private:
    // Light beyond the border is not weakened.
    static void spread(const std::vector<float>& from, int width, int height, std::vector<float>& to) {
        for (int y = 0; y < height; ++y) {
            for (int x = 0; x < width; ++x) {
                const std::size_t at = std::size_t(y) * std::size_t(width) + std::size_t(x);
                const float left = x > 0 ? from[at - 1] : 1.0f;
                const float right = x + 1 < width ? from[at + 1] : 1.0f;
                const float above = y > 0 ? from[at - std::size_t(width)] : 1.0f;
                const float below = y + 1 < height ? from[at + std::size_t(width)] : 1.0f;
                to[at] = kStraight * from[at] + kBeside * (left + right + above + below);
            }
        }
    }

    const CoarseMatter& matter_;
    const std::vector<float>& extinction_;
    std::size_t side_;
    int axis_;
};

std::array<double, 7> basisOf(const SideLight& light) {
    std::array<double, 7> basis{};
    for (std::size_t i = 0; i < kSides; ++i) basis[i] = light[i];
    basis[kSides] = 1.0;
    return basis;
}

}  // namespace

float LitMatter::openness(std::size_t cell) const {
    float sum = 0.0f;
    for (const float part : light[cell]) sum += part;
    return sum / float(kSides);
}

glm::vec3 riseAround(const CoarseMatter& matter, const LitMatter& lit, std::size_t cell) {
    const glm::ivec3 at = matter.cellAt(cell);
    glm::vec3 rise{0.0f};
    for (int axis = 0; axis < 3; ++axis) {
        glm::ivec3 below = at;
        glm::ivec3 above = at;
        below[axis] = std::max(at[axis] - 1, 0);
        above[axis] = std::min(at[axis] + 1, matter.size()[axis] - 1);
        rise[axis] = lit.opacity[matter.indexOf(above)] - lit.opacity[matter.indexOf(below)];
    }
    return rise;
}

SideLight lightOn(const CoarseMatter& matter, const LitMatter& lit, std::size_t cell) {
    const glm::vec3 rise = riseAround(matter, lit, cell);
    const float length = glm::length(rise);
    if (!(length > kSurfaceRise)) return lit.light[cell];
    const glm::ivec3 outside(glm::round(glm::vec3(matter.cellAt(cell)) - 1.2f * rise / length));
    return lit.light[matter.indexOf(glm::clamp(outside, glm::ivec3(0), matter.size() - 1))];
}

LitMatter litMatter(const CoarseMatter& matter, const ShownMatter& shown) {
    const TimelineStage stage("light of estimate");
    LitMatter lit = shownMatterOf(matter, shown);
    lit.light.resize(matter.cellCount());
    parallelFor(kSides, [&](std::size_t side) { Sweep(matter, lit.extinctionPerMm, side).run(lit.light); });
    return lit;
}

glm::vec3 reflectanceOf(const glm::vec3& albedo) {
    const glm::vec3 root = glm::sqrt(1.0f - glm::clamp(albedo, 0.0f, 1.0f));
    return (1.0f - root) / (1.0f + root);
}

glm::vec3 LightOfSides::at(const SideLight& light) const {
    glm::vec3 sum = radiance[kSides];
    for (std::size_t i = 0; i < kSides; ++i) sum += light[i] * radiance[i];
    return sum;
}

LightOfSides lightOf(const trace::Environment& environment, const glm::dmat3& worldFromVoxel) {
    LightOfSides light;
    std::array<glm::dvec3, kSides> sums{};
    std::array<double, kSides> weights{};
    constexpr double kPi = std::numbers::pi;
    for (int y = 0; y < environment.height(); ++y) {
        const double polar = kPi * (y + 0.5) / environment.height();
        for (int x = 0; x < environment.width(); ++x) {
            const double azimuth = 2.0 * kPi * ((x + 0.5) / environment.width() - 0.5);
            // The table's axes are left, superior and anterior; the world's are left, posterior and superior.
            const glm::dvec3 towards{-std::sin(polar) * std::sin(azimuth),
                                     -std::sin(polar) * std::cos(azimuth), std::cos(polar)};
            const std::size_t at = std::size_t(y) * std::size_t(environment.width()) + std::size_t(x);
            for (std::size_t side = 0; side < kSides; ++side) {
                const glm::dvec3 axis = glm::normalize(worldFromVoxel[int(side / 2)]);
                const double cosine = (side % 2 == 0 ? -1.0 : 1.0) * glm::dot(axis, towards);
                if (!(cosine > 0.0)) continue;
                const double weight = cosine * cosine * std::sin(polar);
                sums[side] += weight * glm::dvec3(environment.texels()[at].radiance);
                weights[side] += weight;
            }
        }
    }
    for (std::size_t side = 0; side < kSides; ++side) {
        if (weights[side] > 0.0)
            light.radiance[side] = glm::vec3(sums[side] / weights[side] / kSidesOfSurface);
    }
    return light;
}

// Non-negative least squares by coordinate descent (Gauss-Seidel), with a ridge towards `expected`.
LightOfSides fittedLight(std::span<const LitSample> samples, const LightOfSides& expected) {
    constexpr std::size_t kUnknowns = kSides + 1;
    constexpr int kTurns = 200;
    constexpr double kOfExpected = 0.002;  // weight of `expected` for each unit of the samples' weight
    using Row = std::array<glm::dvec3, kUnknowns>;
    std::array<Row, kUnknowns> products{};
    Row right{};
    double weights = 0.0;
    for (const LitSample& sample : samples) {
        const std::array<double, kUnknowns> basis = basisOf(sample.light);
        const glm::dvec3 reflectance(sample.reflectance);
        const glm::dvec3 radiance(sample.radiance);
        const auto weight = double(sample.weight);
        for (std::size_t i = 0; i < kUnknowns; ++i) {
            for (std::size_t j = 0; j < kUnknowns; ++j)
                products[i][j] += weight * basis[i] * basis[j] * reflectance * reflectance;
            right[i] += weight * basis[i] * reflectance * radiance;
        }
        weights += weight;
    }
    if (!(weights > 0.0)) return expected;
    Row x{};
    for (std::size_t i = 0; i < kUnknowns; ++i) {
        x[i] = glm::dvec3(expected.radiance[i]);
        products[i][i] += kOfExpected * weights;
        right[i] += kOfExpected * weights * x[i];
    }
    for (int turn = 0; turn < kTurns; ++turn) {
        for (std::size_t i = 0; i < kUnknowns; ++i) {
            glm::dvec3 rest = right[i];
            for (std::size_t j = 0; j < kUnknowns; ++j) {
                if (j != i) rest -= products[i][j] * x[j];
            }
            x[i] = glm::max(rest / products[i][i], glm::dvec3(0.0));
        }
    }
    LightOfSides light;
    for (std::size_t i = 0; i < kUnknowns; ++i) light.radiance[i] = glm::vec3(x[i]);
    return light;
}

}  // namespace macula::hybrid
