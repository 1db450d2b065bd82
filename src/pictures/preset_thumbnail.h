// Small pictures of a volume under a preset, drawn on the host, to choose a preset by. No device is used, and
// nobody who draws waits for them.
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

namespace macula::app {

inline constexpr int kPresetThumbnailPx = 96;
inline constexpr int kLongestCoarseSide = 96;  // in cells

struct PresetThumbnail {
    int sizePx = 0;
    std::vector<std::uint8_t> rgba;  // opaque, on black, sRGB-encoded, row by row from the top
};

// A volume made coarse once, for the pictures of many presets. Threads may share it.
class CoarseVolume {
  public:
    // The mean of some voxels for each cell, at most kLongestCoarseSide cells a side; padding counts as air,
    // as renderers draw it. Fails with inputNotUsable where all of it is padding, outOfMemory and
    // `cancelled`; throws nothing.
    static Result<std::shared_ptr<const CoarseVolume>> of(std::shared_ptr<const Volume> volume,
                                                          const CancelToken& token = {});

    const glm::ivec3& size() const { return size_; }
    double valueAt(const glm::dvec3& cell) const;  // trilinear, and as at the border beyond it
    const glm::dmat4& cellFromWorld() const { return cellFromWorld_; }
    const Volume& volume() const { return *volume_; }
    // The curves where they lie on the volume itself.
    TransferFunction fittedCurves(const TransferFunction& preset) const;

  private:
    explicit CoarseVolume(std::shared_ptr<const Volume> volume) : volume_(std::move(volume)) {}

    std::shared_ptr<const Volume> volume_;
    glm::ivec3 size_{0};
    std::vector<float> values_;
    glm::dmat4 cellFromWorld_{1.0};
    mutable std::once_flag foregroundOnce_;
    mutable ValueRange foreground_;  // of a fit, which looks at each voxel
};

// Emission and absorption along the ray with the preset's own curves, as the look "dvr" has them, lit from
// the eye where the preset asks for that; its gradient opacity counts as 1, and what is steep is told by the
// gradient between cells. Where the volume is coarse, thin matter is fainter than it is in a picture. `clip`,
// in patient LPS mm, without its mask; null: all is shown. Looked at from anterior, a short scan (isShort)
// obliquely, the whole box in the picture. Fails with inputNotUsable for a preset that is not valid,
// outOfMemory, and `cancelled`, which is looked for in each row; throws nothing.
Result<PresetThumbnail> presetThumbnail(const CoarseVolume& coarse, const TransferFunction& preset,
                                        const Clip* clip = nullptr, const CancelToken& token = {},
                                        int sizePx = kPresetThumbnailPx);

}  // namespace macula::app
