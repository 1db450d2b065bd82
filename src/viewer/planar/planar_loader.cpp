#include "viewer/planar/planar_loader.h"

#include <utility>

namespace macula::viewer {

namespace {

constexpr int kAllFrames = -1;

std::size_t bytesOf(const LoadedImage& image) {
    return image.pixels->values.size() * sizeof(float) + image.pixels->rgb.size();
}

}  // namespace

PlanarLoader::PlanarLoader(QObject* parent)
    : QObject(parent), job_(this, {.ended = [this](const Result<LoadedImage>& image) { take(image); }}) {}

void PlanarLoader::setSeries(std::shared_ptr<const study::FoundVolumes> found, const dicom::Stack* stack) {
    job_.cancel();
    images_.clear();
    headers_.clear();
    bytes_ = 0;
    asked_.reset();
    loading_.reset();
    failedAhead_.reset();
    ahead_ = {};
    found_ = std::move(found);
    stack_ = stack;
}

void PlanarLoader::ask(std::size_t place) {
    if (stack_ == nullptr || place >= stack_->frames.size()) return;
    const auto known = images_.find(place);
    if (known != images_.end()) {
        asked_.reset();
        return Q_EMIT loaded(known->second);
    }
    asked_ = place;
    if (!loading_) startNext();
}

void PlanarLoader::readAhead(const study::PlanarLoop& loop) {
    ahead_ = loop;
    failedAhead_.reset();
    if (!loading_) startNext();
}

std::optional<std::size_t> PlanarLoader::nextAhead() const {
    // Another image would evict one of these.
    const bool isFull = !images_.empty() && bytes_ + bytesOf(images_.begin()->second) > mostBytes_;
    if (isFull || failedAhead_) return {};
    for (std::size_t place = ahead_.begin; place < ahead_.end; ++place)
        if (!images_.contains(place)) return place;
    return {};
}

std::shared_ptr<const dicom::PlanarHeader> PlanarLoader::headerOf(const dicom::Frame& frame) const {
    for (const int number : {kAllFrames, frame.number}) {
        const auto known = headers_.find(std::pair(frame.instance.get(), number));
        if (known != headers_.end()) return known->second;
    }
    return nullptr;
}

void PlanarLoader::startNext() {
    loading_ = asked_ ? asked_ : nextAhead();
    if (!loading_ || stack_ == nullptr) return;
    const dicom::Frame& frame = stack_->frames[*loading_];
    const std::shared_ptr<const dicom::PlanarHeader> header = headerOf(frame);
    // The job holds what the stack belongs to: another folder may be opened meanwhile.
    job_.start([found = found_, stack = stack_, place = *loading_,
                header](Progress& progress) -> Result<LoadedImage> {
        LoadedImage image{.place = place, .header = header, .pixels = {}};
        if (!image.header) {
            const dicom::Frame& of = stack->frames[place];
            MACULA_TRY(auto read, dicom::readPlanarHeader(of.instance->file, of.number));
            image.header = std::make_shared<const dicom::PlanarHeader>(std::move(read));
        }
        MACULA_TRY(auto pixels, dicom::loadPlanarFrame(*stack, place, *image.header, progress.token()));
        image.pixels = std::make_shared<const dicom::PlanarFrame>(std::move(pixels));
        return image;
    });
}

void PlanarLoader::take(const Result<LoadedImage>& image) {
    const std::size_t place = *std::exchange(loading_, std::nullopt);
    const bool wasAsked = asked_ == place;
    if (wasAsked) asked_.reset();
    if (image) {
        const dicom::Frame& frame = stack_->frames[place];
        headers_.emplace(
            std::pair(frame.instance.get(), image->header->isOfFrame ? frame.number : kAllFrames),
            image->header);
        keep(*image);
    } else {
        failedAhead_ = place;
    }
    if (wasAsked && image) Q_EMIT loaded(*image);
    if (wasAsked && !image) Q_EMIT failed(place, image.error());
    if (!loading_) startNext();
}

// Evicts first the image that lies farthest from the newest one.
void PlanarLoader::keep(const LoadedImage& image) {
    images_.emplace(image.place, image);
    bytes_ += bytesOf(image);
    while (bytes_ > mostBytes_ && images_.size() > 1) {
        const std::size_t low = images_.begin()->first;
        const std::size_t high = images_.rbegin()->first;
        const auto gone = image.place - low > high - image.place ? images_.begin() : std::prev(images_.end());
        bytes_ -= bytesOf(gone->second);
        images_.erase(gone);
    }
}

}  // namespace macula::viewer
