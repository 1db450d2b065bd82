#include "viewer/slices/slice_sampler.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <new>
#include <utility>
#include <vector>

#include "base/give_way.h"
#include "base/log.h"
#include "base/parallel.h"
#include "slices/difference.h"
#include "slices/grey.h"
#include "study/dose/dose_field.h"

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

void colour(QImage& grey, slices::ColourTable table) {
    if (table == slices::ColourTable::grey || grey.isNull()) return;
    QList<QRgb> colours;
    for (int value = 0; value < 256; ++value) {
        const slices::Rgb rgb = slices::colourOf(table, std::uint8_t(value));
        colours.push_back(qRgb(rgb.red, rgb.green, rgb.blue));
    }
    grey.reinterpretAsFormat(QImage::Format_Indexed8);
    grey.setColorTable(colours);
}

QImage imageOf(const std::vector<std::uint32_t>& colours, const glm::ivec2& sizePx) {
    QImage image(sizePx.x, sizePx.y, QImage::Format_ARGB32_Premultiplied);
    if (image.isNull()) throw std::bad_alloc();
    const std::size_t width = std::size_t(sizePx.x);
    for (int y = 0; y < sizePx.y; ++y)
        std::memcpy(image.scanLine(y), colours.data() + std::size_t(y) * width,
                    width * sizeof(std::uint32_t));
    return image;
}

slices::SliceFrame transformed(const slices::SliceFrame& frame, const glm::dmat4& toFromFrame) {
    if (toFromFrame == glm::dmat4(1.0)) return frame;  // exactly the same frame
    slices::SliceFrame to = frame;
    to.plane.centreMm = transformPoint(toFromFrame, frame.plane.centreMm);
    to.plane.right = glm::normalize(transformVector(toFromFrame, frame.plane.right));
    to.plane.down = glm::normalize(transformVector(toFromFrame, frame.plane.down));
    return to;
}

}  // namespace

SliceSampler::SliceSampler(std::function<void(SlicePicture)> made)
    : made_(std::move(made)), thread_([this] { run(); }) {}

SliceSampler::~SliceSampler() {
    ends_ = true;
    requests_.close();
}

void SliceSampler::publish(SliceRequest request) {
    study_ = request.study;
    requests_.publish(std::move(request));
}

void SliceSampler::run() {
    giveWay(GiveWay::toTheHand);
    while (std::optional<SliceRequest> request = requests_.take()) {
        if (ends_) return;
        if (!request->volume) {
            last_.reset();
            lastOver_.reset();
            painted_ = {};
            segments_ = {};
            forgetIsodoses();
            continue;
        }
        SlicePicture picture = make(*request);
        // Cancelled on the way, so the samples are incomplete.
        if (ends_ || study_ != request->study) continue;
        made_(std::move(picture));
    }
}

SlicePicture SliceSampler::make(const SliceRequest& request) {
    SlicePicture picture{.of = request, .grey = {}, .colours = {}};
    try {
        const auto* slice = sampled(last_, request.volume, transformed(request.frame, request.volumeFromPane),
                                    request.slab, request.study);
        if (slice == nullptr) return picture;
        if (request.isDifference) {
            picture.grey = imageOf(slices::toDiverging(slice->values, request.window), request.frame.sizePx);
        } else {
            picture.grey = imageOf(slices::toGrey(slice->values, request.window, request.isInverted),
                                   request.frame.sizePx);
            colour(picture.grey, request.colours);
        }
        paintSegments(request);
        picture.segments = segments_;
        if (!request.over) {
            lastOver_.reset();
            forgetIsodoses();
            return picture;
        }
        const SliceOver& over = *request.over;
        slice = sampledOver(lastOver_, request, request.slab);
        if (slice == nullptr) return {.of = request, .grey = {}};
        picture.colours = imageOf(
            slices::toColours(slice->values, over.window, over.isInverted, over.colours, over.opacity),
            request.frame.sizePx);
        drawIsodoses(request);
        picture.isodoses = isodoses_;
    } catch (const std::bad_alloc&) {
        last_.reset();
        lastOver_.reset();
        painted_ = {};
        forgetIsodoses();
        picture.grey = {};  // a partial picture must not pass for a whole one
        log::error("No memory for a slice of {} x {} pixels", request.frame.sizePx.x, request.frame.sizePx.y);
    }
    return picture;
}

void SliceSampler::paintSegments(const SliceRequest& request) {
    if (painted_.volume == request.volume && painted_.frame == request.frame &&
        painted_.segments == request.segments && painted_.pixelRatio == request.pixelRatio)
        return;
    painted_ = {};
    segments_ = {};
    if (request.segments) {
        const auto isGivenUp = [this, study = request.study] { return ends_ || study_ != study; };
        const int linePx = std::max(1, int(std::lround(request.pixelRatio)));
        const slices::SegmentPicture picture =
            slices::paintSegments(*request.volume, request.frame, *request.segments, linePx, isGivenUp);
        if (isGivenUp()) return;
        if (!picture.argb.empty()) segments_ = imageOf(picture.argb, picture.sizePx);
    }
    painted_ = request;
}

void SliceSampler::forgetIsodoses() {
    drawn_ = {};
    isodoses_.clear();
}

void SliceSampler::drawIsodoses(const SliceRequest& request) {
    const SliceOver& over = *request.over;
    if (!over.dose || over.dose->lines.empty()) return forgetIsodoses();
    if (drawn_.dose && drawn_.dose->lines == over.dose->lines && drawn_.volume == over.volume &&
        drawn_.volumeFromPane == over.volumeFromPane && drawnFrame_ == request.frame)
        return;
    forgetIsodoses();
    const auto isGivenUp = [this, study = request.study] { return ends_ || study_ != study; };
    const bool isSlab = request.slab.thicknessMm > 0.0;
    std::optional<Sampled> ofPlane;  // a projection through a slab has no isodose
    const auto* slice =
        sampledOver(isSlab ? ofPlane : lastOver_, request, isSlab ? slices::Slab() : request.slab);
    if (slice == nullptr) return;
    isodoses_ = isodosePaths(*slice, over.dose->lines, isGivenUp);
    if (isGivenUp()) return forgetIsodoses();
    drawn_ = over;
    drawnFrame_ = request.frame;
}

// The second volume over the picture. Null if the request was cancelled.
const slices::SampledSlice* SliceSampler::sampledOver(std::optional<Sampled>& kept,
                                                      const SliceRequest& request, const slices::Slab& slab) {
    const SliceOver& over = *request.over;
    const slices::SliceFrame frame = transformed(request.frame, over.volumeFromPane);
    const bool isKept = kept && kept->isOf(over.volume, frame, slab);
    const slices::SampledSlice* slice = sampled(kept, over.volume, frame, slab, request.study);
    if (slice != nullptr && over.dose && !isKept) forgetUncovered(*kept);
    return slice;
}

// A dose is shown where its pointer and its histogram have one, and not half a voxel beyond.
void SliceSampler::forgetUncovered(Sampled& dose) {
    const study::DoseField field(dose.volume);
    const glm::ivec2 size = dose.slice.sizePx;
    parallelFor(std::size_t(size.y), [&](std::size_t y) {
        for (int x = 0; x < size.x; ++x)
            if (!field.covers(dose.frame.worldFromPicture({x + 0.5, double(y) + 0.5})))
                dose.slice.values[y * std::size_t(size.x) + std::size_t(x)] =
                    std::numeric_limits<float>::quiet_NaN();
    });
}

// Null if the request was cancelled.
const slices::SampledSlice* SliceSampler::sampled(std::optional<Sampled>& kept,
                                                  const std::shared_ptr<const Volume>& volume,
                                                  const slices::SliceFrame& frame, const slices::Slab& slab,
                                                  std::uint64_t study) {
    if (kept && kept->isOf(volume, frame, slab)) return &kept->slice;
    kept.reset();
    const auto isGivenUp = [this, study] { return ends_ || study_ != study; };
    slices::SampledSlice slice = slices::sampleSlice(*volume, frame, slab, slices::Filter::linear, isGivenUp);
    if (slice.sizePx != frame.sizePx || isGivenUp()) return nullptr;
    kept = Sampled{.volume = volume, .frame = frame, .slab = slab, .slice = std::move(slice)};
    return &kept->slice;
}

}  // namespace macula::viewer
