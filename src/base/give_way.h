// Which threads go first where all want the processor at once.
#pragma once

namespace macula {

// How far work steps back behind the thread of the user interface, which does not.
enum class GiveWay {
    toTheHand,   // what follows a hand on the host: slices
    toTheFrame,  // the picture, and what it waits for. Where the device is the CPU, tracing takes every core.
    toAll,       // nobody waits for it
};

// The calling thread, and those that it starts from now on (so the threads of a driver, which are started by
// the thread that makes the device). On Linux; elsewhere nothing happens. A refusal is no error: all works,
// only less smoothly.
void giveWay(GiveWay to);

}  // namespace macula
