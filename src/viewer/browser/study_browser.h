// A list of the studies, series and volumes in the open folder.
#pragma once

#include <QLabel>
#include <QLineEdit>
#include <QTimer>
#include <QTreeView>
#include <QWidget>
#include <cstddef>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "study/list/series_thumbnail.h"
#include "viewer/browser/study_tree_model.h"
#include "viewer/jobs/background_job.h"

namespace macula::viewer {

// A tree with a search field above it. One click selects; a double click or Enter chooses. A choice changes
// the open volume's mark only after setShown. Thumbnails are made in the background, one at a time, for
// visible rows only, and not while the browser is hidden.
class StudyBrowser : public QWidget {
    Q_OBJECT

  public:
    explicit StudyBrowser(QWidget* parent = nullptr);

    // Wide enough for most series descriptions beside their thumbnails.
    QSize sizeHint() const override { return {340, 400}; }

    // `found` null: no folder is open. `open` is an index into FoundVolumes::volumes(); if it is nothing, no
    // row is selected until a person selects one, and the browser says that the open volume is not in the
    // folder. The search is cleared, unless the new list continues a folder that is still being read
    // (FoundVolumes::isWhole).
    void setFound(std::shared_ptr<const study::FoundVolumes> found, std::optional<std::size_t> open);
    const std::shared_ptr<const study::FoundVolumes>& found() const { return found_; }
    void setShown(std::optional<std::size_t> open);
    // While names are hidden, so is all text from files that may name a patient. Thumbnails stay, with any
    // text burnt into the images.
    void showNames(bool shown);
    // Indices of the volumes that have data stored between runs.
    void setStored(std::set<std::size_t> volumes);
    // Marks the series that have key images; of found().
    void setKeyImages(std::shared_ptr<const study::KeyImages> keys);
    void focusSearch();
    std::optional<std::size_t> selectedOther() const;  // a volume other than the open one

  Q_SIGNALS:
    void listed();                                         // another found()
    void chosen(std::size_t index);                        // a volume other than the open one
    void secondAsked(std::size_t index);                   // a volume to show beside the open one
    void openChosen();                                     // the open volume once more
    void imagesChosen(const macula::dicom::Stack* stack);  // a series without a volume; of found()
    void documentChosen(const macula::study::StudyRow::Document& document);  // of found()
    // A person chose this presentation state; its volume may not be open.
    void imagesPresented(const macula::study::StudyRow::Presentation& presentation);
    void presentationChosen(const macula::study::StudyRow::Presentation& presentation);
    // The chosen presentation state cannot be shown; the sentence is study::StudyRow::whyNot.
    void presentationRefused(const Text& whyNot);

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    void makeSearch();
    void makeTree();
    bool onSearchKey(int key);
    study::StudyTree makeRows() const;
    void search();
    void endSearch();
    void showRows();  // the same ones, with other texts
    void layOut(std::size_t current);
    bool isExpanded(std::size_t row) const;
    void rememberExpanded(const QModelIndex& index, bool isExpanded);
    void revealOpen();
    std::size_t currentRow() const;
    std::size_t rowToSelect(std::size_t wanted) const;
    void openRow(const QModelIndex& index);
    void tellWhatIsMissing();
    void makeNextPicture();
    void takePicture(const Result<study::Thumbnail>& made);

    QLineEdit* search_;
    QTreeView* tree_;
    QLabel* nothing_;
    QLabel* reading_;    // the folder is still being read
    QLabel* elsewhere_;  // the open volume is in another folder
    StudyTreeModel* model_;

    std::shared_ptr<const study::FoundVolumes> found_;
    std::shared_ptr<const study::KeyImages> keys_;  // of `found_`; null: none
    bool namesShown_ = true;
    std::vector<std::string> words_;  // the words to search for
    std::vector<bool> expanded_;      // whether each row is expanded while there is no search
    bool isLayingOut_ = false;

    QTimer picturesAreDue_;
    const dicom::Stack* making_ = nullptr;
    BackgroundJob<study::Thumbnail> pictures_;
};

}  // namespace macula::viewer
