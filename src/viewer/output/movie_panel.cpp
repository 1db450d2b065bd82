#include "viewer/output/movie_panel.h"

#include <QFormLayout>
#include <QHBoxLayout>
#include <QSignalBlocker>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>
#include <utility>

#include "pictures/view_sequence.h"
#include "pipeline/trace/settings.h"
#include "scene/choice/quality_choice.h"
#include "viewer/language/window_language.h"
#include "viewer/menus/controls.h"

namespace macula::viewer {

namespace {

constexpr double kLongestS = 600.0;
constexpr double kShortestS = 0.1;
constexpr const char* kFirstQuality = "normal";

template <class Box, class Number>
Box* number(QWidget* parent, const QString& name, Number low, Number high, Number value,
            const QString& unit) {
    auto* box = new Box(parent);
    box->setRange(low, high);
    box->setValue(value);
    box->setSuffix(unit);
    box->setAccessibleName(name);
    box->setToolTip(MoviePanel::tr("%1, %2 to %3%4").arg(name).arg(low).arg(high).arg(unit));
    box->setKeyboardTracking(false);
    return box;
}

QCheckBox* check(QWidget* parent, const QString& title, const QString& tip, bool isOn) {
    auto* box = new QCheckBox(title, parent);
    box->setToolTip(tip);
    box->setChecked(isOn);
    return box;
}

QPushButton* button(QWidget* parent, const QString& title, const char* name, const QString& tip) {
    auto* made = new QPushButton(title, parent);
    made->setObjectName(QLatin1String(name));
    made->setToolTip(tip);
    return made;
}

}  // namespace

MoviePanel::MoviePanel(std::function<std::optional<Camera>()> camera, QWidget* parent)
    : QWidget(parent), camera_(std::move(camera)) {
    auto* column = new QVBoxLayout(this);
    addChoices();
    addViews();
    draw_ = button(this, tr("&Draw Movie…"), "movie-draw",
                   tr("Draw all pictures to a folder, while the window goes on"));
    connect(draw_, &QPushButton::clicked, this, &MoviePanel::drawAsked);
    column->addWidget(draw_);
    column->addStretch(1);
    showViews();
    showFrames();
}

void MoviePanel::addChoices() {
    kinds_ = new QComboBox(this);
    describe(*kinds_, "movie-kind", tr("How the camera goes"),
             tr("Around the patient from here, or along views that are added"));
    kinds_->addItems({tr("Turntable"), tr("Along views")});
    degrees_ =
        number<QDoubleSpinBox>(this, tr("Degrees around the patient"), -3600.0, 3600.0, 360.0, tr("°"));
    seconds_ = number<QDoubleSpinBox>(this, tr("Seconds"), kShortestS, kLongestS, 8.0, tr(" s"));
    rate_ = number<QDoubleSpinBox>(this, tr("Pictures per second"), 1.0, 60.0, 25.0, tr(" /s"));
    width_ = number<QSpinBox>(this, tr("Width in pixels"), 16, trace::kMaxPictureSide, 1280, tr(" px"));
    height_ = number<QSpinBox>(this, tr("Height in pixels"), 16, trace::kMaxPictureSide, 720, tr(" px"));
    qualities_ = new QComboBox(this);
    qualities_->setAccessibleName(tr("Quality"));
    qualities_->setToolTip(tr("More samples per pixel: less noise, and more time"));
    if (const auto all = scene::builtInQualities()) {
        for (const trace::Quality& quality : *all)
            qualities_->addItem(titleInWindowsLanguage(quality.title), QString::fromStdString(quality.name));
    }
    qualities_->setCurrentIndex(qualities_->findData(QString::fromLatin1(kFirstQuality)));
    letters_ = check(this, tr("Sides of the &patient"), tr("Letters at the edges of each picture"), true);
    names_ = check(this, tr("&Name patient and study"),
                   tr("Over each picture, as in the window. Without it nobody is named; a face can still be "
                      "seen"),
                   false);
    video_ =
        check(this, tr("&Video of them"), tr("An MP4 file beside them, by ffmpeg if it is installed"), true);
    noEncoder_ =
        new QLabel(tr("This machine has no encoder: install ffmpeg for a video. Pictures are drawn to "
                      "the folder all the same."),
                   this);
    noEncoder_->setObjectName(QStringLiteral("movie-no-encoder"));
    noEncoder_->setWordWrap(true);
    noEncoder_->hide();
    count_ = new QLabel(this);
    count_->setObjectName(QStringLiteral("movie-count"));
    auto* form = new QFormLayout;
    form->addRow(tr("&Camera"), kinds_);
    form->addRow(tr("De&grees"), degrees_);
    form->addRow(tr("&Seconds"), seconds_);
    form->addRow(tr("Pictures per second"), rate_);
    form->addRow(tr("&Width"), width_);
    form->addRow(tr("&Height"), height_);
    form->addRow(tr("&Quality"), qualities_);
    for (QCheckBox* box : {letters_, names_, video_}) form->addRow(box);
    form->addRow(noEncoder_);
    form->addRow(count_);
    static_cast<QVBoxLayout*>(layout())->addLayout(form);
    connect(kinds_, &QComboBox::currentIndexChanged, this, &MoviePanel::showViews);
    for (QDoubleSpinBox* box : {seconds_, rate_})
        connect(box, &QDoubleSpinBox::valueChanged, this, &MoviePanel::showFrames);
}

void MoviePanel::addViews() {
    list_ = new QListWidget(this);
    describe(*list_, "movie-views", tr("Views of the way"),
             tr("The camera goes smoothly from each to the next"));
    auto* add =
        button(this, tr("&Add View"), "movie-add", tr("What is looked at now, 2 s after the view before"));
    remove_ = button(this, tr("&Remove"), "movie-remove", tr("Leave out the view that is chosen"));
    auto* open =
        button(this, tr("&Open…"), "movie-open", tr("A way from a file, as of macula hybrid --path"));
    save_ = button(this, tr("Save…"), "movie-save", tr("The way to a file, for macula hybrid --path"));
    connect(add, &QPushButton::clicked, this, &MoviePanel::addView);
    connect(remove_, &QPushButton::clicked, this, &MoviePanel::removeView);
    connect(open, &QPushButton::clicked, this, &MoviePanel::openAsked);
    connect(save_, &QPushButton::clicked, this, &MoviePanel::saveAsked);
    connect(list_, &QListWidget::currentRowChanged, this, [this](int row) { remove_->setEnabled(row >= 0); });
    auto* above = new QHBoxLayout;
    auto* below = new QHBoxLayout;
    for (QPushButton* each : {add, remove_}) above->addWidget(each);
    for (QPushButton* each : {open, save_}) below->addWidget(each);
    auto* column = static_cast<QVBoxLayout*>(layout());
    column->addWidget(list_);
    column->addLayout(above);
    column->addLayout(below);
}

int MoviePanel::frames() const {
    return std::clamp(int(std::lround(seconds() * picturesPerS())), 1, pictures::kMostFrames);
}

std::string MoviePanel::quality() const {
    return qualities_->currentData().toString().toStdString();
}

bool MoviePanel::isClosed() const {
    return isTurntable() && std::abs(std::remainder(degrees(), 360.0)) < 1e-9 && degrees() != 0.0;
}

std::optional<scene::CameraPath> MoviePanel::pathFrom(const Camera& camera) const {
    if (isTurntable()) {
        if (degrees() == 0.0) return scene::CameraPath{{{.atS = 0.0, .camera = camera}}};
        // scene::turntable turns to the left; the other way is the same path backwards.
        scene::CameraPath path = scene::turntable(camera, 360.0 * seconds() / std::abs(degrees()), seconds());
        if (degrees() > 0.0) return path;
        const scene::OrbitCamera from = scene::orbitCameraOf(camera);
        for (scene::CameraPath::Stop& stop : path.stops)
            stop.camera = toCamera(scene::orbited(from, degrees() * stop.atS / seconds(), 0.0));
        return path;
    }
    if (views_.stops.empty()) return std::nullopt;
    scene::CameraPath path = views_;
    const double whole = path.seconds();
    if (whole > 0.0) {
        for (scene::CameraPath::Stop& stop : path.stops) stop.atS *= seconds() / whole;
    }
    return path;
}

void MoviePanel::setViews(scene::CameraPath views) {
    views_ = std::move(views);
    if (!views_.stops.empty()) {
        kinds_->setCurrentIndex(1);
        if (views_.seconds() > 0.0) seconds_->setValue(views_.seconds());
    }
    showViews();
}

void MoviePanel::addView() {
    const std::optional<Camera> camera = camera_();
    if (!camera || views_.stops.size() >= scene::kMostStops) return;
    scene::CameraPath next = views_;
    const double atS = next.stops.empty() ? 0.0 : next.seconds() + kSecondsPerView;
    next.stops.push_back({.atS = atS, .camera = *camera});
    setViews(std::move(next));
    list_->setCurrentRow(list_->count() - 1);
}

// The views after the removed one move forward by its duration.
void MoviePanel::removeView() {
    const int row = list_->currentRow();
    if (row < 0 || std::size_t(row) >= views_.stops.size()) return;
    scene::CameraPath next = views_;
    auto& stops = next.stops;
    const auto at = std::size_t(row);
    const double gapS = at + 1 < stops.size() ? stops[at + 1].atS - stops[at].atS : 0.0;
    for (std::size_t i = at + 1; i < stops.size(); ++i) stops[i].atS -= gapS;
    stops.erase(stops.begin() + row);
    setViews(std::move(next));
    list_->setCurrentRow(std::min(row, list_->count() - 1));
}

void MoviePanel::showViews() {
    {
        const QSignalBlocker quiet(list_);
        list_->clear();
        for (std::size_t i = 0; i < views_.stops.size(); ++i)
            list_->addItem(tr("View %1, at %L2 s").arg(i + 1).arg(views_.stops[i].atS, 0, 'f', 1));
    }
    remove_->setEnabled(list_->currentRow() >= 0);
    save_->setEnabled(!views_.stops.empty());
    degrees_->setEnabled(isTurntable());
    draw_->setEnabled(isTurntable() || !views_.stops.empty());
}

void MoviePanel::setHasEncoder(bool hasEncoder) {
    video_->setEnabled(hasEncoder);
    noEncoder_->setVisible(!hasEncoder);
}

void MoviePanel::showFrames() {
    count_->setText(tr("%Ln pictures", nullptr, frames()));
}

}  // namespace macula::viewer
