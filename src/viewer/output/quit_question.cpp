#include "viewer/output/quit_question.h"

#include <QCoreApplication>
#include <QMessageBox>
#include <QPushButton>
#include <utility>

namespace macula::viewer {

namespace {

struct Words {
    Q_DECLARE_TR_FUNCTIONS(QuitQuestion)
};

}  // namespace

void askToQuit(QWidget* parent, const QStringList& unfinished, std::function<void()> wait,
               std::function<void()> quit) {
    auto* box = new QMessageBox(QMessageBox::Question, Words::tr("Quit?"), unfinished.join(QLatin1Char(' ')),
                                QMessageBox::Cancel, parent);
    box->setObjectName(QStringLiteral("quit-question"));
    box->setInformativeText(Words::tr("If you quit now, no file of it is left."));
    box->setAttribute(Qt::WA_DeleteOnClose);
    QPushButton* finish = box->addButton(Words::tr("&Finish, Then Quit"), QMessageBox::AcceptRole);
    QPushButton* now = box->addButton(Words::tr("&Quit Now"), QMessageBox::DestructiveRole);
    box->setDefaultButton(finish);
    box->setEscapeButton(QMessageBox::Cancel);
    QObject::connect(box, &QMessageBox::finished, box,
                     [box, finish, now, wait = std::move(wait), quit = std::move(quit)] {
                         if (box->clickedButton() == finish) wait();
                         if (box->clickedButton() == now) quit();
                     });
    box->open();  // exec() would run a second event loop
}

}  // namespace macula::viewer
