// What was opened since the program was started, to open it again.
#pragma once

#include <QMenu>
#include <filesystem>
#include <vector>

namespace macula::viewer {

// Nothing of it is kept between runs: the names of folders may be those of patients (docs/privacy.md).
class RecentMenu : public QMenu {
    Q_OBJECT

  public:
    explicit RecentMenu(QWidget* parent = nullptr);

    void add(const std::filesystem::path& path);  // it becomes the first; the eleventh goes
    void clearAll();
    void showNames(bool shown);  // without names the menu cannot be opened

  signals:
    void chosen(const QString& path);

  private:
    void fill();

    std::vector<std::filesystem::path> paths_;  // absolute
    bool namesShown_ = true;
};

}  // namespace macula::viewer
