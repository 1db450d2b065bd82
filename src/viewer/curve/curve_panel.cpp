#include "viewer/curve/curve_panel.h"

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>
#include <algorithm>
#include <utility>

#include "pipeline/volume/window.h"
#include "viewer/curve/curve_view.h"
#include "viewer/language/window_language.h"
#include "viewer/menus/controls.h"
#include "viewer/overlay/slice_steps.h"

namespace macula::viewer {

namespace {

constexpr double kLeastHeightMm = 5.0;
constexpr double kMostHeightMm = 400.0;
constexpr int kPauseMs = 600;

}  // namespace

CurvePanel::CurvePanel(StudyEditor& session, QWidget* parent)
    : QWidget(parent),
      session_(session),
      view_(new CurveView(this)),
      job_(this, {.ended = [this](const Result<CurvePicture>& picture) {
               if (picture) {
                   view_->show(*picture);
                   Q_EMIT pictureShown();
               } else if (picture.error().code != ErrorCode::cancelled) {
                   view_->clear(inWindowsLanguage(picture.error().message));
               }
               if (std::exchange(isStale_, false)) start();
           }}) {
    setObjectName(QStringLiteral("curve-panel"));
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(4, 4, 4, 4);
    addControls();
    column->addWidget(view_, 1);
    scrollEnds_.setSingleShot(true);
    scrollEnds_.setInterval(kPauseMs);
    connect(&scrollEnds_, &QTimer::timeout, this, [this] {
        if (session_.undoText() == tr("Along the Curve")) session_.endDrag();
    });
    connect(view_, &CurveView::pointed, this, [this](const glm::dvec3& mm) {
        session_.drag(tr("Cross-hair"), [&](scene::StudyState& next) { next.slices.crosshairMm = mm; });
    });
    connect(view_, &CurveView::released, &session_, &StudyEditor::endDrag);
    connect(view_, &CurveView::resized, this, &CurvePanel::refresh);
    connect(view_, &CurveView::scrolledBy, this, [this](double mm) {
        if (curve().isUsable()) goTo(curve().nearestMm(crosshairMm()) + mm);
    });
    connect(&session_, &StudyEditor::studyShown, this, &CurvePanel::onStudyShown);
    connect(&session_, &StudyEditor::changed, this, [this](const scene::StudyState& before) {
        if (before.slices != session_.state().slices) refresh();
    });
    refresh();
}

QDoubleSpinBox* CurvePanel::addNumber(const char* name, const QString& title, double low, double high,
                                      double value) {
    auto* box = new QDoubleSpinBox(this);
    describe(*box, name, title, title);
    box->setRange(low, high);
    box->setDecimals(0);
    box->setValue(value);
    connect(box, &QDoubleSpinBox::valueChanged, this, [this] {
        look_.turnDeg = turn_->value();
        look_.heightMm = height_->value();
        refresh();
    });
    return box;
}

void CurvePanel::addControls() {
    auto* row = new QHBoxLayout;
    kind_ = new QComboBox(this);
    describe(*kind_, "curve-kind", tr("Kind of curved plane"),
             tr("Straightened: the curve is a straight line. Stretched: the surface along it is unrolled"));
    kind_->addItem(tr("Straightened"));
    kind_->addItem(tr("Stretched"));
    connect(kind_, &QComboBox::currentIndexChanged, this, [this](int index) {
        look_.kind = slices::CurvedKind(index);
        refresh();
    });
    turn_ = addNumber("curve-turn", tr("Turn the plane about the curve, in °"), 0.0, 359.0, look_.turnDeg);
    turn_->setSuffix(QStringLiteral("°"));
    turn_->setWrapping(true);
    turn_->setSingleStep(5.0);
    height_ = addNumber("curve-height", tr("Height of the picture across the curve, in mm"), kLeastHeightMm,
                        kMostHeightMm, look_.heightMm);
    height_->setSuffix(tr(" mm"));
    height_->setSingleStep(10.0);
    const auto button = [&](const char* name, const QString& title, const QString& tip) {
        auto* made = new QPushButton(title, this);
        describe(*made, name, title, tip);
        return made;
    };
    follow_ = button("curve-follow", tr("&Follow the Vessel"),
                     tr("Looks for the way of a vessel, or another tube, through all points of the curve"));
    connect(follow_, &QPushButton::clicked, this, &CurvePanel::followAsked);
    across_ = button("curve-across", tr("Planes &Across"),
                     tr("Turns the planes of all panes: the axial one is then across the curve"));
    connect(across_, &QPushButton::clicked, this, &CurvePanel::standPlanesAcross);
    remove_ = button("curve-remove", tr("&Remove the Curve"), tr("Removes all points of the curve"));
    connect(remove_, &QPushButton::clicked, this, [this] {
        session_.change(tr("Remove the Curve"), [](scene::StudyState& next) { next.slices.curveMm.clear(); });
    });
    row->addWidget(kind_);
    row->addWidget(turn_);
    row->addWidget(height_);
    row->addStretch(1);
    row->addWidget(follow_);
    row->addWidget(across_);
    row->addWidget(remove_);
    static_cast<QVBoxLayout*>(layout())->insertLayout(0, row);
}

void CurvePanel::showEvent(QShowEvent* event) {
    QWidget::showEvent(event);
    refresh();
}

// The picture may be of another patient, and would keep that volume.
void CurvePanel::onStudyShown() {
    job_.cancel();
    isStale_ = false;
    phase_.reset();
    phaseText_.clear();
    view_->clear({});
    refresh();
}

void CurvePanel::setPhase(std::shared_ptr<const study::OpenedStudy> phase, const QString& text) {
    phase_ = std::move(phase);
    phaseText_ = text;
    refresh();
}

const slices::Curve& CurvePanel::curve() const {
    return curve_.through(session_.state().slices.curveMm);
}

glm::dvec3 CurvePanel::crosshairMm() const {
    return session_.state().slices.crosshairMm.value_or(middleMm(*session_.study().measured()));
}

void CurvePanel::setFollowing(bool follows) {
    isFollowing_ = follows;
    follow_->setEnabled(!follows && session_.hasStudy() && curve().isUsable());
    follow_->setText(follows ? tr("Looking for the vessel…") : tr("&Follow the Vessel"));
}

std::optional<CurveRequest> CurvePanel::request() const {
    if (!session_.hasStudy()) return {};
    const scene::SliceState& slices = session_.state().slices;
    if (!curve().isUsable()) return {};
    const auto& volume = study().measured();
    return CurveRequest{.volume = volume,
                        .pointsMm = slices.curveMm,
                        .look = look_,
                        .slab = slices.slab,
                        .window = slices.window.value_or(seriesWindow(*session_.study().measured())),
                        .isInverted = slices.isInverted != session_.study().isLowBright,
                        .isLowBright = session_.study().isLowBright,
                        .sectionAtMm = curve().nearestMm(crosshairMm()),
                        .widthPx = view_->widthPx(),
                        .sectionPx = view_->sectionPx(),
                        .pixelRatio = devicePixelRatioF(),
                        .phaseText = phaseText_};
}

void CurvePanel::refresh() {
    const bool hasCurve = session_.hasStudy() && curve().isUsable();
    follow_->setEnabled(hasCurve && !isFollowing_);
    across_->setEnabled(hasCurve);
    remove_->setEnabled(session_.hasStudy() && !session_.state().slices.curveMm.empty());
    if (!hasCurve) {
        job_.cancel();
        isStale_ = false;
        return view_->clear(tr("Choose the curve tool (Y), and click the points of the curve on slices."));
    }
    if (!isVisible()) return view_->clear({});
    if (job_.running()) {
        isStale_ = true;  // the running picture is shown first: a drag must not starve
    } else {
        start();
    }
}

void CurvePanel::start() {
    const std::optional<CurveRequest> wanted = request();
    if (!wanted || (view_->picture() && view_->picture()->of == *wanted)) return;
    job_.start([asked = *wanted](Progress& progress) { return makeCurvePicture(asked, progress.token()); });
}

void CurvePanel::goTo(double atMm) {
    const glm::dvec3 mm = curve().at(std::clamp(atMm, 0.0, curve().lengthMm())).mm;
    session_.drag(tr("Along the Curve"), [&](scene::StudyState& next) { next.slices.crosshairMm = mm; });
    scrollEnds_.start();
}

void CurvePanel::standPlanesAcross() {
    const std::optional<CurveRequest> now = request();
    if (!now) return;
    const slices::CurvePlace place = curve().at(now->sectionAtMm);
    const slices::SlicePlane axial =
        planeBeforeTurn(*now->volume, slices::Orientation::axial, session_.state().slices.asAcquired);
    // The curve may have been drawn from either end: the plane turns by less than a right angle.
    const bool isBackwards = glm::dot(axial.normal(), place.along) < 0.0;
    const glm::dquat turn =
        slices::leastTurn(axial.normal(), isBackwards ? -place.along : place.along, axial.down);
    session_.change(tr("Planes Across"), [&](scene::StudyState& next) {
        next.slices.turn = turn;
        next.slices.crosshairMm = place.mm;
    });
}

}  // namespace macula::viewer
