#pragma once

#include "scenes/observe.h"

namespace bullet_buoyancy::scenes {

/// Thirty barrels (0.6 m in diameter, 0.9 m long, a fifth as dense as water), each jointed to the next,
/// across a harbour between two fixed points.
struct ChainResult {
    double widestGap;  ///< of a joint at any time after the first second, m
    double highest;    ///< centre of a barrel at any time above the water, m
    double speed;      ///< of the fastest in the last of 60 s, see `stepAndClock`, m/s
    bool finite;
};
ChainResult chainBarrels(Floater floater, const Stepping& stepping = {});

/// Bodies that something holds.
struct HeldResult {
    double highest;  ///< rise of a centre above where it was let go, at any time, m
    double deepest;  ///< how far a body has gone into what holds it, in the end, m
    double speed;    ///< of the fastest in the last second, see `stepAndClock`, m/s
    bool finite;
};

/// A crate of 1 m, a fifth as dense as water, pressed to its draft between two walls 5 mm too close; for 20
/// s.
HeldResult wedgeCrate(Floater floater, const Stepping& stepping = {});

/// A box, a ball and a roller of density `ratio` on a beach that rises by 1 in 4, let go at the waterline;
/// for 60 s.
HeldResult beach(double ratio, Floater floater, const Stepping& stepping = {});

/// Four boxes of 0.3 m, a hundredth as dense as water, under a deck 1 m under water for 10 s, and then
/// without it.
struct DeckResult {
    HeldResult held;
    double rise;      ///< greatest height over what the energy at the release allows
    bool settled;     ///< they came to rest within 2000 s
    double wetError;  ///< largest |wet fraction - ratio| / ratio
};
DeckResult holdUnderDeck(Floater floater, const Stepping& stepping = {});

}  // namespace bullet_buoyancy::scenes
