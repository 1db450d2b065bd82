#include "viewer/slices/slice_sampler.h"

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
    } catch (const std::bad_alloc&) {
        last_.reset();
        log::error("No memory for a slice of {} x {} pixels", wish.frame.sizePx.x, wish.frame.sizePx.y);
    }
    return picture;
}

}  // namespace macula::viewer
