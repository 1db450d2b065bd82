// Opens what links ask for: from a RIS, an EHR, or any web page.
#pragma once

#include <QObject>
#include <QPointer>
#include <QString>

#include "net/sources/source_list.h"
#include "study/link/linked_studies.h"
#include "viewer/context/window_context.h"
#include "viewer/jobs/background_job.h"

class QWidget;

namespace macula::viewer {

class ArchiveController;
class WorkBar;

// Nothing is asked of an archive before a person has said yes to that link, and there is no way to say yes to
// all. One question at a time: while it is open, other links are refused, since a question that changed under
// the hand would be answered unread. Lives on the UI thread.
class LinksController : public QObject {
    Q_OBJECT

  public:
    LinksController(const WindowContext& context, ArchiveController& archive);

    void open(const QString& link);
    WorkBar* bar() const { return bar_; }  // while archives are asked
    void showNames(bool shown) { showsNames_ = shown; }
    bool asking() const { return !question_.isNull(); }
    bool searching() const { return search_.running(); }

  private:
    void search(const study::StudyLink& link, const net::SourceList& sources);
    void showFound(const Result<study::LinkedStudies>& found);
    void fetch(const study::LinkedStudy& study);

    WindowContext context_;
    ArchiveController& archive_;
    WorkBar* bar_;
    bool showsNames_ = true;
    QPointer<QWidget> question_;  // or the choice that follows it
    bool isByUid_ = false;        // the link that is followed names a Study Instance UID
    BackgroundJob<study::LinkedStudies> search_;
};

}  // namespace macula::viewer
