// The dose-volume histograms of the regions of a study, as a chart and as figures.
#pragma once

#include <QDialog>
#include <QString>
#include <memory>
#include <optional>

#include "study/dose/dose_report.h"

class QLabel;
class QPushButton;
class QTableWidget;

namespace macula::viewer {

class DvhChart;
class WorkBar;

// Not modal. Shows what it is given; whoever computes listens to its signals.
class DvhDialog : public QDialog {
    Q_OBJECT

  public:
    explicit DvhDialog(QWidget* parent = nullptr);

    void begin(const QString& stage);  // shows progress instead of an old report
    void setProgress(const QString& stage, double fraction);
    void setReport(std::shared_ptr<const study::DoseReport> report, const QString& title);
    void setTrouble(const QString& sentence);
    void showNames(bool shown);  // the titles of structure sets may name the patient

    const std::shared_ptr<const study::DoseReport>& report() const { return report_; }
    DvhChart& chart() const { return *chart_; }
    QTableWidget& table() const { return *table_; }

  Q_SIGNALS:
    void cancelAsked();
    void exportAsked(const QString& csv);

  private:
    void fill();
    void showNotes();
    void copy();
    QString csv() const;
    void onItemChanged();

    std::shared_ptr<const study::DoseReport> report_;
    bool namesShown_ = true;
    bool isFilling_ = false;
    QLabel* title_;
    DvhChart* chart_;
    QTableWidget* table_;
    QLabel* notes_;
    WorkBar* work_;
    QPushButton* copy_;
    QPushButton* export_;
};

}  // namespace macula::viewer
