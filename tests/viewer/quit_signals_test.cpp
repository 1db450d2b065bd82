// A program that is asked to end from outside.
#include "viewer/program/quit_signals.h"

#include <gtest/gtest.h>

#include <QCoreApplication>
#include <csignal>

#include "viewer/wait_until.h"

namespace macula::viewer {
namespace {

int heard = 0;  // by the handler of before

TEST(QuitSignals, AreToldInTheEventLoopAndTheSecondOfAKindIsNot) {
    int argc = 1;
    char name[] = "test";
    char* argv[] = {name, nullptr};
    const QCoreApplication application(argc, argv);
    for (const int number : {SIGTERM, SIGINT, SIGHUP}) {
        struct sigaction before {};
        const auto handler = std::signal(number, [](int) { ++heard; });
        heard = 0;
        {
            QuitSignals signalsToQuit;
            int asked = 0;
            QObject::connect(&signalsToQuit, &QuitSignals::asked, &signalsToQuit, [&] { ++asked; });
            ASSERT_EQ(std::raise(number), 0);
            EXPECT_EQ(asked, 0) << "not in the handler, which may do nothing";
            EXPECT_TRUE(waitUntil([&] { return asked == 1; }));
            sigaction(number, nullptr, &before);
            EXPECT_EQ(before.sa_handler, SIG_DFL)
                << "whoever asks again is not waiting for a program that hangs";
        }
        EXPECT_EQ(std::raise(number), 0);
        EXPECT_EQ(heard, 1) << "the handler of before is there again";
        std::signal(number, handler);
    }
}

TEST(QuitSignals, WhatTheProgramIsToIgnoreStaysIgnored) {
    int argc = 1;
    char name[] = "test";
    char* argv[] = {name, nullptr};
    const QCoreApplication application(argc, argv);
    const auto handler = std::signal(SIGHUP, SIG_IGN);
    {
        QuitSignals signalsToQuit;
        bool isAsked = false;
        QObject::connect(&signalsToQuit, &QuitSignals::asked, &signalsToQuit, [&] { isAsked = true; });
        ASSERT_EQ(std::raise(SIGHUP), 0);
        for (int i = 0; i < 5; ++i) QCoreApplication::processEvents();
        EXPECT_FALSE(isAsked) << "it was started with nohup";
    }
    std::signal(SIGHUP, handler);
}

}  // namespace
}  // namespace macula::viewer
