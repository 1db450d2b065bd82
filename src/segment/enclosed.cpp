#include "segment/enclosed.h"

#include <algorithm>

#include "segment/itk_filters.h"

namespace macula::segment {

namespace {

// A region is the room, not an organ, when the field of view bounds more than this share of it.
constexpr double kOpenShare = 1.0 / 3.0;

struct Border {
    std::size_t open = 0;
    std::size_t closed = 0;
};

Result<void> fillSlice(const Grid& slice, const std::uint8_t* outside, std::uint8_t* mask) {
    Mask hollow(slice.count());
    for (std::size_t n = 0; n < hollow.size(); ++n) hollow[n] = mask[n] == 0 && outside[n] == 0 ? 1 : 0;
    MACULA_TRY(const Labels regions, connectedParts(slice, hollow, false));
    std::vector<Border> borders(regions.count + 1);
    for (std::size_t n = 0; n < hollow.size(); ++n) {
        if (hollow[n] == 0) continue;
        Border& border = borders[regions.ofBlock[n]];
        const auto look = [&](bool within, std::size_t beside) {
            if (!within || outside[beside] != 0) {
                ++border.open;
            } else if (mask[beside] != 0) {
                ++border.closed;
            }
        };
        const auto na = std::size_t(slice.size.x);
        look(n % na > 0, n - 1);
        look((n + 1) % na > 0, n + 1);
        look(n >= na, n - na);
        look(n + na < hollow.size(), n + na);
    }
    for (std::size_t n = 0; n < hollow.size(); ++n) {
        const Border& border = borders[regions.ofBlock[n]];
        const bool isEnclosed = double(border.open) <= kOpenShare * double(border.open + border.closed);
        if (hollow[n] != 0 && isEnclosed) mask[n] = 1;
    }
    return {};
}

}  // namespace

Result<void> fillEnclosed(const Grid& grid, const Mask& outside, Mask& mask, const CancelToken& token) {
    Grid slice = grid;
    slice.size.z = 1;
    for (std::size_t first = 0; first < mask.size() && !token.cancelled(); first += slice.count())
        MACULA_TRY_VOID(fillSlice(slice, outside.data() + first, mask.data() + first));
    return {};
}

}  // namespace macula::segment
