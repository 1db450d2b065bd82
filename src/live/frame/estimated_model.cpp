#include "live/frame/estimated_model.h"

#include <utility>

#include "base/check.h"
#include "base/timeline.h"
#include "pipeline/splat/draw/raster_view.h"
#include "pipeline/volume/medium.h"
#include "pipeline/volume/volume_fit.h"
#include "pipeline/volume/window.h"

namespace macula::live {

namespace {

// So few that a CPU keeps up with a moving hand.
constexpr hybrid::SplatEstimateOptions kOptionsOnCpu{.mostNewSplats = 24'000};

bool hasAdditions(const scene::Drawing& drawing) {
    return drawing.additions && !drawing.additions->isNothing();
}

bool isEstimated(const scene::Drawing& drawing) {
    return drawing.transferFunction && !usesGradientOpacity(*drawing.transferFunction) &&
           !hasAdditions(drawing);
}

// The settings of the light, without exposure and tone map: only grey faces depend on those, and each
// estimate makes its own faces.
trace::Settings lightOf(const scene::Drawing& drawing) {
    trace::Settings settings = scene::settingsOfLight(drawing);
    settings.exposure = trace::Settings{}.exposure;
    settings.toneMap = trace::Settings{}.toneMap;
    return settings;
}

bool isSame(const scene::Drawing& a, const scene::Drawing& b) {
    return a.transferFunction == b.transferFunction && a.clip == b.clip && a.lights == b.lights &&
           scene::settingsOfLight(a) == scene::settingsOfLight(b);
}

}  // namespace

bool EstimatedModel::isInLightOf(const scene::Drawing& drawing) const {
    return drawing.lights == learntOf_.lights && lightOf(drawing) == lightOf(learntOf_);
}

void EstimatedModel::begin(const std::shared_ptr<const Volume>& volume, const scene::Drawing& drawing) {
    if (canTell(volume, drawing) || !isEstimated(drawing)) return;
    splat::Splats none;
    const Box box = volume->worldBox();
    none.originMm = 0.5 * (box.low + box.high);
    learnt(volume, drawing, std::make_shared<const splat::Splats>(std::move(none)), 1.0);
}

void EstimatedModel::learnt(const std::shared_ptr<const Volume>& volume, const scene::Drawing& drawing,
                            std::shared_ptr<const splat::Splats> model, double gain) {
    forget();
    if (volume_ != volume) {
        matter_.reset();
        bits_.reset();
        masked_ = {};
    }
    volume_ = volume;
    learntOf_ = drawing;
    model_ = std::move(model);
    gain_ = gain;
    estimate_.reset();
}

bool EstimatedModel::canTell(const std::shared_ptr<const Volume>& volume,
                             const scene::Drawing& drawing) const {
    return model_ && volume_ == volume && volume->format() == VoxelFormat::stored16 && isInLightOf(drawing) &&
           isEstimated(drawing) && (isEstimated(learntOf_) || !hasLearnt());
}

bool EstimatedModel::isOf(const std::shared_ptr<const Volume>& volume, const scene::Drawing& drawing) const {
    return painter_ && volume_ == volume && isEstimated(drawing) && isSame(drawing, shown_);
}

void EstimatedModel::forget() {
    painter_.reset();
    splats_.reset();
    shown_ = {};
}

hybrid::ShownMatter EstimatedModel::shownMatter(const scene::Drawing& drawing) {
    const TimelineStage stage("curve of estimate");
    const TransferFunction function = fitted(*drawing.transferFunction, *volume_);
    hybrid::ShownMatter shown{.optics = opticsByEntry(*volume_, function),
                              .clip = drawing.clip ? *drawing.clip : Clip{},
                              .mask = nullptr};
    if (usesSteepCurves(function)) {
        shown.steep = opticsByEntry(*volume_, withCurvesSwapped(function));
        shown.steepGradientPerMm = function.steep.gradientPerMm;
    }
    if (scene::hasGreyFaces(drawing)) {
        const auto [low, high] = entriesOf(*shown.clip.greyFaces, *volume_);
        shown.faces = hybrid::GreyValues{.low = low,
                                         .high = high,
                                         .belowIsBlack = shown.clip.facesBelowWindowAreBlack,
                                         .exposure = float(drawing.settings.exposure),
                                         .keepsHue = drawing.settings.toneMap == trace::ToneMap::hue};
    }
    if (!shown.clip.mask) return shown;
    const Mask& mask = *shown.clip.mask;
    if (!bits_ || masked_ != mask) {
        bits_ = mask.bits ? mask.bits : std::make_shared<const MaskBits>(maskBits(mask, *volume_));
        masked_ = mask;
    }
    shown.mask = bits_;
    return shown;
}

Result<void> EstimatedModel::make(const scene::Drawing& drawing) {
    MACULA_CHECK(canTell(volume_, drawing));
    if (isOf(volume_, drawing)) return {};
    const TimelineStage stage("estimate model");
    forget();
    if (!matter_) matter_ = std::make_shared<const hybrid::CoarseMatter>(volume_);
    if (!estimate_)
        estimate_.emplace(matter_, model_, shownMatter(learntOf_),
                          trace::Environment::fromRig(*learntOf_.lights),
                          device_->isCpu() ? kOptionsOnCpu : hybrid::SplatEstimateOptions{});
    splats_ = std::make_shared<const splat::Splats>(estimate_->under(shownMatter(drawing)));
    const TimelineStage upload("upload estimate");
    MACULA_TRY(splat::ModelPainter painter, splat::ModelPainter::create(device_, *splats_));
    painter_.emplace(std::move(painter));
    shown_ = drawing;
    return {};
}

Result<hybrid::DrawnSplats> EstimatedModel::draw(const Camera& eye, const glm::ivec2& sizePx) {
    MACULA_CHECK(painter_.has_value());
    MACULA_TRY(const splat::RasterView view,
               splat::rasterView(eye, sizePx, splats_->originMm, splat::RasterView{}.nearMm));
    MACULA_TRY(const splat::DevicePicture* picture, painter_->drawOnDevice(view));
    return hybrid::DrawnSplats{picture, &painter_->depthsOnDevice()};
}

}  // namespace macula::live
