// A menu that reopens folders and files opened in this run.
#pragma once

#include <QMenu>
#include <filesystem>
#include <vector>

namespace macula::viewer {

// It is not kept between runs, because folder names may contain patient names (docs/privacy.md).
class RecentMenu : public QMenu {
    Q_OBJECT

  public:
    explicit RecentMenu(QWidget* parent = nullptr);

    void add(const std::filesystem::path& path);  // puts it first and drops the eleventh
    void clearAll();
    void showNames(bool shown);  // the menu is disabled while names are hidden

    const std::vector<std::filesystem::path>& paths() const { return paths_; }

  Q_SIGNALS:
    void chosen(const QString& path);

  private:
    void fill();

    std::vector<std::filesystem::path> paths_;  // absolute
    bool namesShown_ = true;
};

}  // namespace macula::viewer
