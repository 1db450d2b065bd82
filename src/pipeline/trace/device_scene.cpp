#include "pipeline/trace/device_scene.h"

#include <algorithm>
#include <limits>
#include <span>

#include "pipeline/gpu/recorder.h"
#include "pipeline/gpu/transfer.h"
#include "pipeline/trace/scene.h"
#include "pipeline/volume/clip_bricks.h"
#include "pipeline/volume/visible_box.h"
#include "pipeline/volume/visible_hull.h"
#include "pipeline/volume/voxel_blocks.h"

namespace macula::trace {

namespace {

template <class T>
Result<gpu::TexelBuffer> makeTexels(const std::shared_ptr<gpu::Device>& device, const char* label,
                                    VkFormat format, std::span<const T> values) {
    MACULA_TRY(auto texels, gpu::TexelBuffer::create(
                                device, {.label = label, .elements = values.size(), .format = format}));
    MACULA_TRY_VOID(gpu::uploadTo(texels.buffer(), values));
    return texels;
}

// What a look needs of the scene beside its transfer function.
std::optional<Projection> projectionOf(Look look) {
    switch (look) {
        case Look::mip:
            return Projection::maximum;
        case Look::minip:
            return Projection::minimum;
        case Look::average:
            return Projection::mean;
        case Look::cinematic:
        case Look::clear:
        case Look::dvr:
            break;
    }
    return std::nullopt;
}

// The normals of guides steer the denoiser.
bool takesGradients(const Settings& settings) {
    return isDenoised(settings) || (settings.look == Look::dvr && settings.shading == Shading::headlight);
}

}  // namespace

Result<void> DeviceScene::setVolume(std::shared_ptr<const Volume> volume) {
    MACULA_CHECK(volume != nullptr);
    ++edition_;
    voxels_.reset();
    gradients_ = false;
    extinction_.reset();
    mask_.reset();
    maskBits_.reset();
    function_.reset();
    volume_.reset();
    grid_ = makeBrickGrid(*volume);
    MACULA_TRY(voxels_, DeviceVolume::create(device_, volume, grid_, limits_));
    volume_ = std::move(volume);
    return {};
}

Result<void> DeviceScene::setTransferFunction(const TransferFunction& function) {
    if (!volume_) return Error{ErrorCode::usage, "There is nothing to trace yet.", {}, "Open a study first."};
    MACULA_TRY_VOID(validate(function));
    function_ = function;
    return makeTables();
}

Result<void> DeviceScene::setClip(const Clip& clip) {
    MACULA_TRY_VOID(validate(clip));
    ++edition_;
    clip_ = clip;
    mask_.reset();
    maskBits_.reset();
    return volume_ && function_ ? makeTables() : Result<void>();
}

// A mask is one word of nothing when there is none.
Result<void> DeviceScene::makeMask() {
    if (mask_) return {};
    if (clip_.mask) {
        const glm::dvec3 size(volume_->size());
        if (size.x * size.y * size.z > double(std::numeric_limits<std::int32_t>::max())) {
            return Error{ErrorCode::outOfMemory,
                         "A volume of more than 2147 million voxels cannot be masked.",
                         {},
                         "Show it without a mask."};
        }
        maskBits_ = maskBits(*clip_.mask, *volume_);
    }
    const std::uint32_t none = 0;
    MACULA_TRY(mask_, makeTexels<std::uint32_t>(device_, "mask", VK_FORMAT_R32_UINT,
                                                maskBits_ ? std::span<const std::uint32_t>(maskBits_->words)
                                                          : std::span(&none, 1)));
    return {};
}

Result<void> DeviceScene::showVoxels() {
    std::vector<std::uint8_t> alsoShown = bricksAtGreyFaces(clip_, *volume_, grid_);
    if (hasGradientOpacity() || (gradients_ && !projection_))
        addReachOfGradients(grid_, medium_.bounds, alsoShown);
    return voxels_->show(grid_, medium_.bounds, alsoShown, medium_.extinctionPerMm);
}

Result<void> DeviceScene::makeTables() {
    ++edition_;
    MACULA_TRY_VOID(makeMask());
    const MaskBits* mask = maskBits_ ? &*maskBits_ : nullptr;
    medium_ = projection_ ? makeMedium(*volume_, grid_, *projection_, clip_, mask)
                          : makeMedium(*volume_, grid_, fitted(*function_, *volume_), clip_, mask);
    extinction_.reset();  // all or none: tables of different length must never meet
    albedo_.reset();
    bounds_.reset();
    MACULA_TRY_VOID(showVoxels());
    if (voxels_->isCoarse()) coverCoarseBlocks(medium_, grid_, voxels_->levels());
    std::vector<float> opacities = medium_.extinctionPerMm;
    opacities.insert(opacities.end(), medium_.gradientOpacity.begin(), medium_.gradientOpacity.end());
    MACULA_TRY(extinction_, makeTexels<float>(device_, "extinction", VK_FORMAT_R32_SFLOAT, opacities));
    MACULA_TRY(albedo_,
               makeTexels<glm::vec4>(device_, "albedo", VK_FORMAT_R32G32B32A32_SFLOAT, medium_.albedo));
    MACULA_TRY(bounds_, makeTexels<float>(device_, "bounds", VK_FORMAT_R32_SFLOAT, medium_.bounds));
    return {};
}

Result<void> DeviceScene::setEnvironment(const Environment& environment) {
    static_assert(sizeof(EnvironmentTexel) == 4 * sizeof(float));
    ++edition_;
    environmentTexels_.reset();
    cumulativeTexels_.reset();
    MACULA_TRY(environmentTexels_,
               makeTexels<EnvironmentTexel>(device_, "environment", VK_FORMAT_R32G32B32A32_SFLOAT,
                                            environment.texels()));
    MACULA_TRY(cumulativeTexels_, makeTexels<float>(device_, "cumulative light", VK_FORMAT_R32_SFLOAT,
                                                    environment.cumulative()));
    environment_ = environment;
    return {};
}

bool DeviceScene::isComplete() const {
    return voxels_ && voxels_->isShown() && mask_ && extinction_ && albedo_ && bounds_ &&
           environmentTexels_ && cumulativeTexels_;
}

Result<void> DeviceScene::makeReadyFor(const Settings& settings) {
    MACULA_CHECK(isComplete());
    const bool gradients = takesGradients(settings);
    const auto projection = projectionOf(settings.look);
    if (projection == projection_) return gradients ? keepForGradients() : Result<void>();
    projection_ = projection;
    gradients_ = gradients_ || gradients;
    return makeTables();
}

Result<void> DeviceScene::keepForGradients() {
    MACULA_CHECK(isComplete());
    if (gradients_) return {};
    gradients_ = true;
    if (projection_ || hasGradientOpacity()) return {};
    // What was there before stays as it is, and so does what was seen of it, unless something has to become
    // coarser.
    if (voxels_->isCoarse()) return makeTables();
    MACULA_TRY_VOID(showVoxels());
    return voxels_->isCoarse() ? makeTables() : Result<void>();
}

Result<shared::TraceParams> DeviceScene::params(const View& view, const Settings& settings) const {
    MACULA_CHECK(isComplete());
    return makeTraceParams(*volume_, medium_, *environment_, view, settings, clip_);
}

Box DeviceScene::seenMm() const {
    MACULA_CHECK(isComplete() && !projection_);
    if (!clip_.removedCastsShadow) return visibleBoxMm(*volume_, grid_, medium_);
    Clip ofEye = clip_;
    ofEye.removedCastsShadow = false;
    const MaskBits* mask = maskBits_ ? &*maskBits_ : nullptr;
    return visibleBoxMm(*volume_, grid_,
                        makeMedium(*volume_, grid_, fitted(*function_, *volume_), ofEye, mask));
}

std::vector<glm::dvec3> DeviceScene::outlineMm() const {
    MACULA_CHECK(isComplete());
    const MaskBits* mask = maskBits_ ? &*maskBits_ : nullptr;
    if (!projection_) return visibleHullMm(*volume_, grid_, medium_, clip_, mask);
    return visibleHullMm(*volume_, grid_,
                         makeMedium(*volume_, grid_, fitted(*function_, *volume_), clip_, mask), clip_, mask);
}

VoxelMemory DeviceScene::voxelMemory() const {
    return voxels_ ? voxels_->memory() : VoxelMemory{};
}

std::vector<Message> DeviceScene::messages() const {
    if (!voxels_ || !voxels_->message()) return {};
    return {*voxels_->message()};
}

std::vector<gpu::Binding> DeviceScene::bindings() const {
    MACULA_CHECK(isComplete());
    return {voxels_->pool(),     *extinction_,       *albedo_,         *bounds_,
            *environmentTexels_, *cumulativeTexels_, voxels_->table(), *mask_};
}

}  // namespace macula::trace
