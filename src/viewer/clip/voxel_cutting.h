// Which voxels the scissors leave, found while the window goes on.
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

// Keeps the mask of app::scissorMask for what was wanted last. Until it is found the one before holds, and a
// cut that comes after others takes no more time than alone. Lives on the UI thread.
class VoxelCutting : public QObject {
    Q_OBJECT

  public:
    explicit VoxelCutting(QObject* parent);

    void setVolume(std::shared_ptr<const Volume> volume);  // nothing is cut of it yet; tells nobody
    void want(const std::vector<app::ScissorCut>& scissors);
    const std::optional<Mask>& mask() const { return made_.mask; }           // nothing: nothing is cut
    const std::vector<app::ScissorCut>& madeOf() const { return made_.of; }  // of the mask
    bool running() const { return job_.running(); }
    // What is being cut is refused: see `refused`.
    void cancel();

  signals:
    void began();
    void progressed(const QString& stage, double fraction);
    void ended();
    void changed();  // the mask
    // What was wanted is not to be had; these cuts are.
    void refused(const std::vector<macula::app::ScissorCut>& had);
    void failed(const macula::Error& error);

  private:
    struct Made {
        std::vector<app::ScissorCut> of = {};
        std::optional<Mask> mask = {};
    };
    void onEnded(const Result<std::optional<Mask>>& outcome);

    std::shared_ptr<const Volume> volume_;
    std::vector<app::ScissorCut> wanted_;
    Made made_;
    BackgroundJob<std::optional<Mask>> job_;
};

}  // namespace macula::viewer
