#include "viewer/viewport/viewport.h"  // before Qt, see vulkan_window.h

#include "viewer/segmenting/segmenting_controller.h"

#include <QAction>
#include <QFileDialog>
#include <QMainWindow>
#include <QMenu>
#include <QScrollArea>
#include <QScrollBar>
#include <QSplitter>
#include <utility>

#include "scene/segments/own_segments.h"
#include "segment/surface_file.h"
#include "viewer/language/window_language.h"
#include "viewer/menus/controls.h"
#include "viewer/segmentation/segmentation_panel.h"
#include "viewer/segmenting/program_dialog.h"
#include "viewer/segmenting/segmenting_panel.h"
#include "viewer/settings/file_dialogs.h"
#include "viewer/slices/slice_view.h"
#include "viewer/status/notifications.h"
#include "viewer/status/status_widgets.h"
#include "viewer/status/study_notes.h"

namespace macula::viewer {

SegmentingController::SegmentingController(const WindowContext& context, const Parts& parts)
    : QObject(&context.window),
      context_(context),
      parts_(parts),
      work_(context.session, parts.keeper),
      stroke_(context.session, parts.keeper, work_),
      kept_(context.session, parts.keeper, parts.store),
      bar_(new WorkBar),
      saving_(this, {.progressed =
                         [this](const ProgressUpdate& update) {
                             bar_->setProgress(inWindowsLanguage(update.stage), update.fraction);
                         },
                     .ended =
                         [this](const Result<std::vector<Text>>& notes) {
                             bar_->hide();
                             if (notes) {
                                 if (holdsAll_) kept_.wereSaved(saved_);
                                 context_.notifications.showDone(
                                     tr("The segments are written to %1.").arg(path_),
                                     inWindowsLanguage(*notes));
                             } else {
                                 context_.notifications.failUnlessCancelled(notes.error());
                             }
                             Q_EMIT written();
                         }}) {
    for (SliceView* pane : parts_.slices) pane->setBrush(&stroke_);
    connectWork();
    connectProgram();
    connect(&kept_, &KeptSegments::looked, &context_.notes, &StudyNotes::show);
    connect(&kept_, &KeptSegments::failed, &context_.notifications, &Notifications::failUnlessCancelled);
    connect(&parts_.list, &SegmentationPanel::selectionChanged, this, &SegmentingController::followList);
}

void SegmentingController::connectWork() {
    connect(&work_, &SegmentWork::began, bar_, &WorkBar::begin);
    connect(&work_, &SegmentWork::progressed, bar_, &WorkBar::setProgress);
    connect(&work_, &SegmentWork::ended, bar_, &QWidget::hide);
    connect(&work_, &SegmentWork::failed, &context_.notifications, &Notifications::failUnlessCancelled);
    connect(&work_, &SegmentWork::added, this, &SegmentingController::follow);
    connect(bar_, &WorkBar::cancelClicked, this, [this] {
        work_.cancel();
        program_.cancel();
        if (saving_.cancel()) bar_->hide();
    });
}

void SegmentingController::connectProgram() {
    connect(&program_, &ProgramRun::progressed, bar_, &WorkBar::setProgress);
    connect(&program_, &ProgramRun::ended, bar_, &QWidget::hide);
    connect(&program_, &ProgramRun::failed, &context_.notifications, &Notifications::failUnlessCancelled);
    connect(&program_, &ProgramRun::succeeded, this, [this](const std::vector<scene::OwnSegment>& found) {
        std::vector<scene::OwnSegment> segments = found;
        for (scene::OwnSegment& each : segments) {
            each.segment.algorithm = "AUTOMATIC";
            each.segment.algorithmName = "unknown program";
        }
        const int count = int(segments.size());
        work_.addSegments(std::move(segments), tr("Segments of a program"));
        context_.notifications.showNote(
            tr("The program made %n segments. Nobody has checked them yet.", nullptr, count));
    });
    // Its volume is no longer the open one.
    connect(&context_.session, &StudyEditor::studyShown, &program_, &ProgramRun::cancel);
}

// A revision takes the place of another: then the same segment stays selected in the list.
void SegmentingController::followList() {
    const auto row = parts_.list.selected();
    const bool isOwn = row && row->number && parts_.keeper.isOwn(row->digest);
    if (isOwn) {
        work_.select(row->number);
    } else if (row) {
        work_.select(std::nullopt);
    }
}

void SegmentingController::follow(std::uint16_t number) {
    if (parts_.keeper.own()) parts_.list.select({parts_.keeper.own()->digest, number});
}

QWidget* SegmentingController::makePanel() {
    auto* tools = new SegmentingPanel(context_.session, work_);
    connect(tools, &SegmentingPanel::toolAsked, this, [this] {
        if (tool_ != nullptr) tool_->trigger();
    });
    connect(tools, &SegmentingPanel::saveAsked, this, &SegmentingController::askWhereToSave);
    connect(tools, &SegmentingPanel::programAsked, this, &SegmentingController::askForProgram);
    auto* scroll = new QScrollArea;
    scroll->setWidget(tools);
    scroll->setWidgetResizable(true);
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setFocusPolicy(Qt::NoFocus);  // its contents have the focus
    scroll->setMinimumWidth(tools->sizeHint().width() + scroll->verticalScrollBar()->sizeHint().width());
    auto* both = new QSplitter(Qt::Vertical);
    both->setChildrenCollapsible(false);
    both->addWidget(&parts_.list);
    both->addWidget(scroll);
    return both;
}

void SegmentingController::addFileActions(QMenu& file) {
    QAction* save = file.addAction(tr("Save Own Segments…"), this, &SegmentingController::askWhereToSave);
    describe(*save, "save-own-segments", tr("A NIfTI label map, or the surface of a segment as STL or glTF"));
    QAction* program =
        file.addAction(tr("Segment by a Program…"), this, &SegmentingController::askForProgram);
    describe(*program, "segment-by-program", tr("Lets a program of your own segment the open volume"));
}

QString SegmentingController::unfinished() {
    kept_.flush();
    if (saving_.running()) return tr("Segments are still being written.");
    if (program_.isRunning()) return tr("A program is still segmenting.");
    return kept_.isAllKept() ? QString() : tr("Own segments are in no file, and are not kept.");
}

void SegmentingController::cancel() {
    saving_.cancel();
    program_.cancel();
    work_.cancel();
    kept_.giveUp();
}

scene::SegmentsToSave SegmentingController::toSave() const {
    scene::SegmentsToSave what;
    what.volume = context_.session.study().measured();
    const auto& own = parts_.keeper.own();
    if (!own) return what;
    what.segments = scene::segmentsOf(*own);
    if (const study::LoadedSegment* chosen = work_.segment()) {
        what.surfaceOf = chosen->voxels;
        const auto choice = scene::choiceOf(context_.session.state().segmentations, own->digest);
        what.rgb =
            scene::choiceOf(choice, chosen->segment.number).rgb.value_or(study::usualRgb(chosen->segment));
    }
    return what;
}

void SegmentingController::askWhereToSave() {
    if (!parts_.keeper.own() || parts_.keeper.own()->segments.empty())
        return context_.notifications.refuse(tr("There are no own segments."),
                                             tr("Make one in the panel Segmentations, F11."));
    // Takes what is there now: while a person answers, another study may open.
    auto* dialog = context_.files.toSave(
        FolderKind::measurements, tr("Save own segments"),
        tr("NIfTI label map of all (*.nii.gz);;Surface of the selected one, STL (*.stl);;"
           "Surface of the selected one, glTF (*.glb)"),
        QStringLiteral("nii.gz"), QStringLiteral("segments.nii.gz"));
    FileDialogs::followFilter(*dialog);
    context_.files.ask(dialog, FolderKind::measurements,
                       [this, what = toSave(), mark = kept_.mark()](const QString& path) {
                           saved_ = mark;
                           path_ = path;
                           holdsAll_ = !segment::surfaceFormatOf(path.toStdString());
                           bar_->begin(tr("Saving segments"));
                           saving_.start([path = path.toStdString(), what](Progress& progress) {
                               return scene::saveSegments(path, what, progress);
                           });
                       });
}

void SegmentingController::askForProgram() {
    if (!context_.notifications.refuseUnless(context_.session.hasStudy(), tr("No study is open."))) return;
    context_.viewport.window().endDrag();  // the dialog gets the button's release
    auto* dialog = new ProgramDialog(lastProgram_, &context_.window);
    connect(dialog, &QDialog::accepted, this, [this, dialog] {
        lastProgram_ = dialog->program();
        if (!context_.session.hasStudy()) return;
        bar_->begin(tr("Segmenting by a program"));
        if (const auto started = program_.start(lastProgram_, context_.session.study().measured());
            !started) {
            bar_->hide();
            context_.notifications.fail(started.error());
        }
    });
    dialog->open();
}

}  // namespace macula::viewer
