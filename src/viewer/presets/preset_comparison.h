// Compares two presets in the same view.
#pragma once

#include <QDialog>
#include <QImage>
#include <QLabel>
#include <QPointer>
#include <QSlider>
#include <QString>
#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "pictures/view_picture.h"

class QCheckBox;

namespace macula::viewer {

class ComparisonJob;
class WorkBar;

// Two pictures of one size: over each other, with the first left of a line that a person drags, or side by
// side.
class PictureCurtain : public QWidget {
    Q_OBJECT

  public:
    explicit PictureCurtain(QWidget* parent = nullptr);

    void setPictures(QImage first, QImage second);
    bool hasPictures() const { return !first_.isNull(); }
    void setBesideEachOther(bool are);
    void setPart(double part);  // where the line is: 0 to 1, from the left
    double part() const { return part_; }
    QSize sizeHint() const override;

  Q_SIGNALS:
    void partMoved(double part);  // by a person

  protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;

  private:
    QRect place() const;  // where the picture is, while one lies over the other

    QImage first_;
    QImage second_;
    bool areBesideEachOther_ = false;
    double part_ = 0.5;
};

// Draws both in the background as still pictures; closing cancels. Show it with open() or show().
class PresetComparison : public QDialog {
    Q_OBJECT

  public:
    struct Side {
        QString title;
        pictures::ViewPicture picture;  // both of one size; writes no file
    };

    PresetComparison(const Side& first, const Side& second, const std::string& preferredDevice,
                     QWidget* parent = nullptr);

    ~PresetComparison() override;  // does not wait for the drawing

    PictureCurtain& curtain() { return *curtain_; }
    bool isDrawing() const;
    QString trouble() const { return trouble_->text(); }

  Q_SIGNALS:
    void secondChosen();

  private:
    friend class ComparisonJob;
    using Pictures = std::vector<std::vector<std::uint8_t>>;

    void onDrawn(const Result<Pictures>& drawn);

    QSize sizePx_;
    PictureCurtain* curtain_;
    QSlider* slider_;
    QCheckBox* secondVolume_;
    QLabel* trouble_;
    WorkBar* work_;
    QPointer<ComparisonJob> job_;
};

}  // namespace macula::viewer
