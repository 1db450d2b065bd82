// Where all comes together that hides single voxels in 3D.
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

// A mask for each part; a voxel is shown where every part shows it. One part by itself is there at once;
// several are joined in the background, and until then the mask before stays. Who hides something new is a
// part more. Lives on the UI thread.
class HiddenVoxels : public QObject {
    Q_OBJECT

  public:
    enum class Part { table, scissors, segments, count };

    explicit HiddenVoxels(QObject* parent = nullptr);

    void setVolume(std::shared_ptr<const Volume> volume);  // of which nothing is hidden; tells nobody
    void set(Part part, std::optional<Mask> mask);         // nothing: the part hides nothing
    const std::optional<Mask>& mask() const { return mask_; }
    bool isJoining() const { return job_.running(); }

  signals:
    void changed();  // the mask, or it was set again
    void failed(const macula::Error& error);

  private:
    void join();

    std::shared_ptr<const Volume> volume_;
    std::array<std::optional<Mask>, std::size_t(Part::count)> parts_;
    std::optional<Mask> mask_;
    BackgroundJob<std::optional<Mask>> job_;
};

}  // namespace macula::viewer
