// Joins all masks that hide single voxels in 3D.
#pragma once

#include <QObject>
#include <array>
#include <cstddef>
#include <memory>
#include <optional>

#include "base/result.h"
#include "base/volume.h"
#include "pipeline/volume/clip.h"
#include "viewer/jobs/background_job.h"

namespace macula::viewer {

// One mask for each part; a voxel is shown if every part shows it. A single mask applies at once; several are
// joined in the background, and the old mask stays until then. A new feature that hides voxels adds a part.
// Lives on the UI thread.
class HiddenVoxels : public QObject {
    Q_OBJECT

  public:
    enum class Part { table, scissors, segments, count };

    explicit HiddenVoxels(QObject* parent = nullptr);

    void setVolume(std::shared_ptr<const Volume> volume);  // hides nothing; emits nothing
    void set(Part part, std::optional<Mask> mask);         // nothing: the part hides nothing
    const std::optional<Mask>& mask() const { return mask_; }
    bool isJoining() const { return job_.running(); }

  Q_SIGNALS:
    void changed();  // the mask, or the same mask was set again
    void failed(const macula::Error& error);

  private:
    void join();

    std::shared_ptr<const Volume> volume_;
    std::array<std::optional<Mask>, std::size_t(Part::count)> parts_;
    std::optional<Mask> mask_;
    BackgroundJob<std::optional<Mask>> job_;
};

}  // namespace macula::viewer
