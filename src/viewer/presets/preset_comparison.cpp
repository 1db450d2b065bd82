#include "viewer/presets/preset_comparison.h"

#include <QCheckBox>
#include <QDialogButtonBox>
#include <QHBoxLayout>
#include <QMouseEvent>
#include <QPainter>
#include <QPushButton>
#include <QVBoxLayout>
#include <algorithm>
#include <new>
#include <utility>

#include "viewer/jobs/background_job.h"
#include "viewer/jobs/post.h"
#include "viewer/language/window_language.h"
#include "viewer/menus/controls.h"
#include "viewer/status/status_widgets.h"

namespace macula::viewer {

namespace {

constexpr int kSteps = 1000;  // of the slider
constexpr int kGapPx = 4;

QImage asImage(const std::vector<std::uint8_t>& rgba, QSize size) {
    const QImage borrowed(rgba.data(), size.width(), size.height(), QImage::Format_RGBA8888);
    return borrowed.copy();
}

// The largest rectangle with the picture's aspect, centred in `room`.
QRect fitted(QSize picture, const QRect& room) {
    QRect place(QPoint(), picture.scaled(room.size(), Qt::KeepAspectRatio));
    place.moveCenter(room.center());
    return place;
}

QLabel* makeTitle(const QString& text, Qt::Alignment alignment) {
    auto* label = new QLabel(text);
    label->setTextFormat(Qt::PlainText);
    label->setAlignment(alignment);
    return label;
}

}  // namespace

// Outlives the dialog until its thread notices the cancellation: a device takes a second to start, and the
// window must not block for that. Lives on the UI thread.
class ComparisonJob : public QObject {
  public:
    // `window` owns it; null: the dialog does.
    ComparisonJob(PresetComparison& dialog, QWidget* window)
        : QObject(window != nullptr ? window : &dialog),
          job_(this, {.progressed =
                          [&dialog](const ProgressUpdate& update) {
                              dialog.work_->setProgress(inWindowsLanguage(update.stage), update.fraction);
                          },
                      .ended = [&dialog](const Result<Pictures>& drawn) { dialog.onDrawn(drawn); }}) {}

    void start(std::vector<pictures::ViewPicture> pictures, std::string preferredDevice) {
        job_.start([this, pictures = std::move(pictures),
                    device = std::move(preferredDevice)](Progress& progress) -> Result<Pictures> {
            Result<Pictures> drawn = draw(pictures, device, progress);
            post(this, [this] {
                isDone_ = true;
                if (isLeft_) deleteLater();
            });
            return drawn;
        });
    }
    bool isRunning() const { return job_.running(); }
    void cancel() { job_.cancel(); }
    // Cancels, and reports nothing to the dialog any more.
    void leave() {
        job_.cancel();
        isLeft_ = true;
        if (isDone_) deleteLater();
    }

  private:
    using Pictures = PresetComparison::Pictures;

    static Result<Pictures> draw(const std::vector<pictures::ViewPicture>& pictures,
                                 const std::string& device, Progress& progress) {
        try {
            return pictures::drawViewPictures(pictures, device, progress);
        } catch (const std::bad_alloc&) {
            return Error{ErrorCode::outOfMemory,
                         Text("There is not enough memory for both pictures."),
                         {},
                         Text("Close other programs.")};
        }
    }

    bool isDone_ = false;
    bool isLeft_ = false;
    BackgroundJob<Pictures> job_;
};

PictureCurtain::PictureCurtain(QWidget* parent) : QWidget(parent) {
    setAccessibleName(tr("Both pictures"));
    setToolTip(tr("Drag the line between the two presets"));
    setMinimumSize(240, 180);
}

void PictureCurtain::setPictures(QImage first, QImage second) {
    first_ = std::move(first);
    second_ = std::move(second);
    update();
}

void PictureCurtain::setBesideEachOther(bool are) {
    areBesideEachOther_ = are;
    update();
}

void PictureCurtain::setPart(double part) {
    part_ = std::clamp(part, 0.0, 1.0);
    update();
}

QSize PictureCurtain::sizeHint() const {
    return first_.isNull() ? QSize(640, 480) : first_.size();
}

QRect PictureCurtain::place() const {
    return fitted(first_.size(), rect());
}

void PictureCurtain::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.fillRect(rect(), Qt::black);
    if (!hasPictures()) return;
    painter.setRenderHint(QPainter::SmoothPixmapTransform);
    if (areBesideEachOther_) {
        const int half = (width() - kGapPx) / 2;
        painter.drawImage(fitted(first_.size(), QRect(0, 0, half, height())), first_);
        painter.drawImage(fitted(second_.size(), QRect(width() - half, 0, half, height())), second_);
        return;
    }
    const QRect both = place();
    const int line = both.left() + int(part_ * both.width());
    painter.setClipRect(QRect(QPoint(0, 0), QPoint(line - 1, height())));
    painter.drawImage(both, first_);
    painter.setClipRect(QRect(QPoint(line, 0), QPoint(width(), height())));
    painter.drawImage(both, second_);
    painter.setClipping(false);
    painter.setPen(palette().color(QPalette::Text));
    painter.drawLine(line, both.top(), line, both.bottom());
}

void PictureCurtain::mousePressEvent(QMouseEvent* event) {
    mouseMoveEvent(event);
}

void PictureCurtain::mouseMoveEvent(QMouseEvent* event) {
    if (!hasPictures() || areBesideEachOther_ || !event->buttons().testFlag(Qt::LeftButton)) return;
    const QRect both = place();
    setPart((event->position().x() - both.left()) / std::max(1, both.width()));
    Q_EMIT partMoved(part_);
}

PresetComparison::PresetComparison(const Side& first, const Side& second, const std::string& preferredDevice,
                                   QWidget* parent)
    : QDialog(parent),
      sizePx_(first.picture.sizePx.x, first.picture.sizePx.y),
      curtain_(new PictureCurtain),
      slider_(new QSlider(Qt::Horizontal)),
      secondVolume_(new QCheckBox(tr("&Beside each other"))),
      trouble_(new QLabel),
      work_(new WorkBar),
      job_(new ComparisonJob(*this, parent)) {
    setWindowTitle(tr("Compare presets"));
    slider_->setAccessibleName(tr("Where the two pictures meet"));
    slider_->setToolTip(tr("Where the two pictures meet, from left to right"));
    slider_->setRange(0, kSteps);
    slider_->setValue(kSteps / 2);
    secondVolume_->setToolTip(tr("Each picture as a whole, instead of one line between them"));
    makePlain(*trouble_, "comparison-trouble");
    trouble_->hide();
    auto* titles = new QHBoxLayout;
    titles->addWidget(makeTitle(first.title, Qt::AlignLeft), 1);
    titles->addWidget(makeTitle(second.title, Qt::AlignRight), 1);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close);
    QPushButton* choose = buttons->addButton(
        tr("&Use %1").arg(QString(second.title).replace(QLatin1Char('&'), QLatin1String("&&"))),
        QDialogButtonBox::AcceptRole);
    choose->setObjectName(QStringLiteral("comparison-use"));
    choose->setToolTip(tr("Show the volume with the preset at the right; can be undone"));
    auto* column = new QVBoxLayout(this);
    column->addLayout(titles);
    column->addWidget(curtain_, 1);
    column->addWidget(slider_);
    column->addWidget(secondVolume_);
    column->addWidget(trouble_);
    column->addWidget(work_);
    column->addWidget(buttons);
    connect(slider_, &QSlider::valueChanged, curtain_,
            [this](int value) { curtain_->setPart(double(value) / kSteps); });
    connect(curtain_, &PictureCurtain::partMoved, slider_,
            [this](double part) { slider_->setValue(int(part * kSteps + 0.5)); });
    connect(secondVolume_, &QCheckBox::toggled, this, [this](bool are) {
        curtain_->setBesideEachOther(are);
        slider_->setEnabled(!are);
    });
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    connect(buttons, &QDialogButtonBox::accepted, this, [this] {
        Q_EMIT secondChosen();
        accept();
    });
    connect(work_, &WorkBar::cancelClicked, this, &QDialog::reject);
    connect(this, &QDialog::finished, this, [this] { job_->cancel(); });
    work_->begin(tr("Drawing both"));
    job_->start(std::vector{first.picture, second.picture}, preferredDevice);
}

PresetComparison::~PresetComparison() {
    if (job_) job_->leave();
}

bool PresetComparison::isDrawing() const {
    return job_ && job_->isRunning();
}

void PresetComparison::onDrawn(const Result<Pictures>& drawn) {
    work_->hide();
    if (!drawn) {
        trouble_->setText(inWindowsLanguage(drawn.error()));
        return trouble_->show();
    }
    curtain_->setPictures(asImage(drawn->at(0), sizePx_), asImage(drawn->at(1), sizePx_));
}

}  // namespace macula::viewer
