#include "pipeline/splat/draw/shown_tiles.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "pipeline/splat/draw/shown_tiles.cpp"
#include <hwy/foreach_target.h>  // first
#include <hwy/highway.h>

#include <algorithm>

#include "base/vector_in_glsl.h"

HWY_BEFORE_NAMESPACE();
namespace macula::splat::HWY_NAMESPACE {
namespace {

using namespace macula::HWY_NAMESPACE;
using IntTag = hn::Rebind<std::int32_t, FloatTag>;

#define float Float
#define PRECISE

struct VectorPower : GlslInVectors {
#include "lib/splat_least_power.glsl"
};

#undef float
#undef PRECISE

HWY_INLINE Float floorOf(Float x) {
    return hn::Floor(x.values);
}

}  // namespace

void findTiles(const SearchedTiles& searched, std::size_t from, ShownTiles& shown) {
    static_assert(kLanes <= ShownTiles::kLongestVector);
    const FloatTag tag;
    const IntTag integers;
    const std::size_t end = std::min(searched.count(), from + ShownTiles::kMost);
    const int columns = searched.end.x - searched.first.x;
    const Vec3 conic(searched.conic.x, searched.conic.y, searched.conic.z);
    const Vec2 mean(searched.mean.x, searched.mean.y);
    const Vec2 half(Float(0.5f));
    shown.count = 0;
    for (std::size_t n = from; n < end; n += kLanes) {
        // Numbers up to 2^22 divide exactly enough.
        const Float number(hn::Iota(tag, static_cast<float>(n)));
        const Float row = floorOf((number + Float(0.5f)) / Float(columns));
        const Vec2 tile(number - row * Float(columns) + Float(searched.first.x),
                        row + Float(searched.first.y));
        const Vec2 low = tile * Vec2(Float(searched.tileSize.x), Float(searched.tileSize.y));
        const Vec2 high(GlslInVectors::min(low.x + Float(searched.tileSize.x), Float(searched.sizePx.x)),
                        GlslInVectors::min(low.y + Float(searched.tileSize.y), Float(searched.sizePx.y)));
        const Float power = VectorPower().leastPowerIn(conic, low + half - mean, high - half - mean);
        const Mask shows = power <= Float(searched.most) && number < Float(end);
        const Float at = tile.y * Float(searched.tileColumns) + tile.x;
        shown.count +=
            hn::CompressStore(hn::ConvertTo(integers, at.values), hn::RebindMask(integers, shows.bits),
                              integers, reinterpret_cast<std::int32_t*>(&shown.tiles[shown.count]));
    }
}

}  // namespace macula::splat::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace macula::splat {

HWY_EXPORT(findTiles);

void findShownTiles(const SearchedTiles& searched, std::size_t from, ShownTiles& shown) {
    HWY_DYNAMIC_DISPATCH(findTiles)(searched, from, shown);
}

}  // namespace macula::splat
#endif
