// Mirrors the left eye of the headset in the window.
#pragma once

#include <QImage>
#include <QString>
#include <QWidget>

class QCheckBox;
class QLabel;
class QPushButton;

namespace macula::viewer {

class MirrorPicture;

// Patient and study are shown above it only on request, because others may watch the screen.
class HeadsetMirror : public QWidget {
    Q_OBJECT

  public:
    explicit HeadsetMirror(QWidget* parent = nullptr);

    void setNames(const QString& names);  // the names of patient and study
    void setRunning(bool runs);
    void setPicture(const QImage& leftEye);  // null: no picture
    void setNote(const QString& note);

    bool showsNames() const;
    QSize sizeHint() const override { return {360, 420}; }

  Q_SIGNALS:
    void startAsked();
    void stopAsked();

  private:
    void showTexts();

    MirrorPicture* picture_;
    QLabel* namesText_;
    QLabel* note_;
    QCheckBox* names_;
    QPushButton* button_;
    QString named_;
    bool runs_ = false;
};

}  // namespace macula::viewer
