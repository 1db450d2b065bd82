#include "viewer/browser/recent_menu.h"

#include <algorithm>
#include <cstddef>

#include "viewer/language/harmless_text.h"

namespace macula::viewer {

namespace {

constexpr std::size_t kMost = 10;
constexpr int kDigits = 9;  // "&1" to "&9"

QString shownPath(const std::filesystem::path& path) {
    return harmless(QString::fromStdString(path.string()));
}

// Includes the parent folder: exports of many patients have subfolders of the same name.
QString titleOfPath(const std::filesystem::path& path) {
    const std::filesystem::path parent = path.parent_path().filename();
    QString title = shownPath(parent.empty() ? path : parent / path.filename());
    return title.replace(QLatin1Char('&'), QLatin1String("&&"));
}

}  // namespace

RecentMenu::RecentMenu(QWidget* parent) : QMenu(tr("Open &Recent"), parent) {
    setToolTipsVisible(true);
    menuAction()->setToolTip(tr("What was opened since the program was started; it is not kept for longer"));
    fill();
}

void RecentMenu::add(const std::filesystem::path& path) {
    std::error_code failed;
    std::filesystem::path absolute = std::filesystem::absolute(path, failed).lexically_normal();
    if (failed) absolute = path;
    if (!absolute.has_filename()) absolute = absolute.parent_path();  // "folder/"
    std::erase(paths_, absolute);
    paths_.insert(paths_.begin(), std::move(absolute));
    if (paths_.size() > kMost) paths_.pop_back();
    fill();
}

void RecentMenu::clearAll() {
    paths_.clear();
    fill();
}

void RecentMenu::showNames(bool shown) {
    namesShown_ = shown;
    fill();
}

void RecentMenu::fill() {
    clear();
    setEnabled(namesShown_ && !paths_.empty());
    if (!isEnabled()) return;
    int number = 0;
    for (const std::filesystem::path& path : paths_) {
        ++number;
        const QString digit = number <= kDigits ? QStringLiteral("&%1  ").arg(number) : QString();
        QAction* action = addAction(digit + titleOfPath(path), this,
                                    [this, path] { Q_EMIT chosen(QString::fromStdString(path.string())); });
        action->setToolTip(shownPath(path));
    }
    addSeparator();
    // Queued, because clearAll() deletes the action that emits this signal.
    connect(addAction(tr("&Forget All")), &QAction::triggered, this, &RecentMenu::clearAll,
            Qt::QueuedConnection);
}

}  // namespace macula::viewer
