#include "viewer/viewport/viewport.h"  // before Qt, see vulkan_window.h

#include "viewer/hanging/hanging_controller.h"

#include <QAction>
#include <QDialog>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QInputDialog>
#include <QMainWindow>
#include <QMenu>
#include <QSpinBox>
#include <algorithm>
#include <array>
#include <chrono>
#include <utility>

#include "viewer/editor/study_editor.h"
#include "viewer/keys/keys.h"
#include "viewer/language/window_language.h"
#include "viewer/menus/controls.h"
#include "viewer/planar/planar_controller.h"
#include "viewer/planar/planar_measuring.h"
#include "viewer/planar/planar_presenting.h"
#include "viewer/status/notifications.h"

namespace macula::viewer {

namespace {

constexpr std::chrono::milliseconds kScrollEnds{500};
constexpr std::array<std::pair<int, int>, 8> kGrids{
    {{1, 1}, {1, 2}, {2, 1}, {2, 2}, {1, 3}, {2, 3}, {2, 4}, {3, 3}}};

}  // namespace

HangingController::HangingController(const WindowContext& context, PlanarController& images,
                                     const std::optional<std::filesystem::path>& folder)
    : QObject(&context.window),
      context_(context),
      images_(images),
      own_(new OwnProtocols(folder, this)),
      kept_(new KeptArrangement(this)),
      menu_(new QMenu(tr("&Boxes of Images"), &context.window)),
      reading_(this, {.ended = [this](const auto& facts) { take(facts); }}) {
    menu_->setObjectName(QStringLiteral("boxes-menu"));
    menu_->setToolTipsVisible(true);
    acquired_ = new QAction(tr("As &Acquired"), this);
    describe(*acquired_, "images-as-acquired",
             tr("Show the slices of the open volume as they were acquired, and priors beside them"));
    acquired_->setShortcut(keyOf(KeyAction::images));
    acquired_->setEnabled(false);
    connect(acquired_, &QAction::triggered, this, &HangingController::showAsAcquired);
    connect(menu_, &QMenu::aboutToShow, this, &HangingController::fillMenu);
    fillMenu();
    images_.boxes().setMenu(menu_);
    connect(own_, &OwnProtocols::failed, &context_.notifications, &Notifications::showError);
    connect(&images_, &PlanarController::begun, this, &HangingController::begin);
    connect(&images_.boxes(), &ImageBoxes::arranged, this, [this] {
        if (!images_.isShown() || isHanging_) return;
        isUntouched_ = false;
        keep();
    });
    scrollEnds_.setSingleShot(true);
    scrollEnds_.setInterval(kScrollEnds);
    connect(&images_.boxes(), &ImageBoxes::scrolled, this, [this] {
        isUntouched_ = false;
        scrollEnds_.start();
    });
    connect(&scrollEnds_, &QTimer::timeout, this, &HangingController::keep);
    connect(&images_, &PlanarController::aboutToClose, this, [this] {
        keep();
        kept_->close();
    });
    connect(&images_, &PlanarController::shownChanged, this, [this] {
        if (images_.isShown()) return;
        kept_->close();
        onStudyShown();
    });
    connect(kept_, &KeptArrangement::answered, this, [this](const std::optional<study::KeptBoxes>& kept) {
        left_ = kept;
        isAnswered_ = true;
        if (!isUntouched_) return keep();
        hangFirst();
    });
}

void HangingController::keepIn(const std::shared_ptr<live::StudyKeeper>& keeper) {
    if (scrollEnds_.isActive()) keep();
    kept_->setKeeper(keeper);
}

// Nothing before the store has answered: it would replace what a person left.
void HangingController::keep() {
    scrollEnds_.stop();
    if (images_.isShown() && isAnswered_) kept_->keep(keptOf(images_.boxes().arrangement()));
}

void HangingController::addMenu(QMenu& view) {
    view.addMenu(menu_);
}

void HangingController::onStudyShown() {
    const study::OpenedStudy& open = context_.session.study();
    acquired_->setEnabled(open.found != nullptr);
    // What is known of another folder would keep that, and the copy of an archive that it came from.
    if (!images_.isShown() && facts_ && facts_->found != open.found) facts_.reset();
    if (!images_.isShown()) reading_.cancel();
    if (open.found != nullptr && !images_.isShown())
        prepare(open.found,
                study::studyToRead(*open.found->volumes().at(open.volumeIndex).study, *open.found));
}

// The images of another patient or folder are shown.
void HangingController::begin() {
    const ImageBox& first = images_.box();
    isUntouched_ = true;
    isAnswered_ = false;
    left_.reset();
    const dicom::Study& read = study::studyToRead(*first.series().study, *first.found());
    prepare(first.found(), read);
    kept_->open(read);
}

void HangingController::prepare(std::shared_ptr<const study::FoundVolumes> found, const dicom::Study& study) {
    if (facts_ && facts_->found == found && facts_->images.studies.front() == &study) return;
    facts_.reset();
    reading_.start(
        [found = std::move(found), &study](Progress& progress) -> Result<std::shared_ptr<const Facts>> {
            MACULA_TRY(auto images, study::hangingImages(study, *found, progress));
            return std::make_shared<const Facts>(Facts{found, std::move(images)});
        });
}

void HangingController::take(const Result<std::shared_ptr<const Facts>>& facts) {
    if (!facts) return;
    facts_ = *facts;
    hangFirst();
}

// Once both are known: how it was left, and what there is to hang.
void HangingController::hangFirst() {
    if (!images_.isShown() || !isUntouched_ || !isAnswered_) return;
    const ImageBox& first = images_.box();
    if (!first.isShown() || first.measuring().isDrawing() || first.presenting().isWanted()) {
        isUntouched_ = false;
        return;
    }
    const auto hasFirst = [&](const BoxArrangement& arrangement) {
        return std::ranges::any_of(arrangement.boxes, [&](const BoxArrangement::Box& box) {
            return box.stack == first.series().stack;
        });
    };
    std::optional<BoxArrangement> wanted;
    if (left_) {
        wanted = arrangementOf(*left_, first.found(), first.series().study->patient);
        if (!hasFirst(*wanted)) wanted.reset();
    } else if (!facts_) {
        return;
    }
    if (!wanted && !left_ && facts_->found == first.found()) {
        std::vector<study::HangingProtocol> all = own_->all();
        const auto& builtIn = study::builtInHangingProtocols();
        all.insert(all.end(), builtIn.begin(), builtIn.end());
        for (const study::HangingProtocol& protocol : all) {
            if (!study::isFor(protocol, facts_->images)) continue;
            BoxArrangement made = hung(protocol);
            if (!hasFirst(made)) continue;
            wanted = std::move(made);
            break;
        }
    }
    isUntouched_ = false;
    if (!wanted || *wanted == images_.boxes().arrangement()) return;
    isHanging_ = true;
    images_.boxes().hang(*wanted);
    isHanging_ = false;
}

// Slices begin in their middle: places of different studies are no measure, so this is where they are linked.
BoxArrangement HangingController::hung(const study::HangingProtocol& protocol) const {
    BoxArrangement made{
        .rows = protocol.rows, .columns = protocol.columns, .boxes = {}, .isLinked = protocol.isLinked};
    for (const auto& place : study::hang(protocol, facts_->images)) {
        made.boxes.emplace_back();
        if (!place) continue;
        const study::HangingImage& image = facts_->images.images[*place];
        made.boxes.back() = {facts_->found, image.of.stack,
                             image.isVolume ? image.of.stack->frames.size() / 2 : image.place};
    }
    return made;
}

void HangingController::apply(const study::HangingProtocol& protocol) {
    if (!facts_) return;
    const BoxArrangement made = hung(protocol);
    const ImageBox* shown = images_.boxes().firstShown();
    const int patient = facts_->images.studies.front()->patient;
    if (shown != nullptr && shown->found() == facts_->found && shown->series().study->patient == patient)
        return images_.boxes().arrange(tr("Hanging protocol"), made);
    isUntouched_ = false;
    kept_->close();
    images_.showBoxes(made);
    kept_->open(*facts_->images.studies.front());
}

void HangingController::hang(const QString& title) {
    const auto isCalled = [&](const study::HangingProtocol& each) {
        return inWindowsLanguage(each.titleForPeople()) == title;
    };
    for (const auto* all : {&own_->all(), &study::builtInHangingProtocols()}) {
        const auto found = std::ranges::find_if(*all, isCalled);
        if (found != all->end() && facts_ && study::isFor(*found, facts_->images)) return apply(*found);
    }
}

void HangingController::showAsAcquired() {
    const study::OpenedStudy& open = context_.session.study();
    if (open.found == nullptr) return;
    images_.show(open.found, open.found->volumes().at(open.volumeIndex).stack);
}

void HangingController::setGrid(int rows, int columns) {
    if (!images_.isShown()) {
        if (!acquired_->isEnabled()) return;
        showAsAcquired();
    }
    isUntouched_ = false;
    images_.boxes().setGrid(rows, columns);
}

void HangingController::fillMenu() {
    menu_->clear();
    qDeleteAll(menu_->findChildren<QMenu*>());
    menu_->addAction(acquired_);
    menu_->addSeparator();
    addGrids(*menu_);
    menu_->addSeparator();
    addProtocols(*menu_);
    menu_->addSeparator();
    const bool isShown = images_.isShown();
    QAction* linked = menu_->addAction(tr("&Scroll Together") + QStringLiteral("\tL"));
    describe(*linked, "link-boxes", tr("By the place in the patient; across studies as the boxes lie now"));
    linked->setCheckable(true);
    linked->setChecked(images_.boxes().isLinked());
    linked->setEnabled(isShown);
    connect(linked, &QAction::triggered, &images_.boxes(), &ImageBoxes::setLinked);
    QAction* alone = menu_->addAction(tr("This Box A&lone") + QStringLiteral("\tB"));
    describe(*alone, "box-alone", tr("The box that is chosen, or all of them again"));
    alone->setCheckable(true);
    alone->setChecked(images_.boxes().isAlone());
    alone->setEnabled(isShown);
    connect(alone, &QAction::triggered, &images_.boxes(), &ImageBoxes::setAlone);
    QAction* detached = menu_->addAction(tr("In a &Window of Their Own"));
    describe(*detached, "images-in-own-window",
             tr("On another screen where there is one, while this window shows the volume"));
    detached->setCheckable(true);
    detached->setChecked(images_.isDetached());
    connect(detached, &QAction::triggered, &images_, &PlanarController::setDetached);
}

void HangingController::addGrids(QMenu& menu) {
    const bool can = images_.isShown() || acquired_->isEnabled();
    for (const auto& [rows, columns] : kGrids) {
        QAction* action = menu.addAction(tr("%1 × %2").arg(rows).arg(columns));
        action->setObjectName(QStringLiteral("boxes-%1-%2").arg(rows).arg(columns));
        action->setToolTip(tr("Rows and columns of boxes"));
        action->setEnabled(can);
        connect(action, &QAction::triggered, this,
                [this, grid = std::pair(rows, columns)] { setGrid(grid.first, grid.second); });
    }
    QAction* other = menu.addAction(tr("&Other Grid…"), this, &HangingController::askForGrid);
    describe(*other, "boxes-other", tr("Any number of rows and columns"));
    other->setEnabled(can);
}

void HangingController::addProtocols(QMenu& menu) {
    const auto add = [&](const study::HangingProtocol& protocol) {
        const bool fits = facts_ && study::isFor(protocol, facts_->images);
        if (!fits && !protocol.title.empty()) return;
        QAction* action = menu.addAction(
            inWindowsLanguage(protocol.titleForPeople()).replace(QLatin1Char('&'), QStringLiteral("&&")));
        action->setObjectName(QStringLiteral("hanging-protocol"));
        action->setEnabled(fits);
        action->setToolTip(fits ? tr("Hang the study by this protocol") : tr("It is for other studies."));
        connect(action, &QAction::triggered, this, [this, protocol] { apply(protocol); });
    };
    for (const study::HangingProtocol& each : own_->all()) add(each);
    for (const study::HangingProtocol& each : study::builtInHangingProtocols()) add(each);
    QAction* save = menu.addAction(tr("Save as &Hanging Protocol…"), this, &HangingController::askForName);
    describe(*save, "save-hanging-protocol", tr("Hang studies of this kind as these boxes are now"));
    save->setEnabled(images_.isShown() && facts_ != nullptr);
    if (own_->all().empty()) return;
    QMenu* remove = menu.addMenu(tr("&Remove Hanging Protocol"));
    for (const study::HangingProtocol& each : own_->all()) {
        const QString title = QString::fromStdString(each.name);
        remove->addAction(QString(title).replace(QLatin1Char('&'), QStringLiteral("&&")), this,
                          [this, name = each.name] { own_->remove(name); });
    }
}

void HangingController::askForGrid() {
    auto* dialog = new QDialog(&context_.window);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setObjectName(QStringLiteral("grid-dialog"));
    dialog->setWindowTitle(tr("Boxes of Images"));
    auto* form = new QFormLayout(dialog);
    const auto add = [&](const char* name, const QString& title, int most, int value) {
        auto* box = new QSpinBox;
        describe(*box, name, title, title);
        box->setRange(1, most);
        box->setValue(value);
        form->addRow(title, box);
        return box;
    };
    QSpinBox* rows = add("grid-rows", tr("Rows"), study::kMostBoxRows, images_.boxes().rows());
    QSpinBox* columns = add("grid-columns", tr("Columns"), study::kMostBoxColumns, images_.boxes().columns());
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel);
    form->addRow(buttons);
    connect(buttons, &QDialogButtonBox::accepted, dialog, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, dialog, &QDialog::reject);
    connect(dialog, &QDialog::accepted, this,
            [this, rows, columns] { setGrid(rows->value(), columns->value()); });
    dialog->open();
}

void HangingController::askForName() {
    auto* dialog = new QInputDialog(&context_.window);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setObjectName(QStringLiteral("hanging-protocol-name"));
    dialog->setWindowTitle(tr("Save as Hanging Protocol"));
    dialog->setLabelText(tr("Name; one of the same name is replaced"));
    connect(dialog, &QInputDialog::textValueSelected, this, &HangingController::save);
    dialog->open();
}

void HangingController::save(const QString& name) {
    if (!images_.isShown() || !facts_) return;
    const BoxArrangement now = images_.boxes().arrangement();
    std::vector<std::optional<std::size_t>> shown;
    const std::vector<study::HangingImage>& images = facts_->images.images;
    for (const BoxArrangement::Box& box : now.boxes) {
        shown.emplace_back();
        // Of the images of a stack, the one that is shown or came before.
        for (std::size_t i = 0; i < images.size(); ++i)
            if (box.stack != nullptr && images[i].of.stack == box.stack &&
                images[i].place <= box.place.value_or(0))
                shown.back() = i;
    }
    const study::HangingProtocol made = study::protocolOf(name.trimmed().toStdString(), now.rows, now.columns,
                                                          shown, now.isLinked, facts_->images);
    if (const Result<void> added = own_->add(made); !added)
        return context_.notifications.showError(added.error());
    context_.notifications.showNote(tr("Studies of this kind are hung so from now on."));
}

}  // namespace macula::viewer
