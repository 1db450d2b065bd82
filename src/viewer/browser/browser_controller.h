// The study browser, the list of the open folder's volumes, and the menu of what was opened before.
#pragma once

#include <QComboBox>
#include <QObject>
#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

#include "base/text.h"
#include "study/open/found_volumes.h"
#include "viewer/context/window_context.h"

class QAction;
class QMenu;
class QToolBar;

namespace macula::live {
class StudyKeeper;
}

namespace macula::viewer {

class OpeningController;
class RecentMenu;
class StudyBrowser;

// Lists "1 of 3" and a name for each volume. Shows that of the open one: a choice changes it only once the
// other volume is open.
class VolumeChoice : public QComboBox {
    Q_OBJECT

  public:
    explicit VolumeChoice(QWidget* parent = nullptr);

    void setVolumes(const std::vector<Text>& titles, std::size_t shown);

  Q_SIGNALS:
    void chosen(std::size_t index);

  protected:
    void paintEvent(QPaintEvent* event) override;

  private:
    int shown_ = -1;
};

// Lives on the UI thread.
class BrowserController : public QObject {
    Q_OBJECT

  public:
    // `opening` and the keeper live until the window's destructor; without a keeper nothing is kept between
    // runs.
    BrowserController(const WindowContext& context, OpeningController& opening, live::StudyKeeper* keeper);

    StudyBrowser& browser() const { return *browser_; }
    void setShownAction(QAction& shown) { shown_ = &shown; }  // shows and hides the browser's panel
    RecentMenu& recent() const { return *recent_; }
    // A volume that is selected in the browser while it is shown, other than the open one.
    std::optional<std::size_t> selectedOther() const;

    void addFindAction(QMenu& edit);
    void addVolumes(QToolBar& bar);  // a list of the volumes in the open study's folder
    void showNames(bool shown);
    void onStudyShown();

  private:
    void showFound(const std::shared_ptr<const study::FoundVolumes>& found, std::optional<std::size_t> open);
    void showOpen();
    void showVolumes();
    void connectLoader();

    WindowContext context_;
    OpeningController& opening_;
    live::StudyKeeper* keeper_;
    StudyBrowser* browser_;
    RecentMenu* recent_;
    bool namesShown_ = true;
    QAction* shown_ = nullptr;
    VolumeChoice* volumes_ = nullptr;
    QAction* volumesInBar_ = nullptr;  // shows and hides `volumes_`
};

}  // namespace macula::viewer
