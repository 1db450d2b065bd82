// Computes in the background which voxels the scissors leave.
#pragma once

#include <QObject>
#include <QString>
#include <memory>
#include <optional>
#include <vector>

#include "base/result.h"
#include "base/volume.h"
#include "pipeline/volume/clip.h"
#include "scene/clip/cuts.h"
#include "viewer/jobs/background_job.h"

namespace macula::viewer {

// Holds the scene::scissorMask of the cuts last given to want(). The old mask stays until the new one is
// made. If cuts were only appended, the mask is computed from the old one and the new cuts. Lives on the UI
// thread.
class VoxelCutting : public QObject {
    Q_OBJECT

  public:
    explicit VoxelCutting(QObject* parent);

    void setVolume(std::shared_ptr<const Volume> volume);  // removes all cuts; does not emit changed()
    void want(const std::vector<scene::ScissorCut>& scissors);
    const std::optional<Mask>& mask() const { return made_.mask; }             // nothing: no cuts
    const std::vector<scene::ScissorCut>& madeOf() const { return made_.of; }  // those in mask()
    bool running() const { return job_.running(); }
    // Drops the cuts that are being computed, and emits refused().
    void cancel();

  Q_SIGNALS:
    void began();
    void progressed(const QString& stage, double fraction);
    void ended();
    void changed();  // mask() is another one
    // The wanted cuts failed or were cancelled; `had` are the cuts that mask() still includes.
    void refused(const std::vector<macula::scene::ScissorCut>& had);
    void failed(const macula::Error& error);

  private:
    struct Made {
        std::vector<scene::ScissorCut> of = {};
        std::optional<Mask> mask = {};
    };
    void onEnded(const Result<std::optional<Mask>>& outcome);

    std::shared_ptr<const Volume> volume_;
    std::vector<scene::ScissorCut> wanted_;
    Made made_;
    BackgroundJob<std::optional<Mask>> job_;
};

}  // namespace macula::viewer
