// The options of a movie: turntable or camera path, duration, size and quality.
#pragma once

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QSpinBox>
#include <QWidget>
#include <functional>
#include <optional>
#include <string>

#include "scene/camera/camera_path.h"

namespace macula::viewer {

// Keeps the views of the path until another study is shown. Draws nothing: the owner draws on `drawAsked`.
// Lives on the UI thread.
class MoviePanel : public QWidget {
    Q_OBJECT

  public:
    // `camera` returns the window's current camera; nothing without a study.
    explicit MoviePanel(std::function<std::optional<Camera>()> camera, QWidget* parent = nullptr);

    bool isTurntable() const { return kinds_->currentIndex() == 0; }
    // The turntable's angle; below 0: to the patient's right.
    double degrees() const { return degrees_->value(); }
    double seconds() const { return seconds_->value(); }
    double picturesPerS() const { return rate_->value(); }
    int frames() const;
    QSize sizePx() const { return {width_->value(), height_->value()}; }
    std::string quality() const;  // by name: pictures::EffortRequest
    bool withLetters() const { return letters_->isChecked(); }
    bool withNames() const { return names_->isChecked(); }  // names of patient and study
    bool wantsVideo() const { return video_->isEnabled() && video_->isChecked(); }
    // Whether the machine can encode a video; if not, the panel says so before drawing.
    void setHasEncoder(bool hasEncoder);

    // The chosen path, for a turntable from that camera; nothing for a path without views. Lasts seconds().
    std::optional<scene::CameraPath> pathFrom(const Camera& camera) const;
    // Whether the turntable makes whole turns, so that the first picture also follows the last.
    bool isClosed() const;

    const scene::CameraPath& views() const { return views_; }
    void setViews(scene::CameraPath views);  // as read from a file; empty: none
    void addView();                          // the current view, kSecondsPerView after the one before
    static constexpr double kSecondsPerView = 2.0;

  Q_SIGNALS:
    void drawAsked();
    void openAsked();  // to open a path from a file
    void saveAsked();  // to save the path to a file

  private:
    void addChoices();
    void addViews();
    void removeView();
    void showViews();
    void showFrames();

    std::function<std::optional<Camera>()> camera_;
    scene::CameraPath views_;
    QComboBox* kinds_ = nullptr;
    QDoubleSpinBox* degrees_ = nullptr;
    QDoubleSpinBox* seconds_ = nullptr;
    QDoubleSpinBox* rate_ = nullptr;
    QSpinBox* width_ = nullptr;
    QSpinBox* height_ = nullptr;
    QComboBox* qualities_ = nullptr;
    QCheckBox* letters_ = nullptr;
    QCheckBox* names_ = nullptr;
    QCheckBox* video_ = nullptr;
    QLabel* noEncoder_ = nullptr;  // shown without an encoder
    QLabel* count_ = nullptr;
    QListWidget* list_ = nullptr;
    QPushButton* remove_ = nullptr;
    QPushButton* save_ = nullptr;
    QPushButton* draw_ = nullptr;
};

}  // namespace macula::viewer
