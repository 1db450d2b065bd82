// A second volume beside the study: how it is opened, and where it is seen.
#include <QFileDialog>
#include <QMenu>
#include <QStatusBar>

#include "registration/rigid_registration.h"
#include "viewer/beside/beside_bar.h"
#include "viewer/beside/beside_study.h"
#include "viewer/beside/patient_question.h"
#include "viewer/beside/slice_pair.h"
#include "viewer/browser/study_browser.h"
#include "viewer/keys/keys.h"
#include "viewer/language/core_words.h"
#include "viewer/panes/tool_box.h"
#include "viewer/volume/shown_additions.h"
#include "viewer/volume/shown_volume.h"
#include "viewer/window/join_question.h"
#include "viewer/window/main_window.h"

namespace macula::viewer {

// After panes and panels.
void MainWindow::makeBeside() {
    beside_ = new BesideStudy(session_, this);
    besideWork_ = new WorkBar;
    connect(browser_, &StudyBrowser::besideAsked, this,
            [this](std::size_t index) { beside_->open(browser_->found(), index); });
    connect(beside_, &BesideStudy::began, this, [this](const QString& stage) {
        messages_->hide();
        besideWork_->begin(stage);
    });
    connect(beside_, &BesideStudy::progressed, besideWork_, &WorkBar::setProgress);
    connect(beside_, &BesideStudy::ended, this, [this] {
        besideWork_->hide();
        if (session_.state().beside && beside_->state() == nullptr) showNotes();  // it is still not there
    });
    connect(besideWork_, &WorkBar::cancelClicked, beside_, &BesideStudy::cancel);
    connect(beside_, &BesideStudy::failed, this, [this](const Error& error) {
        messages_->showError(error);
        emit failed(error);
    });
    connect(beside_, &BesideStudy::askedAboutPatient, this, [this](const QStringList& differs) {
        viewport_->window().endDrag();
        askAboutPatient(
            this, differs, [this] { beside_->acceptPatient(); }, [this] { beside_->refusePatient(); });
    });
    connect(beside_, &BesideStudy::askedToJoin, this, [this](const QString& path, const QString& question) {
        viewport_->window().endDrag();
        askToJoin(this, question, [this, path] { beside_->open(path.toStdString(), true); });
    });
    connect(beside_, &BesideStudy::secondChanged, this, [this] {
        for (SlicePair* pair : pairs_) pair->setSecond(beside_->second());
        shown_->additions().setSecond(beside_->second());
        showBeside();
        showNotes();
    });
    connect(&session_, &ViewerSession::changed, this, &MainWindow::showBeside);
    for (SlicePair* pair : pairs_) {
        SliceView* pane = &pair->second();
        connect(tools_, &ToolBox::toolChosen, pane, &SliceView::setTool);
        connect(pane, &SliceView::maximizeAsked, &pair->study(), &SliceView::maximizeAsked);
    }
}

// After the other bars: it has a row of its own.
void MainWindow::makeBesideBar() {
    addToolBarBreak();
    besideBar_ = new BesideBar(session_, *beside_, this);
    connect(besideBar_, &BesideBar::listLeft, this, &MainWindow::focusPicture);
    addToolBar(besideBar_);
    besideBar_->showState();
    statusBar()->addWidget(besideWork_);
    besideWork_->hide();
    showBeside();
}

// As the state has it.
void MainWindow::showBeside() {
    const app::BesideState* state = beside_->state();
    const bool both = state != nullptr && state->view == app::BesideView::beside;
    for (SlicePair* pair : pairs_) pair->setBoth(both);
    for (QAction* action : besideActions_) action->setEnabled(state != nullptr);
}

QStringList MainWindow::besideNotes() const {
    QStringList notes;
    const app::BesideState* state = beside_->state();
    if (state == nullptr) {
        if (session_.state().beside && !beside_->isWorking())
            notes << tr(
                "The second volume that was beside this study is not open; open it with Ctrl+B to see "
                "both as they were.");
        return notes;
    }
    if (beside_->isPlacedAnew())
        notes << tr(
            "Where the second volume lay when this study was left is not taken over: the images had other "
            "values or positions then, or an older Macula kept it. It is placed anew.");
    const app::OpenedStudy& second = beside_->second()->study;
    for (const std::string& assumption : second.volume->provenance().assumptions)
        notes << tr("Second volume: %1").arg(inWindowsLanguage(assumption));
    for (const std::string& message : second.messages)
        notes << tr("Second volume: %1").arg(inWindowsLanguage(message));
    if (registration::boxOverlap(*study().volume, *second.volume, state->secondFromStudy) == 0.0)
        notes << tr("The second volume shows another part of the body: nothing of it lies in the study.");
    return notes;
}

void MainWindow::addBesideToFile(QMenu& file) {
    QAction* beside = file.addAction(tr("Open &Beside…"), this, [this] {
        if (const auto index = browserShown_->isChecked() ? browser_->selectedOther() : std::nullopt)
            return beside_->open(browser_->found(), *index);
        askForBeside(QFileDialog::Directory);
    });
    beside->setObjectName(QStringLiteral("open-beside"));
    beside->setShortcut(keyOf(KeyAction::openBeside));
    beside->setToolTip(
        tr("A prior, a PET or an MR beside this study: what is selected in the list of studies, "
           "else of a folder"));
    file.addAction(tr("Open File Besi&de…"), this, [this] { askForBeside(QFileDialog::ExistingFile); })
        ->setToolTip(tr("The series of an image, or a NIfTI, NRRD or MetaImage file, beside this study"));
    QAction* close = file.addAction(tr("&Close Second Volume"), this, [this] { beside_->close(); });
    close->setObjectName(QStringLiteral("close-second"));
    close->setToolTip(tr("The study stays open"));
    besideActions_ << close;
}

void MainWindow::addBesideToView(QMenu& view) {
    QAction* flip =
        view.addAction(tr("Second Volume in the Place of the Study"), this, [this] { beside_->flip(); });
    flip->setObjectName(QStringLiteral("flip"));
    flip->setShortcuts({keyOf(KeyAction::flip), QKeySequence(Qt::CTRL | Qt::Key_Tab)});
    flip->setToolTip(tr("The same planes of the second volume, and back"));
    besideActions_ << flip;
}

void MainWindow::askForBeside(int mode) {
    const auto fileMode = QFileDialog::FileMode(mode);
    auto* dialog =
        new QFileDialog(this, tr("Open a second volume beside the study"), folders_.of(FolderKind::studies));
    dialog->setFileMode(fileMode);
    dialog->setOption(QFileDialog::ShowDirsOnly, fileMode == QFileDialog::Directory);
    ask(dialog, FolderKind::studies, [this](const QString& path) {
        sawStudy(path);
        beside_->open(path.toStdString());
    });
}

}  // namespace macula::viewer
