// Where file dialogs begin, and what of it is kept.
#include "viewer/settings/file_dialogs.h"

#include <gtest/gtest.h>

#include <QDir>
#include <QFile>
#include <QTemporaryDir>

namespace macula::viewer {
namespace {

class LastFoldersTest : public testing::Test {
  protected:
    QString made(const QString& name) {
        const QString path = folder_.filePath(name);
        QDir().mkpath(path);
        return path;
    }

    QTemporaryDir folder_;
};

TEST_F(LastFoldersTest, EachKindBeginsWhereItEnded) {
    LastFolders folders;
    const QString pictures = made(QStringLiteral("pictures"));
    const QString views = made(QStringLiteral("views"));
    folders.use(FolderKind::pictures, pictures);
    folders.use(FolderKind::views, views);
    EXPECT_EQ(folders.of(FolderKind::pictures), pictures);
    EXPECT_EQ(folders.of(FolderKind::views), views);
    const LastFolders later(folders.toKeep());
    EXPECT_EQ(later.of(FolderKind::pictures), pictures);
    EXPECT_EQ(later.of(FolderKind::views), views);
}

TEST_F(LastFoldersTest, OneThatIsGoneOrWasNeverUsedIsAFolderOfThePerson) {
    LastFolders folders;
    folders.use(FolderKind::models, folder_.filePath(QStringLiteral("gone")));
    const QDir here;
    for (const auto kind : {FolderKind::models, FolderKind::studies, FolderKind::movies}) {
        EXPECT_TRUE(QDir(folders.of(kind)).exists());
        EXPECT_NE(QDir(folders.of(kind)).canonicalPath(), here.canonicalPath()) << int(kind);
    }
}

// A folder of a study may be named for its patient.
TEST_F(LastFoldersTest, NoFolderOfAStudyIsKept) {
    LastFolders folders;
    const QString archive = made(QStringLiteral("archive"));
    const QString doe = made(QStringLiteral("archive/DOE^JOHN/CT"));
    folders.use(FolderKind::pictures, doe);
    folders.use(FolderKind::studies, archive);
    folders.sawStudy(archive + QStringLiteral("/DOE^JOHN"));
    EXPECT_EQ(folders.of(FolderKind::studies), archive);
    folders.use(FolderKind::measurements, doe);
    EXPECT_EQ(folders.of(FolderKind::measurements), doe) << "in this run it is where it was";
    QFile file(doe + QStringLiteral("/1.dcm"));
    ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    file.close();
    folders.sawStudy(file.fileName());
    ASSERT_EQ(folders.toKeep().size(), 3);
    for (const QString& kept : folders.toKeep())
        EXPECT_FALSE(kept.contains(QLatin1String("DOE"))) << kept.toStdString();
    EXPECT_EQ(LastFolders(folders.toKeep()).of(FolderKind::measurements), archive);
}

TEST_F(LastFoldersTest, WhatALaterVersionKeptStays) {
    LastFolders folders({{QStringLiteral("holograms"), QStringLiteral("/holograms")}});
    folders.use(FolderKind::views, folder_.path());
    EXPECT_EQ(folders.toKeep().value(QStringLiteral("holograms")), QStringLiteral("/holograms"));
}

}  // namespace
}  // namespace macula::viewer
