// Segmenting in the window: the tools of the panel, the brush on slices, and what becomes of the segments.
#pragma once

#include <QObject>
#include <QString>
#include <array>
#include <vector>

#include "scene/segments/segments_to_file.h"
#include "viewer/context/window_context.h"
#include "viewer/jobs/background_job.h"
#include "viewer/segmenting/kept_segments.h"
#include "viewer/segmenting/program_run.h"
#include "viewer/segmenting/segment_stroke.h"
#include "viewer/segmenting/segment_work.h"

class QAction;
class QMenu;

namespace macula::viewer {

class SegmentationPanel;
class SliceView;
class WorkBar;

// Lives on the UI thread.
class SegmentingController : public QObject {
    Q_OBJECT

  public:
    struct Parts {  // outlive its use
        SegmentationKeeper& keeper;
        SegmentationPanel& list;
        std::array<SliceView*, 3> slices;
        live::StudyKeeper* store = nullptr;  // null: nothing is kept between runs
    };
    SegmentingController(const WindowContext& context, const Parts& parts);

    QWidget* makePanel();  // the list of segmentations, with the tools below it
    void setToolAction(QAction& tool) { tool_ = &tool; }  // takes SliceTool::segment
    void addFileActions(QMenu& file);
    WorkBar* bar() const { return bar_; }
    SegmentWork& work() { return work_; }
    ProgramRun& program() { return program_; }

    void keep() { kept_.flush(); }  // before the program ends
    QString unfinished();           // a sentence; empty: nothing would be lost
    void cancel();

    void askForProgram();
    void askWhereToSave();

  Q_SIGNALS:
    void written();

  private:
    void connectWork();
    void connectProgram();
    void followList();
    void follow(std::uint16_t number);
    scene::SegmentsToSave toSave() const;

    WindowContext context_;
    Parts parts_;
    SegmentWork work_;
    SegmentStroke stroke_;
    KeptSegments kept_;
    ProgramRun program_;
    ProgramToRun lastProgram_;
    WorkBar* bar_;
    QAction* tool_ = nullptr;
    QString path_;              // of the file that is being written
    bool holdsAll_ = false;     // that file
    KeptSegments::Mark saved_;  // what it holds
    BackgroundJob<std::vector<Text>> saving_;
};

}  // namespace macula::viewer
