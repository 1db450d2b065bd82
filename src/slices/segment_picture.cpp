#include "slices/segment_picture.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <optional>
#include <utility>

#include "base/parallel.h"
#include "slices/sampled_slice.h"
#include "slices/voxel_grid.h"

namespace macula::slices {

namespace {

constexpr double kTouchMm = 1e-3;  // the plane misses boxes that are farther away

// A rectangle of pixels; `end` is one past the last.
struct Rect {
    glm::ivec2 begin{0};
    glm::ivec2 end{0};

    int width() const { return end.x - begin.x; }
    int height() const { return end.y - begin.y; }
};

// The pixels that may show a set of voxels; nothing if there are none. Has one more pixel on each side,
// because borders are found by their neighbours.
std::optional<Rect> rectOf(const VoxelSet& voxels, const Volume& volume, const SliceFrame& frame) {
    if (voxels.high().x < voxels.low().x) return std::nullopt;
    glm::dvec2 low(1e9);
    glm::dvec2 high(-1e9);
    double nearest = 1e300;
    double farthest = -1e300;
    for (const glm::dvec3& corner :
         cornersOf({glm::dvec3(voxels.low()) - 0.5, glm::dvec3(voxels.high()) + 0.5})) {
        const glm::dvec3 mm = transformPoint(volume.worldFromVoxel(), corner);
        const glm::dvec2 px = frame.pictureFromWorld(mm);
        low = glm::min(low, px);
        high = glm::max(high, px);
        nearest = std::min(nearest, frame.distanceMm(mm));
        farthest = std::max(farthest, frame.distanceMm(mm));
    }
    if (nearest > kTouchMm || farthest < -kTouchMm) return std::nullopt;
    const glm::dvec2 size(frame.sizePx);
    low = glm::clamp(glm::floor(low) - 1.0, glm::dvec2(0.0), size);
    high = glm::clamp(glm::ceil(high) + 1.0, glm::dvec2(0.0), size);
    if (!(low.x < high.x && low.y < high.y)) return std::nullopt;
    return Rect{glm::ivec2(low), glm::ivec2(high)};
}

// Which pixels of a picture belong to a segment.
class Cut {
  public:
    Cut(const Rect& rect, const glm::ivec2& sizePx)
        : rect_(rect), sizePx_(sizePx), isIn_(std::size_t(rect.width()) * std::size_t(rect.height())) {}

    const Rect& rect() const { return rect_; }
    std::uint8_t* row(int y) {
        return isIn_.data() + std::size_t(y - rect_.begin.y) * std::size_t(rect_.width());
    }
    bool isIn(int x, int y) const {
        if (x < rect_.begin.x || y < rect_.begin.y || x >= rect_.end.x || y >= rect_.end.y) return false;
        return isIn_[std::size_t(y - rect_.begin.y) * std::size_t(rect_.width()) +
                     std::size_t(x - rect_.begin.x)] != 0;
    }
    // Whether a pixel of the segment has one outside it within `widthPx` beside it.
    bool isBorder(int x, int y, int widthPx) const {
        for (int n = 1; n <= widthPx; ++n) {
            if (isOut(x - n, y) || isOut(x + n, y) || isOut(x, y - n) || isOut(x, y + n)) return true;
        }
        return false;
    }

  private:
    // Pixels beyond the picture are unknown, and do not count as outside the segment.
    bool isOut(int x, int y) const {
        return x >= 0 && y >= 0 && x < sizePx_.x && y < sizePx_.y && !isIn(x, y);
    }

    Rect rect_;
    glm::ivec2 sizePx_;
    std::vector<std::uint8_t> isIn_;
};

class Painter {
  public:
    Painter(const Volume& volume, const SliceFrame& frame, const std::function<bool()>& cancelled)
        : volume_(volume), frame_(frame), places_(volume), cancelled_(cancelled) {
        step_ = places_.ofVector(frame.plane.right * frame.mmPerPixel);
    }

    bool isCancelled() const { return token_.cancelled(); }

    // Nothing if the segment is not visible.
    std::optional<Cut> cut(const VoxelSet& voxels) const {
        const auto rect = rectOf(voxels, volume_, frame_);
        if (!rect) return std::nullopt;
        Cut cut(*rect, frame_.sizePx);
        const Bounds bounds = boundsOf(volume_.size());
        std::atomic<bool> isSeen{false};
        forEachRow(*rect, [&](int y) {
            const glm::dvec3 first = places_.ofPoint(frame_.worldFromPicture({0.5, double(y) + 0.5}));
            std::uint8_t* row = cut.row(y);
            bool seen = false;
            for (int x = rect->begin.x; x < rect->end.x; ++x) {
                const glm::dvec3 at = first + double(x) * step_;
                const bool isIn = bounds.contain(at) && voxels.contains(nearestVoxel(at, volume_.size()));
                row[x - rect->begin.x] = isIn ? 1 : 0;
                seen = seen || isIn;
            }
            if (seen) isSeen = true;
        });
        return isSeen ? std::optional(std::move(cut)) : std::nullopt;
    }

    template <class Row>
    void forEachRow(const Rect& rect, const Row& row) const {
        parallelFor(
            std::size_t(rect.height()),
            [&](std::size_t n) {
                if (cancelled_ && cancelled_()) return token_.cancel();
                row(rect.begin.y + int(n));
            },
            token_);
    }

  private:
    const Volume& volume_;
    const SliceFrame& frame_;
    VoxelPlaces places_;
    glm::dvec3 step_{0.0};
    const std::function<bool()>& cancelled_;
    CancelToken token_;
};

// The colour blended over `below`, both premultiplied.
std::uint32_t over(const std::array<std::uint8_t, 3>& rgb, unsigned alpha, std::uint32_t below) {
    std::uint32_t result = 0;
    const auto blend = [&](unsigned shift, unsigned ink) {
        const unsigned was = below >> shift & 0xFFu;
        const unsigned now = (ink * alpha + was * (255u - alpha) + 127u) / 255u;
        result |= std::min(now, 255u) << shift;
    };
    blend(24, 255u);
    blend(16, rgb[0]);
    blend(8, rgb[1]);
    blend(0, rgb[2]);
    return result;
}

unsigned alphaOf(double opacity) {
    return std::isfinite(opacity) ? unsigned(std::lround(255.0 * std::clamp(opacity, 0.0, 1.0))) : 0u;
}

}  // namespace

SegmentPicture paintSegments(const Volume& volume, const SliceFrame& frame,
                             std::span<const ShownSegment> segments, int linePx,
                             const std::function<bool()>& cancelled) {
    const glm::ivec2 size = frame.sizePx;
    if (size.x < 1 || size.y < 1 || double(size.x) * double(size.y) > kMostSlicePixels || !frame.isUsable())
        return {};
    const Painter painter(volume, frame, cancelled);
    std::vector<std::pair<const ShownSegment*, Cut>> seen;
    for (const ShownSegment& segment : segments) {
        if (!segment.voxels) continue;
        if (auto cut = painter.cut(*segment.voxels)) seen.emplace_back(&segment, *std::move(cut));
        if (painter.isCancelled()) return {};
    }
    if (seen.empty()) return {};
    SegmentPicture picture{.sizePx = size, .argb = {}};
    picture.argb.resize(std::size_t(size.x) * std::size_t(size.y));
    const auto paint = [&](const ShownSegment& segment, const Cut& cut, unsigned alpha, bool isLine) {
        painter.forEachRow(cut.rect(), [&](int y) {
            for (int x = cut.rect().begin.x; x < cut.rect().end.x; ++x) {
                if (!cut.isIn(x, y) || (isLine && !cut.isBorder(x, y, linePx))) continue;
                std::uint32_t& pixel = picture.argb[std::size_t(y) * std::size_t(size.x) + std::size_t(x)];
                pixel = over(segment.rgb, alpha, pixel);
            }
        });
    };
    for (const auto& [segment, cut] : seen) paint(*segment, cut, alphaOf(segment->opacity), false);
    for (const auto& [segment, cut] : seen) paint(*segment, cut, 255u, true);
    if (painter.isCancelled()) return {};
    return picture;
}

std::vector<std::size_t> segmentsAt(const Volume& volume, const glm::dvec3& mm,
                                    std::span<const ShownSegment> segments) {
    std::vector<std::size_t> found;
    const auto at = probe(volume, mm);
    if (!at) return found;
    for (std::size_t i = 0; i < segments.size(); ++i) {
        if (segments[i].voxels && segments[i].voxels->contains(at->voxel)) found.push_back(i);
    }
    return found;
}

}  // namespace macula::slices
