// Saves the measurements of the open study to a file, as a table or as a DICOM report, and removes them.
#pragma once

#include <QObject>
#include <QString>
#include <functional>
#include <utility>
#include <vector>

#include "scene/slices/reported_measurements.h"
#include "viewer/context/window_context.h"
#include "viewer/jobs/background_job.h"

class QMenu;

namespace macula::viewer {

// Lives on the UI thread.
class MeasurementsController : public QObject {
    Q_OBJECT

  public:
    explicit MeasurementsController(const WindowContext& context);

    void addFileActions(QMenu& file);
    void addEditActions(QMenu& edit);
    // Called first when a person saves a table, or removes all; true: it did so with those of what hides the
    // slices.
    struct Instead {
        std::function<bool()> save = {};
        std::function<bool()> remove = {};
    };
    void setInstead(Instead instead) { instead_ = std::move(instead); }

    // What a report of the measurements is made of, as they are now. Fails with usage where there are none,
    // or no DICOM images are open.
    Result<scene::ReportRequest> onScreen() const;

    QString unfinished() const;  // a sentence; empty: nothing is being written
    void cancel() { saving_.cancel(); }

  Q_SIGNALS:
    void written();

  private:
    void askWhereToSave();
    void askHowToSaveReport();
    void askWhereToSaveReport(scene::ReportRequest request);

    WindowContext context_;
    Instead instead_;
    QString path_;  // of the report that is being written
    BackgroundJob<std::vector<Text>> saving_;
};

}  // namespace macula::viewer
