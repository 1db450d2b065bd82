// Asks what to send to which archive, and names the patient whom it is about.
#pragma once

#include <QDialog>
#include <QSize>
#include <QString>
#include <QStringList>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "study/archive/files_to_send.h"
#include "study/open/identity.h"
#include "viewer/jobs/background_job.h"

class QCheckBox;
class QComboBox;
class QFormLayout;
class QLabel;
class QPushButton;

namespace macula::viewer {

// What the open study can give.
struct SendOffer {
    QStringList archives;
    QString archive;          // chosen at first
    study::Identity patient;  // of the open study
    QString whyNoObjects;     // of it; empty: objects can be made of it
    QString whyNoView;        // likewise, of the view alone
    int measurements = 0;
    QString whyNoMeasurements;
    int segments = 0;
    QString whyNoSegments;
    QSize screenPx;  // of the 3D view
    bool is3dShown = true;
    bool isDeidentified = false;  // at first
};

// Its values hold once it is accepted. Names stand in it also where they are hidden over pictures: nobody
// should send what is not known whose it is. Lives on the UI thread.
class SendDialog : public QDialog {
    Q_OBJECT

  public:
    explicit SendDialog(const SendOffer& offer, QWidget* parent = nullptr);

    // Of a disk, besides those chosen before; folders, too. Reads them in the background.
    void addFiles(std::vector<std::filesystem::path> paths);

    QString archive() const;
    bool sendsPicture() const;
    bool sendsView() const;
    bool sendsMeasurements() const;
    bool sendsSegments() const;
    bool isDeidentified() const;
    QSize sizePx() const;
    const study::FilesToSend& files() const { return files_; }

  Q_SIGNALS:
    void filesAsked();   // answered by addFiles
    void folderAsked();  // likewise

  private:
    void makeObjects(QFormLayout& form);
    void makeFiles(QFormLayout& form);
    QWidget* makeButtons();
    void clearFiles();
    void showFiles(const Result<study::FilesToSend>& found);
    void showQuestion();

    SendOffer offer_;
    std::vector<std::filesystem::path> paths_;
    study::FilesToSend files_;
    QComboBox* archives_;
    QCheckBox* picture_;
    QComboBox* sizes_;
    QCheckBox* view_;
    QCheckBox* measurements_;
    QCheckBox* segments_;
    QCheckBox* deidentified_;
    QLabel* filesTold_;
    QPushButton* clear_ = nullptr;
    QLabel* question_;
    QLabel* patients_;
    QLabel* warning_;
    QPushButton* send_ = nullptr;
    BackgroundJob<study::FilesToSend> reading_;
};

}  // namespace macula::viewer
