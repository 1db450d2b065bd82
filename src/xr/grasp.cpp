#include "xr/grasp.h"

#include "xr/placement.h"

namespace macula::xr {

glm::dmat4 Grasp::follow(const glm::dmat4& stageFromWorld, const TwoHands& hands) {
    std::array<bool, 2> holds{};
    for (std::size_t i = 0; i < hands.size(); ++i)
        holds[i] = hands[i].grip && holdsOn(hands[i].squeeze, holds_[i]);
    if (holds != holds_) {  // another hold starts from the present placement
        holds_ = holds;
        stageFromWorldThen_ = stageFromWorld;
        for (std::size_t i = 0; i < hands.size(); ++i) then_[i] = hands[i].grip.value_or(Pose{});
        return stageFromWorld;
    }
    if (holds[0] && holds[1])
        return followingHands(stageFromWorldThen_, then_, {*hands[0].grip, *hands[1].grip});
    for (std::size_t i = 0; i < hands.size(); ++i)
        if (holds[i]) return followingHand(stageFromWorldThen_, then_[i], *hands[i].grip);
    return stageFromWorld;
}

}  // namespace macula::xr
