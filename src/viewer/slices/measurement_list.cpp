#include "viewer/slices/measurement_list.h"

#include <QGuiApplication>
#include <QHeaderView>
#include <QKeyEvent>
#include <QTimer>
#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include "base/utf8.h"
#include "scene/state/measurements_json.h"
#include "viewer/language/harmless_text.h"
#include "viewer/menus/controls.h"
#include "viewer/overlay/slice_steps.h"
#include "viewer/overlay/slice_texts.h"

namespace macula::viewer {

namespace {

enum Column { kLabel, kValue, kSlice };

constexpr double kParallel = 0.99985;  // the cosine of a degree

glm::dvec3 middleOf(const slices::Measurement& measurement) {
    if (const auto* ellipse = std::get_if<slices::Ellipse>(&measurement.shape))
        return ellipse->plane.centreMm;
    const std::vector<glm::dvec3> points = slices::pointsOf(measurement);
    glm::dvec3 sum(0.0);
    for (const glm::dvec3& mm : points) sum += mm;
    return points.empty() ? sum : sum / double(points.size());
}

glm::dvec3 normalOf(const slices::Measurement& measurement) {
    const auto* ellipse = std::get_if<slices::Ellipse>(&measurement.shape);
    return ellipse != nullptr ? ellipse->plane.normal() : measurement.normal;
}

// The turn with which one pane is parallel to the measurement; that of the state if one already is.
std::optional<glm::dquat> turnFor(const slices::Measurement& measurement, const Volume& volume,
                                  const scene::SliceState& state) {
    const glm::dvec3 normal = normalOf(measurement);
    constexpr std::array kPanes{slices::Orientation::axial, slices::Orientation::coronal,
                                slices::Orientation::sagittal};
    const auto parallelTo = [&](const std::optional<glm::dquat>& turn) {
        return std::ranges::any_of(kPanes, [&](slices::Orientation pane) {
            const glm::dvec3 before = planeBeforeTurn(volume, pane, state.asAcquired).normal();
            return std::abs(glm::dot(turn ? *turn * before : before, normal)) > kParallel;
        });
    };
    if (parallelTo(state.turn)) return state.turn;
    if (parallelTo(std::nullopt)) return std::nullopt;
    // The pane that has to turn least.
    const auto nearest = std::ranges::max(kPanes, {}, [&](slices::Orientation pane) {
        return std::abs(glm::dot(planeBeforeTurn(volume, pane, state.asAcquired).normal(), normal));
    });
    const slices::SlicePlane plane = planeBeforeTurn(volume, nearest, state.asAcquired);
    const bool isBackwards = glm::dot(plane.normal(), normal) < 0.0;
    return slices::leastTurn(plane.normal(), isBackwards ? -normal : normal, plane.down);
}

}  // namespace

MeasurementList::MeasurementList(StudyEditor& session, QWidget* parent)
    : QTreeWidget(parent), session_(session) {
    describe(*this, "measurement-list", tr("Measurements"),
             tr("Click: the slices go there. F2: its label. Delete: removes it"));
    setRootIsDecorated(false);
    setSelectionMode(QAbstractItemView::ExtendedSelection);
    setEditTriggers(QAbstractItemView::DoubleClicked | QAbstractItemView::EditKeyPressed);
    setHeaderLabels({tr("Label"), tr("Value"), tr("Slice")});
    header()->setStretchLastSection(false);
    header()->setSectionResizeMode(kValue, QHeaderView::Stretch);
    // With a modifier the click selects several.
    connect(this, &QTreeWidget::itemClicked, this, [this](QTreeWidgetItem* item) {
        if (QGuiApplication::keyboardModifiers() == Qt::NoModifier)
            goTo(std::size_t(indexOfTopLevelItem(item)));
    });
    connect(this, &QTreeWidget::itemChanged, this,
            [this](QTreeWidgetItem* item, int column) { takeLabel(*item, column); });
    connect(&session_, &StudyEditor::studyShown, this, [this] {
        texts_.forget();
        listed_.clear();
        isStale_ = true;
        refresh();
    });
    connect(&session_, &StudyEditor::changed, this, [this](const scene::StudyState& before) {
        if (before.measurements != session_.state().measurements) isStale_ = true;
        refresh();
    });
}

void MeasurementList::showEvent(QShowEvent* event) {
    QTreeWidget::showEvent(event);
    refresh();
}

// Values within ellipses take a while, so a hidden list is not kept up to date.
void MeasurementList::refresh() {
    if (!isVisible() || !isStale_) return;
    isStale_ = false;
    fills_ = true;
    const int row = currentItem() != nullptr ? indexOfTopLevelItem(currentItem()) : -1;
    clear();
    if (session_.hasStudy()) {
        listed_ = session_.state().measurements;
        const Volume& volume = *session_.study().measured();
        for (const slices::Measurement& measurement : listed_) {
            auto* item = new QTreeWidgetItem(this);
            item->setFlags(item->flags() | Qt::ItemIsEditable);
            item->setText(kLabel, harmless(QString::fromStdString(measurement.label)));
            slices::Measurement unlabelled = measurement;
            unlabelled.label.clear();
            item->setText(kValue, texts_.of(unlabelled, session_.study().measured()));
            item->setToolTip(kValue, item->text(kValue));
            const auto slice = slices::sliceOf(measurement, volume);
            if (!slice) continue;
            const auto image = imageNumber(session_.study(), *slice);
            item->setText(
                kSlice, image ? tr("%1, image %2").arg(*slice + 1).arg(*image) : QString::number(*slice + 1));
        }
    }
    if (row >= 0 && topLevelItemCount() > 0)
        setCurrentItem(topLevelItem(std::min(row, topLevelItemCount() - 1)));
    fills_ = false;
}

void MeasurementList::goTo(std::size_t index) {
    if (!session_.hasStudy() || index >= listed_.size()) return;
    const slices::Measurement measurement = listed_[index];
    const glm::dvec3 middle = middleOf(measurement);
    const auto turn = turnFor(measurement, *session_.study().measured(), session_.state().slices);
    session_.change(tr("Go to a Measurement"), [&](scene::StudyState& next) {
        next.slices.crosshairMm = middle;
        next.slices.turn = turn;
    });
}

void MeasurementList::takeLabel(const QTreeWidgetItem& item, int column) {
    const int index = indexOfTopLevelItem(const_cast<QTreeWidgetItem*>(&item));
    if (fills_ || column != kLabel || index < 0 || std::size_t(index) >= listed_.size()) return;
    // Later: the change fills the list anew, and its editor is still open.
    const auto take = [this, edited = listed_[std::size_t(index)],
                       typed = item.text(kLabel).trimmed().toStdString()] {
        session_.change(tr("Label"), [&](scene::StudyState& next) {
            const auto found = std::ranges::find(next.measurements, edited);
            if (found != next.measurements.end())
                found->label = std::string(startOf(typed, scene::kLongestLabelBytes));
        });
    };
    QTimer::singleShot(0, this, take);
}

void MeasurementList::removeSelected() {
    std::set<std::size_t> chosen;
    for (QTreeWidgetItem* item : selectedItems()) chosen.insert(std::size_t(indexOfTopLevelItem(item)));
    if (chosen.empty()) return;
    session_.change(tr("Measurement removed"), [&](scene::StudyState& next) {
        std::vector<slices::Measurement> kept;
        for (std::size_t i = 0; i < next.measurements.size(); ++i)
            if (!chosen.contains(i)) kept.push_back(next.measurements[i]);
        next.measurements = std::move(kept);
    });
}

bool MeasurementList::edit(const QModelIndex& index, EditTrigger trigger, QEvent* event) {
    return index.column() == kLabel && QTreeWidget::edit(index, trigger, event);
}

void MeasurementList::keyPressEvent(QKeyEvent* event) {
    if (event->key() == Qt::Key_Delete || event->key() == Qt::Key_Backspace) return removeSelected();
    if ((event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter) && currentItem() != nullptr)
        return goTo(std::size_t(indexOfTopLevelItem(currentItem())));
    QTreeWidget::keyPressEvent(event);
}

}  // namespace macula::viewer
