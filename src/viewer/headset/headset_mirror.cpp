#include "viewer/headset/headset_mirror.h"

#include <QCheckBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <QPushButton>
#include <QVBoxLayout>

#include "viewer/menus/controls.h"

namespace macula::viewer {

// As large as fits, with the aspect that it has in the headset.
class MirrorPicture : public QWidget {
  public:
    explicit MirrorPicture(QWidget* parent) : QWidget(parent) {
        setMinimumSize(120, 120);
        setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
        setAttribute(Qt::WA_OpaquePaintEvent);
    }

    void setPicture(const QImage& picture) {
        picture_ = picture;
        update();
    }

  protected:
    void paintEvent(QPaintEvent*) override {
        QPainter painter(this);
        painter.fillRect(rect(), Qt::black);
        if (picture_.isNull()) return;
        QRect shown(QPoint(0, 0), picture_.size().scaled(size(), Qt::KeepAspectRatio));
        shown.moveCenter(rect().center());
        painter.setRenderHint(QPainter::SmoothPixmapTransform);
        painter.drawImage(shown, picture_);
    }

  private:
    QImage picture_;
};

HeadsetMirror::HeadsetMirror(QWidget* parent)
    : QWidget(parent),
      picture_(new MirrorPicture(this)),
      namesText_(new QLabel(this)),
      note_(new QLabel(this)),
      names_(new QCheckBox(tr("Patient and study"), this)),
      button_(new QPushButton(this)) {
    picture_->setObjectName(QStringLiteral("headset-picture"));
    picture_->setAccessibleName(tr("What the left eye sees in the headset"));
    makePlain(*namesText_, "headset-patient");
    makePlain(*note_, "headset-note");
    names_->setObjectName(QStringLiteral("headset-names"));
    names_->setToolTip(tr("Whose study is in the headset, above the mirror; off at each start"));
    button_->setObjectName(QStringLiteral("headset-button"));
    auto* column = new QVBoxLayout(this);
    column->addWidget(namesText_);
    column->addWidget(picture_, 1);
    column->addWidget(note_);
    auto* row = new QHBoxLayout;
    row->addWidget(names_);
    row->addStretch(1);
    row->addWidget(button_);
    column->addLayout(row);
    connect(names_, &QCheckBox::toggled, this, &HeadsetMirror::showTexts);
    connect(button_, &QPushButton::clicked, this, [this] {
        if (runs_) {
            Q_EMIT stopAsked();
        } else {
            Q_EMIT startAsked();
        }
    });
    showTexts();
}

bool HeadsetMirror::showsNames() const {
    return names_->isChecked();
}

void HeadsetMirror::setNames(const QString& names) {
    named_ = names;
    showTexts();
}

void HeadsetMirror::setRunning(bool runs) {
    runs_ = runs;
    if (runs) names_->setChecked(false);
    if (!runs) picture_->setPicture({});
    showTexts();
}

void HeadsetMirror::setPicture(const QImage& leftEye) {
    if (runs_) picture_->setPicture(leftEye);
}

void HeadsetMirror::setNote(const QString& note) {
    note_->setText(note);
    note_->setVisible(!note.isEmpty());
}

void HeadsetMirror::showTexts() {
    namesText_->setText(showsNames() ? named_ : QString());
    namesText_->setVisible(showsNames() && !named_.isEmpty());
    note_->setVisible(!note_->text().isEmpty());
    button_->setText(runs_ ? tr("Stop") : tr("Show in Headset"));
    button_->setToolTip(runs_ ? tr("End the session in the headset; the window goes on")
                              : tr("The study of this window in a headset (OpenXR)"));
}

}  // namespace macula::viewer
