// The browser of studies, while a folder is read and after; and what was opened before.
#include <set>

#include "viewer/browser/recent_menu.h"
#include "viewer/browser/study_browser.h"
#include "viewer/jobs/post.h"
#include "viewer/window/main_window.h"

namespace macula::viewer {

void MainWindow::connectBrowser() {
    connect(browser_, &StudyBrowser::chosen, this, [this](std::size_t index) {
        keepState();  // as in open()
        // It may be a folder of which no volume is on screen yet.
        loader_.open(browser_->found(), index);
        focusPicture();
    });
    connectListedPresentations();
    recent_ = new RecentMenu(this);
    connect(recent_, &RecentMenu::chosen, this, [this](const QString& path) { open(path.toStdString()); });

    connect(
        &loader_, &StudyLoader::found, this,
        [this](const std::shared_ptr<const study::FoundVolumes>& found) { showFound(found, std::nullopt); });
    connect(&loader_, &StudyLoader::loaded, this, [this] {
        if (const study::StudySource& source = loader_.source()) recent_->add(*source);
    });
    // Of a folder that was read the series stay, to choose another one from.
    const auto goBack = [this] {
        if (browser_->found() && !browser_->found()->isWhole()) showFound(study().found, study().volumeIndex);
    };
    connect(&loader_, &StudyLoader::failed, this, goBack);
    connect(&loader_, &StudyLoader::askedToJoin, this, goBack);
    connect(&loader_, &StudyLoader::cancelled, this, goBack);
}

// Which of it was seen before is known later, and of glimpses not asked for: there are no volumes yet.
void MainWindow::showFound(const std::shared_ptr<const study::FoundVolumes>& found,
                           std::optional<std::size_t> open) {
    const bool isNew = found != browser_->found();
    browser_->setFound(found, open);
    if (!keeper_ || !found || !found->isWhole() || !isNew) return;
    keeper_->askWhatWasSeen(found, [this, found](const std::set<std::size_t>& seen) {
        post(this, [this, found, seen] {
            if (browser_->found() == found) browser_->setStored(seen);
        });
    });
}

}  // namespace macula::viewer
