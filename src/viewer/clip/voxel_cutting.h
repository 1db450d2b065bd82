// Which voxels the scissors leave, found while the window goes on.
#pragma once

#include <QObject>
#include <QString>
#include <memory>
#include <optional>
#include <vector>

#include "app/clip/cuts.h"
#include "base/result.h"
#include "base/volume.h"
#include "pipeline/volume/clip.h"
#include "viewer/background_job.h"

namespace macula::viewer {

// Keeps the mask of app::shownVoxels for what was wanted last. Until it is found the one before holds, and a
// cut that comes after others takes no more time than alone. Lives on the UI thread.
class VoxelCutting : public QObject {
    Q_OBJECT

  public:
    explicit VoxelCutting(QObject* parent);

    void setVolume(std::shared_ptr<const Volume> volume);  // nothing is hidden of it yet
    // `others` is what is hidden besides. Whether the mask is another one at once; else `changed` tells.
    bool want(const std::optional<Mask>& others, const std::vector<app::ScissorCut>& scissors);
    const std::optional<Mask>& mask() const { return made_.mask; }
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
    struct Wanted {
        std::optional<Mask> others = {};
        std::vector<app::ScissorCut> scissors = {};
        bool operator==(const Wanted&) const = default;
    };
    struct Made {
        Wanted of = {};
        std::optional<Mask> mask = {};
    };
    void onEnded(const Result<std::optional<Mask>>& outcome);
    void refuse();

    std::shared_ptr<const Volume> volume_;
    Wanted wanted_;
    Made made_;
    BackgroundJob<std::optional<Mask>> job_;
};

}  // namespace macula::viewer
