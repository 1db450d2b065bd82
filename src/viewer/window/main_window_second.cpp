// A second volume beside the study: how it is opened, and where it is seen.
#include <QFileDialog>
#include <QMenu>
#include <QStatusBar>

#include "registration/rigid_registration.h"
#include "viewer/browser/study_browser.h"
#include "viewer/keys/keys.h"
#include "viewer/language/core_words.h"
#include "viewer/panes/tool_box.h"
#include "viewer/second/patient_question.h"
#include "viewer/second/second_volume_bar.h"
#include "viewer/second/second_volume_loader.h"
#include "viewer/second/slice_pair.h"
#include "viewer/volume/shown_additions.h"
#include "viewer/volume/shown_volume.h"
#include "viewer/window/join_question.h"
#include "viewer/window/main_window.h"

namespace macula::viewer {

// After panes and panels.
void MainWindow::makeSecondVolume() {
    secondVolume_ = new SecondVolumeLoader(session_, this);
    besideWork_ = new WorkBar;
    connect(browser_, &StudyBrowser::secondAsked, this,
            [this](std::size_t index) { secondVolume_->open(browser_->found(), index); });
    connect(secondVolume_, &SecondVolumeLoader::began, this, [this](const QString& stage) {
        messages_->hide();
        besideWork_->begin(stage);
    });
    connect(secondVolume_, &SecondVolumeLoader::progressed, besideWork_, &WorkBar::setProgress);
    connect(secondVolume_, &SecondVolumeLoader::ended, this, [this] {
        besideWork_->hide();
        if (session_.state().secondVolume && secondVolume_->state() == nullptr)
            showNotes();  // it is still not there
    });
    connect(besideWork_, &WorkBar::cancelClicked, secondVolume_, &SecondVolumeLoader::cancel);
    connect(secondVolume_, &SecondVolumeLoader::failed, this, [this](const Error& error) {
        messages_->showError(error);
        emit failed(error);
    });
    connect(secondVolume_, &SecondVolumeLoader::askedAboutPatient, this, [this](const QStringList& differs) {
        viewport_->window().endDrag();
        askAboutPatient(
            this, differs, [this] { secondVolume_->acceptPatient(); },
            [this] { secondVolume_->refusePatient(); });
    });
    connect(secondVolume_, &SecondVolumeLoader::askedToJoin, this,
            [this](const QString& path, const QString& question) {
                viewport_->window().endDrag();
                askToJoin(this, question, [this, path] { secondVolume_->open(path.toStdString(), true); });
            });
    connect(secondVolume_, &SecondVolumeLoader::secondChanged, this, [this] {
        for (SlicePair* pair : pairs_) pair->setSecond(secondVolume_->second());
        shown_->additions().setSecond(secondVolume_->second());
        showSecond();
        showNotes();
    });
    connect(&session_, &StudyEditor::changed, this, &MainWindow::showSecond);
    for (SlicePair* pair : pairs_) {
        SliceView* pane = &pair->second();
        connect(tools_, &ToolBox::toolChosen, pane, &SliceView::setTool);
        connect(pane, &SliceView::maximizeAsked, &pair->study(), &SliceView::maximizeAsked);
    }
}

// After the other bars: it has a row of its own.
void MainWindow::makeSecondVolumeBar() {
    addToolBarBreak();
    besideBar_ = new SecondVolumeBar(session_, *secondVolume_, this);
    connect(besideBar_, &SecondVolumeBar::listLeft, this, &MainWindow::focusPicture);
    addToolBar(besideBar_);
    besideBar_->showState();
    statusBar()->addWidget(besideWork_);
    besideWork_->hide();
    showSecond();
}

// As the state has it.
void MainWindow::showSecond() {
    const scene::SecondVolumeState* state = secondVolume_->state();
    const bool both = state != nullptr && state->view == scene::SecondVolumePlace::beside;
    for (SlicePair* pair : pairs_) pair->setBoth(both);
    for (QAction* action : besideActions_) action->setEnabled(state != nullptr);
}

QStringList MainWindow::besideNotes() const {
    QStringList notes;
    const scene::SecondVolumeState* state = secondVolume_->state();
    if (state == nullptr) {
        if (session_.state().secondVolume && !secondVolume_->isWorking())
            notes << tr(
                "The second volume that was beside this study is not open; open it with Ctrl+B to see "
                "both as they were.");
        return notes;
    }
    if (secondVolume_->isPlacedAnew())
        notes << tr(
            "Where the second volume lay when this study was left is not taken over: the images had other "
            "values or positions then, or an older Macula kept it. It is placed anew.");
    const study::OpenedStudy& second = secondVolume_->second()->study;
    for (const std::string& assumption : second.volume->provenance().assumptions)
        notes << tr("Second volume: %1").arg(inWindowsLanguage(assumption));
    for (const std::string& message : second.messages)
        notes << tr("Second volume: %1").arg(inWindowsLanguage(message));
    if (registration::boxOverlap(*study().volume, *second.volume, state->secondFromStudy) == 0.0)
        notes << tr("The second volume shows another part of the body: nothing of it lies in the study.");
    return notes;
}

void MainWindow::addSecondToFile(QMenu& file) {
    QAction* beside = file.addAction(tr("Open &Beside…"), this, [this] {
        if (const auto index = browserShown_->isChecked() ? browser_->selectedOther() : std::nullopt)
            return secondVolume_->open(browser_->found(), *index);
        askForSecond(QFileDialog::Directory);
    });
    beside->setObjectName(QStringLiteral("open-beside"));
    beside->setShortcut(keyOf(KeyAction::openSecond));
    beside->setToolTip(
        tr("A prior, a PET or an MR beside this study: what is selected in the list of studies, "
           "else of a folder"));
    file.addAction(tr("Open File Besi&de…"), this, [this] { askForSecond(QFileDialog::ExistingFile); })
        ->setToolTip(tr("The series of an image, or a NIfTI, NRRD or MetaImage file, beside this study"));
    QAction* close = file.addAction(tr("&Close Second Volume"), this, [this] { secondVolume_->close(); });
    close->setObjectName(QStringLiteral("close-second"));
    close->setToolTip(tr("The study stays open"));
    besideActions_ << close;
}

void MainWindow::addSecondToView(QMenu& view) {
    QAction* flip = view.addAction(tr("Second Volume in the Place of the Study"), this,
                                   [this] { secondVolume_->flip(); });
    flip->setObjectName(QStringLiteral("flip"));
    flip->setShortcuts({keyOf(KeyAction::flip), QKeySequence(Qt::CTRL | Qt::Key_Tab)});
    flip->setToolTip(tr("The same planes of the second volume, and back"));
    besideActions_ << flip;
}

void MainWindow::askForSecond(int mode) {
    const auto fileMode = QFileDialog::FileMode(mode);
    auto* dialog =
        new QFileDialog(this, tr("Open a second volume beside the study"), folders_.of(FolderKind::studies));
    dialog->setFileMode(fileMode);
    dialog->setOption(QFileDialog::ShowDirsOnly, fileMode == QFileDialog::Directory);
    ask(dialog, FolderKind::studies, [this](const QString& path) {
        sawStudy(path);
        secondVolume_->open(path.toStdString());
    });
}

}  // namespace macula::viewer
