#include "viewer/viewport/viewport.h"  // before Qt, see vulkan_window.h

#include "viewer/planar/image_boxes.h"

#include <QGridLayout>
#include <QStackedWidget>
#include <algorithm>
#include <set>
#include <utility>

#include "base/check.h"
#include "study/planar/linked_frames.h"
#include "viewer/browser/series_mime.h"
#include "viewer/panes/pane_grid.h"
#include "viewer/planar/image_box.h"
#include "viewer/planar/planar_bar.h"
#include "viewer/planar/planar_measuring.h"
#include "viewer/status/notifications.h"

namespace macula::viewer {

namespace {

constexpr std::size_t kMostSteps = 200;
constexpr int kGapPx = 2;
// Of decoded images, of all boxes together; each has room for some.
constexpr std::size_t kMostBytes = std::size_t{1} << 30;
constexpr std::size_t kLeastBytes = std::size_t{64} << 20;
constexpr QSize kLeastSize(160, 120);
constexpr QSize kLeastSizeOfMany(90, 70);

std::size_t countOf(int rows, int columns) {
    return std::size_t(rows) * std::size_t(columns);
}

// A box scrolls with others unless it lies across all of them.
void tellLinks(const std::vector<ImageBox*>& boxes, bool areLinked) {
    for (ImageBox* box : boxes) {
        const bool follows = std::ranges::any_of(boxes, [&](const ImageBox* other) {
            if (other == box || !other->isShown() || !box->isShown()) return false;
            const dicom::Frame& a = box->placeFrame();
            const dicom::Frame& b = other->placeFrame();
            return !a.plane || !b.plane || study::shiftMm(a, b).has_value();
        });
        box->setLinked(areLinked && follows);
    }
}

// Which of two studies is the older one is said also where names are hidden.
void tellPriors(const std::vector<ImageBox*>& boxes) {
    std::string newest;
    for (const ImageBox* box : boxes)
        if (box->isShown()) newest = std::max(newest, box->series().study->date);
    for (ImageBox* box : boxes) {
        const std::string date = box->isShown() ? box->series().study->date : std::string();
        box->setPrior(!date.empty() && date < newest ? date : std::string());
    }
}

}  // namespace

ImageBoxes::ImageBoxes(const WindowContext& context, QWidget* parent)
    : QWidget(parent), context_(context), grid_(new QGridLayout(this)), bars_(new QStackedWidget) {
    grid_->setContentsMargins(0, 0, 0, 0);
    grid_->setSpacing(kGapPx);
    bars_->setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
    addBox();
    layOut();
}

QWidget& ImageBoxes::bars() const {
    return *bars_;
}

ImageBox& ImageBoxes::addBox() {
    auto* box = new ImageBox(context_, this);
    boxes_.push_back(box);
    bars_->addWidget(&box->bar());
    box->frame().setParent(this);
    box->keepIn(keeper_);
    box->showNames(namesShown_);
    box->bar().setBoxesMenu(menu_);
    connectBox(*box);
    return *box;
}

void ImageBoxes::connectBox(ImageBox& box) {
    connect(&box, &ImageBox::activated, this, [this, &box] { choose(box); });
    connect(&box, &ImageBox::closeAsked, this, [this] {
        if (isAlone_) return setAlone(false);
        Q_EMIT closeAsked();
    });
    connect(&box, &ImageBox::aloneAsked, this, [this] { setAlone(!isAlone_); });
    connect(&box, &ImageBox::linkAsked, this, [this] { setLinked(!isLinked()); });
    connect(&box, &ImageBox::saveAsked, this, &ImageBoxes::saveAsked);
    connect(&box, &ImageBox::placeChosen, this, [this, &box] {
        links_.follow(box, boxes());
        Q_EMIT scrolled();
    });
    // What is kept of its place came: that is where it lies now.
    connect(&box, &ImageBox::restored, this, [this] {
        if (!isLinked()) return;
        links_.unlink();
        links_.link(boxes());
    });
    connect(&box, &ImageBox::dropped, this, [this, &box](const QByteArray& series) { onDrop(box, series); });
    connect(&box, &ImageBox::imageShown, this, [this, &box] {
        showLines();
        if (&box == &chosen()) Q_EMIT imageShown();
    });
    PlanarMeasuring& measuring = box.measuring();
    connect(&measuring, &PlanarMeasuring::stepMade, this, [this, &measuring] {
        done_.push_back({.measuring = &measuring, .what = {}, .before = {}});
        if (done_.size() > kMostSteps) done_.erase(done_.begin());
        undone_.clear();
    });
    connect(&measuring, &PlanarMeasuring::changed, this, [this, &box] {
        if (isApplying_) return;
        forgetStepsOf(box.measuring());
        shareMeasurements(box);
        Q_EMIT stepsChanged();
    });
}

std::vector<ImageBox*> ImageBoxes::boxes() const {
    return {boxes_.begin(), boxes_.begin() + std::ptrdiff_t(countOf(rows_, columns_))};
}

const ImageBox* ImageBoxes::firstShown() const {
    const auto found = std::ranges::find_if(boxes_, &ImageBox::isShown);
    return found == boxes_.end() ? nullptr : *found;
}

void ImageBoxes::keepIn(const std::shared_ptr<live::StudyKeeper>& keeper) {
    keeper_ = keeper;
    for (ImageBox* box : boxes_) box->keepIn(keeper);
}

void ImageBoxes::showNames(bool shown) {
    namesShown_ = shown;
    for (ImageBox* box : boxes_) box->showNames(shown);
}

void ImageBoxes::stopPlaying() {
    for (ImageBox* box : boxes_) box->setPlaying(false);
}

void ImageBoxes::choose(ImageBox& box) {
    const auto found = std::ranges::find(boxes_, &box);
    MACULA_CHECK(found != boxes_.end());
    const auto index = std::size_t(found - boxes_.begin());
    // As boxes are hidden, the focus goes through them.
    if (isLayingOut_ || index == chosen_ || index >= countOf(rows_, columns_)) return;
    chosen_ = index;
    layOut();
    showLines();
    Q_EMIT shownChanged();
}

BoxArrangement ImageBoxes::arrangement() const {
    BoxArrangement now{.rows = rows_, .columns = columns_, .isLinked = isLinked()};
    for (const ImageBox* box : boxes()) {
        now.boxes.emplace_back();
        if (box->isShown()) now.boxes.back() = {box->found(), box->series().stack, box->place()};
    }
    return now;
}

void ImageBoxes::begin(const BoxArrangement& first) {
    isAlone_ = false;
    chosen_ = 0;
    measured_.clear();
    apply(first);
    done_.clear();
    undone_.clear();
    Q_EMIT stepsChanged();
}

void ImageBoxes::hang(const BoxArrangement& next) {
    const dicom::Stack* opened = chosen().series().stack;
    isAlone_ = false;
    apply(next);
    const std::vector<ImageBox*> all = boxes();
    const auto has = [&](const ImageBox* box) { return box->isShown() && box->series().stack == opened; };
    if (const auto found = std::ranges::find_if(all, has); found != all.end()) choose(**found);
    Q_EMIT stepsChanged();
}

void ImageBoxes::arrange(const QString& what, const BoxArrangement& next) {
    Step step{.measuring = nullptr, .what = what, .before = arrangement()};
    isAlone_ = false;
    apply(next);
    // The measurements of boxes that show something else now are no steps any more.
    done_.push_back(std::move(step));
    undone_.clear();
    Q_EMIT stepsChanged();
}

// Boxes that change are emptied first: what is kept of a series is stored before another box reads it.
void ImageBoxes::apply(const BoxArrangement& next) {
    isApplying_ = true;
    rows_ = std::max(1, next.rows);
    columns_ = std::max(1, next.columns);
    const std::size_t count = countOf(rows_, columns_);
    while (boxes_.size() < count) addBox();
    if (chosen_ >= count) chosen_ = 0;
    std::vector<BoxArrangement::Box> wanted = next.boxes;
    wanted.resize(boxes_.size());
    for (std::size_t i = count; i < wanted.size(); ++i) wanted[i] = {};
    std::set<const dicom::Stack*> kept;
    std::vector<bool> keeps(boxes_.size());
    for (std::size_t i = 0; i < boxes_.size(); ++i) {
        const BoxArrangement::Box& box = wanted[i];
        keeps[i] = box.stack != nullptr && kept.insert(box.stack).second;
        const ImageBox& now = *boxes_[i];
        const bool isSame = now.isShown() && now.found() == box.found && now.series().stack == box.stack &&
                            now.keeps() == keeps[i];
        if (!isSame) boxes_[i]->clear();
        boxes_[i]->setMostBytes(std::max(kLeastBytes, kMostBytes / count));
    }
    for (std::size_t i = 0; i < count; ++i) {
        const BoxArrangement::Box& box = wanted[i];
        if (box.stack == nullptr) continue;
        if (boxes_[i]->isShown()) {
            if (box.place) boxes_[i]->follow(*box.place);
            continue;
        }
        const study::PlanarSeries series = study::seriesOf(*box.found, box.stack);
        if (series.stack == nullptr) continue;
        boxes_[i]->show(box.found, series, box.place, keeps[i]);
        boxes_[i]->measuring().setAll(measured_[box.stack]);
    }
    if (next.isLinked)
        links_.link(boxes());
    else
        links_.unlink();
    tellLinks(boxes(), isLinked());
    tellPriors(boxes());
    isApplying_ = false;
    for (const ImageBox* box : boxes_) forgetStepsOf(box->measuring());
    layOut();
    showLines();
    Q_EMIT shownChanged();
    Q_EMIT arranged();
}

void ImageBoxes::setGrid(int rows, int columns) {
    BoxArrangement next = arrangement();
    if (next.rows == rows && next.columns == columns) return setAlone(false);
    const std::size_t count = countOf(rows, columns);
    std::vector<BoxArrangement::Box> shown;
    std::set<const dicom::Stack*> stacks;
    std::size_t chosen = 0;
    for (std::size_t i = 0; i < next.boxes.size(); ++i) {
        if (next.boxes[i].stack == nullptr) continue;
        if (i == chosen_) chosen = shown.size();
        shown.push_back(next.boxes[i]);
        stacks.insert(next.boxes[i].stack);
    }
    if (chosen >= count && chosen < shown.size()) std::swap(shown[chosen], shown[count - 1]);
    chosen = std::min(chosen, count - 1);
    shown.resize(std::min(shown.size(), count));
    if (!shown.empty()) {
        const BoxArrangement::Box from = shown[chosen];
        const study::PlanarSeries of = study::seriesOf(*from.found, from.stack);
        for (const dicom::Series& series : of.study->series)
            for (const dicom::Stack& stack : series.stacks)
                if (shown.size() < count && !stack.frames.empty() && stacks.insert(&stack).second)
                    shown.push_back({from.found, &stack, {}});
    }
    next.rows = rows;
    next.columns = columns;
    next.boxes = std::move(shown);
    chosen_ = chosen;
    arrange(tr("Boxes of images"), next);
}

void ImageBoxes::showInChosen(std::shared_ptr<const study::FoundVolumes> found,
                              const study::PlanarSeries& series) {
    BoxArrangement next = arrangement();
    next.boxes.at(chosen_) = {std::move(found), series.stack, {}};
    arrange(tr("Series in a box"), next);
}

// A series that another box shows changes places with what the box shows.
void ImageBoxes::onDrop(ImageBox& box, const QByteArray& text) {
    const ImageBox* shown = firstShown();
    if (shown == nullptr) return;
    const auto found = shown->found();
    const study::PlanarSeries series = seriesOfText(text, *found);
    if (series.stack == nullptr) return;
    if (series.study->patient != shown->series().study->patient)
        return context_.notifications.showNote(
            tr("That series is of another patient. Boxes show one patient; a double click opens it."));
    choose(box);
    BoxArrangement next = arrangement();
    const auto elsewhere = std::ranges::find(next.boxes, series.stack, &BoxArrangement::Box::stack);
    BoxArrangement::Box& here = next.boxes.at(chosen_);
    if (elsewhere != next.boxes.end())
        std::swap(*elsewhere, here);
    else
        here = {found, series.stack, {}};
    arrange(tr("Series in a box"), next);
}

void ImageBoxes::setLinked(bool linked) {
    BoxArrangement next = arrangement();
    next.isLinked = linked;
    arrange(linked ? tr("Scroll together") : tr("Scroll alone"), next);
}

void ImageBoxes::setAlone(bool alone) {
    if (alone == isAlone_) return;
    isAlone_ = alone;
    layOut();
    Q_EMIT arranged();
}

void ImageBoxes::setMenu(QMenu* menu) {
    menu_ = menu;
    for (const ImageBox* box : boxes_) box->bar().setBoxesMenu(menu);
}

void ImageBoxes::clear() {
    begin({});
}

void ImageBoxes::layOut() {
    isLayingOut_ = true;
    const std::size_t count = countOf(rows_, columns_);
    const bool hadFocus =
        std::ranges::any_of(boxes_, [](const ImageBox* box) { return box->view().hasFocus(); });
    const bool isMany = count > 4 && !isAlone_;
    for (std::size_t i = 0; i < boxes_.size(); ++i) {
        PaneFrame& frame = boxes_[i]->frame();
        grid_->removeWidget(&frame);
        const bool isVisible = i < count && (!isAlone_ || i == chosen_);
        boxes_[i]->view().setMinimumSize(isMany ? kLeastSizeOfMany : kLeastSize);
        if (isVisible) grid_->addWidget(&frame, int(i) / columns_, int(i) % columns_);
        frame.setVisible(isVisible);
        frame.setActive(i == chosen_ && count > 1);
    }
    for (int row = 0; row < std::max(rows_, grid_->rowCount()); ++row)
        grid_->setRowStretch(row, row < rows_ && (!isAlone_ || row == int(chosen_) / columns_) ? 1 : 0);
    for (int column = 0; column < std::max(columns_, grid_->columnCount()); ++column)
        grid_->setColumnStretch(
            column, column < columns_ && (!isAlone_ || column == int(chosen_) % columns_) ? 1 : 0);
    bars_->setCurrentWidget(&chosen().bar());
    if (hadFocus) chosen().view().setFocus();
    isLayingOut_ = false;
}

void ImageBoxes::showLines() {
    if (isApplying_) return;
    for (ImageBox* box : boxes()) box->setLineOf(box != &chosen() ? chosen().shownFrame() : nullptr);
}

// Boxes of one stack have the same measurements, and so has the next one that shows it.
void ImageBoxes::shareMeasurements(const ImageBox& from) {
    if (!from.isShown()) return;
    const dicom::Stack* stack = from.series().stack;
    measured_[stack] = from.measuring().all();
    for (ImageBox* box : boxes())
        if (box != &from && box->isShown() && box->series().stack == stack)
            box->takeMeasurements(from.measuring().all());
}

void ImageBoxes::forgetStepsOf(const PlanarMeasuring& measuring) {
    if (!measuring.undoText().isEmpty() || !measuring.redoText().isEmpty()) return;
    for (std::vector<Step>* steps : {&done_, &undone_})
        std::erase_if(*steps, [&](const Step& step) { return step.measuring == &measuring; });
}

QString ImageBoxes::undoText() const {
    if (done_.empty()) return {};
    return done_.back().measuring != nullptr ? done_.back().measuring->undoText() : done_.back().what;
}

QString ImageBoxes::redoText() const {
    if (undone_.empty()) return {};
    return undone_.back().measuring != nullptr ? undone_.back().measuring->redoText() : undone_.back().what;
}

void ImageBoxes::undo() {
    restore(done_, undone_, true);
}

void ImageBoxes::redo() {
    restore(undone_, done_, false);
}

void ImageBoxes::restore(std::vector<Step>& from, std::vector<Step>& to, bool isUndo) {
    if (from.empty()) return;
    Step step = std::move(from.back());
    from.pop_back();
    if (PlanarMeasuring* measuring = step.measuring) {
        to.push_back(std::move(step));
        if (isUndo)
            measuring->undo();
        else
            measuring->redo();
    } else {
        const BoxArrangement before = std::exchange(step.before, arrangement());
        isAlone_ = false;
        apply(before);
        to.push_back(std::move(step));
    }
    Q_EMIT stepsChanged();
}

}  // namespace macula::viewer
