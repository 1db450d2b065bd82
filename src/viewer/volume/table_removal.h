// The table of a CT, hidden or shown.
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

// The action that hides the table, and the search that it begins. What was found is kept as long as the
// volume, so that the table comes and goes at once after the first time. Nothing is hidden of a volume before
// somebody asks for it. Lives on the UI thread.
class TableRemoval : public QObject {
    Q_OBJECT

  public:
    explicit TableRemoval(QObject* parent);

    QAction& action() { return action_; }
    void setVolume(std::shared_ptr<const Volume> volume);  // ends a search, of which nothing is told any more

    // As if somebody had checked the action, or had not.
    void ask(bool removed);
    bool searching() const { return job_.running(); }
    void cancel();

    // What of the volume is shown; nothing while all of it is.
    std::optional<Mask> mask() const;
    // What has to be known of it: what went, or why nothing did. Empty while nobody asks.
    QStringList notes() const;

  signals:
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
    bool asked_ = false;  // for what was found
};

}  // namespace macula::viewer
