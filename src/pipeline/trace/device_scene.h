// What is traced, on the device: voxels, optical tables, bounds and light. One for all views of it
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

// Used by one thread at a time, the one that uses the device. What is replaced is dropped first, so that only
// one of it is ever there: after a setter has failed the scene is not complete.
class DeviceScene {
  public:
    explicit DeviceScene(std::shared_ptr<gpu::Device> device, const MemoryLimits& limits = {})
        : device_(std::move(device)), limits_(limits), indirect_(device_) {}

    const std::shared_ptr<gpu::Device>& device() const { return device_; }
    // Grows whenever bindings() gives something else, or something else can be seen: pictures of an earlier
    // edition begin anew.
    std::uint64_t edition() const { return edition_; }

    // Uploads no voxels yet: only the transfer function, which has to be set again, tells which can be seen.
    // outOfMemory when the device cannot hold the grid of the volume.
    Result<void> setVolume(std::shared_ptr<const Volume> volume);
    // After setVolume. Rebuilds the tables and the bound on extinction of every brick, and uploads the voxels
    // that have become visible. outOfMemory when the device cannot hold even the coarsest.
    Result<void> setTransferFunction(const TransferFunction& function);
    Result<void> setEnvironment(const Environment& environment);

    // Shows all of it again when the clip is nothing. After setVolume it stays.
    Result<void> setClip(const Clip& clip);
    // A second volume and coloured segments, or nothing; of projections neither counts. Both belong to the
    // volume: a new one has none until they are set again. Where segments have other colours alone, a table
    // of these is all that is made anew. outOfMemory as setTransferFunction.
    Result<void> setAdditions(const Additions& additions);
    LightFrame lightFrame() const { return environment_ ? environment_->frame() : LightFrame::patient; }
    // What kernels are specialised for.
    bool isClipped() const { return clip_.hasShape(); }
    bool holdsCoarseBlocks() const {
        return (voxels_ && voxels_->holdsCoarseBlocks()) ||
               (second_ && second_->voxels().holdsCoarseBlocks());
    }
    // Of the pool of voxels (kPoolViews in shaders/trace/host.glsl).
    int poolViews() const { return voxels_ && voxels_->isShown() ? int(voxels_->pool().viewCount()) : 1; }
    int poolViewShift() const { return voxels_ ? voxels_->viewShift() : 0; }
    // In the look that makeReadyFor() prepared last.
    bool hasSecond() const { return additions_.second.has_value() && !projection_; }
    bool hasTints() const { return additions_.tints.has_value() && !projection_; }
    bool isMasked() const { return clip_.mask.has_value(); }
    bool hasGreyFaces() const { return clip_.hasShape() && clip_.greyFaces.has_value(); }

    double anisotropy() const { return function_ ? function_->anisotropy : 0.0; }

    // Whether matter scatters like a surface anywhere, in path-traced looks.
    bool hasSurfaces() const { return function_ && function_->surface.weight > 0.0; }
    // Whether there is gradient opacity in the look that makeReadyFor() prepared last.
    bool hasGradientOpacity() const { return !medium_.gradientOpacity.empty(); }

    // Whether steep matter has curves of its own in that look.
    bool hasSteep() const { return !medium_.steep.empty(); }
    // Whether it is denser or thinner by them anywhere, and not of another colour alone.
    bool hasSteepDensity() const { return hasSteepDensity_; }

    bool isComplete() const;
    // Majorants and empty distances by brick (Medium::bounds), in that look as well.
    std::span<const float> bounds() const { return medium_.bounds; }
    const std::shared_ptr<const Volume>& volume() const { return volume_; }

    // Makes the tables and majorants that the look needs. When complete.
    Result<void> makeReadyFor(const Settings& settings);
    // The voxels that gradients reach, of whatever can be seen (addReachOfGradients), are there from now on,
    // as they are for settings that take gradients; until the next volume. Its edition stays while nothing is
    // coarse. When complete.
    Result<void> keepForGradients();
    bool keepsForGradients() const { return gradients_; }
    // When made ready for them, see makeTraceParams.
    Result<shared::TraceParams> params(const View& view, const Settings& settings) const;

    // What is known of its indirect light. It is no part of the scene, which stays as it is while that grows.
    IndirectCache& indirect() const { return indirect_; }

    // Where an eye sees anything of it, LPS mm (visibleBoxMm): what a clip has removed is not in it, though
    // it may cast shadow. Empty, low > high, when there is nothing. When complete, and ready for a
    // path-traced look.
    Box seenMm() const;

    // The outline of its matter (visibleHullMm), whatever the look. When complete.
    std::vector<glm::dvec3> outlineMm() const;

    // What the voxels take; nothing without a volume.
    VoxelMemory voxelMemory() const;
    // What a person has to know about what is shown.
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
    std::optional<Projection> projection_;      // what medium_ is for; nothing: matter
    bool gradients_ = false;                    // whether what these reach is kept
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
