// The exact test of a rectangle of pixels against all of its pixels.
#include "pipeline/splat/draw/reference_host.h"
#include "splat/draw/reference_scenes.h"

namespace macula::splat {
namespace {

struct Counts {
    int tiles = 0;
    int shown = 0;     // a pixel has some of the splat
    int kept = 0;      // the test says so
    int inExtent = 0;  // the rectangle of the extent says so
};

// Splats of all shapes from the projection itself, so also long needles with centres far outside.
template <class Host>
Counts compare(std::uint32_t seed, int tile, const Blending& blending) {
    using Real = typename Host::Real;
    RasterView view = frontView({160, 128});
    view.focalPx = glm::dvec2(1000);
    Host host(view, blending);
    Dice dice(seed);
    Counts counts;
    for (int n = 0; n < 150; ++n) {
        const double distance = dice.uniform(0, 1) < 0.2 ? 2000.0 : 60.0;
        typename Host::Splat splat{};
        splat.position = dice.vec3(-distance, distance);
        splat.logScale = dice.vec3(-5, n % 3 == 0 ? 7 : 3);
        splat.rotation = dice.quaternion();
        splat.opacityLogit = Real(dice.uniform(-4, 6));
        const auto screen = host.projectSplat(splat, host.frame);
        if (!(screen.opacity > 0)) continue;
        glm::ivec2 first;
        glm::ivec2 end;
        host.pixelsOf(screen, host.frame.sizePx, first, end);
        for (int row = 0; row < view.sizePx.y; row += tile) {
            for (int column = 0; column < view.sizePx.x; column += tile) {
                bool shown = false;
                for (int y = row; y < row + tile; ++y) {
                    for (int x = column; x < column + tile; ++x) {
                        const Real raw = host.rawAlphaAt(screen, {Real(x) + Real(0.5), Real(y) + Real(0.5)});
                        if (!(host.limitedAlpha(raw, host.frame) > 0)) continue;
                        shown = true;
                        EXPECT_TRUE(x >= first.x && x < end.x && y >= first.y && y < end.y)
                            << "outside of the extent";
                    }
                }
                const bool kept =
                    host.showsIn(screen, {column, row}, {column + tile, row + tile}, host.frame);
                EXPECT_TRUE(kept || !shown);
                ++counts.tiles;
                counts.shown += shown ? 1 : 0;
                counts.kept += kept ? 1 : 0;
                counts.inExtent +=
                    first.x < column + tile && end.x > column && first.y < row + tile && end.y > row ? 1 : 0;
            }
        }
    }
    return counts;
}

TEST(SplatTile, NothingThatShowsIsLost) {
    for (const int tile : {16, 8, 1}) {
        for (const bool classic : {false, true}) {
            const Blending blending = blendingOf(classic ? LowPass::classic : LowPass::adaptive);
            const Counts single =
                compare<reference::HostSingle>(static_cast<std::uint32_t>(tile), tile, blending);
            const Counts twofold =
                compare<reference::HostTwofold>(static_cast<std::uint32_t>(tile), tile, blending);
            for (const Counts& counts : {single, twofold}) {
                EXPECT_GT(counts.shown, 200);
                // And little is kept for nothing: what passes between the centres of pixels, and a hair for
                // rounding.
                EXPECT_LE(counts.kept, counts.shown * 1.1 + 20);
                EXPECT_LE(counts.kept, counts.inExtent);
            }
        }
    }
}

// The least power against a dense search, for rectangles with the mean inside, beside and far off.
TEST(SplatTile, FindsTheLeastPower) {
    reference::HostTwofold host(frontView(), {});
    Dice dice(21);
    for (int n = 0; n < 300; ++n) {
        const glm::dvec3 conic(std::exp(dice.uniform(-6, 1)), dice.uniform(-3, 3),
                               std::exp(dice.uniform(-6, 1)));
        const glm::dvec2 low(dice.uniform(-30, 20), dice.uniform(-30, 20));
        const glm::dvec2 high = low + glm::dvec2(dice.uniform(0, 20), dice.uniform(0, 20));
        double least = 1e300;
        for (int i = 0; i <= 100; ++i) {
            for (int k = 0; k <= 100; ++k)
                least = std::min(least,
                                 host.powerAt(conic, low + (high - low) * glm::dvec2(i / 100.0, k / 100.0)));
        }
        const double found = host.leastPowerIn(conic, low, high);
        EXPECT_LE(found, least);
        // The search misses the least point by half a step at most.
        const glm::dvec2 step = (high - low) / 200.0;
        const double across = step.x + std::abs(conic.y) * step.y;
        const double slack =
            0.5 * (conic.x * across * across + conic.z * step.y * step.y) +
            std::sqrt(2.0 * least) * std::sqrt(conic.x * across * across + conic.z * step.y * step.y);
        EXPECT_GE(found, least - slack - 1e-4 * (1.0 + least));
    }
}

}  // namespace
}  // namespace macula::splat
