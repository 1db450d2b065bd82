#include "pipeline/trace/view_history.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "pipeline/trace/guide_pixel.h"

namespace macula::trace {

namespace {

// In half widths of the picture: after a larger jump, the gaze meets parts that the previous picture stored
// coarsely.
constexpr double kFarthestGaze = 0.1;

// After a larger turn a view shows other sides of things: the previous one is of no use.
constexpr double kMostTurnDeg = 20.0;
constexpr double kMostTurnWithLightsDeg = 1.0;
// For lights fixed to the camera: the mean angle by which the views in the history may lag behind.
constexpr double kMostLagWithLightsDeg = 2.0;

// Whether both foveations are alike, with the gaze within `farthest`, in half widths and half heights of the
// picture.
bool sameFovea(const std::optional<Foveation>& a, const std::optional<Foveation>& b, double farthest) {
    if (!a || !b) return !a && !b;
    return a->fieldDeg == b->fieldDeg && a->magnification == b->magnification &&
           glm::distance(a->gaze, b->gaze) <= farthest;
}

bool sameView(const View& a, const View& b) {
    return a.width == b.width && a.height == b.height && a.camera == b.camera && a.lens == b.lens &&
           sameFovea(a.foveation, b.foveation, 0.0);
}

// The larger of the turns of the forward and the up axis; nothing where a camera has no axes.
std::optional<double> turnDeg(const Camera& from, const Camera& to) {
    const auto eyeFrom = basis(from);
    const auto eyeTo = basis(to);
    if (!eyeFrom || !eyeTo) return std::nullopt;
    const double cosine =
        std::min(glm::dot(eyeFrom->forward, eyeTo->forward), glm::dot(eyeFrom->up, eyeTo->up));
    return glm::degrees(std::acos(std::clamp(cosine, -1.0, 1.0)));
}

// Whether `to` can reuse the picture of `from`: both have the same size, field of view and lens, and the turn
// is small.
bool continues(const View& from, const View& to, LightFrame lights) {
    if (from.width != to.width || from.height != to.height ||
        from.camera.verticalFovDeg != to.camera.verticalFovDeg ||
        isParallel(from.camera) != isParallel(to.camera) || !(from.lens == to.lens) ||
        !sameFovea(from.foveation, to.foveation, kFarthestGaze)) {
        return false;
    }
    // Lights fixed to the camera turn with it, so that every degree changes the shading.
    const double most = lights == LightFrame::camera ? kMostTurnWithLightsDeg : kMostTurnDeg;
    const std::optional<double> turned = turnDeg(from.camera, to.camera);
    return turned && *turned <= most;
}

}  // namespace

// Makes the picture of the last view the history; if it was not denoised, there is none.
void ViewHistory::turnPage(const View& view, std::uint32_t seed, bool wasTraced, LightFrame lights) {
    const bool traced = view_ && wasTraced;
    const bool again = traced && seed_ == seed && sameView(*view_, view);
    if (traced) {
        const bool known = denoiser_ && denoisedEdition_ && guides_->isWhole();
        if (known) {
            std::swap(guides_, guidesBefore_);
            denoiser_->advance();
        } else if (denoiser_) {
            denoiser_->forget();
        }
        viewBefore_ = *view_;
    }
    if (!view_ || forgets_) viewBefore_ = view;
    // The same view with the same random numbers would add no information.
    if (denoiser_ && (forgets_ || again || !continues(viewBefore_, view, lights))) denoiser_->forget();
    limitLag(view, lights);
    view_ = view;
    seed_ = seed;
    forgets_ = false;
    restart();
}

// The temporal history is a running mean: if it counts as h samples, blending in one new sample leaves h / (h
// + 1) of the angle by which it lags. This lowers h until that angle is at most kMostLagWithLightsDeg.
void ViewHistory::limitLag(const View& view, LightFrame lights) {
    historySamples_ = Denoiser::kHistorySamples;
    if (lights != LightFrame::camera || !denoiser_ || !denoiser_->remembers()) {
        lagDeg_ = 0.0;
        return;
    }
    const double lag = lagDeg_ + turnDeg(viewBefore_.camera, view.camera).value_or(0.0);
    const double beyond = lag - kMostLagWithLightsDeg;
    if (beyond > 0.0) historySamples_ = std::min(historySamples_, float(kMostLagWithLightsDeg / beyond));
    lagDeg_ = lag * historySamples_ / (historySamples_ + 1.0);
}

void ViewHistory::restart() {
    if (guides_) guides_->begin();
    if (denoiser_) denoiser_->giveUp();
    denoisedEdition_.reset();
}

Result<void> ViewHistory::makeGuides(const SceneView& scene, TraceKernels& kernels,
                                     const std::function<bool()>& keepGoing) {
    if (!guides_ || guides_->width() != view_->width || guides_->height() != view_->height) {
        guides_.reset();
        MACULA_TRY(guides_, Guides::create(device_, view_->width, view_->height));
    }
    if (scene.scene().keepsForGradients() && !haveNormals_) guides_->begin();
    haveNormals_ = scene.scene().keepsForGradients();
    if (guides_->isWhole()) return {};
    MACULA_TRY(const shared::GuidePush push, guidePush(*view_, viewBefore_));
    MACULA_TRY(const gpu::Kernel* kernel, kernels.guides(kindOf(scene.scene())));
    return guides_->compute(scene, *kernel, push, keepGoing);
}

Result<const Guides*> ViewHistory::guides(const SceneView& scene, TraceKernels& kernels) {
    MACULA_TRY_VOID(makeGuides(scene, kernels, {}));
    return &*guides_;
}

Result<bool> ViewHistory::denoiseSome(const Film& film, std::uint64_t edition, Denoising how,
                                      const SceneView& scene, TraceKernels& kernels,
                                      const std::function<bool()>& keepGoing) {
    if (denoisedEdition_ == edition && denoisedAs_ == how) return true;
    MACULA_TRY_VOID(makeGuides(scene, kernels, keepGoing));
    if (!guides_->isWhole()) return false;
    if (!denoiser_ || denoiser_->width() != view_->width || denoiser_->height() != view_->height) {
        denoiser_.reset();
        MACULA_TRY(auto filters, kernels.denoising());
        MACULA_TRY(denoiser_, Denoiser::create(device_, std::move(filters), view_->width, view_->height));
    }
    if (begunEdition_ != edition || begunAs_ != how) denoiser_->giveUp();
    denoisedEdition_.reset();
    begunEdition_ = edition;
    begunAs_ = how;
    const double pixelAngle =
        2.0 * std::tan(glm::radians(view_->camera.verticalFovDeg) / 2.0) / view_->height;
    MACULA_TRY(const bool isWhole, denoiser_->run(film, *guides_, guidesBefore_ ? &*guidesBefore_ : nullptr,
                                                  static_cast<float>(pixelAngle), how, keepGoing,
                                                  foveaInPlane(*view_), historySamples_));
    if (!isWhole) return false;
    denoisedEdition_ = edition;
    denoisedAs_ = how;
    return true;
}

Result<const gpu::Buffer*> ViewHistory::denoised(const Film& film, std::uint64_t edition, Denoising how,
                                                 const SceneView& scene, TraceKernels& kernels) {
    MACULA_TRY([[maybe_unused]] const bool done, denoiseSome(film, edition, how, scene, kernels, {}));
    return &denoiser_->result();
}

}  // namespace macula::trace
