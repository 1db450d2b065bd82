// Small pictures of a volume under each preset, to choose one by. Drawn on the CPU without a device; the
// renderer never waits for them.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

#include "base/camera.h"
#include "base/progress.h"
#include "base/result.h"
#include "base/volume.h"
#include "pipeline/volume/clip.h"
#include "pipeline/volume/transfer_function.h"

namespace macula::pictures {

inline constexpr int kPresetThumbnailPx = 96;
inline constexpr int kLongestCoarseSide = 96;  // in cells

struct PresetThumbnail {
    int sizePx = 0;
    std::vector<std::uint8_t> rgba;  // opaque, on black, sRGB-encoded, row by row from the top
};

// A volume downsampled once, for the thumbnails of many presets. Threads may share it.
class CoarseVolume {
  public:
    // Each cell is the mean of at most 4 voxels per axis; at most kLongestCoarseSide cells a side. Padding
    // counts as air, as in the renderers. Fails with inputNotUsable if all of it is padding, with outOfMemory
    // and `cancelled`; throws nothing.
    static Result<std::shared_ptr<const CoarseVolume>> of(std::shared_ptr<const Volume> volume,
                                                          const CancelToken& token = {});

    const glm::ivec3& size() const { return size_; }
    double valueAt(const glm::dvec3& cell) const;  // trilinear; clamped to the border
    const glm::dmat4& cellFromWorld() const { return cellFromWorld_; }
    const Volume& volume() const { return *volume_; }
    // The preset, fitted to the full-resolution volume.
    TransferFunction fittedCurves(const TransferFunction& preset) const;

  private:
    explicit CoarseVolume(std::shared_ptr<const Volume> volume) : volume_(std::move(volume)) {}

    std::shared_ptr<const Volume> volume_;
    glm::ivec3 size_{0};
    std::vector<float> values_;
    glm::dmat4 cellFromWorld_{1.0};
    mutable std::once_flag foregroundOnce_;
    mutable ValueRange foreground_;  // cached for fits, because finding it reads each voxel
};

// Ray casts emission and absorption with the curves of the preset, as the look "dvr", with a headlight if the
// preset asks for one; gradient opacity is 1, and steepness comes from the gradient between cells. Thin
// matter is fainter than in a picture, because the volume is coarse. `clip` is in patient LPS mm, its mask
// ignored; null: all is shown. Frames the whole box from anterior, a short scan (isShort) obliquely. Fails
// with inputNotUsable for an invalid preset, outOfMemory, and `cancelled`, checked in each row; throws
// nothing.
Result<PresetThumbnail> presetThumbnail(const CoarseVolume& coarse, const TransferFunction& preset,
                                        const Clip* clip = nullptr, const CancelToken& token = {},
                                        int sizePx = kPresetThumbnailPx);

}  // namespace macula::pictures
