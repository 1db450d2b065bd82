// The traced scene on the device: voxels, optical tables, majorants and light. All views of it share one
// (scene_view.h).
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "base/result.h"
#include "base/volume.h"
#include "pipeline/gpu/recorder.h"
#include "pipeline/gpu/resources.h"
#include "pipeline/trace/addition_tables.h"
#include "pipeline/trace/device_volume.h"
#include "pipeline/trace/environment.h"
#include "pipeline/trace/indirect_cache.h"
#include "pipeline/trace/second_on_device.h"
#include "pipeline/trace/settings.h"
#include "pipeline/volume/additions.h"
#include "pipeline/volume/medium.h"
#include "pipeline/volume/transfer_function.h"
#include "shared/trace_params.h"

namespace macula::trace {

// Used by one thread at a time, the one that uses the device. A setter drops the old tables before it makes
// new ones, so that the device never holds both: after a setter has failed the scene is not complete.
class DeviceScene {
  public:
    explicit DeviceScene(std::shared_ptr<gpu::Device> device, const MemoryLimits& limits = {})
        : device_(std::move(device)), limits_(limits), indirect_(device_) {}

    const std::shared_ptr<gpu::Device>& device() const { return device_; }
    // Grows whenever bindings() changes, or what can be seen: pictures of an earlier edition have to start
    // over.
    std::uint64_t edition() const { return edition_; }

    // Uploads no voxels yet: which can be seen depends on the transfer function, which has to be set again.
    // outOfMemory when the device cannot hold the grid of the volume.
    Result<void> setVolume(std::shared_ptr<const Volume> volume);
    // After setVolume. Rebuilds the tables and the majorant of every brick, and uploads the voxels that have
    // become visible. outOfMemory when the device cannot hold even the coarsest.
    Result<void> setTransferFunction(const TransferFunction& function);
    Result<void> setEnvironment(const Environment& environment);

    // An empty clip shows all of the volume again. The clip stays when another volume is set.
    Result<void> setClip(const Clip& clip);
    // A second volume and coloured segments, or nothing; projections show neither. Both belong to the volume:
    // a new one has none until they are set again. If only the colours of segments change, only their table
    // is rebuilt. outOfMemory as setTransferFunction.
    Result<void> setAdditions(const Additions& additions);
    LightFrame lightFrame() const { return environment_ ? environment_->frame() : LightFrame::patient; }
    // What kernels are specialised for.
    bool isClipped() const { return clip_.hasShape(); }
    bool holdsCoarseBlocks() const {
        return (voxels_ && voxels_->holdsCoarseBlocks()) ||
               (second_ && second_->voxels().holdsCoarseBlocks());
    }
    // Views of the pool of voxels (kPoolViews in shaders/trace/host.glsl).
    int poolViews() const { return voxels_ && voxels_->isShown() ? int(voxels_->pool().viewCount()) : 1; }
    int poolViewShift() const { return voxels_ ? voxels_->viewShift() : 0; }
    // These two are for the look that makeReadyFor() prepared last.
    bool hasSecond() const { return additions_.second.has_value() && !projection_; }
    bool hasTints() const { return additions_.tints.has_value() && !projection_; }
    bool isMasked() const { return clip_.mask.has_value(); }
    bool hasGreyFaces() const { return clip_.hasShape() && clip_.greyFaces.has_value(); }

    double anisotropy() const { return function_ ? function_->anisotropy : 0.0; }

    // Whether matter scatters like a surface anywhere, in path-traced looks.
    bool hasSurfaces() const { return function_ && function_->surface.weight > 0.0; }
    // Whether there is gradient opacity in the look that makeReadyFor() prepared last.
    bool hasGradientOpacity() const { return !medium_.gradientOpacity.empty(); }

    // Whether steep matter has its own curves in that look.
    bool hasSteep() const { return !medium_.steep.empty(); }
    // Whether these curves change its density anywhere, and not only its colour.
    bool hasSteepDensity() const { return hasSteepDensity_; }

    bool isComplete() const;
    // Majorants and empty distances by brick (Medium::bounds), also for that look.
    std::span<const float> bounds() const { return medium_.bounds; }
    const std::shared_ptr<const Volume>& volume() const { return volume_; }

    // Makes the tables and majorants that the look needs. When complete.
    Result<void> makeReadyFor(const Settings& settings);
    // From now on, until the next volume, the device also keeps the voxels from which the gradients of
    // visible matter are taken (addReachOfGradients), as it does for settings that need gradients. The
    // edition does not change as long as no block is coarse. When complete.
    Result<void> keepForGradients();
    bool keepsForGradients() const { return gradients_; }
    // makeTraceParams() for this scene, after makeReadyFor(settings).
    Result<shared::TraceParams> params(const View& view, const Settings& settings) const;

    // The cache of its indirect light. It is not part of the scene's state: it grows while the scene is
    // const.
    IndirectCache& indirect() const { return indirect_; }

    // The box of all that an eye can see, LPS mm (visibleBoxMm), without what a clip has removed, even if
    // that casts shadow. Empty, low > high, when there is nothing. When complete, and ready for a look that
    // shows matter.
    Box seenMm() const;

    // The outline of its matter (visibleHullMm), whatever the look. When complete.
    std::vector<glm::dvec3> outlineMm() const;

    // The memory of the voxels; all 0 without a volume.
    VoxelMemory voxelMemory() const;
    // What a person has to know about the picture, such as that voxels are coarse.
    std::vector<Message> messages() const;

    // When complete: bindings 1 to 15 of shaders/trace/host.glsl.
    std::vector<gpu::Binding> bindings() const;

  private:
    Result<void> makeMask();
    Result<void> makeTables();
    Result<void> showVoxels();
    Result<void> showSecond();
    const Additions& shownAdditions() const;
    std::span<const float> secondBounds() const;

    std::shared_ptr<gpu::Device> device_;
    MemoryLimits limits_;
    mutable IndirectCache indirect_;
    std::uint64_t edition_ = 0;
    std::shared_ptr<const Volume> volume_;
    BrickGrid grid_;
    Medium medium_;
    bool hasSteepDensity_ = false;
    std::optional<Projection> projection_;      // that medium_ was made for; nothing: for matter
    bool gradients_ = false;                    // whether voxels that gradients reach are kept
    std::optional<TransferFunction> function_;  // as it was given
    Clip clip_;
    Additions additions_;
    std::optional<SecondOnDevice> second_;
    AdditionTables additionTables_;
    std::optional<DeviceVolume> voxels_;
    std::optional<gpu::TexelBuffer> extinction_, albedo_, bounds_, mask_;
    std::optional<MaskBits> maskBits_;  // of the clip, on the grid of the volume
    std::optional<Environment> environment_;
    std::optional<gpu::TexelBuffer> environmentTexels_, cumulativeTexels_;
};

}  // namespace macula::trace
