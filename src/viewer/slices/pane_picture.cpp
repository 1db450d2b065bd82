#include "viewer/slices/pane_picture.h"

#include <utility>

#include "viewer/jobs/post.h"

namespace macula::viewer {

namespace {

// Whether both have the same pixels: the cross-hair is drawn over them.
bool samePixels(const SliceRequest& a, SliceRequest b) {
    b.crosshairMm = a.crosshairMm;
    return a == b;
}

}  // namespace

// Qt drops pictures that arrive after this object is destroyed.
PanePicture::PanePicture()
    : sampler_(std::make_unique<SliceSampler>([this](SlicePicture picture) {
          post(this, [this, picture = std::move(picture)] { take(picture); });
      })) {}

PanePicture::~PanePicture() {
    sampler_.reset();
}

void PanePicture::forget() {
    ++study_;
    wanted_.reset();
    shown_.reset();
    SliceRequest nothing;
    nothing.study = study_;
    sampler_->publish(std::move(nothing));
}

void PanePicture::ask(SliceRequest request) {
    request.study = study_;
    const bool isNew = !wanted_ || !samePixels(*wanted_, request);
    wanted_ = request;
    if (isNew) sampler_->publish(std::move(request));
}

bool PanePicture::isUpToDate() const {
    return shown_ && wanted_ && samePixels(shown_->of, *wanted_);
}

void PanePicture::take(SlicePicture picture) {
    if (picture.of.study != study_) return;
    shown_ = std::move(picture);
    Q_EMIT arrived();
}

}  // namespace macula::viewer
