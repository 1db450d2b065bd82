// Radiotherapy doses of the open study: their panel, the dose over the slices, and dose-volume histograms.
#pragma once

#include <QObject>
#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

#include "study/dose/dose_report.h"
#include "study/dose/found_dose.h"
#include "viewer/context/window_context.h"
#include "viewer/jobs/background_job.h"

class QAction;
class QMenu;

namespace macula::viewer {

class DosePanel;
class DvhDialog;
class SecondVolumeLoader;

// Lives on the UI thread.
class DoseController : public QObject {
    Q_OBJECT

  public:
    DoseController(const WindowContext& context, SecondVolumeLoader& second);  // outlives this

    DosePanel& panel() const { return *panel_; }
    DvhDialog& dialog() const { return *dialog_; }
    const std::vector<study::FoundDose>& found() const { return found_; }  // on the open images
    bool isAtRest() const { return finding_.atRest() && reporting_.atRest(); }
    void addViewActions(QMenu& view);
    void showNames(bool shown);

  private:
    using Found = std::vector<study::FoundDose>;
    using Report = std::shared_ptr<const study::DoseReport>;

    void onStudyShown();
    void showDose(std::size_t dose);       // an index into found()
    void showHistogram(std::size_t dose);  // likewise
    void onReport(const Result<Report>& outcome);
    void showState();
    void exportCsv(const QString& csv);
    QStringList notes() const;

    WindowContext context_;
    SecondVolumeLoader& second_;
    DosePanel* panel_;
    DvhDialog* dialog_;
    QAction* show_ = nullptr;
    QAction* histogram_ = nullptr;
    Found found_;
    std::size_t reported_ = 0;  // the dose of the histogram, an index into found_
    BackgroundJob<Found> finding_;
    BackgroundJob<Report> reporting_;
};

}  // namespace macula::viewer
