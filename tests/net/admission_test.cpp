// Who may call, and how often: addresses and limits without a network.
#include "net/dimse/admission.h"

#include <arpa/inet.h>
#include <gtest/gtest.h>
#include <netinet/in.h>

namespace macula::net {

namespace {

WireAddress addressOf(const std::string& text) {
    WireAddress address;
    auto* ipv4 = reinterpret_cast<sockaddr_in*>(address.bytes);
    auto* ipv6 = reinterpret_cast<sockaddr_in6*>(address.bytes);
    address.family = text.find(':') == std::string::npos ? AF_INET : AF_INET6;
    void* number = address.family == AF_INET ? static_cast<void*>(&ipv4->sin_addr) : &ipv6->sin6_addr;
    EXPECT_EQ(inet_pton(address.family, text.c_str(), number), 1) << text;
    return address;
}

bool contains(const std::string& range, const std::string& address) {
    const auto found = AddressRange::of(range);
    EXPECT_TRUE(found) << range;
    return found && found->contains(addressOf(address));
}

TEST(AddressRange, BitsInCommonDecide) {
    EXPECT_TRUE(contains("10.1.2.3", "10.1.2.3"));
    EXPECT_FALSE(contains("10.1.2.3", "10.1.2.4"));
    EXPECT_TRUE(contains("10.1.0.0/16", "10.1.255.255"));
    EXPECT_FALSE(contains("10.1.0.0/16", "10.2.0.0"));
    EXPECT_TRUE(contains("10.1.2.128/25", "10.1.2.200"));
    EXPECT_FALSE(contains("10.1.2.128/25", "10.1.2.127"));
    EXPECT_TRUE(contains("10.1.77.3/16", "10.1.2.3")) << "bits behind the range do not count";
    EXPECT_TRUE(contains("0.0.0.0/0", "198.51.100.7"));
    EXPECT_TRUE(contains("2001:db8::/32", "2001:db8:1::5"));
    EXPECT_FALSE(contains("2001:db8::/32", "2001:db9::"));
    EXPECT_TRUE(contains("::1", "::1"));
}

TEST(AddressRange, OfBothFamiliesAreToldApart) {
    EXPECT_TRUE(contains("10.0.0.0/8", "::ffff:10.1.2.3")) << "IPv4 at a listener of IPv6";
    EXPECT_FALSE(contains("0.0.0.0/0", "2001:db8::1"));
    EXPECT_FALSE(contains("2001:db8::/32", "10.1.2.3"));
    EXPECT_TRUE(contains("::/0", "10.1.2.3"));
    EXPECT_EQ(textOf(addressOf("::ffff:10.1.2.3")), "10.1.2.3");
    EXPECT_EQ(textOf(addressOf("2001:db8::1")), "2001:db8::1");
}

TEST(AddressRange, OtherTextIsNone) {
    for (const char* text : {"", "pacs", "10.1.2", "10.1.2.3.4", "10.1.2.3/33", "10.1.2.3/", "10.1.2.3/-1",
                             "10.1.2.3/8x", "::1/129", "/8", "10.1.2.3 ", "*"})
        EXPECT_FALSE(AddressRange::of(text)) << text;
}

TEST(AddressRange, OfThisMachineAlone) {
    for (const char* address : {"127.0.0.1", "127.1.2.3", "::1", "localhost"})
        EXPECT_TRUE(isOfThisMachineAlone(address)) << address;
    for (const char* address : {"", "0.0.0.0", "::", "10.1.2.3", "pacs.example.org", "128.0.0.1"})
        EXPECT_FALSE(isOfThisMachineAlone(address)) << address;
}

std::unique_ptr<Admission> admissionOf(const std::vector<AdmittedCaller>& callers, bool admitsAnyone = false,
                                       const AdmissionLimits& limits = {}) {
    auto admission = Admission::of(callers, admitsAnyone, limits);
    EXPECT_TRUE(admission);
    return admission ? std::move(*admission) : nullptr;
}

TEST(Admission, TitleAndAddressMustFitTogether) {
    const auto admission = admissionOf({{"CT1", "10.1.2.3"}, {"", "10.9.0.0/16"}, {"MR1", ""}});
    EXPECT_TRUE(admission->mayCall("CT1", addressOf("10.1.2.3")));
    EXPECT_FALSE(admission->mayCall("CT1", addressOf("10.1.2.4")));
    EXPECT_FALSE(admission->mayCall("CT2", addressOf("10.1.2.3")));
    EXPECT_TRUE(admission->mayCall("ANY", addressOf("10.9.8.7")));
    EXPECT_TRUE(admission->mayCall("MR1", addressOf("2001:db8::1")));
    EXPECT_FALSE(admission->mayCall("", addressOf("10.1.2.3")));
    EXPECT_TRUE(admission->mayConnect(addressOf("198.51.100.7"))) << "it may turn out to be MR1";
    EXPECT_FALSE(admissionOf({{"CT1", "10.1.2.3"}})->mayConnect(addressOf("198.51.100.7")));
}

TEST(Admission, WithoutAListOnlyThisMachineMayCall) {
    const auto own = admissionOf({});
    EXPECT_TRUE(own->mayCall("ANY", addressOf("127.0.0.1")));
    EXPECT_TRUE(own->mayCall("ANY", addressOf("::1")));
    EXPECT_TRUE(own->mayCall("ANY", addressOf("::ffff:127.0.0.1")));
    EXPECT_FALSE(own->mayConnect(addressOf("10.1.2.3")));
    EXPECT_TRUE(admissionOf({}, true)->mayCall("ANY", addressOf("10.1.2.3")));
    EXPECT_FALSE(Admission::of({{"CT1", "pacs"}}, false, {}));
}

TEST(Admission, CountsOverTime) {
    const auto admission =
        admissionOf({}, true, {.associations = 3, .associationsPerSecond = 2, .associationsPerMinute = 4});
    const Admission::Clock::time_point begin{};
    const auto at = [&](double seconds) {
        return begin + std::chrono::milliseconds(static_cast<long>(seconds * 1000));
    };
    const auto enters = [&](double seconds) {
        const auto rejection = admission->enter(at(seconds));
        if (!rejection) return 0u;
        EXPECT_EQ(rejection->result, 2u);
        EXPECT_EQ(rejection->source, 3u);
        return rejection->reason;
    };
    EXPECT_EQ(enters(0.0), 0u);
    EXPECT_EQ(enters(0.1), 0u);
    EXPECT_EQ(enters(0.2), 1u) << "two in a second";
    EXPECT_EQ(enters(1.05), 0u) << "the first is longer ago";
    EXPECT_EQ(enters(5.0), 2u) << "three are open";
    admission->leave();
    EXPECT_EQ(enters(5.0), 0u);
    admission->leave();
    EXPECT_EQ(enters(59.0), 1u) << "four in a minute";
    EXPECT_EQ(enters(60.05), 0u);
}

}  // namespace

}  // namespace macula::net
