#include "viewer/slices/slice_sampler.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <new>
#include <utility>
#include <vector>

#include "base/log.h"
#include "slices/grey.h"

namespace macula::viewer {

namespace {

QImage imageOf(const std::vector<std::uint8_t>& grey, const glm::ivec2& sizePx) {
    QImage image(sizePx.x, sizePx.y, QImage::Format_Grayscale8);
    if (image.isNull()) return image;
    const std::size_t width = std::size_t(sizePx.x);
    for (int y = 0; y < sizePx.y; ++y)
        std::memcpy(image.scanLine(y), grey.data() + std::size_t(y) * width, width);
    return image;
}

QImage imageOf(const slices::SegmentPicture& picture) {
    QImage image(picture.sizePx.x, picture.sizePx.y, QImage::Format_ARGB32_Premultiplied);
    if (image.isNull()) throw std::bad_alloc();
    const std::size_t width = std::size_t(picture.sizePx.x);
    for (int y = 0; y < picture.sizePx.y; ++y)
        std::memcpy(image.scanLine(y), picture.argb.data() + std::size_t(y) * width, 4 * width);
    return image;
}

}  // namespace

SliceSampler::SliceSampler(std::function<void(SlicePicture)> made)
    : made_(std::move(made)), thread_([this] { run(); }) {}

SliceSampler::~SliceSampler() {
    ends_ = true;
    wishes_.close();
}

void SliceSampler::publish(SliceWish wish) {
    study_ = wish.study;
    wishes_.publish(std::move(wish));
}

void SliceSampler::run() {
    while (std::optional<SliceWish> wish = wishes_.take()) {
        if (ends_) return;
        if (!wish->volume) {
            last_.reset();
            painted_ = {};
            segments_ = {};
            continue;
        }
        SlicePicture picture = make(*wish);
        // Given up on the way: what was sampled is not whole.
        if (ends_ || study_ != wish->study) continue;
        made_(std::move(picture));
    }
}

SlicePicture SliceSampler::make(const SliceWish& wish) {
    SlicePicture picture{.of = wish, .grey = {}};
    try {
        if (!last_ || last_->volume != wish.volume || last_->frame != wish.frame ||
            last_->slab != wish.slab) {
            last_.reset();
            const auto isGivenUp = [this, study = wish.study] { return ends_ || study_ != study; };
            slices::SampledSlice slice =
                slices::sampleSlice(*wish.volume, wish.frame, wish.slab, slices::Filter::linear, isGivenUp);
            if (slice.sizePx != wish.frame.sizePx || isGivenUp()) return picture;
            last_ = Sampled{
                .volume = wish.volume, .frame = wish.frame, .slab = wish.slab, .slice = std::move(slice)};
        }
        picture.grey =
            imageOf(slices::toGrey(last_->slice.values, wish.window, wish.isInverted), wish.frame.sizePx);
        paintSegments(wish);
        picture.segments = segments_;
    } catch (const std::bad_alloc&) {
        last_.reset();
        painted_ = {};
        picture.grey = {};  // without its segments it would say less than was asked for
        log::error("No memory for a slice of {} x {} pixels", wish.frame.sizePx.x, wish.frame.sizePx.y);
    }
    return picture;
}

void SliceSampler::paintSegments(const SliceWish& wish) {
    if (painted_.volume == wish.volume && painted_.frame == wish.frame &&
        painted_.segments == wish.segments && painted_.pixelRatio == wish.pixelRatio)
        return;
    painted_ = {};
    segments_ = {};
    if (wish.segments) {
        const auto isGivenUp = [this, study = wish.study] { return ends_ || study_ != study; };
        const int linePx = std::max(1, int(std::lround(wish.pixelRatio)));
        const slices::SegmentPicture picture =
            slices::paintSegments(*wish.volume, wish.frame, *wish.segments, linePx, isGivenUp);
        if (isGivenUp()) return;
        if (!picture.argb.empty()) segments_ = imageOf(picture);
    }
    painted_ = wish;
}

}  // namespace macula::viewer
