// The storage provider, against those who may not call, and those who break rules.
#include <gtest/gtest.h>

#include <chrono>
#include <thread>

#include "net/provider_support.h"
#include "net/servers.h"

namespace macula::net::test {

namespace {

using Rejected = std::vector<unsigned>;
using Why = TurnedAway::Why;

// After whatever was done to it, it still takes an instance.
void expectAlive(TestedProvider& provider, const std::string& sopInstanceUid = "2.25.1.999") {
    EXPECT_TRUE(comes([&] {
        ProviderCaller caller(provider.port());
        return caller.associates() && caller.store("2.25.1", sopInstanceUid) == 0x0000;
    }));
}

void expectTurnedAway(const TestedProvider& provider, Why why) {
    EXPECT_TRUE(comes([&] { return !provider.turnedAway().empty(); }));
    ASSERT_FALSE(provider.turnedAway().empty());
    EXPECT_EQ(provider.turnedAway().back().why, why);
    EXPECT_FALSE(textOf(provider.turnedAway().back()).empty());
}

TEST(HostileToProvider, TitlesThatMayNotCallAreRejectedWithTheReason) {
    StoreProviderOptions options;
    options.callers = {{"CT1", ""}, {"HOSTILE", "10.0.0.0/8"}};
    const TestedProvider provider(options);
    ProviderCaller other(provider.port());
    EXPECT_FALSE(other.associates("SOMEBODY"));
    EXPECT_EQ(other->rejection(), (Rejected{1, 1, 7}));
    expectTurnedAway(provider, Why::calledTitle);
    ProviderCaller caller(provider.port());
    EXPECT_FALSE(caller.associates());
    EXPECT_EQ(caller->rejection(), (Rejected{1, 1, 3})) << "its title is known at another address alone";
    EXPECT_TRUE(comes([&] { return provider.turnedAway().size() == 2; }));
    expectTurnedAway(provider, Why::callingTitle);
    EXPECT_EQ(provider.turnedAway().back().caller.ae, "HOSTILE");
    EXPECT_EQ(provider.turnedAway().back().caller.address, "127.0.0.1");
    EXPECT_TRUE(provider.reception.callers().empty());
}

TEST(HostileToProvider, OfOtherAddressesNothingIsRead) {
    StoreProviderOptions options;
    options.callers = {{"", "10.0.0.0/8"}, {"HOSTILE", "2001:db8::/32"}};
    const TestedProvider provider(options);
    ProviderCaller caller(provider.port());
    EXPECT_FALSE(caller.associates());
    EXPECT_EQ(caller->rejection(), (Rejected{1, 1, 3}));
    EXPECT_TRUE(caller.isEnded());
    expectTurnedAway(provider, Why::address);
    ProviderCaller silent(provider.port());
    EXPECT_TRUE(silent.isEnded());
}

TEST(HostileToProvider, MoreAssociationsThanAllowedAreRejectedAndMakeRoom) {
    StoreProviderOptions options;
    options.admission.associations = 2;
    TestedProvider provider(options);
    {
        ProviderCaller first(provider.port());
        ProviderCaller second(provider.port());
        ASSERT_TRUE(first.associates());
        ASSERT_TRUE(second.associates());
        ProviderCaller third(provider.port());
        EXPECT_FALSE(third.associates());
        EXPECT_EQ(third->rejection(), (Rejected{2, 3, 2}));
        expectTurnedAway(provider, Why::tooMany);
        std::vector<std::unique_ptr<ProviderCaller>> idle;
        for (int i = 0; i < 30; ++i) idle.push_back(std::make_unique<ProviderCaller>(provider.port()));
        EXPECT_EQ(first.store("2.25.1", "2.25.1.1"), 0x0000) << "those that came first are served";
    }
    expectAlive(provider);
}

TEST(HostileToProvider, MoreAssociationsInAWhileThanAllowedAreRejected) {
    StoreProviderOptions options;
    options.admission.associationsPerMinute = 3;
    const TestedProvider provider(options);
    for (int i = 0; i < 5; ++i) {
        ProviderCaller caller(provider.port());
        EXPECT_EQ(caller.associates(), i < 3);
        if (i >= 3) {
            EXPECT_EQ(caller->rejection(), (Rejected{2, 3, 1}));
        }
    }
    expectTurnedAway(provider, Why::tooOften);
}

TEST(HostileToProvider, OtherServicesAreNotOffered) {
    TestedProvider provider;
    ProviderCaller finder(provider.port());
    EXPECT_FALSE(finder->requestAssociation("MACULA", "1.2.840.10008.5.1.4.1.2.2.1", kExplicitSyntax));
    EXPECT_EQ(finder->rejection(), (Rejected{1, 1, 1}));
    ProviderCaller unknown(provider.port());
    EXPECT_FALSE(unknown->requestAssociation("MACULA", kCtImages, "1.2.3.4"));
    ProviderCaller committing(provider.port());
    EXPECT_FALSE(committing->requestAssociation("MACULA", "1.2.840.10008.1.20.1", kExplicitSyntax))
        << "it promises nobody to keep anything";
    ProviderCaller other(provider.port());
    ASSERT_TRUE(other.associates());
    other->sendCommand(1, {.field = CommandField::findRequest, .messageId = std::uint16_t{1}});
    EXPECT_TRUE(other.isEnded());
    expectAlive(provider);
}

TEST(HostileToProvider, AnEndlessInstanceStopsAtTheLimit) {
    StoreProviderOptions options;
    options.mostBytesOfInstance = 200'000;
    TestedProvider provider(options);
    ProviderCaller caller(provider.port());
    ASSERT_TRUE(caller.associates());
    caller.beginStore("2.25.1.1");
    std::size_t sent = 0;
    while (sent < 100'000'000 && caller->sendFragment(1, false, false, Bytes(16000, 'x'))) sent += 16000;
    EXPECT_LT(sent, 100'000'000u);
    EXPECT_TRUE(comes([&] { return provider.counts().refused == 1; }));
    EXPECT_EQ(provider.reception.receiver.filesInFolder(), 0u);
    expectAlive(provider);
}

TEST(HostileToProvider, InAllNoMoreIsKeptThanAllowedAndTheSenderHearsOfIt) {
    StoreProviderOptions options;
    options.mostBytes = 300'000;
    TestedProvider provider(options);
    ProviderCaller caller(provider.port());
    ASSERT_TRUE(caller.associates());
    EXPECT_EQ(caller.store("2.25.1", "2.25.1.1", 200'000), 0x0000);
    EXPECT_EQ(caller.store("2.25.1", "2.25.1.2", 200'000), 0xa700);
    EXPECT_EQ(caller.store("2.25.1", "2.25.1.1", 50'000), 0x0000) << "it was there: no more is needed";
    EXPECT_EQ(caller.store("2.25.1", "2.25.1.3", 50'000), 0x0000) << "there is room for this one";
    EXPECT_EQ(provider.counts().withoutRoom, 1u);
    EXPECT_EQ(provider.counts().kept, 2u);
    EXPECT_LE(provider.counts().bytes, options.mostBytes);
}

TEST(HostileToProvider, AFullDiskIsSaidAndTriedAgain) {
    TestedProvider provider;
    provider.reception.receiver.fullAfter = 1;
    ProviderCaller caller(provider.port());
    ASSERT_TRUE(caller.associates());
    EXPECT_EQ(caller.store("2.25.1", "2.25.1.1"), 0x0000);
    EXPECT_EQ(caller.store("2.25.1", "2.25.1.2", 100'000), 0xa700);
    EXPECT_EQ(caller.store("2.25.1", "2.25.1.3"), 0xa700);
    provider.reception.receiver.fullAfter = 10;
    EXPECT_EQ(caller.store("2.25.1", "2.25.1.2"), 0x0000);
    EXPECT_EQ(provider.counts().withoutRoom, 2u);
}

TEST(HostileToProvider, SilenceEnds) {
    StoreProviderOptions options;
    options.idleTimeout = std::chrono::milliseconds(300);
    TestedProvider provider(options);
    ProviderCaller silent(provider.port());
    EXPECT_TRUE(silent.isEnded());
    expectTurnedAway(provider, Why::noRequest);
    ProviderCaller midway(provider.port());
    ASSERT_TRUE(midway.associates());
    midway.beginStore("2.25.1.1");
    midway->sendFragment(1, false, false, Bytes(1000, 'x'));
    EXPECT_TRUE(midway.isEnded());
    EXPECT_TRUE(comes([&] { return provider.counts().cutOff == 1; }));
    EXPECT_EQ(provider.reception.receiver.filesInFolder(), 0u);
}

TEST(HostileToProvider, ARequestThatComesByteByByteEnds) {
    StoreProviderOptions options;
    options.idleTimeout = std::chrono::milliseconds(500);
    const TestedProvider provider(options);
    ProviderCaller caller(provider.port());
    caller->sendAll({1, 0, 0, 0, 0x10, 0});
    int sent = 0;
    while (sent < 300 && caller->sendAll({0})) {
        std::this_thread::sleep_for(std::chrono::milliseconds(50));
        ++sent;
    }
    EXPECT_LT(sent, 300) << "each byte got it more time";
}

TEST(HostileToProvider, WhatIsNoDicomDoesNoHarm) {
    TestedProvider provider;
    ProviderCaller(provider.port())->sendAll(Bytes(100, 0xff));
    ProviderCaller(provider.port())->sendAll({1, 0, 0xff, 0xff, 0xff, 0xff});
    ProviderCaller(provider.port())->sendPdu(1, Bytes(3, 0));
    ProviderCaller(provider.port())->sendPdu(4, Bytes(8, 0));
    // Fragments whose length is more, or less, than what is there, or that are of no context.
    for (const Bytes& body : {Bytes{0, 0, 0xff, 0xff, 1, 2, 0}, Bytes{0, 0, 0, 1, 1},
                              Bytes{0xff, 0xff, 0xff, 0xff}, Bytes{0, 0, 0, 4, 99, 3, 0, 0}}) {
        ProviderCaller caller(provider.port());
        ASSERT_TRUE(caller.associates());
        caller.beginStore("2.25.1.1");
        caller->sendPdu(4, body);
    }
    // A command within a dataset, and a dataset without a command.
    ProviderCaller mixed(provider.port());
    ASSERT_TRUE(mixed.associates());
    mixed.beginStore("2.25.1.1");
    mixed->sendFragment(1, false, false, Bytes(10, 'x'));
    mixed.beginStore("2.25.1.2");
    EXPECT_TRUE(mixed.isEnded());
    ProviderCaller bare(provider.port());
    ASSERT_TRUE(bare.associates());
    bare->sendFragment(1, false, true, Bytes(10, 'x'));
    EXPECT_TRUE(bare.isEnded());
    expectAlive(provider);
    EXPECT_TRUE(comes([&] { return provider.reception.receiver.filesInFolder() == 1; }));
}

TEST(HostileToProvider, NamesThatArePathsAreRefused) {
    TestedProvider provider;
    ProviderCaller caller(provider.port());
    ASSERT_TRUE(caller.associates());
    EXPECT_EQ(caller.store("2.25.1", "../2.25.1.2"), 0xa900);
    EXPECT_EQ(caller.store("2.25.1", "/etc/passwd"), 0xa900);
    EXPECT_EQ(caller.store("2.25.1", ""), 0xa900);
    EXPECT_EQ(caller.store("2.25.1", "2.25.1.1"), 0x0000);
    EXPECT_EQ(provider.counts().refused, 3u);
    EXPECT_EQ(provider.reception.receiver.filesInFolder(), 1u);
}

TEST(HostileToProvider, EndsThoughSomebodySends) {
    TestedProvider provider;
    ProviderCaller idle(provider.port());
    ASSERT_TRUE(idle.associates());
    ProviderCaller midway(provider.port());
    ASSERT_TRUE(midway.associates());
    midway.beginStore("2.25.1.1");
    midway->sendFragment(1, false, false, Bytes(1000, 'x'));
    const std::uint16_t port = provider.port();
    provider.end();
    EXPECT_FALSE(answersAt(port));
    EXPECT_TRUE(idle.isEnded());
    EXPECT_TRUE(midway.isEnded());
    EXPECT_EQ(provider.reception.receiver.filesInFolder(), 0u);
}

}  // namespace

}  // namespace macula::net::test
