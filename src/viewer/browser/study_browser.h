// The studies, series and volumes of the folder that is open, to pick from.
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

// A tree with a search above it. One click selects; a double click or Enter chooses. It names what is open: a
// choice changes it only once it is told that the other volume is. Small pictures are made one after another
// beside the UI thread, of the rows that are seen, and of nothing while the browser is hidden.
class StudyBrowser : public QWidget {
    Q_OBJECT

  public:
    explicit StudyBrowser(QWidget* parent = nullptr);

    // So wide that most descriptions of series have room beside their pictures.
    QSize sizeHint() const override { return {340, 400}; }

    // Null: there is no folder. `open` is in FoundVolumes::volumes(); without it no row is selected until a
    // person selects one, and the browser says that nothing of the folder is open. The search starts anew
    // with a folder, but for one that was shown while it was being read (FoundVolumes::isWhole): that is the
    // same one.
    void setFound(std::shared_ptr<const app::FoundVolumes> found, std::optional<std::size_t> open);
    const std::shared_ptr<const app::FoundVolumes>& found() const { return found_; }
    void setShown(std::optional<std::size_t> open);
    // Without names no text of the files is shown that may name a patient; pictures are, and text that a
    // machine has drawn into its images is seen in them.
    void showNames(bool shown);
    // Volumes that something is kept of between runs.
    void setStored(std::set<std::size_t> volumes);
    void focusSearch();
    std::optional<std::size_t> selectedOther() const;  // a volume that is not the one that is open

  signals:
    void chosen(std::size_t index);       // another volume than the one that is open
    void besideAsked(std::size_t index);  // the same, to be shown beside it
    // A volume, open or not, as the presentation state of that row says.
    void presentationChosen(const macula::app::StudyRow::Presentation& presentation);
    // A presentation state that cannot be shown, and why: a sentence as in app::StudyRow::whyNot.
    void presentationRefused(const std::string& whyNot);

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    void makeSearch();
    void makeTree();
    bool onSearchKey(int key);
    app::StudyTree makeRows() const;
    void search();
    void endSearch();
    void layOut(std::size_t current);
    bool isExpanded(std::size_t row) const;
    void rememberExpanded(const QModelIndex& index, bool isExpanded);
    void revealOpen();
    std::size_t currentRow() const;
    std::size_t rowToSelect(std::size_t wanted) const;
    void openRow(const QModelIndex& index);
    void tellWhatIsMissing();
    void makeNextPicture();
    void takePicture(const Result<app::Thumbnail>& made);

    QLineEdit* search_;
    QTreeView* tree_;
    QLabel* nothing_;
    QLabel* reading_;    // the folder is not read to its end
    QLabel* elsewhere_;  // what is open is of another folder
    StudyTreeModel* model_;

    std::shared_ptr<const app::FoundVolumes> found_;
    bool namesShown_ = true;
    std::vector<std::string> words_;  // that were searched
    std::vector<bool> expanded_;      // of each row, when nothing is searched
    bool isLayingOut_ = false;

    QTimer picturesAreDue_;
    const dicom::Stack* making_ = nullptr;
    BackgroundJob<app::Thumbnail> pictures_;
};

}  // namespace macula::viewer
