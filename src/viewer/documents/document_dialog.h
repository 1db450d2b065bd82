// The reading pane: one document of a study as text, with the images that it refers to.
#pragma once

#include <QDialog>
#include <QString>
#include <QStringList>
#include <cstddef>
#include <vector>

#include "dicom/documents/document.h"

class QLabel;
class QListWidget;
class QPushButton;
class QTextBrowser;

namespace macula::viewer {

// Not modal: a person reads beside the images. Escape closes it. Lives on the UI thread.
class DocumentDialog : public QDialog {
    Q_OBJECT

  public:
    explicit DocumentDialog(QWidget* parent = nullptr);

    // `images` names the references of the document, in their order, as "Series 3, image 12"; empty for those
    // that are not in the folder.
    void setDocument(const dicom::StudyDocument& document, const QStringList& images);
    const dicom::StudyDocument& document() const { return document_; }
    // Marks the image that is on screen.
    void setImage(int place);
    int image() const { return image_; }
    QString text() const;  // all of it, as plain text

  Q_SIGNALS:
    void imageAsked(int place);  // among the references
    void textSaveAsked();
    void fileOpenAsked();
    void fileSaveAsked();
    void measurementsAsked();

  private:
    void makeText();
    void makeImages();
    QWidget* makeButtons();
    void copy();
    void step(int by);

    dicom::StudyDocument document_;
    QStringList images_;
    int image_ = -1;
    QLabel* patient_;
    QLabel* title_;
    QLabel* status_;
    QLabel* notes_;
    QTextBrowser* browser_;
    QWidget* beside_;
    QLabel* imagesTitle_;
    QListWidget* list_;
    QPushButton* previous_ = nullptr;
    QPushButton* next_ = nullptr;
    QPushButton* openFile_ = nullptr;
    QPushButton* saveFile_ = nullptr;
    QPushButton* measurements_ = nullptr;
};

}  // namespace macula::viewer
