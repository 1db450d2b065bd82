// What a movie is to be: a turntable or a way of the camera, how long, how large, how good.
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

// Keeps the views of the way until another study comes. Draws nothing: who has the window asks it when
// `drawAsked` comes. Lives on the UI thread.
class MoviePanel : public QWidget {
    Q_OBJECT

  public:
    // `camera`: that of the window now; nothing where there is no study.
    explicit MoviePanel(std::function<std::optional<Camera>()> camera, QWidget* parent = nullptr);

    bool isTurntable() const { return kinds_->currentIndex() == 0; }
    double degrees() const { return degrees_->value(); }  // of a turntable; below 0: to the patient's right
    double seconds() const { return seconds_->value(); }
    double picturesPerS() const { return rate_->value(); }
    int frames() const;
    QSize sizePx() const { return {width_->value(), height_->value()}; }
    std::string quality() const;  // by name: app::EffortWish
    bool withLetters() const { return letters_->isChecked(); }
    bool withNames() const { return names_->isChecked(); }  // of patient and study
    bool wantsVideo() const { return video_->isEnabled() && video_->isChecked(); }
    // Whether the machine can make one: where it cannot, the panel says so before anything is drawn.
    void setHasEncoder(bool hasEncoder);

    // Of what is chosen, from that camera; nothing for a way without views. Its time is seconds().
    std::optional<app::CameraPath> pathFrom(const Camera& camera) const;
    // Once around: the last picture would be the first again.
    bool isClosed() const;

    const app::CameraPath& views() const { return views_; }
    void setViews(app::CameraPath views);  // as they are in a file; empty: none
    void addView();                        // of now, kSecondsPerView after the one before
    static constexpr double kSecondsPerView = 2.0;

  signals:
    void drawAsked();
    void openAsked();  // a way from a file
    void saveAsked();  // to one

  private:
    void addChoices();
    void addViews();
    void removeView();
    void showViews();
    void showFrames();

    std::function<std::optional<Camera>()> camera_;
    app::CameraPath views_;
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
    QLabel* noEncoder_ = nullptr;  // says that there is none
    QLabel* count_ = nullptr;
    QListWidget* list_ = nullptr;
    QPushButton* remove_ = nullptr;
    QPushButton* save_ = nullptr;
    QPushButton* draw_ = nullptr;
};

}  // namespace macula::viewer
