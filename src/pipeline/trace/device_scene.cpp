#include "pipeline/trace/device_scene.h"

#include <algorithm>
#include <limits>
#include <span>

#include "pipeline/gpu/recorder.h"
#include "pipeline/trace/scene.h"
#include "pipeline/trace/scene_texels.h"
#include "pipeline/volume/clip_bricks.h"
#include "pipeline/volume/visible_box.h"
#include "pipeline/volume/visible_hull.h"
#include "pipeline/volume/voxel_blocks.h"

namespace macula::trace {

namespace {

// The projection of a look; nothing for looks that show matter.
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

// The denoiser needs them for the normals of guides.
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
    additions_ = {};
    second_.reset();
    additionTables_.forget();
    grid_ = makeBrickGrid(*volume);
    MACULA_TRY(voxels_, DeviceVolume::create(device_, volume, grid_, limits_));
    volume_ = std::move(volume);
    return {};
}

Result<void> DeviceScene::setTransferFunction(const TransferFunction& function) {
    if (!volume_)
        return Error{
            ErrorCode::usage, Text("There is nothing to trace yet."), {}, Text("Open a study first.")};
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

// Without a mask it is a single 0, because a binding cannot be empty.
Result<void> DeviceScene::makeMask() {
    if (mask_) return {};
    if (clip_.mask) {
        const glm::dvec3 size(volume_->size());
        if (size.x * size.y * size.z > double(std::numeric_limits<std::int32_t>::max())) {
            return Error{ErrorCode::outOfMemory,
                         Text("A volume of more than 2147 million voxels cannot be masked."),
                         {},
                         Text("Show it without a mask.")};
        }
        maskBits_ = maskBits(*clip_.mask, *volume_);
    }
    const std::uint32_t none = 0;
    MACULA_TRY(mask_,
               uploadedTexels<std::uint32_t>(
                   device_, "mask", VK_FORMAT_R32_UINT,
                   maskBits_ ? std::span<const std::uint32_t>(maskBits_->words) : std::span(&none, 1)));
    return {};
}

Result<void> DeviceScene::setAdditions(const Additions& additions) {
    if (volume_) MACULA_TRY_VOID(validate(additions, *volume_, additions_));
    ++edition_;
    const bool sameMatter = isComplete() && isSameMatter(additions, additions_);
    additionTables_.forgetFor(additions, additions_);
    additions_ = additions;
    if (second_ && (!additions.second || additions.second->volume != second_->volume())) second_.reset();
    if (!volume_ || !function_) return {};
    return sameMatter ? additionTables_.make(device_, additions_) : makeTables();
}

// Projections show the values of the volume alone.
const Additions& DeviceScene::shownAdditions() const {
    static const Additions kNone;
    return projection_ ? kNone : additions_;
}

std::span<const float> DeviceScene::secondBounds() const {
    return hasSecond() && second_ ? second_->bounds() : std::span<const float>();
}

Result<void> DeviceScene::showSecond() {
    const Additions& shown = shownAdditions();
    if (!shown.second) return {};
    if (!second_) {
        MACULA_TRY(second_, SecondOnDevice::create(device_, shown.second->volume, limits_));
    }
    return second_->show(*shown.second, *volume_, grid_);
}

Result<void> DeviceScene::showVoxels() {
    std::vector<std::uint8_t> alsoShown = bricksAtGreyFaces(clip_, *volume_, grid_);
    if (!projection_ && (hasGradientOpacity() || hasSteep() || hasSurfaces() || gradients_))
        addReachOfGradients(grid_, medium_.bounds, alsoShown);
    // Where only the second volume is visible, this volume's voxels need not be uploaded: they have no
    // extinction.
    return voxels_->show(grid_, medium_.ownBounds(), alsoShown, medium_.mostPerMm());
}

Result<void> DeviceScene::makeTables() {
    ++edition_;
    MACULA_TRY_VOID(makeMask());
    const MaskBits* mask = maskBits_ ? &*maskBits_ : nullptr;
    extinction_.reset();  // all or none: tables of different lengths must never be used together
    albedo_.reset();
    bounds_.reset();
    MACULA_TRY_VOID(showSecond());
    MACULA_TRY_VOID(additionTables_.make(device_, additions_));
    medium_ = projection_
                  ? makeMedium(*volume_, grid_, *projection_, clip_, mask)
                  : makeMedium(*volume_, grid_, fitted(*function_, *volume_), clip_, mask, secondBounds());
    MACULA_TRY_VOID(showVoxels());
    if (voxels_->isCoarse()) coverCoarseBlocks(medium_, grid_, voxels_->levels());
    std::vector<float> opacities = medium_.extinctionPerMm;
    opacities.insert(opacities.end(), medium_.gradientOpacity.begin(), medium_.gradientOpacity.end());
    std::vector<glm::vec4> matter = medium_.albedo;
    matter.insert(matter.end(), medium_.steep.begin(), medium_.steep.end());
    for (const glm::vec4& steep : medium_.steep) opacities.push_back(steep.w);
    hasSteepDensity_ = false;
    for (std::size_t entry = 0; entry < medium_.steep.size(); ++entry)
        hasSteepDensity_ = hasSteepDensity_ || medium_.steep[entry].w != medium_.extinctionPerMm[entry];
    MACULA_TRY(extinction_, uploadedTexels<float>(device_, "extinction", VK_FORMAT_R32_SFLOAT, opacities));
    MACULA_TRY(albedo_, uploadedTexels<glm::vec4>(device_, "albedo", VK_FORMAT_R32G32B32A32_SFLOAT, matter));
    MACULA_TRY(bounds_, uploadedTexels<float>(device_, "bounds", VK_FORMAT_R32_SFLOAT, medium_.bounds));
    return {};
}

Result<void> DeviceScene::setEnvironment(const Environment& environment) {
    static_assert(sizeof(EnvironmentTexel) == 4 * sizeof(float));
    ++edition_;
    environmentTexels_.reset();
    cumulativeTexels_.reset();
    MACULA_TRY(environmentTexels_,
               uploadedTexels<EnvironmentTexel>(device_, "environment", VK_FORMAT_R32G32B32A32_SFLOAT,
                                                environment.texels()));
    MACULA_TRY(cumulativeTexels_, uploadedTexels<float>(device_, "cumulative light", VK_FORMAT_R32_SFLOAT,
                                                        environment.cumulative()));
    environment_ = environment;
    return {};
}

bool DeviceScene::isComplete() const {
    return voxels_ && voxels_->isShown() && mask_ && extinction_ && albedo_ && bounds_ &&
           additionTables_.areMade(additions_) && (second_ || !hasSecond()) && environmentTexels_ &&
           cumulativeTexels_;
}

Result<void> DeviceScene::makeReadyFor(const Settings& settings) {
    MACULA_CHECK(isComplete());
    const bool gradients = takesGradients(settings);
    const auto projection = projectionOf(settings.look);
    // Majorants with a larger reach would hold for all filters, but then the bits of a path-traced picture
    // would depend on the filters of earlier pictures.
    const int reach = reachOf(filterOf(settings.look, settings.filter));
    if (isPathTraced(settings.look) ? grid_.reach != reach : grid_.reach < reach) {
        grid_ = makeBrickGrid(*volume_, reach);
        projection_ = projection;
        gradients_ = gradients_ || gradients;
        return makeTables();
    }
    if (projection == projection_) return gradients ? keepForGradients() : Result<void>();
    projection_ = projection;
    gradients_ = gradients_ || gradients;
    return makeTables();
}

Result<void> DeviceScene::keepForGradients() {
    MACULA_CHECK(isComplete());
    if (gradients_) return {};
    gradients_ = true;
    if (projection_ || hasGradientOpacity() || hasSteep() || hasSurfaces()) return {};
    // Blocks on the device stay as they are, and pictures with them, unless some have to become coarser.
    if (voxels_->isCoarse()) return makeTables();
    MACULA_TRY_VOID(showVoxels());
    return voxels_->isCoarse() ? makeTables() : Result<void>();
}

Result<shared::TraceParams> DeviceScene::params(const View& view, const Settings& settings) const {
    MACULA_CHECK(isComplete());
    return makeTraceParams(*volume_, medium_, *environment_, view, settings, clip_, additions_);
}

Box DeviceScene::seenMm() const {
    MACULA_CHECK(isComplete() && !projection_);
    if (!clip_.removedCastsShadow) return visibleBoxMm(*volume_, grid_, medium_);
    Clip ofEye = clip_;
    ofEye.removedCastsShadow = false;
    const MaskBits* mask = maskBits_ ? &*maskBits_ : nullptr;
    return visibleBoxMm(
        *volume_, grid_,
        makeMedium(*volume_, grid_, fitted(*function_, *volume_), ofEye, mask, secondBounds()));
}

std::vector<glm::dvec3> DeviceScene::outlineMm() const {
    MACULA_CHECK(isComplete());
    const MaskBits* mask = maskBits_ ? &*maskBits_ : nullptr;
    if (!projection_) return visibleHullMm(*volume_, grid_, medium_, clip_, mask, additions_);
    return visibleHullMm(*volume_, grid_,
                         makeMedium(*volume_, grid_, fitted(*function_, *volume_), clip_, mask), clip_, mask);
}

VoxelMemory DeviceScene::voxelMemory() const {
    VoxelMemory memory = voxels_ ? voxels_->memory() : VoxelMemory{};
    if (!second_) return memory;
    const VoxelMemory second = second_->voxels().memory();
    memory.shownBlocks += second.shownBlocks;
    memory.coarseBlocks += second.coarseBlocks;
    memory.poolBytes += second.poolBytes;
    memory.gridBytes += second.gridBytes;
    return memory;
}

std::vector<Message> DeviceScene::messages() const {
    std::vector<Message> messages;
    if (voxels_ && voxels_->message()) messages.push_back(*voxels_->message());
    if (hasSecond() && second_ && second_->voxels().message()) {
        Message message = *second_->voxels().message();
        message.sentence = Text("Of the second volume: {}", message.sentence);
        messages.push_back(std::move(message));
    }
    return messages;
}

std::vector<gpu::Binding> DeviceScene::bindings() const {
    MACULA_CHECK(isComplete());
    // Shaders do not read views beyond the last: these bind the first one.
    const gpu::TexelBuffer& pool = voxels_->pool();
    const auto poolView = [&pool](std::size_t view) {
        return gpu::Binding(pool, view < pool.viewCount() ? view : 0);
    };
    return {voxels_->pool(),
            *extinction_,
            *albedo_,
            *bounds_,
            *environmentTexels_,
            *cumulativeTexels_,
            voxels_->table(),
            *mask_,
            second_ ? second_->voxels().pool() : additionTables_.noEntries(),
            second_ ? second_->voxels().table() : additionTables_.noBlocks(),
            additionTables_.optics(),
            additionTables_.segments(),
            poolView(1),
            poolView(2),
            poolView(3)};
}

}  // namespace macula::trace
