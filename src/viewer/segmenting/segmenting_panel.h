// The controls that make and change own segments.
#pragma once

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QLabel>
#include <QPushButton>
#include <QWidget>
#include <vector>

#include "viewer/editor/study_editor.h"
#include "viewer/segmenting/segment_work.h"

namespace macula::viewer {

// Shows what the work says, and asks it for changes. Both outlive it.
class SegmentingPanel : public QWidget {
    Q_OBJECT

  public:
    SegmentingPanel(StudyEditor& session, SegmentWork& work, QWidget* parent = nullptr);

  Q_SIGNALS:
    void toolAsked();  // the tool that paints on slices
    void programAsked();
    void saveAsked();

  private:
    QWidget* makeSegmentRow();
    void makeBrush(QFormLayout& form);
    void makeThreshold(QFormLayout& form);
    void makePreview(QFormLayout& form);
    void makeFilter(QFormLayout& form);
    static void setUnit(QDoubleSpinBox& spin, const QString& unit);
    QDoubleSpinBox* makeSpin(const char* name, const QString& what, double low, double high, double value);
    QPushButton* makeButton(const char* name, const QString& text, const QString& what);
    QWidget* row(const std::vector<QWidget*>& widgets);

    void askForName(const QString& title, const QString& now, void (SegmentWork::*then)(const QString&));
    void takeBrush();
    void takeWindow();
    void showThreshold();
    void followStudy();
    void followFilter();
    void show();
    void showStatistics();

    StudyEditor& session_;
    SegmentWork& work_;
    QWidget* tools_ = nullptr;
    QPushButton* make_ = nullptr;
    QPushButton* rename_ = nullptr;
    QPushButton* remove_ = nullptr;
    QComboBox* mode_ = nullptr;
    QDoubleSpinBox* radius_ = nullptr;
    QCheckBox* oneSlice_ = nullptr;
    QDoubleSpinBox* tolerance_ = nullptr;
    QDoubleSpinBox* most_ = nullptr;
    QCheckBox* corners_ = nullptr;
    QCheckBox* within_ = nullptr;
    QDoubleSpinBox* low_ = nullptr;
    QDoubleSpinBox* high_ = nullptr;
    QLabel* preview_ = nullptr;
    std::vector<QPushButton*> joins_;
    QComboBox* filter_ = nullptr;
    QDoubleSpinBox* amount_ = nullptr;
    QPushButton* apply_ = nullptr;
    QLabel* statistics_ = nullptr;
};

}  // namespace macula::viewer
