// Hides the table of a CT.
#pragma once

#include <QAction>
#include <QObject>
#include <QString>
#include <QStringList>
#include <memory>
#include <optional>

#include "base/result.h"
#include "base/volume.h"
#include "pipeline/volume/clip.h"
#include "segment/patient.h"
#include "viewer/jobs/background_job.h"

namespace macula::viewer {

// The action that hides the table, and the search that it starts. Keeps the result as long as the volume, so
// that the table toggles at once after the first time. Hides nothing until asked. Lives on the UI thread.
class TableRemoval : public QObject {
    Q_OBJECT

  public:
    explicit TableRemoval(QObject* parent);

    QAction& action() { return action_; }
    void setVolume(std::shared_ptr<const Volume> volume);  // ends a search; only `ended` follows

    // As if a person had checked or unchecked the action.
    void ask(bool removed);
    bool searching() const { return job_.running(); }
    void cancel();

    // The voxels to show; nothing: all of them.
    std::optional<Mask> mask() const;
    // Notes: what was removed, or why nothing was. Empty unless removal was asked for.
    QStringList notes() const;

  Q_SIGNALS:
    void began();
    void progressed(const QString& stage, double fraction);
    void ended();
    void changed();  // the mask or the notes
    void failed(const macula::Error& error);

  private:
    using Found = std::shared_ptr<const segment::PatientMask>;

    void onTriggered();
    void onEnded(const Result<Found>& outcome);

    QAction action_;
    BackgroundJob<Found> job_;
    std::shared_ptr<const Volume> volume_;
    Found found_;
    bool asked_ = false;  // a person wants the removal that found_ describes
};

}  // namespace macula::viewer
