#include "viewer/viewport/viewport.h"  // before Qt, see vulkan_window.h

#include "viewer/second/second_volume_controller.h"

#include <QCoreApplication>
#include <QMainWindow>
#include <QMenu>
#include <QMessageBox>
#include <QPushButton>
#include <QStatusBar>
#include <array>
#include <functional>
#include <utility>

#include "registration/rigid_registration.h"
#include "viewer/browser/browser_controller.h"
#include "viewer/browser/study_browser.h"
#include "viewer/keys/keys.h"
#include "viewer/language/window_language.h"
#include "viewer/menus/controls.h"
#include "viewer/second/second_volume_bar.h"
#include "viewer/second/second_volume_loader.h"
#include "viewer/second/slice_pair.h"
#include "viewer/settings/file_dialogs.h"
#include "viewer/status/notifications.h"
#include "viewer/status/status_widgets.h"
#include "viewer/status/study_notes.h"
#include "viewer/volume/join_question.h"
#include "viewer/volume/shown_additions.h"
#include "viewer/volume/shown_volume.h"

namespace macula::viewer {

namespace {

struct Words {
    Q_DECLARE_TR_FUNCTIONS(PatientQuestion)

  public:
    // The attributes that study::whatDiffers may return.
    static constexpr std::array kAttributes{
        QT_TRANSLATE_NOOP("PatientQuestion", "ID"), QT_TRANSLATE_NOOP("PatientQuestion", "name"),
        QT_TRANSLATE_NOOP("PatientQuestion", "date of birth"), QT_TRANSLATE_NOOP("PatientQuestion", "sex")};
};

QString inWords(const QStringList& attributes) {
    QStringList all;
    for (const char* attribute : Words::kAttributes) {
        if (attributes.contains(QLatin1String(attribute))) all << Words::tr(attribute);
    }
    return all.join(QStringLiteral(", "));
}

// Returns at once; later calls `open` if the person agrees, else `leave`. `differs` names attributes, without
// values: "ID". Enter and Esc decline.
void askAboutPatient(QWidget* parent, const QStringList& differs, std::function<void()> open,
                     std::function<void()> leave) {
    auto* box =
        new QMessageBox(QMessageBox::Warning, Words::tr("Another patient?"),
                        Words::tr("The second volume is of another patient than the study. What differs: %1.")
                            .arg(inWords(differs)),
                        QMessageBox::Cancel, parent);
    box->setObjectName(QStringLiteral("patient-question"));
    box->setInformativeText(Words::tr(
        "Open it only if you know that both are of one patient, or mean to compare two patients. Pictures of "
        "it will say so."));
    box->setAttribute(Qt::WA_DeleteOnClose);
    QPushButton* yes = box->addButton(Words::tr("&Open All the Same"), QMessageBox::AcceptRole);
    box->setDefaultButton(QMessageBox::Cancel);
    QObject::connect(box, &QMessageBox::finished, box,
                     [box, yes, open = std::move(open), leave = std::move(leave)] {
                         if (box->clickedButton() == yes) {
                             open();
                         } else {
                             leave();
                         }
                     });
    box->open();  // exec() would run a second event loop
}

}  // namespace

SecondVolumeController::SecondVolumeController(const WindowContext& context, BrowserController& browser,
                                               const std::array<SlicePair*, 3>& pairs)
    : QObject(&context.window),
      context_(context),
      browser_(browser),
      pairs_(pairs),
      loader_(new SecondVolumeLoader(context.session)),
      work_(new WorkBar) {
    connect(&browser_.browser(), &StudyBrowser::secondAsked, this,
            [this](std::size_t index) { loader_->open(browser_.browser().found(), index); });
    connectLoader();
    askAbout();
    connect(&context_.session, &StudyEditor::changed, this, &SecondVolumeController::show);
    context_.notes.setSource(NoteOn::second, [this] { return notes(); });
}

SecondVolumeController::~SecondVolumeController() {
    delete toolBar_;
    delete loader_;
}

void SecondVolumeController::connectLoader() {
    connect(loader_, &SecondVolumeLoader::began, this, [this](const QString& stage) {
        context_.notifications.hide();
        work_->begin(stage);
    });
    connect(loader_, &SecondVolumeLoader::progressed, work_, &WorkBar::setProgress);
    connect(loader_, &SecondVolumeLoader::ended, this, [this] {
        work_->hide();
        if (context_.session.state().secondVolume && loader_->state() == nullptr)
            context_.notes.show();  // the second volume is still missing
    });
    connect(work_, &WorkBar::cancelClicked, loader_, &SecondVolumeLoader::cancel);
    connect(loader_, &SecondVolumeLoader::failed, this,
            [this](const Error& error) { context_.notifications.fail(error); });
    connect(loader_, &SecondVolumeLoader::secondChanged, this, [this] {
        for (SlicePair* pair : pairs_) pair->setSecond(loader_->second());
        context_.shown.additions().setSecond(loader_->second());
        show();
        context_.notes.show();
    });
}

void SecondVolumeController::askAbout() {
    connect(loader_, &SecondVolumeLoader::askedAboutPatient, this, [this](const QStringList& differs) {
        context_.viewport.window().endDrag();
        askAboutPatient(
            &context_.window, differs, [this] { loader_->acceptPatient(); },
            [this] { loader_->refusePatient(); });
    });
    connect(loader_, &SecondVolumeLoader::askedToJoin, this,
            [this](const QString& path, const QString& question) {
                context_.viewport.window().endDrag();
                askToJoin(&context_.window, question,
                          [this, path] { loader_->open(path.toStdString(), true); });
            });
}

void SecondVolumeController::addBars() {
    context_.window.addToolBarBreak();
    toolBar_ = new SecondVolumeBar(context_.session, *loader_, &context_.window);
    connect(toolBar_, &SecondVolumeBar::listLeft, this, [this] { context_.focusPicture(); });
    context_.window.addToolBar(toolBar_);
    toolBar_->showState();
    context_.window.statusBar()->addWidget(work_);
    work_->hide();
    show();
}

void SecondVolumeController::show() {
    const scene::SecondVolumeState* state = loader_->state();
    const bool both = state != nullptr && state->view == scene::SecondVolumePlace::beside;
    for (SlicePair* pair : pairs_) pair->setBoth(both);
    for (QAction* action : actions_) action->setEnabled(state != nullptr);
}

QStringList SecondVolumeController::notes() const {
    QStringList notes;
    const scene::SecondVolumeState* state = loader_->state();
    if (state == nullptr) {
        if (context_.session.state().secondVolume && !loader_->isWorking())
            notes << tr(
                "The second volume that was beside this study is not open; open it with Ctrl+B to see "
                "both as they were.");
        return notes;
    }
    if (loader_->isPlacedAnew())
        notes << tr(
            "Where the second volume lay when this study was left is not taken over: the images had other "
            "values or positions then, or an older Macula kept it. It is placed anew.");
    const study::OpenedStudy& second = loader_->second()->study;
    for (const Text& assumption : second.volume->provenance().assumptions)
        notes << tr("Second volume: %1").arg(inWindowsLanguage(assumption));
    for (const Text& message : second.messages)
        notes << tr("Second volume: %1").arg(inWindowsLanguage(message));
    if (registration::boxOverlap(*context_.session.study().volume, *second.volume, state->secondFromStudy) ==
        0.0)
        notes << tr("The second volume shows another part of the body: nothing of it lies in the study.");
    return notes;
}

void SecondVolumeController::addFileActions(QMenu& file) {
    QAction* beside = file.addAction(tr("Open &Beside…"), this, [this] {
        if (const auto index = browser_.selectedOther())
            return loader_->open(browser_.browser().found(), *index);
        askFor(QFileDialog::Directory);
    });
    beside->setObjectName(QStringLiteral("open-beside"));
    beside->setShortcut(keyOf(KeyAction::openSecond));
    beside->setToolTip(
        tr("A prior, a PET or an MR beside this study: what is selected in the list of studies, "
           "else of a folder"));
    file.addAction(tr("Open File Besi&de…"), this, [this] { askFor(QFileDialog::ExistingFile); })
        ->setToolTip(tr("The series of an image, or a NIfTI, NRRD or MetaImage file, beside this study"));
    QAction* close = file.addAction(tr("&Close Second Volume"), this, [this] { loader_->close(); });
    describe(*close, "close-second", tr("The study stays open"));
    actions_ << close;
}

void SecondVolumeController::addViewActions(QMenu& view) {
    QAction* flip =
        view.addAction(tr("Second Volume in the Place of the Study"), this, [this] { loader_->flip(); });
    flip->setObjectName(QStringLiteral("flip"));
    flip->setShortcuts({keyOf(KeyAction::flip), QKeySequence(Qt::CTRL | Qt::Key_Tab)});
    flip->setToolTip(tr("The same planes of the second volume, and back"));
    actions_ << flip;
}

void SecondVolumeController::askFor(int mode) {
    const QString title = tr("Open a second volume beside the study");
    auto* dialog = mode == QFileDialog::Directory ? context_.files.toOpenFolder(FolderKind::studies, title)
                                                  : context_.files.toOpen(FolderKind::studies, title);
    context_.files.ask(dialog, FolderKind::studies, [this](const QString& path) {
        context_.files.sawStudy(path);
        loader_->open(path.toStdString());
    });
}

}  // namespace macula::viewer
